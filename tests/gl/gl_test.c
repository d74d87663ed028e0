// The GL floor on one rung of the ladder, with a set of the test's own: gl_test RUNG.
#include "rig.h"
#include "tests.h"

int main(int argc, char **argv)
{
    if (!rig_open(argc, argv))
        return 1;
    const int failed = create_tests() + sync_tests() + sync_edge_tests() + bind_tests() +
                       check_tests() + hostile_tests();
    return !rig_close() || failed != 0;
}

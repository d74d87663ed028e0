#include "tests.h"

int main(void)
{
    return plan_tests() + map_tests();
}

#include "tests.h"

int main(void)
{
    return light_tests() + environment_tests();
}

// The chooser: rules, bad input, steadiness. One program, a group a file.
#include "tests.h"

int main(void)
{
    return input_tests() + rules_tests() + steady_tests() + leaf_tests();
}

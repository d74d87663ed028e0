#include "rig.h"

int main(void)
{
    return set_tests() + growth_tests() + jobs_tests() + memory_tests() + cache_tests() != 0;
}

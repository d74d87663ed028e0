#include "tests.h"

int main(void)
{
    return schema_tests() + input_tests() + model_tests() + null_tests() + color_tests() +
               head_tests() + leaf_tests() + leaf_scale_tests() + leaf_scale_edge_tests() !=
           0;
}

#include "tests.h"

int main(void)
{
    return schema_tests() + input_tests() + model_tests() + null_tests() + color_tests() +
               head_tests() !=
           0;
}

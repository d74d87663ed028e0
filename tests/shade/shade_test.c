#include "ask_shader.h"

int main(void)
{
    return text_tests() + read_tests() + compile_tests() + shadow_tests() + drop_tests() + only_tests() != 0;
}

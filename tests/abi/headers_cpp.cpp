// One public header, alone and twice, in strict C++11. Compiling this file is the test.
#include TSUYA_HEADER
#include TSUYA_HEADER

extern "C" tsu_status tsuya_test_header();
extern "C" tsu_status tsuya_test_header()
{
    return TSU_OK;
}

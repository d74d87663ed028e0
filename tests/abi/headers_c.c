// One public header, alone and twice, in strict C11. Compiling this file is the test.
#include TSUYA_HEADER
#include TSUYA_HEADER

// The header brought what its declarations need.
tsu_status tsuya_test_header(void);
tsu_status tsuya_test_header(void)
{
    return TSU_OK;
}

// Sized descriptors: smaller, equal and larger than ours, read, written and begun.
#include "base/desc.h"
#include "watch.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

// Three releases of one descriptor.
struct first {
    uint32_t struct_size, flags, a, b;
};
struct ours {
    uint32_t struct_size, flags, a, b, c, d;
};
struct later {
    uint32_t struct_size, flags, a, b, c, d, e, f;
};
static const struct ours defaults = {sizeof defaults, 0, 1, 2, 3, 4};

static struct watch watch;

static tsu_status read(const void *host, struct ours *own)
{
    tsu_context *context = watch_open(&watch);
    *own = defaults;
    const tsu_status status = tsu_i_desc_read(context, "tsu_thing_desc", host, own, sizeof *own,
                                              sizeof(struct first));
    tsu_context_destroy(context);
    watch_close(&watch);
    assert_int_equal(watch.log_count, status == TSU_OK ? 0 : 1);
    return status;
}

static void smaller_keeps_our_defaults(void **state)
{
    (void)state;
    struct ours own;
    const struct first host = {sizeof host, 7, 10, 20};
    assert_int_equal(read(&host, &own), TSU_OK);
    const struct ours expected = {sizeof own, 7, 10, 20, 3, 4};
    assert_memory_equal(&own, &expected, sizeof own);
}

static void equal_is_copied(void **state)
{
    (void)state;
    struct ours own;
    const struct ours host = {sizeof host, 7, 10, 20, 30, 40};
    assert_int_equal(read(&host, &own), TSU_OK);
    assert_memory_equal(&own, &host, sizeof own);
}

static void larger_with_a_zero_tail_is_copied(void **state)
{
    (void)state;
    struct ours own;
    const struct later host = {sizeof host, 7, 10, 20, 30, 40, 0, 0};
    assert_int_equal(read(&host, &own), TSU_OK);
    const struct ours expected = {sizeof own, 7, 10, 20, 30, 40};
    assert_memory_equal(&own, &expected, sizeof own);
}

static void larger_with_a_request_is_refused(void **state)
{
    (void)state;
    struct ours own;
    struct later host = {sizeof host, 7, 10, 20, 30, 40, 0, 0x01000000};
    assert_int_equal(read(&host, &own), TSU_E_STRUCT);
    assert_memory_equal(&own, &defaults, sizeof own);
    assert_non_null(strstr(watch.log, "tsu_thing_desc"));
    host.f = 0;
    host.e = 1;
    assert_int_equal(read(&host, &own), TSU_E_STRUCT);
}

static void too_small_is_refused(void **state)
{
    (void)state;
    struct ours own;
    struct ours host = {0, 0, 10, 20, 30, 40};
    for (uint32_t size = 0; size < sizeof(struct first); size++) {
        host.struct_size = size;
        assert_int_equal(read(&host, &own), TSU_E_STRUCT);
        assert_memory_equal(&own, &defaults, sizeof own);
        assert_non_null(strstr(watch.log, "tsu_thing_desc_init()"));
    }
    assert_int_equal(read(NULL, &own), TSU_E_STRUCT);
    assert_non_null(strstr(watch.log, "NULL"));
}

static void writing_respects_the_hosts_size(void **state)
{
    (void)state;
    const struct ours own = {sizeof own, 9, 11, 12, 13, 14};
    unsigned char bytes[2 * sizeof own], expected[sizeof bytes];
    for (uint32_t size = 8; size <= sizeof bytes; size += 4) {
        memset(bytes, 0xcc, sizeof bytes);
        memcpy(bytes, &size, sizeof size);
        memcpy(expected, bytes, sizeof bytes);
        memcpy(expected, &own, size < sizeof own ? size : sizeof own);
        memcpy(expected, &size, sizeof size);
        assert_int_equal(tsu_i_desc_write(bytes, &own, sizeof own), TSU_OK);
        assert_memory_equal(bytes, expected, sizeof bytes);
    }
    for (uint32_t size = 0; size < 8; size++) {
        memset(bytes, 0xcc, sizeof bytes);
        memcpy(bytes, &size, sizeof size);
        memcpy(expected, bytes, sizeof bytes);
        assert_int_equal(tsu_i_desc_write(bytes, &own, sizeof own), TSU_E_STRUCT);
        assert_memory_equal(bytes, expected, sizeof bytes);
    }
    assert_true(tsu_i_desc_write(NULL, &own, sizeof own) < 0);
}

static void failing_zeroes_no_more_than_ours(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {0, 3, 4, 8, 24, sizeof(struct ours), 0x5a5a5a5a, UINT32_MAX};
    unsigned char bytes[2 * sizeof(struct ours)], expected[sizeof bytes];
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const uint32_t size = sizes[i];
        const size_t end = size < sizeof(struct ours) ? size : sizeof(struct ours);
        memset(bytes, 0xcc, sizeof bytes);
        memcpy(bytes, &size, sizeof size);
        memcpy(expected, bytes, sizeof bytes);
        if (end > sizeof size)
            memset(expected + sizeof size, 0, end - sizeof size);
        assert_int_equal(tsu_i_desc_fail(bytes, sizeof(struct ours), TSU_E_PARAMETER),
                         TSU_E_PARAMETER);
        assert_memory_equal(bytes, expected, sizeof bytes);
    }
    assert_int_equal(tsu_i_desc_fail(NULL, 24, TSU_E_PARAMETER), TSU_E_PARAMETER);
}

static void beginning_fills_what_fits(void **state)
{
    (void)state;
    unsigned char bytes[2 * sizeof(struct ours)], expected[sizeof bytes];
    for (uint32_t size = sizeof(struct first); size <= sizeof bytes; size++) {
        memset(bytes, 0xcc, sizeof bytes);
        memset(expected, 0xcc, sizeof bytes);
        memset(expected, 0, size);
        memcpy(expected, &defaults, size < sizeof defaults ? size : sizeof defaults);
        memcpy(expected, &size, sizeof size);
        assert_int_equal(
            tsu_i_desc_init(bytes, size, &defaults, sizeof defaults, sizeof(struct first)), TSU_OK);
        assert_memory_equal(bytes, expected, sizeof bytes);
    }
    for (size_t size = 0; size < sizeof(struct first); size++) {
        memset(bytes, 0xcc, sizeof bytes);
        memset(expected, 0xcc, sizeof bytes);
        assert_int_equal(
            tsu_i_desc_init(bytes, size, &defaults, sizeof defaults, sizeof(struct first)),
            TSU_E_STRUCT);
        assert_memory_equal(bytes, expected, sizeof bytes);
    }
    assert_int_equal(tsu_i_desc_init(NULL, 24, &defaults, sizeof defaults, 16), TSU_E_STRUCT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smaller_keeps_our_defaults),
        cmocka_unit_test(equal_is_copied),
        cmocka_unit_test(larger_with_a_zero_tail_is_copied),
        cmocka_unit_test(larger_with_a_request_is_refused),
        cmocka_unit_test(too_small_is_refused),
        cmocka_unit_test(writing_respects_the_hosts_size),
        cmocka_unit_test(failing_zeroes_no_more_than_ours),
        cmocka_unit_test(beginning_fills_what_fits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

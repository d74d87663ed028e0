// Lights: what is refused, what a record holds.
#include "../base/watch.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "tests.h"

static const double pi = 3.14159265358979323846;
static struct watch watch;
static tsu_context *context;
static tsu_light_desc desc;
static float record[16];

static int open(void **state)
{
    (void)state;
    context = watch_open(&watch);
    assert_int_equal(tsu_light_desc_init(&desc), TSU_OK);
    return 0;
}

static int close(void **state)
{
    (void)state;
    assert_int_equal(watch.calls, 1); // the context alone asks for memory
    tsu_context_destroy(context);
    watch_close(&watch);
    return 0;
}

static void logged(const char *field, const char *range)
{
    assert_int_equal(watch.log_count, 1);
    assert_int_equal(watch.log_level, TSU_LOG_ERROR);
    if (!strstr(watch.log, field) || !strstr(watch.log, range))
        fail_msg("\"%s\" does not name %s and %s", watch.log, field, range);
}

static void refused(tsu_status status, const char *field, const char *range)
{
    watch_quiet(&watch);
    record[5] = 7.0f;
    assert_int_equal(tsu_light_pack(context, &desc, record), status);
    logged(field, range);
    assert_true(record[5] == 0.0f);
}

static void every_number_has_a_range(void **state)
{
    const tsu_light_desc good = desc;
    const struct {
        tsu_light_kind kind;
        float *field;
        float low, high;
        const char *name, *range;
    } numbers[] = {
        {TSU_LIGHT_DIRECTIONAL, &desc.color[1], -1.0f, 2e30f, "color", "[0, 1e30]"},
        {TSU_LIGHT_DIRECTIONAL, &desc.angle, -0.1f, 0.7f, "angle", "[0, 0.6"},
        {TSU_LIGHT_DIRECTIONAL, &desc.direction[1], 0.0f, 2e9f, "direction", "1"},
        {TSU_LIGHT_POINT, &desc.position[2], -2e9f, 2e9f, "position", "1"},
        {TSU_LIGHT_POINT, &desc.least, 0.0f, 2e9f, "least", "1"},
        {TSU_LIGHT_RECT, &desc.x[0], 0.0f, 2e9f, "x (its length)", "1"},
        {TSU_LIGHT_RECT, &desc.y[2], 0.0f, 2e9f, "y (its length)", "1"},
        {TSU_LIGHT_RECT, &desc.x[2], -0.1f, 0.1f, "x . y", "0.001"},
        {TSU_LIGHT_DISK, &desc.x[0], 0.49f, 0.51f, "x (its length) / y", "0.999"},
        {TSU_LIGHT_DISK, &desc.reserved, -1.0f, 1.0f, "reserved", "[0"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        const float bad[] = {numbers[i].low, numbers[i].high, (float)NAN, (float)INFINITY};
        for (int k = 0; k < 4; k++) {
            // A length that is no number is found before an angle.
            const int late = k > 1 && numbers[i].name[0] == 'x';
            desc = good;
            desc.kind = numbers[i].kind;
            *numbers[i].field = bad[k];
            refused(TSU_E_PARAMETER, late ? "x (its length)" : numbers[i].name,
                    late ? "[" : numbers[i].range);
        }
    }
    desc = good;
    desc.kind = 0;
    refused(TSU_E_PARAMETER, "kind", "TSU_LIGHT_");
    desc.kind = 5;
    refused(TSU_E_PARAMETER, "kind", "TSU_LIGHT_");
    desc = good;
    desc.samples = 0;
    refused(TSU_E_PARAMETER, "samples", "64");
    desc.samples = 65;
    refused(TSU_E_PARAMETER, "samples", "64");
    desc = good;
    desc.flags = 2;
    refused(TSU_E_PARAMETER, "flags", "TSU_LIGHT_");
    desc = good;
    desc.struct_size = 0;
    refused(TSU_E_STRUCT, "tsu_light_desc", "init");
    assert_int_equal(tsu_light_pack(context, &good, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_light_pack(NULL, &good, record), TSU_E_PARAMETER);
}

// What a kind does not use is not looked at, and records hold what the header says.
static void records(void **state)
{
    (void)state;
    desc.x[0] = desc.position[0] = desc.least = (float)NAN;
    desc.direction[0] = 3.0f;
    desc.direction[1] = 0.0f;
    desc.direction[2] = 4.0f;
    desc.color[0] = 5.0f;
    desc.least = 0.25f;
    assert_int_equal(tsu_light_pack(context, &desc, record), TSU_OK);
    assert_true(fabsf(record[0] - 0.6f) < 1e-6f && fabsf(record[2] - 0.8f) < 1e-6f);
    assert_true(record[3] == 0.0f && record[12] == 5.0f && record[7] == 13.0f);

    // A disk of the same irradiance: radiance times pi sin^2, axes of tan(angle) across.
    desc.angle = 0.3f;
    assert_int_equal(tsu_light_pack(context, &desc, record), TSU_OK);
    assert_true(record[3] == 4.0f);
    assert_true(fabs((double)record[12] * pi * sin(0.3) * sin(0.3) - 5.0) < 1e-5);
    double xx = 0.0, xy = 0.0, xd = 0.0, yd = 0.0;
    for (int k = 0; k < 3; k++) {
        xx += (double)record[4 + k] * (double)record[4 + k];
        xy += (double)record[4 + k] * (double)record[8 + k];
        xd += (double)record[4 + k] * (double)record[k];
        yd += (double)record[8 + k] * (double)record[k];
    }
    assert_true(fabs(sqrt(xx) - tan(0.3)) < 1e-6);
    assert_true(fabs(xy) < 1e-7 && fabs(xd) < 1e-7 && fabs(yd) < 1e-7);

    assert_int_equal(tsu_light_desc_init(&desc), TSU_OK);
    desc.kind = TSU_LIGHT_RECT;
    desc.flags = TSU_LIGHT_TWO_SIDED;
    desc.position[1] = 2.0f;
    desc.samples = 8;
    assert_int_equal(tsu_light_pack(context, &desc, record), TSU_OK);
    const float rect[16] = {0, 2, 0, 2, 0.5f, 0, 0, 8, 0, 0, 0.5f, 1, 1, 1, 1, 1e-3f};
    assert_memory_equal(record, rect, sizeof rect);
    desc.kind = TSU_LIGHT_POINT;
    assert_int_equal(tsu_light_pack(context, &desc, record), TSU_OK);
    assert_true(record[3] == 1.0f && record[4] == 0.0f && record[11] == 0.0f);
}

int light_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(every_number_has_a_range, open, close),
        cmocka_unit_test_setup_teardown(records, open, close),
    };
    return cmocka_run_group_tests_name("light", tests, NULL, NULL);
}

// Surroundings: what is refused, what comes back.
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
static tsu_environment_desc around;
static tsu_environment environment;

enum { ROWS = 64, COLUMNS = 128 };

// Surroundings: a constant, a linear and a quadratic part, and a disk of light.
static struct {
    float constant[3], linear[3], quadratic;
    float disk[3], axis[3], cosine;
    float poison; // of sample 100
    int what;     // that it poisons
    float angle;  // factor on solid angles
} place;

static void radiance(void *user, uint32_t index, float d[3], float l[3], float *angle)
{
    (void)user;
    const double polar = pi * (index / COLUMNS + 0.5) / ROWS;
    const double turn = 2.0 * pi * (index % COLUMNS) / COLUMNS;
    d[0] = (float)(2.0 * sin(polar) * cos(turn)); // of any length
    d[1] = (float)(2.0 * cos(polar));
    d[2] = (float)(2.0 * sin(polar) * sin(turn));
    *angle = (float)(sin(polar) * pi / ROWS * 2.0 * pi / COLUMNS) * place.angle;
    float along = 0.0f, linear = 0.0f;
    for (int k = 0; k < 3; k++) {
        along += 0.5f * d[k] * place.axis[k];
        linear += 0.5f * d[k] * place.linear[k];
    }
    for (int k = 0; k < 3; k++)
        l[k] = place.constant[k] + linear + place.quadratic * (0.25f * d[0] * d[1]) +
               (along > place.cosine ? place.disk[k] : 0.0f);
    if (index == 100 && place.what == 1)
        d[0] = d[1] = d[2] = place.poison;
    if (index == 100 && place.what == 2)
        l[1] = place.poison;
    if (index == 100 && place.what == 3)
        *angle = place.poison;
}

static int open(void **state)
{
    (void)state;
    context = watch_open(&watch);
    assert_int_equal(tsu_environment_desc_init(&around), TSU_OK);
    assert_int_equal(tsu_environment_init(&environment), TSU_OK);
    around.radiance = radiance;
    around.count = ROWS * COLUMNS;
    memset(&place, 0, sizeof place);
    place.constant[0] = place.constant[1] = place.constant[2] = 1.0f;
    place.axis[0] = 1.0f;
    place.cosine = 2.0f;
    place.angle = 1.0f;
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

static void make(void)
{
    if (tsu_environment_make(context, &around, &environment) != TSU_OK)
        fail_msg("%s", watch.log);
}

// Radiance as the snippet has it.
static double seen(const double d[3], int channel)
{
    const double p[9] = {1,           d[0],        d[1],
                         d[2],        d[0] * d[1], d[1] * d[2],
                         d[2] * d[0], d[0] * d[0] - d[1] * d[1], 3 * d[2] * d[2] - 1};
    double sum = 0.0;
    for (int j = 0; j < 9; j++)
        sum += p[j] * (double)environment.record[4 * j + channel];
    return sum;
}

// A polynomial of order 2 comes back as it is, in every direction.
static void polynomials_come_back(void **state)
{
    (void)state;
    place.linear[1] = 0.4f;
    place.linear[2] = -0.3f;
    place.quadratic = 0.5f;
    place.constant[0] = 2.0f;
    make();
    assert_true(environment.smoothing == 1.0f && environment.light_irradiance[0] == 0.0f);
    assert_true(environment.record[3] == 12.0f);
    for (int i = 0; i < 50; i++) {
        const double z = 1.0 - (2 * i + 1) / 50.0, side = sqrt(1 - z * z);
        const double d[3] = {side * cos(2.4 * i), side * sin(2.4 * i), z};
        const double truth = 0.4 * d[1] - 0.3 * d[2] + 0.5 * d[0] * d[1];
        assert_true(fabs(seen(d, 0) - truth - 2.0) < 3e-3);
        assert_true(fabs(seen(d, 2) - truth - 1.0) < 3e-3);
    }
}

// A bright disk becomes the dominant light: its place, its size, its power; the rest keeps its own.
static void the_dominant_light_is_found(void **state)
{
    (void)state;
    place.axis[0] = 0.6f;
    place.axis[1] = 0.8f;
    place.cosine = cosf(0.25f);
    place.disk[0] = 90.0f;
    place.disk[1] = 60.0f;
    place.disk[2] = 30.0f;
    make();
    double along = 0.0;
    for (int k = 0; k < 3; k++)
        along += (double)(environment.light_direction[k] * place.axis[k]);
    assert_true(along > cos(0.02));
    assert_true(fabs((double)environment.light_angle - 0.25) < 0.02);
    const double disk = 2.0 * pi * (1.0 - cos(0.25));
    for (int k = 0; k < 3; k++) {
        const double back = 0.5 * (1.0 + cos((double)environment.light_angle));
        const double taken = (double)environment.light_irradiance[k] / back;
        const double rest = 4.0 * pi * (double)environment.record[k];
        const double all = 4.0 * pi + disk * (double)place.disk[k];
        assert_true(fabs(taken + rest - all) < 0.03 * all);
        assert_true(taken > 0.8 * disk * (double)place.disk[k]);
    }
    around.threshold = 1e9f;
    make();
    assert_true(environment.light_irradiance[0] == 0.0f && environment.light_direction[1] == 1.0f);
}

// Black ground under a white sky: no direction is darker than black, and the mean stays.
static void nothing_is_negative(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        place.constant[k] = 0.0f;
        place.disk[k] = 1.0f;
    }
    place.cosine = 0.0f;
    make();
    assert_true(environment.smoothing > 0.3f && environment.smoothing < 1.0f);
    assert_true(fabsf(environment.record[0] - 0.5f) < 0.01f);
    for (int i = 0; i < 500; i++) {
        const double z = 1.0 - (2 * i + 1) / 500.0, side = sqrt(1 - z * z);
        const double d[3] = {side * cos(2.4 * i), side * sin(2.4 * i), z};
        assert_true(seen(d, 1) > -1e-3);
    }
}

static void refused(const char *field, const char *range)
{
    watch_quiet(&watch);
    environment.smoothing = 7.0f;
    assert_int_equal(tsu_environment_make(context, &around, &environment), TSU_E_PARAMETER);
    assert_int_equal(watch.log_count, 1);
    assert_int_equal(watch.log_level, TSU_LOG_ERROR);
    if (!strstr(watch.log, field) || !strstr(watch.log, range))
        fail_msg("\"%s\" does not name %s and %s", watch.log, field, range);
    assert_true(environment.smoothing == 0.0f);
    assert_int_equal(environment.struct_size, sizeof environment);
}

static void bad_surroundings_are_refused(void **state)
{
    (void)state;
    const tsu_environment_desc good = around;
    around.radiance = NULL;
    refused("radiance", "NULL");
    around = good;
    around.count = 5;
    refused("count", "[6");
    around = good;
    around.samples = 65;
    refused("samples", "64");
    around = good;
    around.threshold = 0.5f;
    refused("threshold", "[1");
    around = good;
    around.flags = 1;
    refused("flags", "expected 0");
    around = good;
    place.angle = 0.5f;
    refused("solid angles", "12.");
    place.angle = 1.0f;
    static const char *const expected[] = {"", "direction", "radiance in [0", "solid angle in [0"};
    for (place.what = 1; place.what <= 3; place.what++) {
        place.poison = (float)NAN;
        refused("sample 100", expected[place.what]);
        place.poison = place.what == 1 ? 0.0f : -1.0f;
        refused("sample 100", expected[place.what]);
    }
    place.what = 0;
    make();
    assert_int_equal(tsu_environment_make(context, &around, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_environment_make(NULL, &around, &environment), TSU_E_PARAMETER);
}

int environment_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(polynomials_come_back, open, close),
        cmocka_unit_test_setup_teardown(the_dominant_light_is_found, open, close),
        cmocka_unit_test_setup_teardown(nothing_is_negative, open, close),
        cmocka_unit_test_setup_teardown(bad_surroundings_are_refused, open, close),
    };
    return cmocka_run_group_tests_name("environment", tests, NULL, NULL);
}

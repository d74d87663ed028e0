// Colour of a head: the curve as data, its two directions, and every refusal. The curve against the
// solution behind it: tests/optics/head_test.c.
#include "tests.h"
#include "watched.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { LAST = TSU_HAIR_HEAD_NODES - 1 };

static tsu_hair_head_desc usual(void)
{
    tsu_hair_head_desc desc;
    assert_int_equal(tsu_hair_head_desc_init(&desc), TSU_OK);
    return desc;
}

static tsu_hair_head_curve empty(void)
{
    tsu_hair_head_curve curve;
    assert_int_equal(tsu_hair_head_curve_init(&curve), TSU_OK);
    return curve;
}

static tsu_hair_head_curve curve_of(const tsu_hair_head_desc *desc)
{
    tsu_hair_head_curve curve = empty();
    assert_int_equal(tsu_hair_head_curve_solve(context, desc, &curve), TSU_OK);
    return curve;
}

static double albedo_of(const tsu_hair_head_curve *curve, double sigma_a)
{
    const double in[3] = {sigma_a, sigma_a, sigma_a};
    double out[3];
    assert_int_equal(tsu_hair_head_albedo(context, curve, in, out), TSU_OK);
    assert_true(out[0] == out[1] && out[1] == out[2]);
    return out[0];
}

static void the_default_is_the_default_fibre(void **state)
{
    (void)state;
    const tsu_hair_head_desc desc = usual();
    tsu_marschner_params params;
    assert_int_equal(tsu_marschner_params_init(&params), TSU_OK);
    assert_true(desc.eta == params.eta && desc.alpha_R == params.alpha_R &&
                desc.beta_R == params.beta_R && desc.beta_az == params.beta_az &&
                desc.scale_shifts == params.scale_shifts);
    const long calls = watch.calls;
    const tsu_hair_head_curve curve = curve_of(&desc);
    assert_int_equal(watch.calls, calls); // no memory: it is there already
    assert_int_equal(curve.struct_size, sizeof curve);
    assert_true(curve.eta == desc.eta && curve.alpha_R == desc.alpha_R &&
                curve.beta_R == desc.beta_R && curve.beta_az == desc.beta_az &&
                curve.scale_shifts == desc.scale_shifts);
    assert_true(curve.albedo[0] == 1.0);
    for (int i = 0; i < LAST; i++) {
        const double root = 0.15 * i / (LAST - i);
        assert_true(curve.albedo[i] > curve.albedo[i + 1]);
        assert_true(fabs(albedo_of(&curve, root * root) - curve.albedo[i]) <= 1e-12);
    }
}

static void albedo_falls_and_comes_back(void **state)
{
    (void)state;
    const tsu_hair_head_desc desc = usual();
    const tsu_hair_head_curve curve = curve_of(&desc);
    double last = 1.0;
    assert_true(albedo_of(&curve, 0.0) == 1.0);
    for (double sigma_a = 1e-8; sigma_a < 1e6; sigma_a *= 1.01) {
        const double now = albedo_of(&curve, sigma_a);
        assert_true(now <= last && (sigma_a > 50.0 || now < last));
        last = now;
    }
    // Hair without pigment is white, and loses its first light as the root of what absorbs.
    const double one = 1.0 - albedo_of(&curve, 1e-6), four = 1.0 - albedo_of(&curve, 4e-6);
    assert_true(fabs(four / one - 2.0) <= 0.05);
    double worst = 0.0;
    const double least = curve.albedo[LAST];
    for (int i = 1; i <= 1000; i++) {
        const double in[3] = {fmin(least + (1.0 - least) * i / 1000.0, 1.0), 1.0, 0.5};
        double sigma_a[3], out[3];
        assert_int_equal(tsu_hair_head_sigma_a(context, &curve, in, sigma_a), TSU_OK);
        assert_true(sigma_a[0] >= 0.0 && sigma_a[0] <= 1e6 && sigma_a[1] == 0.0);
        assert_int_equal(tsu_hair_head_albedo(context, &curve, sigma_a, out), TSU_OK);
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, fabs(out[k] - in[k]));
    }
    double darkest = 0.0;
    for (double above = 1e-3; above > 1e-12; above *= 0.7) {
        const double in[3] = {least + above, 1.0, 1.0};
        double sigma_a[3], out[3];
        assert_int_equal(tsu_hair_head_sigma_a(context, &curve, in, sigma_a), TSU_OK);
        assert_int_equal(tsu_hair_head_albedo(context, &curve, sigma_a, out), TSU_OK);
        darkest = fmax(darkest, fabs(out[0] - in[0]));
    }
    print_message("head: albedo -> sigma_a -> albedo: worst %.2g, near the least %.2g\n", worst,
                  darkest);
    assert_true(worst <= 1e-12 && darkest <= 1e-8);
}

static void a_head_is_darker_than_its_fibres(void **state)
{
    (void)state;
    const tsu_hair_head_desc desc = usual();
    const tsu_hair_head_curve curve = curve_of(&desc);
    for (uint32_t i = 0; i < tsu_hair_preset_count(); i++) {
        tsu_hair_preset_info preset;
        double one[3], head[3];
        tsu_hair_preset_info_init(&preset);
        assert_int_equal(tsu_hair_preset(i, &preset), TSU_OK);
        assert_int_equal(tsu_hair_albedo(context, 1.55, preset.sigma_a, one), TSU_OK);
        assert_int_equal(tsu_hair_head_albedo(context, &curve, preset.sigma_a, head), TSU_OK);
        for (int k = 0; k < 3; k++)
            assert_true(preset.sigma_a[k] > 0.0 ? head[k] < one[k] : head[k] == 1.0);
    }
}

static void backwards(void *user, void (*job)(void *, uint32_t), void *data, uint32_t count)
{
    *(uint32_t *)user += count;
    while (count > 0)
        job(data, --count);
}

// A fibre next to the default is solved, and its curve is next to the compiled one; jobs change
// nothing.
static void other_fibres_are_solved(void **state)
{
    (void)state;
    tsu_hair_head_desc desc = usual();
    const tsu_hair_head_curve compiled = curve_of(&desc);
    desc.eta += 1e-6f;
    const tsu_hair_head_curve here = curve_of(&desc);
    for (int i = 0; i <= LAST; i++)
        assert_true(fabs(here.albedo[i] - compiled.albedo[i]) <= 2e-6);

    tsu_context_destroy(context);
    uint32_t items = 0;
    tsu_context_desc with_jobs = watch_desc(&watch);
    with_jobs.jobs = backwards;
    with_jobs.jobs_user = &items;
    assert_int_equal(tsu_context_create(&with_jobs, &context), TSU_OK);
    const tsu_hair_head_curve there = curve_of(&desc);
    assert_memory_equal(&here, &there, sizeof here);
    assert_int_equal(items, LAST);

    watch.fail_at = watch.calls + 1;
    tsu_hair_head_curve curve = there;
    assert_int_equal(tsu_hair_head_curve_solve(context, &desc, &curve), TSU_E_MEMORY);
    assert_true(curve.eta == 0.0f && curve.albedo[0] == 0.0);
}

static void refuse_desc(const tsu_hair_head_desc *desc, tsu_status status, const char *part)
{
    tsu_hair_head_curve curve = empty();
    memset(curve.albedo, 77, sizeof curve.albedo);
    watch_quiet(&watch);
    assert_int_equal(tsu_hair_head_curve_solve(context, desc, &curve), status);
    const tsu_hair_head_curve none = empty();
    assert_memory_equal(&curve, &none, sizeof none);
    assert_int_equal(watch.log_count, 1);
    assert_non_null(strstr(watch.log, part));
}

static void impossible_fibres_are_explained(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        const char *name, *range;
        float bad[2];
    } fields[] = {
        {offsetof(tsu_hair_head_desc, eta), ".eta", "[1.2, 2]", {1.19f, 2.01f}},
        {offsetof(tsu_hair_head_desc, alpha_R), ".alpha_R", "[-0.34", {-0.36f, 0.36f}},
        {offsetof(tsu_hair_head_desc, beta_R), ".beta_R", "[0.034", {0.03f, 0.53f}},
        {offsetof(tsu_hair_head_desc, beta_az), ".beta_az", "[0.087", {0.08f, 0.53f}},
        {offsetof(tsu_hair_head_desc, scale_shifts), ".scale_shifts", "[0, 1]", {-0.01f, 1.01f}}};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        const float bad[] = {fields[i].bad[0], fields[i].bad[1], NAN, INFINITY, -INFINITY};
        for (int k = 0; k < 5; k++) {
            tsu_hair_head_desc desc = usual();
            memcpy((char *)&desc + fields[i].offset, bad + k, sizeof *bad);
            refuse_desc(&desc, TSU_E_PARAMETER, fields[i].name);
            assert_non_null(strstr(watch.log, fields[i].range));
        }
    }
    tsu_hair_head_desc desc = usual();
    desc.flags = 4;
    refuse_desc(&desc, TSU_E_PARAMETER, ".flags = 4");
    desc = usual();
    desc.reserved = 3;
    refuse_desc(&desc, TSU_E_PARAMETER, ".reserved = 3");
    desc = usual();
    desc.struct_size = 0;
    refuse_desc(&desc, TSU_E_STRUCT, "tsu_hair_head_desc_init()");
    refuse_desc(NULL, TSU_E_STRUCT, "NULL");
    desc = usual();
    tsu_hair_head_curve curve = {0};
    assert_int_equal(tsu_hair_head_curve_solve(context, &desc, &curve), TSU_E_STRUCT);
    assert_int_equal(tsu_hair_head_curve_solve(context, &desc, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_head_desc_init_sized(&desc, 8), TSU_E_STRUCT);
}

// Each of the two directions with one bad channel.
static void impossible_colours_are_explained(void **state)
{
    (void)state;
    const tsu_hair_head_desc desc = usual();
    const tsu_hair_head_curve curve = curve_of(&desc);
    const double least = curve.albedo[LAST];
    const double bad[] = {NAN, INFINITY, -INFINITY, -1.0, 0.0, 0.9 * least, least, 1.0000001, 2.0};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int k = 0; k < 3; k++) {
            double in[3] = {0.5, 0.5, 0.5}, out[3] = {9, 9, 9};
            in[k] = bad[i];
            watch_quiet(&watch);
            assert_int_equal(tsu_hair_head_sigma_a(context, &curve, in, out), TSU_E_PARAMETER);
            assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
            assert_int_equal(watch.log_count, 1);
            assert_non_null(strstr(watch.log, "head_albedo = "));
            const char *range = strchr(watch.log, '(');
            assert_non_null(range);
            assert_true(fabs(strtod(range + 1, NULL) - least) <= 1e-8);
            assert_non_null(strstr(watch.log, ", 1]"));
        }
    const double bad_sigma_a[] = {NAN, INFINITY, -1e-9, 1.1e6};
    for (int i = 0; i < 4; i++) {
        double in[3] = {0.5, 0.5, bad_sigma_a[i]}, out[3] = {9, 9, 9};
        watch_quiet(&watch);
        assert_int_equal(tsu_hair_head_albedo(context, &curve, in, out), TSU_E_PARAMETER);
        assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
        assert_non_null(strstr(watch.log, "sigma_a = "));
        assert_non_null(strstr(watch.log, "[0, 1000000]"));
    }
}

static void refuse_curve(const tsu_hair_head_curve *curve, tsu_status status)
{
    double out[3] = {0.5, 0.5, 0.5}, same[3] = {0.5, 0.5, 0.5};
    watch_quiet(&watch);
    assert_int_equal(tsu_hair_head_sigma_a(context, curve, out, out), status);
    assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
    assert_int_equal(watch.log_count, 1);
    assert_non_null(strstr(watch.log, "tsu_hair_head_curve"));
    assert_int_equal(tsu_hair_head_albedo(context, curve, same, same), status);
    assert_true(same[0] == 0 && same[1] == 0 && same[2] == 0);
}

static void broken_curves_are_refused(void **state)
{
    (void)state;
    const tsu_hair_head_desc desc = usual();
    const tsu_hair_head_curve whole = curve_of(&desc);
    tsu_hair_head_curve curve = empty();
    refuse_curve(&curve, TSU_E_PARAMETER);
    for (int i = 0; i <= LAST; i++) {
        curve = whole;
        curve.albedo[i] = NAN;
        refuse_curve(&curve, TSU_E_PARAMETER);
        curve.albedo[i] = i ? whole.albedo[i - 1] * (1.0 + 1e-9) : 1.1;
        refuse_curve(&curve, TSU_E_PARAMETER);
    }
    curve = whole;
    curve.struct_size = sizeof curve - 8;
    refuse_curve(&curve, TSU_E_STRUCT);
    refuse_curve(NULL, TSU_E_STRUCT);
}

int head_tests(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, open_watch, close_watch)
    const struct CMUnitTest tests[] = {
        TEST(the_default_is_the_default_fibre), TEST(albedo_falls_and_comes_back),
        TEST(a_head_is_darker_than_its_fibres), TEST(other_fibres_are_solved),
        TEST(impossible_fibres_are_explained),  TEST(impossible_colours_are_explained),
        TEST(broken_curves_are_refused),
    };
    return cmocka_run_group_tests_name("head", tests, NULL, NULL);
}

// Thickness and scale of leaves: every bad field is explained, every extreme one is finite.
#include "leaf_scale_rig.h"
#include "tests.h"
#include "watched.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static tsu_leaf_verdict judge(const tsu_leaf_scale *scale, double pixel, double curvature,
                              double tolerance)
{
    tsu_leaf_verdict verdict;
    assert_int_equal(tsu_leaf_verdict_init(&verdict), TSU_OK);
    assert_int_equal(tsu_leaf_scale_judge(context, scale, pixel, curvature, tolerance, &verdict),
                     TSU_OK);
    return verdict;
}

static void refuse(const tsu_leaf_scale_desc *desc, tsu_status status, const char *part)
{
    tsu_leaf_scale scale = scale_empty();
    scale.thickness = 7.0f;
    watch_quiet(&watch);
    assert_int_equal(tsu_leaf_scale_solve(context, desc, &scale), status);
    const tsu_leaf_scale none = scale_empty();
    assert_memory_equal(&scale, &none, sizeof none);
    assert_int_equal(watch.log_count, 1);
    assert_non_null(strstr(watch.log, part));
}

static void impossible_leaves_are_explained(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        const char *name;
        float bad[2];
    } fields[] = {
        {offsetof(tsu_leaf_scale_desc, n), ".n", {0.99f, 2.01f}},
        {offsetof(tsu_leaf_scale_desc, g), ".g", {-0.01f, 0.81f}},
        {offsetof(tsu_leaf_scale_desc, thickness), ".thickness", {0.0f, 1001.0f}},
        {offsetof(tsu_leaf_scale_desc, share_top), ".share_top", {0.04f, 0.96f}},
        {offsetof(tsu_leaf_scale_desc, scatter_top[1]), ".scatter_top", {-0.1f, 5.1f}},
        {offsetof(tsu_leaf_scale_desc, absorption_top[2]), ".absorption_top", {-0.1f, 10.1f}},
        {offsetof(tsu_leaf_scale_desc, scatter_bottom[0]), ".scatter_bottom", {-0.1f, 5.1f}},
        {offsetof(tsu_leaf_scale_desc, absorption_bottom[0]), ".absorption_bottom", {-0.1f, 10.1f}},
        {offsetof(tsu_leaf_scale_desc, fraction), ".fraction", {0.04f, 1.0f}},
        {offsetof(tsu_leaf_scale_desc, reserved), ".reserved", {1.0f, -1.0f}}};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        const float bad[] = {fields[i].bad[0], fields[i].bad[1], NAN, INFINITY, -INFINITY};
        for (int k = 0; k < 5; k++) {
            tsu_leaf_scale_desc desc = scale_usual();
            memcpy((char *)&desc + fields[i].offset, bad + k, sizeof *bad);
            refuse(&desc, TSU_E_PARAMETER, fields[i].name);
        }
    }
    tsu_leaf_scale_desc desc = scale_usual();
    desc.flags = 2;
    refuse(&desc, TSU_E_PARAMETER, ".flags = 2");
    desc = scale_usual();
    desc.method = 6;
    refuse(&desc, TSU_E_PARAMETER, ".method = 6");
    desc = scale_usual();
    desc.gaussians = 1;
    refuse(&desc, TSU_E_PARAMETER, ".gaussians = 1");
    desc.gaussians = 7;
    refuse(&desc, TSU_E_PARAMETER, ".gaussians = 7");
    desc = scale_usual();
    desc.struct_size = 0;
    refuse(&desc, TSU_E_STRUCT, "tsu_leaf_scale_desc_init()");
    refuse(NULL, TSU_E_STRUCT, "NULL");
    assert_int_equal(tsu_leaf_scale_desc_init_sized(&desc, 8), TSU_E_STRUCT);
    assert_int_equal(tsu_leaf_scale_desc_init_sized(NULL, sizeof desc), TSU_E_STRUCT);
    desc = scale_usual();
    assert_int_equal(tsu_leaf_scale_solve(context, &desc, NULL), TSU_E_PARAMETER);
    tsu_leaf_scale scale = scale_empty();
    assert_int_equal(tsu_leaf_scale_solve(NULL, &desc, &scale), TSU_E_PARAMETER);
}

// The ends of every range give finite numbers.
static void extreme_leaves_are_finite(void **state)
{
    (void)state;
    static const float ends[][5] = {
        {1.0f, 0.0f, 0.0f, 0.0f, 1e-3f},  {2.0f, 0.8f, 5.0f, 0.0f, 1e3f},
        {1.0f, 0.8f, 5.0f, 10.0f, 1.0f},  {2.0f, 0.0f, 0.0f, 10.0f, 0.2f},
        {1.5f, 0.5f, 1e-6f, 1e-6f, 0.2f}, {1.3f, 0.8f, 5.0f, 1e-6f, 0.2f}};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        const double scatter[3] = {2.0 * (double)ends[i][2], 2.0 * (double)ends[i][2], 1.0};
        const double absorption[3] = {2.0 * (double)ends[i][3], 0.0, 2.0 * (double)ends[i][3]};
        tsu_leaf_scale_desc desc = scale_leaf(scatter, absorption);
        desc.n = ends[i][0];
        desc.g = ends[i][1];
        desc.thickness = ends[i][4];
        desc.gaussians = i % 2 ? 2 : 6;
        desc.share_top = i % 2 ? 0.05f : 0.95f;
        const tsu_leaf_scale scale = scale_solve(&desc);
        for (int c = 0; c < 3; c++) {
            assert_true(scale.reflectance[c] >= 0.0f && scale.transmittance[c] >= 0.0f);
            assert_true(scale.reflectance[c] + scale.transmittance[c] + scale.straight[c] <= 1.02f);
            assert_true(scale.reflected_radius[c] >= 0.0f &&
                        scale.reflected_radius[c] < 60.0f * desc.thickness);
            assert_true(scale.transmitted_radius[c] >= 0.0f &&
                        scale.transmitted_radius[c] < 60.0f * desc.thickness);
        }
        for (int j = 0; j < 24; j++)
            assert_true(isfinite(scale.reflected[j]) && isfinite(scale.transmitted[j]));
        const tsu_leaf_verdict v = judge(&scale, 0.3, 20.0, 0.1);
        for (int side = 0; side < 2; side++)
            assert_true(isfinite(v.pixel_error[side]) && v.pixel_error[side] <= 0.5f &&
                        isfinite(v.curvature_error[side]) && isfinite(v.pixel[side]));
    }
}

static void refuse_judge(const tsu_leaf_scale *scale, double pixel, double curvature,
                         double tolerance, tsu_status status, const char *part)
{
    tsu_leaf_verdict verdict;
    assert_int_equal(tsu_leaf_verdict_init(&verdict), TSU_OK);
    verdict.flags = 3;
    watch_quiet(&watch);
    assert_int_equal(tsu_leaf_scale_judge(context, scale, pixel, curvature, tolerance, &verdict),
                     status);
    assert_true(verdict.flags == 0 && verdict.struct_size == sizeof verdict);
    assert_int_equal(watch.log_count, 1);
    assert_non_null(strstr(watch.log, part));
}

static void impossible_questions_are_explained(void **state)
{
    (void)state;
    const tsu_leaf_scale_desc desc = scale_usual();
    const tsu_leaf_scale whole = scale_solve(&desc);
    const double bad[] = {0.0, -1.0, 1e10, NAN, INFINITY};
    for (int i = 0; i < 5; i++) {
        refuse_judge(&whole, bad[i], 10, 0.1, TSU_E_PARAMETER, "pixel_mm = ");
        refuse_judge(&whole, 1, bad[i], 0.1, TSU_E_PARAMETER, "curvature_mm = ");
        refuse_judge(&whole, 1, 10, bad[i], TSU_E_PARAMETER, "tolerance = ");
    }
    tsu_leaf_scale scale = scale_empty();
    refuse_judge(&scale, 1, 10, 0.1, TSU_E_PARAMETER, "tsu_leaf_scale_solve()");
    scale = whole;
    scale.transmitted[5] = NAN;
    refuse_judge(&scale, 1, 10, 0.1, TSU_E_PARAMETER, "tsu_leaf_scale_solve()");
    scale = whole;
    scale.reflected[3] = 0.0f;
    refuse_judge(&scale, 1, 10, 0.1, TSU_E_PARAMETER, "tsu_leaf_scale_solve()");
    scale = whole;
    scale.gaussians = 7;
    refuse_judge(&scale, 1, 10, 0.1, TSU_E_PARAMETER, "tsu_leaf_scale_solve()");
    scale = whole;
    scale.struct_size -= 4;
    refuse_judge(&scale, 1, 10, 0.1, TSU_E_STRUCT, "tsu_leaf_scale");
    refuse_judge(NULL, 1, 10, 0.1, TSU_E_STRUCT, "NULL");
    tsu_leaf_verdict verdict;
    assert_int_equal(tsu_leaf_scale_judge(context, &whole, 1, 10, 0.1, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_leaf_verdict_init(&verdict), TSU_OK);
    assert_int_equal(tsu_leaf_scale_judge(NULL, &whole, 1, 10, 0.1, &verdict), TSU_E_PARAMETER);
}

int leaf_scale_edge_tests(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, open_watch, close_watch)
    const struct CMUnitTest tests[] = {
        TEST(impossible_leaves_are_explained),
        TEST(extreme_leaves_are_finite),
        TEST(impossible_questions_are_explained),
    };
    return cmocka_run_group_tests_name("leaf scale edges", tests, NULL, NULL);
}

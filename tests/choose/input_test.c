// What comes in wrong: every field is named with its range, nothing is half written.
#include "tests.h"
#include "watched.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

static tsu_choose_desc usual(tsu_choose_kind kind)
{
    tsu_choose_desc desc;
    assert_int_equal(tsu_choose_desc_init(&desc), TSU_OK);
    desc.kind = kind;
    return desc;
}

// All three questions refuse, say so in one line each and leave zeros.
static void refuse(const tsu_choose_desc *desc, tsu_status status, const char *part)
{
    tsu_choice choice, no_choice;
    tsu_prediction one, no_one;
    float gain = 7.0f;
    memset(&choice, 0x55, sizeof choice);
    memset(&one, 0x55, sizeof one);
    choice.struct_size = sizeof choice;
    one.struct_size = sizeof one;
    tsu_choice_init(&no_choice);
    tsu_prediction_init(&no_one);
    const tsu_tier tier = tsu_tier_find(desc->kind == TSU_CHOOSE_LEAF ? "leaf" : "exact");
    watch_quiet(&watch);
    assert_int_equal(tsu_choose(context, desc, &choice), status);
    assert_memory_equal(&choice, &no_choice, sizeof choice);
    assert_int_equal(watch.log_count, 1);
    assert_non_null(strstr(watch.log, part));
    watch_quiet(&watch);
    assert_int_equal(tsu_choose_predict(context, desc, tier, &one), status);
    assert_memory_equal(&one, &no_one, sizeof one);
    assert_non_null(strstr(watch.log, part));
    watch_quiet(&watch);
    assert_int_equal(tsu_choose_match(context, desc, tier, tier, &gain), status);
    assert_true(gain == 0.0f);
    assert_non_null(strstr(watch.log, part));
}

#define FIELD(name) offsetof(tsu_choose_desc, name)
static const struct {
    tsu_choose_kind kind;
    size_t offset;
    const char *name;
    float bad[2];
} floats[] = {{TSU_CHOOSE_HAIR, FIELD(sigma_a[0]), ".sigma_a = ", {-0.001f, 1.1e6f}},
              {TSU_CHOOSE_HAIR, FIELD(sigma_a[2]), ".sigma_a = ", {-0.001f, 1.1e6f}},
              {TSU_CHOOSE_HAIR, FIELD(beta_R), ".beta_R = ", {0.03f, 0.53f}},
              {TSU_CHOOSE_HAIR, FIELD(strand_pixels), ".strand_pixels = ", {0.0f, 2e4f}},
              {TSU_CHOOSE_HAIR, FIELD(depth), ".depth = ", {-1.0f, 1.1e6f}},
              {TSU_CHOOSE_HAIR, FIELD(curl), ".curl = ", {-0.1f, 1.1f}},
              {TSU_CHOOSE_HAIR, FIELD(sky_share), ".sky_share = ", {-0.1f, 1.1f}},
              {TSU_CHOOSE_HAIR, FIELD(light_cosine), ".light_cosine = ", {-1.1f, 1.1f}},
              {TSU_CHOOSE_LEAF, FIELD(R_top[1]), ".R_top = ", {-0.1f, 1.1f}},
              {TSU_CHOOSE_LEAF, FIELD(R_bottom[0]), ".R_bottom = ", {-0.1f, 1.1f}},
              {TSU_CHOOSE_LEAF, FIELD(T[2]), ".T = ", {-0.1f, 1.1f}},
              {TSU_CHOOSE_LEAF, FIELD(footprint), ".footprint = ", {0.0f, 1.1e6f}},
              {TSU_CHOOSE_LEAF, FIELD(curvature), ".curvature = ", {0.0f, 1.1e9f}},
              {TSU_CHOOSE_LEAF, FIELD(spread_R), ".spread_R = ", {-0.1f, 1.1e3f}},
              {TSU_CHOOSE_LEAF, FIELD(spread_T), ".spread_T = ", {-0.1f, 1.1e3f}},
              {TSU_CHOOSE_HAIR, FIELD(covered_pixels), ".covered_pixels = ", {-1.0f, 1.1e12f}},
              {TSU_CHOOSE_LEAF, FIELD(error_bound), ".error_bound = ", {9e-7f, 1.1e6f}},
              {TSU_CHOOSE_HAIR, FIELD(luminance_bound), ".luminance_bound = ", {1e-45f, 1.1e6f}},
              {TSU_CHOOSE_HAIR, FIELD(cost_budget), ".cost_budget = ", {9e-4f, 1.1e12f}},
              {TSU_CHOOSE_HAIR, FIELD(hysteresis), ".hysteresis = ", {-0.1f, 1.1f}}};

static const struct {
    tsu_choose_kind kind;
    size_t offset;
    const char *name;
    int32_t bad[2];
} whole[] = {{TSU_CHOOSE_HAIR, FIELD(kind), ".kind = ", {0, 3}},
             {TSU_CHOOSE_HAIR, FIELD(flags), ".flags = ", {8, -1}},
             {TSU_CHOOSE_HAIR, FIELD(shadow), ".shadow = ", {0, 4}},
             {TSU_CHOOSE_HAIR, FIELD(directional_lights), ".directional_lights = ", {1001, -1}},
             {TSU_CHOOSE_HAIR, FIELD(point_lights), ".point_lights = ", {1001, -1}},
             {TSU_CHOOSE_LEAF, FIELD(area_lights), ".area_lights = ", {1001, -1}},
             {TSU_CHOOSE_HAIR, FIELD(environments), ".environments = ", {1001, -1}},
             {TSU_CHOOSE_HAIR, FIELD(target), ".target = ", {0, 7}},
             {TSU_CHOOSE_HAIR, FIELD(gpu), ".gpu = ", {0, 5}},
             {TSU_CHOOSE_HAIR, FIELD(previous), ".previous = ", {-2, 1000}}};

static void impossible_scenes_are_explained(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof floats / sizeof *floats; i++) {
        const float bad[] = {floats[i].bad[0], floats[i].bad[1], NAN, INFINITY, -INFINITY};
        for (int k = 0; k < 5; k++) {
            tsu_choose_desc desc = usual(floats[i].kind);
            memcpy((char *)&desc + floats[i].offset, bad + k, sizeof *bad);
            refuse(&desc, TSU_E_PARAMETER, floats[i].name);
            assert_non_null(strstr(watch.log, ", expected ["));
        }
    }
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++)
        for (int k = 0; k < 2; k++) {
            tsu_choose_desc desc = usual(whole[i].kind);
            memcpy((char *)&desc + whole[i].offset, whole[i].bad + k, sizeof(int32_t));
            refuse(&desc, TSU_E_PARAMETER, whole[i].name);
            assert_non_null(strstr(watch.log, ", expected "));
        }
    tsu_choose_desc desc = usual(TSU_CHOOSE_LEAF);
    desc.R_top[1] = 0.6f;
    desc.T[1] = 0.5f;
    refuse(&desc, TSU_E_PARAMETER, ".R_top + T = ");
    desc.R_top[1] = 0.1f;
    desc.R_bottom[1] = 0.6f;
    refuse(&desc, TSU_E_PARAMETER, ".R_bottom + T = ");
    desc = usual(TSU_CHOOSE_LEAF);
    desc.previous = tsu_tier_find("exact");
    refuse(&desc, TSU_E_PARAMETER, ".previous = ");
}

// A leaf's description may hold anything for hair, and the other way round.
static void fields_of_the_other_kind_are_not_looked_at(void **state)
{
    (void)state;
    const float bad = NAN;
    for (size_t i = 0; i < 15; i++) {
        tsu_choose_desc desc =
            usual(floats[i].kind == TSU_CHOOSE_HAIR ? TSU_CHOOSE_LEAF : TSU_CHOOSE_HAIR);
        tsu_choice choice;
        tsu_choice_init(&choice);
        memcpy((char *)&desc + floats[i].offset, &bad, sizeof bad);
        assert_int_equal(tsu_choose(context, &desc, &choice), TSU_OK);
        assert_true(choice.error >= 0.0f && choice.error < 1e6f);
    }
}

static void the_ends_of_the_ranges_have_finite_answers(void **state)
{
    (void)state;
    static const float ends[][2] = {{0.0f, 1e6f},  {0.0f, 1e6f}, {0.034907f, 0.52359f},
                                    {1e-4f, 1e4f}, {0.0f, 1e6f}, {0.0f, 1.0f},
                                    {0.0f, 1.0f},  {-1.0f, 1.0f}};
    for (unsigned corner = 0; corner < 256; corner++) {
        tsu_choose_desc desc = usual(TSU_CHOOSE_HAIR);
        tsu_choice choice;
        tsu_choice_init(&choice);
        for (unsigned i = 0; i < 8; i++)
            memcpy((char *)&desc + floats[i].offset, &ends[i][corner >> i & 1], sizeof(float));
        desc.sigma_a[1] = desc.sigma_a[0];
        desc.error_bound = corner & 1 ? 1e6f : 1e-6f;
        desc.area_lights = desc.environments = 1000;
        desc.covered_pixels = 1e12f;
        assert_int_equal(tsu_choose(context, &desc, &choice), TSU_OK);
        assert_true(isfinite(choice.error_high) && isfinite(choice.luminance_high));
        assert_true(isfinite(choice.frame_cost) && isfinite(choice.miss));
        assert_non_null(strstr(choice.reason, "Outside of what was measured: "));
        assert_true(choice.outside != 0);
    }
}

static void a_host_without_room_is_told(void **state)
{
    (void)state;
    tsu_choose_desc desc = usual(TSU_CHOOSE_LEAF);
    tsu_choice choice, none;
    desc.flags = TSU_CHOOSE_PIGMENT_MAP;
    desc.samplers = 0;
    tsu_choice_init(&choice);
    tsu_choice_init(&none);
    watch_quiet(&watch);
    assert_int_equal(tsu_choose(context, &desc, &choice), TSU_E_LIMIT);
    assert_memory_equal(&choice, &none, sizeof none);
    assert_non_null(strstr(watch.log, "samplers"));
    desc.samplers = 16;
    desc.memory = 100;
    watch_quiet(&watch);
    assert_int_equal(tsu_choose(context, &desc, &choice), TSU_E_LIMIT);
    assert_non_null(strstr(watch.log, "memory"));
}

static void nothing_is_nothing(void **state)
{
    (void)state;
    tsu_choose_desc desc = usual(TSU_CHOOSE_HAIR);
    tsu_choice choice;
    tsu_prediction one;
    tsu_tier_info info;
    float gain;
    tsu_choice_init(&choice);
    tsu_prediction_init(&one);
    tsu_tier_info_init(&info);
    assert_int_equal(tsu_choose_desc_init_sized(NULL, sizeof desc), TSU_E_STRUCT);
    assert_int_equal(tsu_choose_desc_init_sized(&desc, sizeof desc - 1), TSU_E_STRUCT);
    assert_int_equal(tsu_choose(context, NULL, &choice), TSU_E_STRUCT);
    assert_true(tsu_choose(context, &desc, NULL) < 0);
    assert_int_equal(tsu_choose(NULL, &desc, &choice), TSU_OK); // no context, no log
    assert_true(tsu_choose_predict(context, &desc, 0, NULL) < 0);
    assert_int_equal(tsu_choose_predict(context, NULL, 0, &one), TSU_E_STRUCT);
    assert_int_equal(tsu_choose_predict(context, &desc, TSU_TIER_NONE, &one), TSU_E_PARAMETER);
    assert_int_equal(tsu_choose_predict(context, &desc, tsu_tier_find("leaf"), &one),
                     TSU_E_PARAMETER);
    assert_non_null(strstr(watch.log, "expected a tier of hair"));
    assert_true(tsu_choose_match(context, &desc, 0, 0, NULL) < 0);
    assert_int_equal(tsu_choose_match(context, &desc, 0, 1000, &gain), TSU_E_PARAMETER);
    assert_int_equal(tsu_choose_match(context, &desc, TSU_TIER_NONE, 0, &gain), TSU_E_PARAMETER);
    assert_int_equal(tsu_choose_match(context, NULL, 0, 0, &gain), TSU_E_STRUCT);
    assert_true(tsu_tier_describe(0, NULL) < 0);
    assert_int_equal(tsu_tier_describe(TSU_TIER_NONE, &info), TSU_E_PARAMETER);
    assert_int_equal(tsu_tier_describe(1000, &info), TSU_E_PARAMETER);
    info.struct_size = 0;
    assert_int_equal(tsu_tier_describe(0, &info), TSU_E_STRUCT);
    choice.struct_size = 0;
    assert_int_equal(tsu_choose(context, &desc, &choice), TSU_E_STRUCT);
}

int input_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impossible_scenes_are_explained),
        cmocka_unit_test(fields_of_the_other_kind_are_not_looked_at),
        cmocka_unit_test(the_ends_of_the_ranges_have_finite_answers),
        cmocka_unit_test(a_host_without_room_is_told),
        cmocka_unit_test(nothing_is_nothing),
    };
    return cmocka_run_group_tests_name("input", tests, open_watch, close_watch);
}

// Leaves: errors are those of the nearest leaf of the table, and what light and pixels ask for.
#include "choose/trade.h"
#include "scenes.h"
#include "tests.h"
#include "watched.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

static tsu_choose_desc leaf_of(uint32_t species)
{
    tsu_choose_desc desc;
    assert_int_equal(tsu_choose_desc_init(&desc), TSU_OK);
    desc.kind = TSU_CHOOSE_LEAF;
    for (int c = 0; c < 3; c++) {
        desc.R_top[c] = (float)tsu_i_trade.species[species].color[c];
        desc.R_bottom[c] = (float)tsu_i_trade.species[species].color[3 + c];
        desc.T[c] = (float)tsu_i_trade.species[species].color[6 + c];
    }
    return desc;
}

static tsu_choice choose(const tsu_choose_desc *desc)
{
    tsu_choice choice;
    assert_int_equal(tsu_choice_init(&choice), TSU_OK);
    assert_int_equal(tsu_choose(context, desc, &choice), TSU_OK);
    return choice;
}

static tsu_prediction predict(const tsu_choose_desc *desc, const char *tier)
{
    tsu_prediction one;
    assert_int_equal(tsu_prediction_init(&one), TSU_OK);
    assert_int_equal(tsu_choose_predict(context, desc, tsu_tier_find(tier), &one), TSU_OK);
    return one;
}

static void errors_are_those_of_the_nearest_leaf(void **state)
{
    (void)state;
    for (uint32_t s = 0; s < tsu_i_trade.species_count; s++)
        for (uint32_t t = 0; t < tsu_i_trade.tier_count; t++) {
            const struct tsu_i_trade_tier *tier = tsu_i_trade.tiers + t;
            if (tier->kind != TSU_CHOOSE_LEAF)
                continue;
            tsu_choose_desc desc = leaf_of(s);
            assert_true(predict(&desc, tier->name).error == (float)tier->reflected[s]);
            desc.flags = TSU_CHOOSE_BACKLIT;
            assert_true(predict(&desc, tier->name).error ==
                        (float)fmax(tier->reflected[s], tier->transmitted[s]));
            assert_non_null(strstr(choose(&desc).reason, tsu_i_trade.species[s].name));
            desc.R_top[1] *= 1.02f;
            assert_true(predict(&desc, tier->name).error ==
                        (float)fmax(tier->reflected[s], tier->transmitted[s]));
        }
}

static void no_leaf_is_blue(void **state)
{
    (void)state;
    tsu_choose_desc desc = leaf_of(0);
    desc.R_top[2] = desc.R_bottom[2] = 0.9f;
    desc.R_top[0] = desc.R_bottom[0] = desc.T[0] = 0.0f;
    const tsu_choice choice = choose(&desc);
    assert_int_equal(choice.outside, TSU_OUTSIDE_COLOR);
    assert_non_null(strstr(choice.reason, "colour"));
    assert_true(
        predict(&desc, "leaf_body").error ==
        (float)tsu_i_trade.tiers[tsu_tier_find("leaf_body")].reflected[tsu_i_trade.species_count]);
}

static void what_is_wanted_decides_what_is_possible(void **state)
{
    (void)state;
    tsu_choose_desc desc = leaf_of(0);
    desc.error_bound = 0.1f;
    tsu_choice choice = choose(&desc);
    assert_true(predict(&desc, "leaf").lacks & TSU_LACKS_COAT);
    assert_int_equal(choice.drop, TSU_SHADER_DROP_TRANSMITTED);
    desc.flags = TSU_CHOOSE_BACKLIT;
    assert_int_equal(choose(&desc).drop, 0);
    // Gloss is most of what a leaf reflects at its peak: who wants it gets a coat.
    desc.flags = TSU_CHOOSE_COAT;
    choice = choose(&desc);
    assert_ptr_equal(choice.model, tsu_leaf());
    assert_string_equal(choice.variant, "uniform"); // one pigment, and cheaper
    assert_true(predict(&desc, "leaf_body").error > 0.5f);
    desc.flags |= TSU_CHOOSE_PIGMENT_MAP;
    choice = choose(&desc);
    assert_ptr_equal(choice.model, tsu_leaf());
    assert_string_equal(choice.variant, "");
    assert_true(predict(&desc, "leaf_uniform").lacks & TSU_LACKS_MAP);
}

// tsu_leaf_scale_judge() says from which pixel on a BRDF is enough: the chooser's bound is no
// smaller and at most 1.6 times as large.
static void close_pixels_ask_for_a_blur(void **state)
{
    (void)state;
    tsu_leaf_scale_desc scale_desc;
    tsu_leaf_scale scale;
    tsu_leaf_verdict verdict;
    tsu_leaf_scale_desc_init(&scale_desc);
    tsu_leaf_scale_init(&scale);
    tsu_leaf_verdict_init(&verdict);
    assert_int_equal(tsu_leaf_scale_solve(context, &scale_desc, &scale), TSU_OK);
    assert_int_equal(tsu_leaf_scale_judge(context, &scale, 1.0, 1e9, 0.1, &verdict), TSU_OK);
    tsu_choose_desc desc = leaf_of(0);
    desc.flags = TSU_CHOOSE_BACKLIT;
    for (int c = 0; c < 3; c++) {
        desc.spread_R = fmaxf(desc.spread_R, scale.reflected_radius[c]);
        desc.spread_T = fmaxf(desc.spread_T, scale.transmitted_radius[c]);
    }
    const float enough = fmaxf(verdict.pixel[0], verdict.pixel[1]);
    desc.footprint = 0.999f * enough;
    assert_int_equal(choose(&desc).passes, TSU_PASS_BLUR);
    desc.footprint = 1.6f * enough;
    assert_int_equal(choose(&desc).passes, 0);
    desc.footprint = 1e-3f;
    desc.error_bound = 0.49f;
    assert_int_equal(choose(&desc).passes, TSU_PASS_BLUR);
    // Curvature.
    desc = leaf_of(0);
    desc.curvature = 1.0f;
    assert_int_equal(choose(&desc).outside, TSU_OUTSIDE_CURVATURE);
    desc.curvature = 10.0f;
    assert_int_equal(choose(&desc).outside, 0);
}

int leaf_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_those_of_the_nearest_leaf),
        cmocka_unit_test(no_leaf_is_blue),
        cmocka_unit_test(what_is_wanted_decides_what_is_possible),
        cmocka_unit_test(close_pixels_ask_for_a_blur),
    };
    return cmocka_run_group_tests_name("leaf", tests, open_watch, close_watch);
}

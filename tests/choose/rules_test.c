// The answer against the rules of tsuya/choose.h, applied here once more to every tier's
// prediction.
#include "scenes.h"
#include "tests.h"
#include "watched.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { SCENES = 400, MOST = 32 };
static tsu_choice choose(const tsu_choose_desc *desc)
{
    tsu_choice choice;
    assert_int_equal(tsu_choice_init(&choice), TSU_OK);
    assert_int_equal(tsu_choose(context, desc, &choice), TSU_OK);
    return choice;
}

static tsu_prediction predict(const tsu_choose_desc *desc, tsu_tier tier)
{
    tsu_prediction one;
    assert_int_equal(tsu_prediction_init(&one), TSU_OK);
    assert_int_equal(tsu_choose_predict(context, desc, tier, &one), TSU_OK);
    return one;
}

static tsu_tier_info tier_info(tsu_tier tier)
{
    tsu_tier_info info;
    assert_int_equal(tsu_tier_info_init(&info), TSU_OK);
    assert_int_equal(tsu_tier_describe(tier, &info), TSU_OK);
    return info;
}

// All tiers of the kind; those that the host lacks have no model here.
struct field {
    int count;
    tsu_tier tier[MOST];
    tsu_prediction one[MOST];
};

static struct field field_of(const tsu_choose_desc *desc)
{
    struct field field = {0};
    for (tsu_tier t = 0; t < (tsu_tier)tsu_tier_count(); t++) {
        if (tier_info(t).kind != desc->kind)
            continue;
        const tsu_prediction one = predict(desc, t);
        if (one.lacks)
            continue;
        field.tier[field.count] = t;
        field.one[field.count++] = one;
    }
    return field;
}

static double excess(const tsu_choose_desc *desc, const tsu_prediction *one)
{
    double x = 0.0;
    if (desc->error_bound > 0.0f)
        x = (double)one->error_high / (double)desc->error_bound;
    if (desc->luminance_bound > 0.0f)
        x = fmax(x, (double)one->luminance_high / (double)desc->luminance_bound);
    return x;
}

static int affordable(const tsu_choose_desc *desc, const tsu_prediction *one)
{
    return desc->cost_budget <= 0.0f || one->cost <= desc->cost_budget;
}

static const tsu_prediction *chosen(const struct field *field, const tsu_choice *choice)
{
    for (int i = 0; i < field->count; i++)
        if (field->tier[i] == choice->tier)
            return field->one + i;
    fail_msg("a tier that the host lacks was chosen");
    return NULL;
}

static void check_bound(const tsu_choose_desc *desc, const struct field *field,
                        const tsu_choice *choice, const tsu_prediction *own)
{
    int bounded = 0, affords = 0, both = 0;
    double least = INFINITY, nearest = INFINITY;
    for (int i = 0; i < field->count; i++) {
        const tsu_prediction *one = field->one + i;
        const int in = excess(desc, one) <= 1.0, pays = affordable(desc, one);
        bounded += in;
        affords += pays;
        both += in && pays;
        if (in && pays)
            least = fmin(least, (double)one->cost);
        if (pays)
            nearest = fmin(nearest, excess(desc, one));
    }
    if (both) {
        assert_int_equal(choice->status, TSU_CHOICE_MET);
        assert_true(excess(desc, own) <= 1.0 && affordable(desc, own));
        assert_true((double)own->cost <= 1.05 * least * 1.000001);
        for (int i = 0; i < field->count; i++) // equal costs go to the smaller error
            if (excess(desc, field->one + i) <= 1.0 && affordable(desc, field->one + i) &&
                (double)field->one[i].cost <= 1.05 * least)
                assert_true(own->error_high <= field->one[i].error_high);
        assert_true(choice->miss == 0.0f && choice->over == 0.0f);
    } else if (affords) {
        assert_int_equal(choice->status, bounded ? TSU_CHOICE_CONFLICT : TSU_CHOICE_MISSED);
        assert_true(affordable(desc, own) && excess(desc, own) <= nearest * 1.000001);
        assert_float_equal(choice->miss, nearest - 1.0, 1e-5 * nearest);
    } else {
        assert_int_equal(choice->status, TSU_CHOICE_OVER_BUDGET);
        for (int i = 0; i < field->count; i++)
            assert_true(own->cost <= field->one[i].cost);
        assert_float_equal(choice->over, own->cost / desc->cost_budget - 1.0f,
                           1e-5f * own->cost / desc->cost_budget);
    }
}

static void check_free(const tsu_choose_desc *desc, const struct field *field,
                       const tsu_choice *choice, const tsu_prediction *own)
{
    int affords = 0;
    for (int i = 0; i < field->count; i++)
        affords += affordable(desc, field->one + i);
    assert_int_equal(choice->status, affords ? TSU_CHOICE_MET : TSU_CHOICE_OVER_BUDGET);
    for (int i = 0; i < field->count; i++) {
        if (affords)
            assert_true(!affordable(desc, field->one + i) ||
                        own->error_high <= field->one[i].error_high);
        else
            assert_true(own->cost <= field->one[i].cost);
    }
}

static void check_neighbours(const struct field *field, const tsu_choice *choice,
                             const tsu_prediction *own)
{
    double better = INFINITY, cheaper = INFINITY;
    for (int i = 0; i < field->count; i++) {
        const tsu_prediction *one = field->one + i;
        if (one->error < own->error)
            better = fmin(better, (double)one->cost);
        if (one->cost < own->cost)
            cheaper = fmin(cheaper, (double)one->error);
    }
    assert_int_equal(choice->better != TSU_TIER_NONE, isfinite(better));
    assert_int_equal(choice->cheaper != TSU_TIER_NONE, isfinite(cheaper));
    if (isfinite(better)) {
        assert_true((double)choice->better_cost == better && choice->better_error < own->error);
        assert_true(choice->better != choice->tier);
    }
    if (isfinite(cheaper))
        assert_true((double)choice->cheaper_error == cheaper && choice->cheaper_cost < own->cost);
}

static void check(const tsu_choose_desc *desc)
{
    const tsu_choice choice = choose(desc);
    const struct field field = field_of(desc);
    const tsu_prediction *own = chosen(&field, &choice);
    const tsu_tier_info info = tier_info(choice.tier);
    assert_ptr_equal(choice.model, info.model);
    assert_string_equal(choice.variant, info.variant);
    assert_true(choice.error == own->error && choice.error_high == own->error_high);
    assert_true(choice.luminance == own->luminance && choice.cost == own->cost);
    assert_true(choice.error_high >= choice.error && choice.error >= 0.0f);
    assert_true(choice.luminance_high >= fabsf(choice.luminance) * 0.999999f);
    assert_true(isfinite(choice.error_high) && isfinite(choice.luminance_high));
    assert_float_equal(choice.frame_cost, choice.cost * desc->covered_pixels,
                       1e-5f * choice.frame_cost);
    assert_int_equal(choice.flags, 0);
    if (desc->error_bound > 0.0f || desc->luminance_bound > 0.0f)
        check_bound(desc, &field, &choice, own);
    else
        check_free(desc, &field, &choice, own);
    check_neighbours(&field, &choice, own);

    char number[32];
    snprintf(number, sizeof number, " %.0f clocks", (double)choice.cost);
    assert_memory_equal(choice.reason, info.name, strlen(info.name));
    assert_non_null(strstr(choice.reason, number));
    assert_non_null(strstr(choice.reason, " %"));
    assert_true(strlen(choice.reason) < sizeof choice.reason);
}

// Every kind of wish on scenes at random.
static void answers_follow_the_rules(void **state)
{
    (void)state;
    struct scenes scenes = {1};
    int statuses[5] = {0};
    for (int i = 0; i < SCENES; i++) {
        tsu_choose_desc desc = i % 4 ? scenes_hair(&scenes) : scenes_leaf(&scenes);
        const double budget = exp(scenes_between(&scenes, log(50.0), log(30000.0)));
        const double bound = exp(scenes_between(&scenes, log(0.002), log(4.0)));
        desc.shadow = 1 + (int32_t)scenes_between(&scenes, 0.0, 3.0);
        desc.gpu = 1 + (int32_t)scenes_between(&scenes, 0.0, 4.0);
        check(&desc);
        desc.cost_budget = (float)budget;
        check(&desc);
        desc.error_bound = (float)bound;
        check(&desc);
        statuses[choose(&desc).status]++;
        desc.luminance_bound = (float)scenes_between(&scenes, 0.01, 1.0);
        check(&desc);
        desc.cost_budget = 0.0f;
        check(&desc);
        statuses[choose(&desc).status]++;
    }
    for (int status = TSU_CHOICE_MET; status <= TSU_CHOICE_CONFLICT; status++)
        assert_true(statuses[status] > 0);
}

static void a_looser_bound_never_costs_more(void **state)
{
    (void)state;
    struct scenes scenes = {2};
    int steps = 0;
    for (int i = 0; i < SCENES; i++) {
        tsu_choose_desc desc = i % 4 ? scenes_hair(&scenes) : scenes_leaf(&scenes);
        float last = INFINITY;
        for (double bound = 1e-3; bound < 100.0; bound *= 1.2) {
            desc.error_bound = (float)bound;
            const tsu_choice choice = choose(&desc);
            assert_true(choice.cost <= last);
            steps += choice.cost < last;
            last = choice.cost;
        }
    }
    assert_true(steps > 2 * SCENES);
}

static void a_larger_budget_never_errs_more(void **state)
{
    (void)state;
    struct scenes scenes = {3};
    for (int i = 0; i < SCENES; i++) {
        tsu_choose_desc desc = i % 4 ? scenes_hair(&scenes) : scenes_leaf(&scenes);
        float last = INFINITY;
        for (double budget = 50.0; budget < 1e5; budget *= 1.3) {
            desc.cost_budget = (float)budget;
            const tsu_choice choice = choose(&desc);
            if (choice.status == TSU_CHOICE_OVER_BUDGET)
                continue;
            assert_true(choice.error_high <= last);
            last = choice.error_high;
        }
        assert_true(isfinite(last));
    }
}

static void lights_are_counted_by_their_evaluations(void **state)
{
    (void)state;
    tsu_choose_desc desc;
    tsu_choose_desc_init(&desc);
    desc.shadow = TSU_CHOOSE_SHADOW_COUNT;
    for (desc.gpu = TSU_CHOOSE_NAVI21; desc.gpu <= TSU_CHOOSE_GFX1100; desc.gpu++)
        for (tsu_tier t = 0; t < (tsu_tier)tsu_tier_count(); t++) {
            const tsu_tier_info info = tier_info(t);
            const float clocks = info.clocks[desc.gpu - TSU_CHOOSE_NAVI21];
            desc.kind = info.kind;
            desc.directional_lights = desc.point_lights = 0;
            desc.area_lights = desc.environments = 0;
            assert_true(predict(&desc, t).cost == clocks);
            desc.directional_lights = 2;
            desc.point_lights = 3;
            assert_true(predict(&desc, t).cost == 5.0f * clocks);
            desc.area_lights = 2;
            desc.environments = 1;
            assert_float_equal(predict(&desc, t).cost, (5.0f + 26.0f + 12.0f) * clocks,
                               1e-4f * clocks);
            if (info.kind != TSU_CHOOSE_HAIR)
                continue;
            // Seven of these lights have a map; a look is some 300 clocks or more.
            desc.shadow = TSU_CHOOSE_SHADOW_MAPS;
            const float looks = predict(&desc, t).cost - 43.0f * clocks;
            if (info.flags & TSU_TIER_SHADOW)
                assert_in_range((int)(looks / 7.0f), 250, 1500);
            else
                assert_true(looks == 0.0f);
            desc.shadow = TSU_CHOOSE_SHADOW_COUNT;
        }
}

static void hosts_get_only_what_they_can_have(void **state)
{
    (void)state;
    tsu_choose_desc desc; // brown hair, in which counting fibres is worth what it costs
    tsu_choose_desc_init(&desc);
    desc.error_bound = 1e-3f;
    desc.shadow = TSU_CHOOSE_SHADOW_NONE;
    tsu_choice choice = choose(&desc);
    assert_string_equal(tier_info(choice.tier).name, "unshadowed");
    assert_int_equal(choice.passes, 0);
    desc.shadow = TSU_CHOOSE_SHADOW_COUNT;
    desc.samplers = 1;
    choice = choose(&desc);
    assert_int_equal(choice.passes, TSU_PASS_COUNT);
    assert_true(choice.samplers == 1 && tier_info(choice.tier).bytes > 0);
    desc.shadow = TSU_CHOOSE_SHADOW_MAPS; // three samplers for maps
    assert_string_equal(tier_info(choose(&desc).tier).name, "unshadowed");
    desc.samplers = 3;
    choice = choose(&desc);
    assert_string_equal(tier_info(choice.tier).name, "kajiya_kay");
    assert_true(choice.passes == TSU_PASS_MAPS && choice.samplers == 3 && choice.bytes == 0);
    desc.samplers = 4;
    choice = choose(&desc);
    assert_true(choice.bytes > 0 && choice.samplers == 4);
    desc.memory = choice.bytes - 1;
    assert_true(choose(&desc).bytes < choice.bytes);
    desc.memory = 0;
    assert_int_equal(choose(&desc).bytes, 0);
}

// What the models say of their tables, and what the table of tiers does.
static void tiers_are_what_their_models_say(void **state)
{
    (void)state;
    assert_true(tsu_tier_count() >= 8);
    for (tsu_tier t = 0; t < (tsu_tier)tsu_tier_count(); t++) {
        const tsu_tier_info info = tier_info(t);
        tsu_model_info model;
        uint32_t bytes = 0;
        tsu_model_info_init(&model);
        assert_int_equal(tsu_tier_find(info.name), t);
        assert_int_equal(tsu_model_describe(info.model, &model), TSU_OK);
        for (uint32_t i = 0; i < model.table_count; i++) {
            tsu_table_info table;
            tsu_table_info_init(&table);
            assert_int_equal(tsu_model_table(info.model, i, &table), TSU_OK);
            bytes += table.params_flags ? 0 : table.bytes; // tiers on offer need no such
        }
        assert_int_equal(info.bytes, bytes);
        assert_int_equal(!!(model.flags & TSU_MODEL_SURFACE), info.kind == TSU_CHOOSE_LEAF);
        int found = !info.variant[0] || strcmp(info.variant, "uniform") == 0;
        for (uint32_t i = 0; i < model.variant_count; i++) {
            tsu_variant_info variant;
            tsu_variant_info_init(&variant);
            assert_int_equal(tsu_model_variant(info.model, i, &variant), TSU_OK);
            found |= strcmp(info.variant, variant.name) == 0;
        }
        assert_true(found);
    }
    assert_int_equal(tsu_tier_find("none such"), TSU_TIER_NONE);
    assert_int_equal(tsu_tier_find(NULL), TSU_TIER_NONE);
    assert_non_null(strstr(tsu_trade_source(), "commit"));
}

static void lobes_are_dropped_where_their_light_is_missed_by_nobody(void **state)
{
    (void)state;
    struct scenes scenes = {5};
    int dropped = 0;
    for (int i = 0; i < SCENES; i++) {
        tsu_choose_desc desc = scenes_hair(&scenes);
        desc.depth = (float)scenes_between(&scenes, 0.0, 40.0);
        for (int c = 0; c < 3; c++)
            desc.sigma_a[c] = 0.0f;
        desc.error_bound = 0.02f; // of white hair every lobe is worth more than 0.2 %
        assert_int_equal(choose(&desc).drop, 0);
        for (int c = 0; c < 3; c++)
            desc.sigma_a[c] = 5.0f; // black: next to nothing goes through a fibre
        const tsu_choice black = choose(&desc);
        const char *name = tier_info(black.tier).name;
        const int lobes = strcmp(name, "kajiya_kay") != 0 && strcmp(name, "unshadowed") != 0;
        const uint32_t both = TSU_SHADER_DROP_TRT | TSU_SHADER_DROP_RESIDUAL;
        assert_int_equal(black.drop & both, lobes ? both : 0);
        dropped += lobes;
        // One light channel is enough to keep what it sends.
        desc.sigma_a[0] = 0.0f;
        assert_int_equal(choose(&desc).drop, 0);
        // Of darker hair a tier may drop more.
        uint32_t last = 0;
        tsu_tier tier = TSU_TIER_NONE;
        for (double sigma = 0.0; sigma < 6.0; sigma += 0.25) {
            for (int c = 0; c < 3; c++)
                desc.sigma_a[c] = (float)sigma;
            desc.error_bound = 0.0f;
            const tsu_choice choice = choose(&desc);
            assert_true(choice.tier != tier || (choice.drop & last) == last);
            last = choice.drop;
            tier = choice.tier;
        }
    }
    assert_true(dropped > 0);
}

int rules_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_follow_the_rules),
        cmocka_unit_test(a_looser_bound_never_costs_more),
        cmocka_unit_test(a_larger_budget_never_errs_more),
        cmocka_unit_test(lights_are_counted_by_their_evaluations),
        cmocka_unit_test(hosts_get_only_what_they_can_have),
        cmocka_unit_test(tiers_are_what_their_models_say),
        cmocka_unit_test(lobes_are_dropped_where_their_light_is_missed_by_nobody),
    };
    return cmocka_run_group_tests_name("rules", tests, open_watch, close_watch);
}

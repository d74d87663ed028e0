// The same question has the same answer, a scene that swings around a limit keeps its tier, a
// switch keeps its light, and no memory is asked for.
#include "choose/plain.h"
#include "scenes.h"
#include "tests.h"
#include "watched.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

enum { SCENES = 300 };
static tsu_choice choose(const tsu_choose_desc *desc)
{
    tsu_choice choice;
    assert_int_equal(tsu_choice_init(&choice), TSU_OK);
    assert_int_equal(tsu_choose(context, desc, &choice), TSU_OK);
    return choice;
}

// Against the C library's, which is right within an ulp.
static void plain_arithmetic_is_exact(void **state)
{
    (void)state;
    struct scenes scenes = {11};
    for (int i = 0; i < 100000; i++) {
        const double x = scenes_between(&scenes, -80.0, 80.0), e = exp(x);
        assert_true(fabs(tsu_i_plain_exp(x) - e) <= 4e-15 * e);
        const double small = scenes_between(&scenes, -1.0, 1.0), s = exp(small);
        assert_true(fabs(tsu_i_plain_exp(small) - s) <= 4e-16 * s);
        const double y = exp(scenes_between(&scenes, -200.0, 200.0)), l = log(y);
        assert_true(fabs(tsu_i_plain_log(y) - l) <= 3e-16 * fmax(1.0, fabs(l)));
    }
    assert_true(tsu_i_plain_exp(0.0) == 1.0 && tsu_i_plain_log(1.0) == 0.0);
    assert_true(tsu_i_plain_exp(1e300) == tsu_i_plain_exp(80.0));
    assert_true(tsu_i_plain_exp(-1e300) > 0.0);
}

static void the_same_question_has_the_same_answer(void **state)
{
    (void)state;
    struct scenes scenes = {12};
    tsu_choose_desc asked[SCENES];
    tsu_choice answer[SCENES];
    const long calls = watch.calls;
    for (int i = 0; i < SCENES; i++) {
        asked[i] = i % 4 ? scenes_hair(&scenes) : scenes_leaf(&scenes);
        asked[i].error_bound = (float)scenes_between(&scenes, 0.01, 1.0);
        answer[i] = choose(asked + i);
    }
    for (int i = SCENES; i-- > 0;) {
        const tsu_choice again = choose(asked + i);
        assert_memory_equal(&again, answer + i, sizeof again);
    }
    assert_int_equal(watch.calls, calls); // no memory
}

// Tiers' changes while the wish swings by `swing` around a limit, the answer fed back.
static int changes(tsu_choose_desc desc, size_t wish, double limit, double swing)
{
    int count = 0;
    float *const field = (float *)(void *)((char *)&desc + wish);
    desc.previous = TSU_TIER_NONE;
    for (int frame = 0; frame < 24; frame++) {
        *field = (float)(limit * (frame % 2 ? 1.0 + swing : 1.0 / (1.0 + swing)));
        const tsu_choice choice = choose(&desc);
        count += desc.previous != TSU_TIER_NONE && choice.tier != desc.previous;
        desc.previous = choice.tier;
    }
    return count;
}

// The wish at which the answer changes, found by halving; 0: there is none in between.
static double limit_of(tsu_choose_desc desc, size_t wish, double low, double high)
{
    float *const field = (float *)(void *)((char *)&desc + wish);
    *field = (float)low;
    const tsu_tier first = choose(&desc).tier;
    *field = (float)high;
    if (choose(&desc).tier == first)
        return 0.0;
    for (int i = 0; i < 40; i++) {
        const double middle = sqrt(low * high);
        *field = (float)middle;
        *(choose(&desc).tier == first ? &low : &high) = middle;
    }
    return sqrt(low * high);
}

static void swings_within_the_hysteresis_change_a_tier_once(void **state)
{
    (void)state;
    struct scenes scenes = {13};
    const size_t bound = offsetof(tsu_choose_desc, error_bound);
    const size_t budget = offsetof(tsu_choose_desc, cost_budget);
    int tried = 0;
    for (int i = 0; i < SCENES; i++) {
        tsu_choose_desc desc = i % 4 ? scenes_hair(&scenes) : scenes_leaf(&scenes);
        double limit = limit_of(desc, bound, 1e-3, 100.0);
        if (limit > 0.0) {
            desc.hysteresis = 0.0f;
            const int flips = changes(desc, bound, limit, 0.045);
            desc.hysteresis = 0.1f;
            assert_true(changes(desc, bound, limit, 0.045) <= 1);
            tried += flips > 20;
        }
        limit = limit_of(desc, budget, 50.0, 1e5);
        if (limit > 0.0) {
            desc.hysteresis = 0.0f;
            const int flips = changes(desc, budget, limit, 0.045);
            desc.hysteresis = 0.1f;
            assert_true(changes(desc, budget, limit, 0.045) <= 1);
            desc.error_bound = (float)scenes_between(&scenes, 0.01, 1.0);
            assert_true(changes(desc, budget, limit, 0.045) <= 1);
            tried += flips > 20;
        }
    }
    assert_true(tried > SCENES / 2); // without hysteresis these change each frame
}

// Light and wish move to and fro: an answer that is kept is flagged and no worse than the new one
// by more than the hysteresis.
static void what_is_kept_is_nearly_as_good(void **state)
{
    (void)state;
    struct scenes scenes = {14};
    int held = 0;
    for (int i = 0; i < SCENES; i++) {
        tsu_choose_desc desc = scenes_hair(&scenes);
        const float bound = (float)scenes_between(&scenes, 0.1, 0.8), cosine = desc.light_cosine;
        desc.cost_budget = i % 3 ? 0.0f : (float)scenes_between(&scenes, 100.0, 20000.0);
        for (int frame = 0; frame < 60; frame++) {
            tsu_choose_desc fresh = desc;
            desc.light_cosine = fresh.light_cosine = cosine * (float)cos(0.21 * frame);
            desc.error_bound = fresh.error_bound =
                bound * (float)exp(0.8 * sin(0.105 * frame) + 0.02 * (frame % 2));
            fresh.previous = TSU_TIER_NONE;
            const tsu_choice kept = choose(&desc), now = choose(&fresh);
            assert_int_equal(kept.flags & TSU_CHOICE_HELD ? 1 : 0, kept.tier != now.tier);
            assert_int_equal(kept.status, now.status);
            if (kept.flags & TSU_CHOICE_HELD) {
                held++;
                assert_int_equal(kept.tier, desc.previous);
                assert_non_null(strstr(kept.reason, "Kept"));
                if (now.status == TSU_CHOICE_MET)
                    assert_true(kept.miss <= 0.100001f && kept.cost <= 1.100001f * now.cost);
                else
                    assert_true(kept.miss <= 1.100001f * (1.0f + now.miss) - 1.0f);
                assert_true(now.status == TSU_CHOICE_OVER_BUDGET || kept.over <= 0.100001f);
            }
            desc.previous = kept.tier;
        }
    }
    assert_true(held > 10);
}

static void a_switch_keeps_the_light(void **state)
{
    (void)state;
    struct scenes scenes = {15};
    for (int i = 0; i < SCENES; i++) {
        const tsu_choose_desc desc = i % 4 ? scenes_hair(&scenes) : scenes_leaf(&scenes);
        tsu_tier_info info;
        tsu_tier first = TSU_TIER_NONE;
        for (tsu_tier t = 0; t < (tsu_tier)tsu_tier_count(); t++) {
            float there, back;
            tsu_prediction a, b;
            tsu_tier_info_init(&info);
            assert_int_equal(tsu_tier_describe(t, &info), TSU_OK);
            if (info.kind != desc.kind)
                continue;
            first = first == TSU_TIER_NONE ? t : first;
            assert_int_equal(tsu_choose_match(context, &desc, first, t, &there), TSU_OK);
            assert_int_equal(tsu_choose_match(context, &desc, t, first, &back), TSU_OK);
            assert_float_equal(there * back, 1.0f, 3e-7f);
            assert_true(t != first || there == 1.0f);
            tsu_prediction_init(&a);
            tsu_prediction_init(&b);
            assert_int_equal(tsu_choose_predict(context, &desc, first, &a), TSU_OK);
            assert_int_equal(tsu_choose_predict(context, &desc, t, &b), TSU_OK);
            assert_float_equal(there * (1.0f + b.luminance), 1.0f + a.luminance,
                               1e-6f * (1.0f + a.luminance));
        }
    }
}

int steady_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_arithmetic_is_exact),
        cmocka_unit_test(the_same_question_has_the_same_answer),
        cmocka_unit_test(swings_within_the_hysteresis_change_a_tier_once),
        cmocka_unit_test(what_is_kept_is_nearly_as_good),
        cmocka_unit_test(a_switch_keeps_the_light),
    };
    return cmocka_run_group_tests_name("steady", tests, open_watch, close_watch);
}

// Thickness and scale of leaves: radii against Monte Carlo, what is refused and why, the verdict
// against plain sums and against random walks in bent leaves. Bad input: leaf_scale_edge_test.c.
#include "leaf_scale_rig.h"
#include "photon_walk.h"
#include "tests.h"
#include "watched.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void near(const char *what, double value, double expected, double bound)
{
    if (!(fabs(value - expected) <= bound))
        fail_msg("%s: %.9g, expected %.9g +- %g", what, value, expected, bound);
}

// MCML's leaf (sigma_a 1, sigma_s 39 per mm, g 0.5, n 1.4, 0.2 mm) in green, others beside it.
static void radii_are_those_of_mcml(void **state)
{
    (void)state;
    const double scatter[3] = {3.9, 3.9, 3.9}, absorption[3] = {3.0, 0.2, 0.02};
    tsu_leaf_scale_desc desc = scale_leaf(scatter, absorption);
    desc.n = 1.4f;
    static const float share[3] = {0.5f, 0.9f, 0.99f};
    static const double r[3] = {0.085, 0.255, 0.475}, t[3] = {0.145, 0.325, 0.545};
    for (int i = 0; i < 3; i++) {
        desc.fraction = share[i];
        const tsu_leaf_scale scale = scale_solve(&desc);
        print_message("%g %%: R within %.3f mm, MCML %.3f; T within %.3f mm, MCML %.3f\n",
                      100.0 * (double)share[i], (double)scale.reflected_radius[1], r[i],
                      (double)scale.transmitted_radius[1], t[i]);
        near("R", (double)scale.reflected_radius[1], r[i], i < 2 ? 0.01 : 0.03);
        near("T", (double)scale.transmitted_radius[1], t[i], i < 2 ? 0.01 : 0.03);
        near("reflectance", (double)scale.reflectance[1], 0.3502, 0.002);
        near("transmittance", (double)scale.transmittance[1], 0.1619, 0.002);
        near("straight", (double)scale.straight[1], 0.945 * exp(-8.0), 1e-5);
        // Pale matter spreads light further.
        assert_true(scale.reflected_radius[0] < scale.reflected_radius[1] &&
                    scale.reflected_radius[1] < scale.reflected_radius[2]);
        assert_true(scale.transmitted_radius[0] < scale.transmitted_radius[1] &&
                    scale.transmitted_radius[1] < scale.transmitted_radius[2]);
        assert_int_equal(scale.gaussians, 4);
        assert_true(scale.fit_error <= 0.04f && scale.fraction == share[i]);
        for (int c = 0; c < 3; c++) {
            double sums[2] = {0.0, 0.0};
            for (int j = 0; j < 4; j++) {
                sums[0] += (double)scale.reflected[4 * j + c];
                sums[1] += (double)scale.transmitted[4 * j + c];
                assert_true(scale.reflected[4 * j + c] >= 0.0f);
                assert_true(scale.transmitted[4 * j + c] >= 0.0f);
                assert_true(j == 0 || scale.reflected[4 * j + 3] > scale.reflected[4 * j - 1]);
                assert_true(j == 0 || scale.transmitted[4 * j + 3] > scale.transmitted[4 * j - 1]);
            }
            near("weights", sums[0], 1.0, 1e-5);
            near("weights", sums[1], 1.0, 1e-5);
            assert_int_equal(scale.refusal[c], 0);
        }
    }
    // Lengths scale.
    desc = scale_usual();
    const tsu_leaf_scale thin = scale_solve(&desc);
    desc.thickness = 2.0f;
    const tsu_leaf_scale thick = scale_solve(&desc);
    for (int c = 0; c < 3; c++) {
        near("scaled", (double)(thick.reflected_radius[c] / thin.reflected_radius[c]), 10.0, 1e-2);
        near("scaled", (double)(thick.transmitted_radius[c] / thin.transmitted_radius[c]), 10.0,
             1e-2);
    }
}

// Turning the leaf over is lighting it from below.
static void both_sides_may_be_lit(void **state)
{
    (void)state;
    tsu_leaf_scale_desc desc = scale_usual();
    for (int c = 0; c < 3; c++) {
        desc.scatter_top[c] = 0.5f;
        desc.scatter_bottom[c] = 2.0f;
        desc.absorption_top[c] = 1.0f + (float)c;
        desc.absorption_bottom[c] = 0.1f;
    }
    desc.share_top = 0.3f;
    const tsu_leaf_scale above = scale_solve(&desc);
    desc.flags = TSU_LEAF_LIT_BELOW;
    const tsu_leaf_scale below = scale_solve(&desc);
    // The pale spongy side is brighter.
    for (int c = 0; c < 3; c++)
        assert_true(below.reflectance[c] > 1.2f * above.reflectance[c]);
    for (int c = 0; c < 3; c++) {
        float swap = desc.scatter_top[c];
        desc.scatter_top[c] = desc.scatter_bottom[c];
        desc.scatter_bottom[c] = swap;
        swap = desc.absorption_top[c];
        desc.absorption_top[c] = desc.absorption_bottom[c];
        desc.absorption_bottom[c] = swap;
    }
    desc.share_top = 0.7f;
    desc.flags = 0;
    const tsu_leaf_scale turned = scale_solve(&desc);
    for (int c = 0; c < 3; c++) {
        near("R", (double)turned.reflectance[c], (double)below.reflectance[c], 1e-5);
        near("radius", (double)turned.transmitted_radius[c], (double)below.transmitted_radius[c],
             1e-5);
    }
}

static void diffusion_is_refused_with_a_number(void **state)
{
    (void)state;
    // A green leaf: red and blue absorb too much.
    tsu_leaf_scale_desc desc = scale_usual();
    for (tsu_leaf_method method = TSU_LEAF_MULTIPOLE; method <= TSU_LEAF_DIPOLE; method++) {
        desc.method = method;
        tsu_leaf_scale scale = scale_empty();
        watch_quiet(&watch);
        assert_int_equal(tsu_leaf_scale_solve(context, &desc, &scale), TSU_E_LIMIT);
        assert_int_equal(watch.log_count, 3);
        assert_non_null(strstr(watch.log, "channel 2: its reduced albedo is too low (0.29"));
        for (int c = 0; c < 3; c++) {
            const double albedo = 2.0 / (2.0 + 2.0 * (double)desc.absorption_top[c]);
            assert_int_equal(scale.refusal[c], TSU_LEAF_ABSORBS);
            near("albedo", (double)scale.refusal_value[c], albedo, 1e-6);
            print_message("method %d, a' %.2f: off by %.0f %%\n", (int)method, albedo,
                          100.0 * (double)scale.total_error[c]);
            assert_true(scale.total_error[c] > 0.2f);
            assert_true(scale.reflectance[c] == 0.0f && scale.transmitted_radius[c] == 0.0f);
        }
        assert_true(scale.gaussians == 0 && scale.transmitted[0] == 0.0f);
    }
    // Milk in a dish: every method, within the bound, and like transport.
    const double scatter[3] = {8.0, 10.0, 9.5}, absorption[3] = {0.3, 0.2, 0.4};
    desc = scale_leaf(scatter, absorption);
    const tsu_leaf_scale truth = scale_solve(&desc);
    for (tsu_leaf_method method = TSU_LEAF_MULTIPOLE; method <= TSU_LEAF_PHOTON_BEAM; method++) {
        desc.method = method;
        const tsu_leaf_scale scale = scale_solve(&desc);
        for (int c = 0; c < 3; c++) {
            print_message("method %d, channel %d: R %.3f (%.3f), radius %.3f (%.3f) mm, total off "
                          "by %.1f %%\n",
                          (int)method, c, (double)scale.reflectance[c],
                          (double)truth.reflectance[c], (double)scale.reflected_radius[c],
                          (double)truth.reflected_radius[c], 100.0 * (double)scale.total_error[c]);
            assert_true(scale.total_error[c] <= 0.15f && scale.refusal[c] == 0);
            near("radius over transport's",
                 (double)(scale.reflected_radius[c] / truth.reflected_radius[c]), 1.0, 0.3);
            if (method == TSU_LEAF_MULTIPOLE)
                near("radius over transport's",
                     (double)(scale.transmitted_radius[c] / truth.transmitted_radius[c]), 1.0, 0.1);
            else
                assert_true(scale.transmittance[c] == 0.0f && scale.transmitted_radius[c] == 0.0f);
        }
    }
    // Thin, and black.
    const double few[3] = {1.0, 1.0, 1.0}, none[3] = {0.01, 0.01, 0.01};
    desc = scale_leaf(few, none);
    static const tsu_leaf_method thin[] = {TSU_LEAF_MULTIPOLE, TSU_LEAF_DIPOLE,
                                           TSU_LEAF_PHOTON_BEAM};
    for (int i = 0; i < 3; i++) {
        desc.method = thin[i];
        tsu_leaf_scale scale = scale_empty();
        assert_int_equal(tsu_leaf_scale_solve(context, &desc, &scale), TSU_E_LIMIT);
        assert_int_equal(scale.refusal[1], TSU_LEAF_THIN);
        near("number", (double)scale.refusal_value[1], i ? sqrt(3.0 * 0.01 * 1.01) : 1.01, 1e-5);
    }
}

static void backwards(void *user, void (*job)(void *, uint32_t), void *data, uint32_t count)
{
    *(uint32_t *)user += count;
    while (count > 0)
        job(data, --count);
}

static void jobs_change_nothing_and_memory_may_end(void **state)
{
    (void)state;
    const tsu_leaf_scale_desc desc = scale_usual();
    const tsu_leaf_scale here = scale_solve(&desc);
    tsu_context_destroy(context);
    uint32_t items = 0;
    tsu_context_desc with_jobs = watch_desc(&watch);
    with_jobs.jobs = backwards;
    with_jobs.jobs_user = &items;
    assert_int_equal(tsu_context_create(&with_jobs, &context), TSU_OK);
    const tsu_leaf_scale there = scale_solve(&desc);
    assert_memory_equal(&here, &there, sizeof here);
    assert_int_equal(items, 3);
    watch.fail_at = watch.calls + 1;
    tsu_leaf_scale scale = there;
    assert_int_equal(tsu_leaf_scale_solve(context, &desc, &scale), TSU_E_MEMORY);
    const tsu_leaf_scale none = scale_empty();
    assert_memory_equal(&scale, &none, sizeof none);
}

static tsu_leaf_verdict judge(const tsu_leaf_scale *scale, double pixel, double curvature,
                              double tolerance)
{
    tsu_leaf_verdict verdict;
    assert_int_equal(tsu_leaf_verdict_init(&verdict), TSU_OK);
    assert_int_equal(tsu_leaf_scale_judge(context, scale, pixel, curvature, tolerance, &verdict),
                     TSU_OK);
    return verdict;
}

// The dark pixel beside a border, by plain sums over the Gaussians of the brightest channel.
static double border(const float blur[24], int channel, double pixel)
{
    enum { STEPS = 2000 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++)
        for (int j = 0; j < 4; j++)
            sum += (double)blur[4 * j + channel] * 0.5 *
                   erfc(pixel * (i + 0.5) / STEPS / ((double)blur[4 * j + 3] * sqrt(2.0))) / STEPS;
    return sum;
}

static void verdicts_are_sums_and_thresholds(void **state)
{
    (void)state;
    const double scatter[3] = {2.0, 2.0, 2.0}, absorption[3] = {2.5, 0.6, 5.0};
    const tsu_leaf_scale_desc desc = scale_leaf(scatter, absorption);
    const tsu_leaf_scale scale = scale_solve(&desc);
    double before = 0.5;
    for (double pixel = 1e-4; pixel < 100.0; pixel *= 3.0) {
        const tsu_leaf_verdict v = judge(&scale, pixel, 1e9, 0.05);
        near("reflected", (double)v.pixel_error[0], border(scale.reflected, 1, pixel), 2e-3);
        near("transmitted", (double)v.pixel_error[1], border(scale.transmitted, 1, pixel), 2e-3);
        assert_true((double)v.pixel_error[1] <= before);
        before = (double)v.pixel_error[1];
        assert_int_equal(v.flags & TSU_LEAF_PIXEL_REFLECTED, v.pixel_error[0] > 0.05f);
        assert_int_equal(!!(v.flags & TSU_LEAF_PIXEL_TRANSMITTED), v.pixel_error[1] > 0.05f);
        assert_false(v.flags & (TSU_LEAF_CURVED_REFLECTED | TSU_LEAF_CURVED_TRANSMITTED));
    }
    // A whole leaf on a screen of 1000 pixels is 0.1 to 0.2 mm a pixel; a tree is millimetres.
    const tsu_leaf_verdict tree = judge(&scale, 3.0, 50.0, 0.05);
    const tsu_leaf_verdict macro = judge(&scale, 0.05, 50.0, 0.05);
    print_message("BRDF within 5 %% from %.2f mm a pixel, %.1f mm of radius on; BTDF %.2f, %.1f\n",
                  (double)tree.pixel[0], (double)tree.curvature[0], (double)tree.pixel[1],
                  (double)tree.curvature[1]);
    assert_int_equal(tree.flags, 0);
    assert_int_equal(macro.flags, TSU_LEAF_PIXEL_REFLECTED | TSU_LEAF_PIXEL_TRANSMITTED);
    for (int side = 0; side < 2; side++) {
        const tsu_leaf_verdict at =
            judge(&scale, (double)tree.pixel[side], (double)tree.curvature[side], 0.05);
        near("pixel at the threshold", (double)at.pixel_error[side], 0.05, 1e-5);
        near("curvature at the threshold", (double)at.curvature_error[side], 0.05, 1e-5);
    }
    const tsu_leaf_verdict needle = judge(&scale, 3.0, 0.5, 0.05);
    assert_int_equal(needle.flags, TSU_LEAF_CURVED_REFLECTED | TSU_LEAF_CURVED_TRANSMITTED);
    // A tolerance of one half lets any pixel pass.
    assert_true(judge(&scale, 1e-6, 1e9, 0.5).flags == 0);
    assert_true(judge(&scale, 1e-6, 1e9, 0.5).pixel[0] == 0.0f);
}

// Shells of a sphere, lit from either side: what they give back per area of their middle, against
// the flat slab, stays within the verdict's bound.
static void bent_leaves_stay_within_the_bound(void **state)
{
    (void)state;
    static const double reduced[3] = {0.5, 2.0, 6.0}, absorbed[3] = {0.02, 0.6, 2.5};
    static const double bends[4] = {20.0, -20.0, 10.0, -10.0};
    const int many = getenv("TSUYA_LONG") != NULL;
    const long photons = many ? 400000 : 60000;
    double closest[2] = {0.0, 0.0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double scatter[3] = {reduced[i], reduced[i], reduced[i]};
            const double absorption[3] = {absorbed[j], absorbed[j], absorbed[j]};
            tsu_leaf_scale_desc desc = scale_leaf(scatter, absorption);
            desc.thickness = 1.0f;
            const tsu_leaf_scale scale = scale_solve(&desc);
            struct photon_slab slab = {1.45, 0.0, 1, {{absorbed[j], reduced[i] / 0.5, 0.5, 1.0}}};
            struct photon_result flat, bent;
            photon_walk(&slab, 0.1, photons, 21, &flat);
            for (int b = 0; b < (many ? 4 : 2); b++) {
                slab.bend = bends[b + (many ? 0 : 2)];
                photon_walk(&slab, 0.1, photons, 21, &bent);
                const double area = pow(1.0 + 0.5 / slab.bend, 2.0);
                const tsu_leaf_verdict v = judge(&scale, 1e6, fabs(slab.bend), 0.5);
                for (int side = 0; side < 2; side++) {
                    const struct photon_side *a = side ? &bent.t : &bent.r;
                    const struct photon_side *c = side ? &flat.t : &flat.r;
                    const double off = fabs(a->total * area / c->total - 1.0);
                    const double noise = 3.0 * (a->total_se + c->total_se) / c->total;
                    closest[side] =
                        fmax(closest[side], (off - noise) / (double)v.curvature_error[side]);
                    if (!(off <= (double)v.curvature_error[side] + noise))
                        fail_msg("reduced %g, absorbed %g, bend %g, side %d: off by %.3f, bound "
                                 "%.3f",
                                 reduced[i], absorbed[j], slab.bend, side, off,
                                 (double)v.curvature_error[side]);
                }
            }
        }
    print_message("bent leaves: at most %.2f of the bound for R, %.2f for T\n", closest[0],
                  closest[1]);
    // A bound that nothing comes near says nothing.
    assert_true(closest[0] > 0.6);
}

int leaf_scale_tests(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, open_watch, close_watch)
    const struct CMUnitTest tests[] = {
        TEST(radii_are_those_of_mcml),
        TEST(both_sides_may_be_lit),
        TEST(diffusion_is_refused_with_a_number),
        TEST(jobs_change_nothing_and_memory_may_end),
        TEST(verdicts_are_sums_and_thresholds),
        TEST(bent_leaves_stay_within_the_bound),
    };
    return cmocka_run_group_tests_name("leaf scale", tests, NULL, NULL);
}

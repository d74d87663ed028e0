// Diffusion models: closed digits, totals against transport and random walks, profiles against
// Monte Carlo of another hand, transforms against their profiles, and where they are refused.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/angle.h"
#include "optics/diffusion.h"
#include "optics/fresnel_moment.h"
#include "optics/slab_spread.h"
#include "photon_walk.h"
#include "radial_truth.h"

#include <math.h>
#include <stdlib.h>

#define COUNT(a) (sizeof(a) / sizeof *(a))

static const char *const names[] = {"dipole", "better", "beam", "multipole"};

static void near(const char *what, double value, double expected, double bound)
{
    if (!(fabs(value - expected) <= bound))
        fail_msg("%s: %.10g, expected %.10g +- %g", what, value, expected, bound);
}

static struct tsu_i_medium half_space(double albedo, double n)
{
    return (struct tsu_i_medium){1.0 - albedo, albedo, 0.0, n, INFINITY};
}

// Multiple and single scattering together, as transforms.
static double reflected(int method, const struct tsu_i_medium *medium, double k)
{
    double r, t, once = 0.0;
    tsu_i_diffusion_transform(method, medium, k, &r, &t);
    if (method == TSU_I_DIFFUSION_BETTER || method == TSU_I_DIFFUSION_BEAM)
        tsu_i_single_transform(medium, k, &once, &t);
    return r + once;
}

static struct tsu_i_spread solved(double n, double g, double scatter, double absorption, double d)
{
    const struct tsu_i_spread_slab slab = {n, g, 1, {{scatter, absorption, d}}};
    struct tsu_i_spread out;
    void *memory = malloc(tsu_i_spread_bytes(&slab));
    assert_non_null(memory);
    assert_true(tsu_i_spread_solve(&slab, 0.0, memory, &out));
    free(memory);
    return out;
}

// Digits of n 1.4, and a plain sum for others.
static void moments_have_their_digits(void **state)
{
    (void)state;
    double c1, c2;
    tsu_i_fresnel_moments(1.4, &c1, &c2);
    near("2 C1", 2.0 * c1, 0.52899, 5e-6);
    near("3 C2", 3.0 * c2, 0.38878, 5e-6);
    for (double n = 1.0; n < 2.05; n += 0.25) {
        enum { STEPS = 400000 };
        double sum1 = 0.0, sum2 = 0.0;
        for (int i = 0; i < STEPS; i++) {
            const double mu = (i + 0.5) / STEPS, f = tsu_i_fresnel_inside(n, mu) / STEPS;
            sum1 += f * mu;
            sum2 += f * mu * mu;
        }
        tsu_i_fresnel_moments(n, &c1, &c2);
        near("C1", c1, sum1, 2e-8);
        near("C2", c2, sum2, 2e-8);
    }
}

// Published errors of totals at n 1.4 (percent) against walks: the table of diffusion.h.
static void totals_err_as_stated(void **state)
{
    (void)state;
    static const struct {
        double albedo, dipole, better, beam;
    } rows[] = {{0.3, 40, 5, 9}, {0.5, 37, 5, 10}, {0.7, 29, 4, 8}, {0.8, 21, 4, 6},
                {0.9, 10, 5, 4}, {0.95, 4, 6, 4},  {0.99, -1, 8, 4}};
    for (size_t i = 0; i < COUNT(rows); i++) {
        const struct tsu_i_medium medium = half_space(rows[i].albedo, 1.4);
        const struct photon_slab slab = {
            1.4, 0.0, 1, {{medium.sigma_a, medium.sigma_s, 0.0, INFINITY}}};
        struct photon_result walk;
        photon_walk(&slab, 1.0, 200000, 7 + i, &walk);
        const double noise = 100.0 * 4.0 * walk.r.total_se / walk.r.total;
        const double expected[] = {rows[i].dipole, rows[i].better, rows[i].beam};
        for (int method = 0; method < 3; method++) {
            const double off = 100.0 * (reflected(method, &medium, 0.0) / walk.r.total - 1.0);
            print_message("a' %g, %s: %+.1f %% (4 sigma %.1f)\n", rows[i].albedo, names[method],
                          off, noise);
            near(names[method], off, expected[method], 1.0 + noise);
        }
    }
}

// Columns that others computed, and Monte Carlo in bands of r / l'.
static void profiles_are_those_of_others(void **state)
{
    (void)state;
    enum { BANDS = 6 };
    static const double edges[BANDS + 1] = {0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 12.0};
    static const double most[3][BANDS] = {{0.30, 0.70, 0.55, 0.10, 0.16, 0.16},
                                          {0.30, 0.09, 0.20, 0.17, 0.11, 0.08},
                                          {0.05, 0.05, 0.06, 0.06, 0.03, 0.03}};
    double sum[2][3][BANDS] = {{{0.0}}};
    int count[2][BANDS] = {{0}};
    for (size_t i = 0; i < COUNT(half_space_truth); i++) {
        const int bright = half_space_truth[i].bright;
        const struct tsu_i_medium medium = {bright ? 0.5 : 2.5, bright ? 49.5 : 47.5, 0.0, 1.4,
                                            INFINITY};
        const double r = half_space_truth[i].r, reduced = r * 50.0;
        double once, none, value[3];
        tsu_i_single_profile(&medium, r, &once, &none);
        for (int method = 0; method < 3; method++)
            tsu_i_diffusion_profile(method, &medium, r, value + method, &none);
        near("dipole", value[0], half_space_truth[i].dipole, 1e-3 * value[0]);
        near("better", value[1], half_space_truth[i].better, 1e-3 * value[1]);
        near("beam", value[2], half_space_truth[i].beam, 2e-3 * value[2]);
        if (half_space_truth[i].single > 1e-5)
            near("single", once, half_space_truth[i].single, 2e-3 * once);
        for (int b = 0; b < BANDS; b++) {
            if (!(reduced > edges[b] && reduced <= edges[b + 1]))
                continue;
            count[bright][b]++;
            for (int method = 0; method < 3; method++)
                sum[bright][method][b] += (value[method] + once) / half_space_truth[i].value - 1.0;
        }
    }
    for (int bright = 0; bright < 2; bright++)
        for (int method = 0; method < 3; method++)
            for (int b = 0; b < BANDS; b++) {
                if (!count[bright][b])
                    continue;
                const double off = sum[bright][method][b] / count[bright][b];
                print_message("a' %s, %s, r / l' to %g: %+.1f %%\n", bright ? ".99" : ".95",
                              names[method], edges[b + 1], 100.0 * off);
                if (!(fabs(off) <= most[method][b]))
                    fail_msg("%s to %g: %+.3f, at most %g", names[method], edges[b + 1], off,
                             most[method][b]);
            }
}

// The multipole of a leaf whose reduced albedo is .95 against MCML.
static void multipole_of_a_leaf(void **state)
{
    (void)state;
    const struct tsu_i_medium medium = {10.0, 390.0, 0.5, 1.4, 0.02};
    double worst[2] = {0.0, 0.0};
    for (size_t i = 0; i < COUNT(leaf_truth); i++) {
        double value[2];
        tsu_i_diffusion_profile(TSU_I_DIFFUSION_MULTIPOLE, &medium, leaf_truth[i].r, value,
                                value + 1);
        const int side = leaf_truth[i].side;
        const double off = value[side] / leaf_truth[i].value - 1.0;
        if (leaf_truth[i].error < 0.02 * leaf_truth[i].value && leaf_truth[i].r > 0.001)
            worst[side] = fmax(worst[side], fabs(off));
    }
    print_message("multipole of a leaf, profiles: reflected %.0f %%, transmitted %.0f %%\n",
                  100.0 * worst[0], 100.0 * worst[1]);
    assert_true(worst[0] <= 0.35 && worst[1] <= 0.25);
}

// int P(r) J0(k r) 2 pi r dr by panels of equal ratio.
static void transforms_are_of_their_profiles(void **state)
{
    (void)state;
    const struct tsu_i_medium media[] = {{1.0, 9.0, 0.0, 1.4, 0.5}, {0.05, 8.0, 0.3, 1.5, 0.6}};
    static const double ks[] = {0.0, 0.5, 3.0, 15.0};
    for (size_t m = 0; m < COUNT(media); m++)
        for (size_t q = 0; q < COUNT(ks); q++)
            for (int method = 0; method <= 4; method++) {
                enum { STEPS = 4000 };
                double sum[2] = {0.0, 0.0}, value[2], closed[2];
                for (int i = 0; i < STEPS; i++) {
                    const double step = log(1e8) / STEPS, r = 6e-7 * exp((i + 0.5) * step);
                    if (method < 4)
                        tsu_i_diffusion_profile(method, media + m, r, value, value + 1);
                    else
                        tsu_i_single_profile(media + m, r, value, value + 1);
                    for (int side = 0; side < 2; side++)
                        sum[side] +=
                            2.0 * TSU_I_PI * r * r * step * value[side] * tsu_i_bessel(ks[q] * r);
                }
                if (method < 4)
                    tsu_i_diffusion_transform(method, media + m, ks[q], closed, closed + 1);
                else
                    tsu_i_single_transform(media + m, ks[q], closed, closed + 1);
                for (int side = 0; side < 2; side++)
                    near(method < 4 ? names[method] : "single", sum[side], closed[side],
                         2e-3 * fmax(closed[0], closed[1]));
            }
}

// Light scattered once in a slab, against photons that were.
static void single_scattering_is_that_of_walks(void **state)
{
    (void)state;
    static const struct {
        double scatter, absorption, g, n;
    } rows[] = {{0.3, 0.1, 0.0, 1.4}, {2.0, 0.5, 0.7, 1.5}, {1.0, 3.0, 0.3, 1.3}};
    for (size_t i = 0; i < COUNT(rows); i++) {
        const struct tsu_i_medium medium = {rows[i].absorption, rows[i].scatter, rows[i].g,
                                            rows[i].n, 1.0};
        const struct photon_slab slab = {
            rows[i].n, 0.0, 1, {{rows[i].absorption, rows[i].scatter, rows[i].g, 1.0}}};
        struct photon_result walk;
        photon_walk(&slab, 0.1, 400000, 3 + i, &walk);
        double r, t;
        tsu_i_single_transform(&medium, 0.0, &r, &t);
        print_message("once: R %.5f, walk %.5f; T %.5f, walk %.5f\n", r, walk.r.once, t,
                      walk.t.once);
        near("R of light scattered once", r, walk.r.once, 4.0 * walk.r.total_se);
        near("T of light scattered once", t, walk.t.once, 4.0 * walk.t.total_se);
    }
}

// What is accepted is within the bound, by transport; red and blue of leaves are refused, rightly.
static void refused_where_totals_are_off(void **state)
{
    (void)state;
    int good = 0, refused = 0, needless = 0;
    double worst = 0.0;
    for (double n = 1.35; n < 1.6; n += 0.1)
        for (double albedo = 0.1; albedo<1.0; albedo += albedo> 0.89 ? 0.02 : 0.1)
            for (double depth = 0.6; depth < 30.0; depth *= 1.6)
                for (int method = 0; method <= TSU_I_DIFFUSION_MULTIPOLE; method++) {
                    const struct tsu_i_medium medium = {(1.0 - albedo) * depth, albedo * depth, 0.0,
                                                        n, 1.0};
                    double value, r, t, once = 0.0, none;
                    const int why = tsu_i_diffusion_check(method, &medium, &value);
                    assert_true(value >= 0.0);
                    const struct tsu_i_spread truth =
                        solved(n, 0.0, medium.sigma_s, medium.sigma_a, 1.0);
                    tsu_i_diffusion_transform(method, &medium, 0.0, &r, &t);
                    struct tsu_i_medium deep = medium;
                    deep.thickness = INFINITY;
                    if (method == TSU_I_DIFFUSION_BETTER || method == TSU_I_DIFFUSION_BEAM)
                        tsu_i_single_transform(&deep, 0.0, &once, &none);
                    double off = fabs((r + once) / truth.reflected - 1.0);
                    if (method == TSU_I_DIFFUSION_MULTIPOLE)
                        off = fmax(off, fabs(t / (truth.through + truth.straight) - 1.0));
                    if (why) {
                        refused++;
                        needless += off <= TSU_I_DIFFUSION_BOUND;
                        continue;
                    }
                    good++;
                    worst = fmax(worst, off);
                    if (!(off <= TSU_I_DIFFUSION_BOUND))
                        fail_msg("%s accepted at n %g, a' %g, depth %g: off by %.3f", names[method],
                                 n, albedo, depth, off);
                }
    print_message("accepted %d, worst %.3f; refused %d, of which %d would do\n", good, worst,
                  refused, needless);
    assert_true(good > 100 && refused > 100 && needless < refused / 3);
    // Mature leaf, slab parameters that give its R and T: red and blue.
    static const double leaves[2][2] = {{0.234, 3.5}, {0.128, 5.7}};
    for (int i = 0; i < 2; i++) {
        const double albedo = leaves[i][0], depth = leaves[i][1];
        const struct tsu_i_medium medium = {(1.0 - albedo) * depth, albedo * depth, 0.0, 1.45, 1.0};
        double value, r, t;
        assert_int_equal(tsu_i_diffusion_check(TSU_I_DIFFUSION_MULTIPOLE, &medium, &value),
                         TSU_I_DIFFUSION_ABSORBS);
        near("the number", value, albedo, 1e-12);
        const struct tsu_i_spread truth = solved(1.45, 0.0, medium.sigma_s, medium.sigma_a, 1.0);
        tsu_i_diffusion_transform(TSU_I_DIFFUSION_MULTIPOLE, &medium, 0.0, &r, &t);
        print_message("leaf, a' %g: R %+.0f %%, T %+.0f %%\n", albedo,
                      100.0 * (r / truth.reflected - 1.0),
                      100.0 * (t / (truth.through + truth.straight) - 1.0));
        assert_true(r / truth.reflected > 1.3 && t < 0.2 * (truth.through + truth.straight));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moments_have_their_digits),
        cmocka_unit_test(totals_err_as_stated),
        cmocka_unit_test(profiles_are_those_of_others),
        cmocka_unit_test(multipole_of_a_leaf),
        cmocka_unit_test(transforms_are_of_their_profiles),
        cmocka_unit_test(single_scattering_is_that_of_walks),
        cmocka_unit_test(refused_where_totals_are_off),
    };
    return cmocka_run_group_tests_name("diffusion", tests, NULL, NULL);
}

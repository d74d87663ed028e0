// Sums of Gaussians: fits that must be exact, fits of known profiles, radii and borders against
// plain integration.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/angle.h"
#include "optics/gaussian_sum.h"

#include <math.h>

static void near(const char *what, double value, double expected, double bound)
{
    if (!(fabs(value - expected) <= bound))
        fail_msg("%s: %.10g, expected %.10g +- %g", what, value, expected, bound);
}

static struct tsu_i_transforms samples(int profiles)
{
    struct tsu_i_transforms t = {.samples = 20, .profiles = profiles};
    for (int i = 1; i < t.samples; i++)
        t.k[i] = 0.04 * pow(25.0 / 0.04, (i - 1) / 18.0);
    return t;
}

// Two Gaussians, in different mixtures for three profiles, come back.
static void gaussians_fit_themselves(void **state)
{
    (void)state;
    static const double weight[3][2] = {{0.3, 0.1}, {0.0, 0.5}, {0.02, 0.0}};
    struct tsu_i_transforms t = samples(3);
    for (int p = 0; p < 3; p++)
        for (int i = 0; i < t.samples; i++)
            t.value[p][i] = weight[p][0] * exp(-0.5 * 0.01 * t.k[i] * t.k[i]) +
                            weight[p][1] * exp(-0.5 * 0.25 * t.k[i] * t.k[i]);
    struct tsu_i_gaussians out[3];
    const double off = tsu_i_gaussians_fit(&t, 2, 0.02, 10.0, out);
    print_message("two Gaussians: off by %.4f\n", off);
    assert_true(off <= 0.03);
    for (int p = 0; p < 3; p++) {
        near("first deviation", sqrt(out[p].variance[0]), 0.1, 0.012);
        near("second deviation", sqrt(out[p].variance[1]), 0.5, 0.06);
        near("total", out[p].weight[0] + out[p].weight[1], weight[p][0] + weight[p][1], 1e-12);
        near("transform of 0", tsu_i_gaussians_transform(out + p, 0.0), t.value[p][0], 1e-12);
    }
}

// exp(-k s) belongs to P(r) = s / (2 pi (s^2 + r^2)^(3/2)), half of whose light lies within
// sqrt(3) s: no light, heavy tail. More Gaussians are better, and no weight is negative.
static void more_gaussians_are_better(void **state)
{
    (void)state;
    struct tsu_i_transforms t = samples(2);
    for (int i = 0; i < t.samples; i++) {
        t.value[0][i] = 0.4 * exp(-0.5 * t.k[i]);
        t.value[1][i] = 0.0;
    }
    double before = 1.0;
    for (int count = 1; count <= TSU_I_GAUSSIANS; count++) {
        struct tsu_i_gaussians out[2];
        const double off = tsu_i_gaussians_fit(&t, count, 0.02, 20.0, out);
        const double half = tsu_i_gaussians_radius(out, 0.0, 0.5);
        print_message("%d Gaussians: transform off by %.4f, median radius %.4f (%.4f)\n", count,
                      off, half, 0.5 * sqrt(3.0));
        assert_true(off < before);
        before = off;
        for (int j = 0; j < count; j++) {
            assert_true(out[0].weight[j] >= 0.0 && out[1].weight[j] == 0.0);
            assert_true(j == 0 || out[0].variance[j] > out[0].variance[j - 1]);
        }
    }
    struct tsu_i_gaussians out[2];
    assert_true(tsu_i_gaussians_fit(&t, TSU_I_GAUSSIANS, 0.02, 20.0, out) <= 0.01);
    near("median radius", tsu_i_gaussians_radius(out, 0.0, 0.5), 0.5 * sqrt(3.0), 0.02);
    for (double r = 0.1; r < 4.0; r *= 2.0) {
        const double truth = 0.4 * 0.5 / (2.0 * TSU_I_PI * pow(0.25 + r * r, 1.5));
        near("profile", tsu_i_gaussians_profile(out, r), truth, 0.1 * truth);
    }
    assert_true(tsu_i_gaussians_radius(out + 1, 0.0, 0.5) == 0.0);
    assert_true(tsu_i_gaussians_within(out + 1, 0.0, 1.0) == 0.0);
}

static void radii_and_borders_are_integrals(void **state)
{
    (void)state;
    const struct tsu_i_gaussians sum = {2, {0.04, 1.0}, {0.3, 0.2}};
    const struct tsu_i_gaussians one = {1, {0.25}, {2.0}};
    near("radius of one", tsu_i_gaussians_radius(&one, 0.0, 0.9), 0.5 * sqrt(-2.0 * log(0.1)),
         1e-9);
    near("with straight light", tsu_i_gaussians_radius(&one, 2.0, 0.75),
         0.5 * sqrt(-2.0 * log(0.5)), 1e-9);
    assert_true(tsu_i_gaussians_radius(&one, 18.1, 0.9) == 0.0);
    near("spill of one", tsu_i_gaussians_spill(&one), 0.5 / sqrt(2.0 * TSU_I_PI), 1e-12);
    // Light for x < 0, blurred: its share at x is the tail of the line's profile.
    enum { STEPS = 4000 };
    double inside = 0.0, dark = 0.0, strip = 0.0;
    for (int i = 0; i < STEPS; i++) {
        const double r = 8.0 * (i + 0.5) / STEPS, dr = 8.0 / STEPS;
        inside += r < 1.0 ? 2.0 * TSU_I_PI * r * dr * tsu_i_gaussians_profile(&sum, r) : 0.0;
        double tail = 0.0;
        for (int j = 0; j < 2; j++)
            tail += sum.weight[j] * 0.5 * erfc(r / sqrt(2.0 * sum.variance[j])) / 0.5;
        dark += tail * dr;
        strip += r < 0.8 ? tail * dr / 0.8 : 0.0;
    }
    near("within 1", tsu_i_gaussians_within(&sum, 0.0, 1.0), inside / 0.5, 1e-5);
    near("spill", tsu_i_gaussians_spill(&sum), dark, 1e-5);
    near("strip", tsu_i_gaussians_strip(&sum, 0.8), strip, 1e-5);
    near("thin strip", tsu_i_gaussians_strip(&sum, 1e-7), 0.5, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gaussians_fit_themselves),
        cmocka_unit_test(more_gaussians_are_better),
        cmocka_unit_test(radii_and_borders_are_integrals),
    };
    return cmocka_run_group_tests_name("gaussian", tests, NULL, NULL);
}

// The fibre's azimuthal optics against figures that were computed independently, and against
// limits.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "fiber_truth.h"
#include "optics/angle.h"
#include "optics/fiber.h"

#include <math.h>

#define COUNT(a) (sizeof(a) / sizeof *(a))

static double radians(double degrees)
{
    return degrees * TSU_I_PI / 180.0;
}

static void near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.12g, expected %.12g +- %g", value, expected, tolerance);
}

static void azimuthal_rows(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(azimuthal_truth); i++) {
        double n[4];
        tsu_i_fiber_azimuthal(azimuthal_truth[i].eta, radians(azimuthal_truth[i].theta_d),
                              azimuthal_truth[i].sigma_a, radians(azimuthal_truth[i].beta_az),
                              radians(azimuthal_truth[i].phi), n);
        for (int p = 0; p < 3; p++)
            near(n[p], azimuthal_truth[i].n[p], 1e-9 + 2e-9 * azimuthal_truth[i].n[p]);
        assert_true(n[3] >= azimuthal_truth[i].n[3] * (1.0 - 1e-8) - 1e-9);
    }
}

static void lobe_energies(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(attenuation_truth); i++) {
        double a[4];
        const double *t = attenuation_truth[i].a;
        tsu_i_fiber_attenuation(attenuation_truth[i].eta, radians(attenuation_truth[i].theta_d),
                                attenuation_truth[i].sigma_a, a);
        for (int p = 0; p < 3; p++)
            near(a[p], t[p], 2e-9);
        near(a[3], t[3] + t[4], 2e-9);
    }
}

// Golden energies of a white fibre, eta 1.55, to five digits.
static void golden_energies(void **state)
{
    (void)state;
    static const double golden[][5] = {{0, 0.07495, 0.86179, 0.05567, 0.00758},
                                       {30, 0.08618, 0.84277, 0.06142, 0.00963},
                                       {60, 0.17347, 0.69735, 0.10201, 0.02717},
                                       {75, 0.36024, 0.42501, 0.13667, 0.07808}};
    for (size_t i = 0; i < COUNT(golden); i++) {
        double a[4];
        tsu_i_fiber_attenuation(1.55, radians(golden[i][0]), 0.0, a);
        for (int p = 0; p < 4; p++)
            near(a[p], golden[i][p + 1], 1.0e-5);
    }
}

static void white_fibre_loses_nothing(void **state)
{
    (void)state;
    for (double eta = 1.2; eta <= 2.0; eta += 0.1)
        for (double theta = 0; theta <= 89; theta += 8.9) {
            double a[4];
            tsu_i_fiber_attenuation(eta, radians(theta), 0.0, a);
            near(a[0] + a[1] + a[2] + a[3], 1.0, 1e-12);
        }
    near(tsu_i_fiber_albedo(1.55, 0.0), 1.0, 1e-12);
}

// The integral over phi of each N is its lobe's energy, whatever the blur.
static void azimuthal_integrates_to_energy(void **state)
{
    (void)state;
    const double etas[] = {1.2, 1.55, 2.0}, betas[] = {5, 12, 30}, thetas[] = {0, 50, 85};
    for (int i = 0; i < 27; i++) {
        const double eta = etas[i % 3], beta = radians(betas[i / 3 % 3]);
        const double theta = radians(thetas[i / 9]), sigma_a = 0.4;
        double sum[4] = {0}, a[4];
        const int steps = 360;
        for (int k = 0; k < steps; k++) {
            double n[4];
            tsu_i_fiber_azimuthal(eta, theta, sigma_a, beta, 2.0 * TSU_I_PI * k / steps, n);
            for (int p = 0; p < 4; p++)
                sum[p] += n[p] * 2.0 * TSU_I_PI / steps;
        }
        tsu_i_fiber_attenuation(eta, theta, sigma_a, a);
        for (int p = 0; p < 4; p++)
            near(sum[p], a[p], 1e-9);
    }
}

// With little blur R is the closed form F(cos theta cos(phi/2)) cos(phi/2) / 4.
static void surface_reflection_closed_form(void **state)
{
    (void)state;
    for (double phi = 0.2; phi < 2.6; phi += 0.3) {
        double n[4];
        const double theta = 0.6, eta = 1.55, c = cos(theta) * cos(0.5 * phi);
        const double t = sqrt(1.0 - (1.0 - c * c) / (eta * eta));
        const double s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
        tsu_i_fiber_azimuthal(eta, theta, 1.0, radians(1.0), phi, n);
        near(n[0], 0.125 * (s * s + p * p) * cos(0.5 * phi), 2e-5);
    }
}

static void extremes_are_finite(void **state)
{
    (void)state;
    const double thetas[] = {0, 1e-9, radians(89.999999), radians(90)};
    const double sigmas[] = {0, 1e-12, 1e6};
    for (int i = 0; i < 12; i++) {
        double n[4];
        tsu_i_fiber_azimuthal(1.2, thetas[i % 4], sigmas[i / 4], radians(5), 3.14159, n);
        for (int p = 0; p < 4; p++)
            assert_true(isfinite(n[p]) && n[p] >= 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(azimuthal_rows),
        cmocka_unit_test(lobe_energies),
        cmocka_unit_test(golden_energies),
        cmocka_unit_test(white_fibre_loses_nothing),
        cmocka_unit_test(azimuthal_integrates_to_energy),
        cmocka_unit_test(surface_reflection_closed_form),
        cmocka_unit_test(extremes_are_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

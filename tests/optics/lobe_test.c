// Longitudinal lobes: published values of the Bessel function, energy, and the shader's fit.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/angle.h"
#include "optics/lobe.h"

#include <math.h>

static void near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.12g, expected %.12g +- %g", value, expected, tolerance);
}

// Values of another implementation (Cephes, as in SciPy 1.10: scipy.special.i0e).
static void bessel_table(void **state)
{
    (void)state;
    static const double table[][2] = {{0.0, 1.0},
                                      {1.0, 0.46575960759364},
                                      {2.0, 0.308508322553671},
                                      {5.0, 0.183540812609328},
                                      {10.0, 0.127833337163429},
                                      {20.0, 0.089780311884826}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        near(tsu_i_lobe_i0e(table[i][0]), table[i][1], 1e-14);
    // Series and asymptote meet: the function falls by x I0e' = 8.3e-4 dx here.
    near(tsu_i_lobe_i0e(30.0 - 1e-9), tsu_i_lobe_i0e(30.0), 1e-11);
}

// The fit of glsl/marschner/longitudinal.glsl, in its own units.
static void shader_fit(void **state)
{
    (void)state;
    double worst = 0.0, worst_far = 0.0;
    for (double x = 0.0; x < 1e5; x = x < 8.0 ? x + 1e-3 : x * 1.001) {
        const double y = x * TSU_I_LOG2E, m = fmax(0.0, 1.0 - 0.338199 * y);
        const double fit = 1.0 / sqrt(3.09446921 * (1.414916 * y + m * m * m - 0.674258));
        const double error = fabs(fit / tsu_i_lobe_i0e(x) - 1.0);
        worst = fmax(worst, error);
        worst_far = x > 6.0 ? fmax(worst_far, error) : worst_far;
    }
    print_message("I0e fit: %.3f %% everywhere, %.3f %% for x > 6\n", 100 * worst, 100 * worst_far);
    assert_true(worst <= 0.0040 && worst_far <= 0.0027);
}

static double energy(double (*lobe)(double, double, double), double theta_r, double beta)
{
    const int steps = 6000;
    double sum = 0.0;
    for (int i = 0; i < steps; i++) {
        const double theta_i = ((i + 0.5) / steps - 0.5) * TSU_I_PI;
        sum += lobe(theta_i, theta_r, beta) * cos(theta_i);
    }
    return sum * TSU_I_PI / steps;
}

static void lobes_conserve_energy(void **state)
{
    (void)state;
    const double degree = TSU_I_PI / 180.0;
    for (double beta = 2; beta <= 60; beta *= 2.3)
        for (double theta = -89; theta <= 89; theta += 17.8) {
            near(energy(tsu_i_lobe_deon, theta * degree, beta * degree), 1.0, 2e-5);
            near(energy(tsu_i_lobe_gaussian, theta * degree, beta * degree), 1.0, 2e-5);
        }
    // A view that a shift carried past the pole.
    near(energy(tsu_i_lobe_deon, 101 * degree, 10 * degree), 1.0, 1e-6);
}

static void lobes_are_finite(void **state)
{
    (void)state;
    for (double beta = 1e-3; beta < 3.0; beta *= 3.0)
        for (double theta = -1.5707963; theta < 1.5708; theta += 0.19634954) {
            assert_true(isfinite(tsu_i_lobe_deon(theta, -theta, beta)));
            assert_true(isfinite(tsu_i_lobe_gaussian(theta, -theta, beta)));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bessel_table),
        cmocka_unit_test(shader_fit),
        cmocka_unit_test(lobes_conserve_energy),
        cmocka_unit_test(lobes_are_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

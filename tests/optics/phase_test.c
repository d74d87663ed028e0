// Phase functions and Fresnel's equations against closed forms.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/angle.h"
#include "optics/fresnel.h"
#include "optics/phase.h"
#include "optics/quadrature.h"

#include <math.h>

static void near(const char *what, double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s: %.15g, expected %.15g +- %g", what, value, expected, tolerance);
}

// Mean over the sphere of the l-th Legendre polynomial under p.
static double moment(double g, int l)
{
    double sum = 0.0;
    for (int i = 0; i < 64 * TSU_I_QUADRATURE_PANEL; i++) {
        // Nodes crowd where the peak is: cos = 1 - 2 u^4, or its mirror image.
        double weight;
        const double u = tsu_i_quadrature_node(0.0, 1.0, 64, i, &weight);
        const double cosine = (1.0 - 2.0 * pow(u, 4)) * (g < 0.0 ? -1.0 : 1.0);
        double before = 0.0, now = 1.0;
        for (int k = 0; k < l; k++) {
            const double next = ((2.0 * k + 1.0) * cosine * now - k * before) / (k + 1.0);
            before = now;
            now = next;
        }
        sum += weight * 4.0 * u * u * u * tsu_i_phase_henyey_greenstein(g, cosine) * now;
    }
    return sum;
}

// The form with exponent 3/2 and a minus sign is normalised, and its moments are powers of g.
static void henyey_greenstein(void **state)
{
    (void)state;
    static const double gs[] = {-0.99, -0.5, 0.0, 0.3, 0.75, 0.95, 0.999};
    for (size_t i = 0; i < sizeof gs / sizeof *gs; i++)
        for (int l = 0; l < 12; l++)
            near("moment of Henyey-Greenstein", moment(gs[i], l), pow(gs[i], l), 1e-11);
    assert_true(tsu_i_phase_henyey_greenstein(0.5, 1.0) > tsu_i_phase_henyey_greenstein(0.5, -1.0));
    // (1 + g) / (1 - g)^2 straight on.
    near("peak", tsu_i_phase_henyey_greenstein(0.9999, 1.0) / (1.9999 / 1e-8), 1.0, 1e-11);
}

static void legendre(void **state)
{
    (void)state;
    double chi[400];
    for (int l = 0; l < 400; l++)
        chi[l] = pow(0.9, l);
    for (double cosine = -1.0; cosine <= 1.0; cosine += 0.125)
        near("sum of moments", tsu_i_phase_legendre(chi, 400, cosine),
             tsu_i_phase_henyey_greenstein(0.9, cosine), 1e-11);
    const double rayleigh[3] = {1.0, 0.0, 0.1};
    near("Rayleigh", tsu_i_phase_legendre(rayleigh, 3, 0.6), 0.75 * (1.0 + 0.36), 1e-15);
}

// The addition theorem: all azimuth modes add up to the phase function.
static void modes_add_up(void **state)
{
    (void)state;
    enum { L = 120 };
    const double cosines[][2] = {{0.3, 0.8}, {-0.3, 0.8}, {0.99, 1.0}, {1e-6, 0.5}, {0.7, -0.7}};
    for (size_t i = 0; i < sizeof cosines / sizeof *cosines; i++)
        for (double phi = 0.0; phi < 3.2; phi += 0.4) {
            const double a = cosines[i][0], b = cosines[i][1];
            double of_a[L], of_b[L], sum = 0.0;
            for (uint32_t m = 0; m < L; m++) {
                tsu_i_phase_mode(m, L, a, of_a);
                tsu_i_phase_mode(m, L, b, of_b);
                double mode = 0.0;
                for (uint32_t l = m; l < L; l++)
                    mode += (2.0 * l + 1.0) * pow(0.7, l) * of_a[l - m] * of_b[l - m];
                sum += (m ? 2.0 : 1.0) * cos(m * phi) * mode;
            }
            const double cosine = a * b + sqrt((1.0 - a * a) * (1.0 - b * b)) * cos(phi);
            near("modes", sum, tsu_i_phase_henyey_greenstein(0.7, cosine), 1e-12);
        }
}

// High degrees neither grow nor fade: the mean of (2 l + 1) L^2 over mu is 1.
static void modes_are_normal(void **state)
{
    (void)state;
    enum { L = 1000 };
    static double values[L], sums[L];
    for (uint32_t m = 0; m < 900; m += 128) {
        for (int l = 0; l < L; l++)
            sums[l] = 0.0;
        for (int i = 0; i < 256 * TSU_I_QUADRATURE_PANEL; i++) {
            double weight;
            const double theta = tsu_i_quadrature_node(0.0, TSU_I_PI, 256, i, &weight);
            tsu_i_phase_mode(m, L, cos(theta), values);
            for (uint32_t l = m; l < L; l++)
                sums[l] += weight * sin(theta) * values[l - m] * values[l - m];
        }
        for (uint32_t l = m; l < L; l++)
            near("norm of a mode", 0.5 * (2.0 * l + 1.0) * sums[l], 1.0, 1e-10);
    }
}

static void fresnel(void **state)
{
    (void)state;
    for (double n = 1.05; n < 3.0; n += 0.2)
        for (double theta = 0.0; theta < 1.57; theta += 0.0314) {
            const double k = sin(theta), b = sqrt(n * n - k * k), inside = asin(k / n);
            double expected = pow((n - 1.0) / (n + 1.0), 2);
            if (theta > 0.0)
                expected = 0.5 * (pow(sin(theta - inside) / sin(theta + inside), 2) +
                                  pow(tan(theta - inside) / tan(theta + inside), 2));
            near("reflect", tsu_i_fresnel_reflect(1.0, cos(theta), n, b), expected, 1e-13);
            near("from inside", tsu_i_fresnel_reflect(n, b, 1.0, cos(theta)), expected, 1e-13);
            near("reflect and transmit",
                 tsu_i_fresnel_reflect(1.0, cos(theta), n, b) +
                     tsu_i_fresnel_transmit(1.0, cos(theta), n, b),
                 1.0, 1e-15);
        }
    near("beyond total reflection", tsu_i_fresnel_reflect(1.5, 0.4, 1.0, 0.0), 1.0, 0.0);
    near("the same index", tsu_i_fresnel_transmit(1.5, 0.4, 1.5, 0.4), 1.0, 0.0);
    // Brewster's angle: only light across the plane of incidence is reflected.
    const double n = 1.5, mu = 1.0 / sqrt(1.0 + n * n), b = n * n * mu;
    near("Brewster", tsu_i_fresnel_reflect(1.0, mu, n, b),
         0.5 * pow((n * n - 1.0) / (n * n + 1.0), 2), 1e-15);
    // A plate: r + t^2 r (1 + r^2 + ...) = 2 r / (1 + r).
    near("plate", 1.0 - tsu_i_fresnel_pair(0.96, 0.96), 0.08 / 1.04, 1e-15);
    near("closed plate", tsu_i_fresnel_pair(0.0, 0.0), 0.0, 0.0);
}

static void gauss(void **state)
{
    (void)state;
    static double x[200], w[200];
    for (int count = 1; count <= 200; count += count < 8 ? 1 : 16) {
        double whole = 0.0, even = 0.0;
        tsu_i_quadrature_gauss(count, x, w);
        for (int i = 0; i < count; i++) {
            whole += w[i];
            even += w[i] * pow(x[i], 2 * count - 2);
        }
        near("weights", whole, 2.0, 1e-13);
        near("highest even power", even * (2.0 * count - 1.0), 2.0, 1e-10);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(henyey_greenstein), cmocka_unit_test(legendre),
        cmocka_unit_test(modes_add_up),      cmocka_unit_test(modes_are_normal),
        cmocka_unit_test(fresnel),           cmocka_unit_test(gauss),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

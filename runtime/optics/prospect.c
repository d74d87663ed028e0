#include "optics/prospect.h"

#include "optics/angle.h"
#include "optics/fresnel.h"
#include "optics/quadrature.h"

#include <math.h>

enum { INDEX, CONTENTS, COLUMNS = CONTENTS + 6 };

static const double coefficients[TSU_I_SPECTRUM_POINTS][COLUMNS] = {
#include "optics/prospect_coefficients.inc"
};

// Mean of 1 - F over directions whose cosine is at least `cos_alpha`: a polynomial quadrature over
// the cosine, in which 1 - F is smooth.
static double transmittance(double n, double cos_alpha)
{
    const int panels = 2;
    double sum = 0.0;
    for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
        double weight;
        const double c = tsu_i_quadrature_node(cos_alpha, 1.0, panels, i, &weight);
        const double inside = sqrt(n * n - (1.0 - c * c)); // n times the cosine there
        sum += weight * c * tsu_i_fresnel_transmit(1.0, c, n, inside);
    }
    return 2.0 * sum / (1.0 - cos_alpha * cos_alpha);
}

// 2 E_3(k): the series of Abramowitz and Stegun 1964, 5.1.11, or their continued fraction 5.1.22.
static double diffuse_transmission(double k)
{
    if (k <= 0.0)
        return 1.0;
    if (k <= 1.0) {
        const double euler = 0.57721566490153286;
        double e1 = -euler - log(k), term = 1.0;
        for (int i = 1; i <= 20; i++) {
            term *= -k / i;
            e1 -= term / i;
        }
        return (1.0 - k) * exp(-k) + k * k * e1;
    }
    // Backwards from where it no longer matters at k = 1.
    double fraction = 0.0;
    for (int i = 60; i >= 1; i--)
        fraction = i * (i + 2.0) / (k + 3.0 + 2.0 * i - fraction);
    return 2.0 * exp(-k) / (k + 3.0 - fraction);
}

// Stokes' pile of `count` plates, r + t <= 1. v = b^-count, so that black plates do not overflow.
static void pile(double r, double t, double count, double *R, double *T)
{
    const double lost = 1.0 - r - t;
    if (lost < 1e-12) { // the limit without absorption
        *T = t / (t + (1.0 - t) * count);
        *R = 1.0 - *T;
        return;
    }
    const double d = sqrt((1.0 + r + t) * (1.0 + r - t) * (1.0 - r + t) * lost);
    const double a = (1.0 + r * r - t * t + d) / (2.0 * r);
    const double v = pow(2.0 * t / (1.0 - r * r + t * t + d), count);
    *R = a * (1.0 - v * v) / (a * a - v * v);
    *T = v * (a * a - 1.0) / (a * a - v * v);
}

static void solve(const struct tsu_i_prospect *leaf, const double c[COLUMNS], double *R, double *T)
{
    const double contents[] = {leaf->chlorophyll, leaf->carotenoids, leaf->anthocyanins,
                               leaf->brown,       leaf->water,       leaf->dry_matter};
    double k = 0.0;
    for (int i = 0; i < COLUMNS - CONTENTS; i++)
        k += contents[i] * c[CONTENTS + i] / leaf->N;
    const double tau = diffuse_transmission(k), n = c[INDEX];
    const double t_alpha = transmittance(n, cos(40.0 * TSU_I_PI / 180.0)),
                 t_12 = transmittance(n, 0.0);
    const double t_21 = t_12 / (n * n), r_21 = 1.0 - t_21;
    const double inside = tau * t_21 / (1.0 - r_21 * r_21 * tau * tau);
    const double t = t_12 * inside, r = 1.0 - t_12 + r_21 * tau * t;
    const double t_first = t_alpha * inside, r_first = 1.0 - t_alpha + r_21 * tau * t_first;
    double R_pile, T_pile;
    pile(r, t, leaf->N - 1.0, &R_pile, &T_pile);
    const double between = 1.0 / (1.0 - R_pile * r);
    *R = r_first + t_first * R_pile * t * between;
    *T = t_first * T_pile * between;
}

void tsu_i_prospect_leaf(const struct tsu_i_prospect *leaf, double lambda, double *R, double *T)
{
    const double place = (lambda - TSU_I_SPECTRUM_FIRST) / TSU_I_SPECTRUM_STEP;
    const int last = TSU_I_SPECTRUM_POINTS - 2, i = place < last ? (int)place : last;
    double c[COLUMNS];
    for (int k = 0; k < COLUMNS; k++)
        c[k] = coefficients[i][k] + (place - i) * (coefficients[i + 1][k] - coefficients[i][k]);
    solve(leaf, c, R, T);
}

void tsu_i_prospect_spectrum(const struct tsu_i_prospect *leaf, double R[TSU_I_SPECTRUM_POINTS],
                             double T[TSU_I_SPECTRUM_POINTS])
{
    for (int i = 0; i < TSU_I_SPECTRUM_POINTS; i++)
        solve(leaf, coefficients[i], R + i, T + i);
}

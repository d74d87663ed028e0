#include "optics/lobe.h"

#include "optics/angle.h"
#include "optics/quadrature.h"

double tsu_i_lobe_i0e(double x)
{
    if (x < 30.0) {
        const double q = 0.25 * x * x;
        double term = 1.0, sum = 1.0;
        for (int k = 1; term > 1e-17 * sum; k++) {
            term *= q / ((double)k * k);
            sum += term;
        }
        return sum * exp(-x);
    }
    double term = 1.0, sum = 1.0;
    for (int k = 1; k <= 16; k++) {
        term *= (2.0 * k - 1.0) * (2.0 * k - 1.0) / (8.0 * k * x);
        sum += term;
    }
    return sum / sqrt(2.0 * TSU_I_PI * x);
}

double tsu_i_lobe_deon(double theta_i, double theta_r, double beta)
{
    const double v = beta * beta;
    const double c = cos(theta_i) * fabs(cos(theta_r)), s = sin(theta_i) * sin(theta_r);
    // Where the shifted view stays before the pole, 1 + ss - cc = 2 sin^2(half sum): no
    // cancellation.
    const double half = sin(0.5 * (theta_i + theta_r));
    const double exponent = cos(theta_r) >= 0.0 ? 2.0 * half * half : 1.0 + s - c;
    return exp(-exponent / v) * tsu_i_lobe_i0e(c / v) / (v * -expm1(-2.0 / v));
}

// g(theta_i + theta_r) cos theta_i / cos^2 theta_d without the normaliser; 0 where theta_d reaches
// a pole.
static double plain(double theta_i, double theta_r, double beta)
{
    const double z = (theta_i + theta_r) / beta, cos_d = cos(0.5 * (theta_r - theta_i));
    return cos_d * cos_d < 1e-12 ? 0.0 : exp(-0.5 * z * z) * cos(theta_i) / (cos_d * cos_d);
}

double tsu_i_lobe_gaussian(double theta_i, double theta_r, double beta)
{
    // Two stretches that meet at the lobe's centre, so that panels never straddle a narrow peak.
    const double half_pi = 0.5 * TSU_I_PI;
    const double centre = fmin(fmax(-theta_r, -half_pi), half_pi);
    double k = 0.0;
    for (int side = 0; side < 2; side++) {
        const double far =
            side ? fmin(centre + 9.0 * beta, half_pi) : fmax(centre - 9.0 * beta, -half_pi);
        for (int i = 0; i < 4 * TSU_I_QUADRATURE_PANEL; i++) {
            double weight;
            const double t = tsu_i_quadrature_node(centre, far, 4, i, &weight);
            k += fabs(weight) * plain(t, theta_r, beta) * cos(t);
        }
    }
    return k > 0.0 ? plain(theta_i, theta_r, beta) / k : 0.0;
}

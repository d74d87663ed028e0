#include "optics/fresnel.h"

// Amplitude ratios (a - b) / (a + b) for either polarisation, with normal components for s and
// their ratios to n^2 for p; what goes through is 4 a b / (a + b)^2.
double tsu_i_fresnel_transmit(double n_a, double a, double n_b, double b)
{
    if (!(a > 0.0 && b > 0.0))
        return 0.0;
    if (n_a == n_b)
        return 1.0;
    const double across = a + b, p_a = n_b * n_b * a, p_b = n_a * n_a * b, along = p_a + p_b;
    return 2.0 * a * b / (across * across) + 2.0 * p_a * p_b / (along * along);
}

double tsu_i_fresnel_reflect(double n_a, double a, double n_b, double b)
{
    if (!(a > 0.0 && b > 0.0))
        return 1.0;
    if (n_a == n_b)
        return 0.0;
    const double p_a = n_b * n_b * a, p_b = n_a * n_a * b;
    const double s = (a - b) / (a + b), p = (p_a - p_b) / (p_a + p_b);
    return 0.5 * (s * s + p * p);
}

double tsu_i_fresnel_pair(double through_a, double through_b)
{
    const double sum = through_a + through_b - through_a * through_b; // 1 - r_a r_b
    return sum > 0.0 ? through_a * through_b / sum : 0.0;
}

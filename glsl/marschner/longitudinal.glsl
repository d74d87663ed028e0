// SPDX-License-Identifier: MIT
// d'Eon's energy-conserving longitudinal lobe in a form that costs eleven instructions.
//
// Source: d'Eon et al. 2011, "An Energy-Conserving Hair Reflectance Model", eq. 7, factored as
//   M = C(v) exp(-(1 + sin_i sin_r' - cos_i |cos_r'|)/v) I0e(cos_i |cos_r'|/v)
// with theta_r' = theta_r - alpha, v = beta^2, C = 1/(v (1 - exp(-2/v))), I0e(x) = exp(-x) I0(x).

// One lobe as exponent and factor, M = factor * exp2(exponent), 1/rad. Kept apart so that
// absorption joins the exponent.
//   products   (cos_i cos_r, cos_i sin_r, sin_i sin_r, sin_i cos_r)
//   a, b, c    log2(e) cos(alpha)/v, log2(e) sin(alpha)/v,
//              log2(C(v)) - log2(e)/v - 0.5 log2(3.09446921)
// The factor is I0e, up to a scale in c, with x in units of log2(e):
//   I0e(x) = (6.31671835 x - 2.08647206 + 3.09446921 m^3)^(-1/2), m = max(0, 1 - 0.48791838 x).
// Error: I0e within 0.40 % for every x >= 0, 0.27 % for x > 6 (weighted minimax fit). The
// exponent's terms cancel: with 32 bits another 0.02 % at beta = 5 degrees, 0.3 % at 1 degree.
void tsu_marschner_longitudinal(vec4 products, float a, float b, float c, out float exponent,
                                out float factor)
{
    float x = abs(a * products.x + b * products.y);
    exponent = (c - a * products.z + b * products.w) + x;
    float m = clamp(1.0 - 0.338199 * x, 0.0, 1.0);
    factor = inversesqrt(1.414916 * x + (m * m * m - 0.674258));
}

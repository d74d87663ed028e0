// Phase functions: how a volume spreads the light that it scatters.
//
// p(cos) is per steradian times 4 pi: its mean over the sphere is 1, p = 1 is isotropic. `cos` is
// between the directions of travel before and after, so cos = 1 goes straight on. Moments: p = sum
// over l of (2 l + 1) chi_l P_l(cos), chi_0 = 1, chi_1 the mean cosine.
//
// Sources: Henyey and Greenstein 1941 (chi_l = g^l); Chandrasekhar 1960, "Radiative Transfer",
// section 48 (azimuth modes). Note: Shinya's survey "Rendering techniques for realistic material
// property representation" prints Henyey-Greenstein with the exponent 2/3 and a plus sign before
// 2 g cos. With 2/3 its integral over the sphere is not 1 (0.77 at g 0.5); the exponent is 3/2. The
// plus sign would need one of the two directions reversed; here both are directions of travel and
// it is a minus sign. The same survey leaves the factor 3 out of the diffusion coefficient
// sigma_tr = sqrt(3 sigma_a (sigma_a + sigma_s (1 - g))).
#ifndef TSU_OPTICS_PHASE_H
#define TSU_OPTICS_PHASE_H

#include <stdint.h>

// g (-1, 1); exact up to rounding, also for g next to 1 and cos next to 1.
double tsu_i_phase_henyey_greenstein(double g, double cosine);
// Sum of `count` moments.
double tsu_i_phase_legendre(const double *chi, uint32_t count, double cosine);

// L_l^m(mu) = sqrt((l - m)! / (l + m)!) P_l^m(mu) for l = m .. count - 1 into out[l - m], positive
// at mu = 1. mu (-1, 1]. L_l^m(-mu) = (-1)^(l + m) L_l^m(mu). Stable for any m and count.
//
// They are what the azimuth modes are made of: with
//   P_m(mu, mu') = sum over l >= m of (2 l + 1) chi_l L_l^m(mu) L_l^m(mu')
// p = P_0 + 2 sum over m >= 1 of P_m cos(m (phi - phi')).
void tsu_i_phase_mode(uint32_t m, uint32_t count, double mu, double *out);

#endif

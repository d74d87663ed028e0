// PROSPECT-D: reflectance and transmittance of a leaf from what it is made of.
//
// The leaf is a pile of N identical plates with air between them; N is a structure parameter and
// need not be whole. A plate absorbs k = (1/N) sum content * specific absorption on the way through
// and passes, of light that is diffuse in it, tau = 2 E_3(k) = (1-k) e^-k + k^2 E_1(k). Light
// enters the first plate within a cone of half angle alpha = 40 degrees, all others from
// everywhere.
//
//   t_a(alpha)  mean Fresnel transmittance into index n over directions within alpha, by solid
//   angle
//               times cosine
//   t_12 = t_a(90),  r_12 = 1 - t_12,  t_21 = t_12/n^2,  r_21 = 1 - t_21
//   plate:    t = t_12 tau t_21 / (1 - r_21^2 tau^2),      r = r_12 + r_21 tau t
//   first:    t' = t_a(alpha) tau t_21 / (1 - r_21^2 tau^2),  r' = 1 - t_a(alpha) + r_21 tau t'
//   N-1 more: Stokes' closed form (R_s, T_s)
//   leaf:     R = r' + t' R_s t/(1 - R_s r),               T = t' T_s/(1 - R_s r)
//
// R and T are directional-hemispherical, the surface's reflection included.
//
// Sources: Jacquemoud and Baret 1990, "PROSPECT: A Model of Leaf Optical Properties Spectra", eqs.
// 1-12; Allen et al. 1969 (one plate); Stokes 1862 (the pile); Stern 1964 (t_a); Feret et al. 2017,
// "PROSPECT-D: Towards Modeling Leaf Optical Properties through a Complete Lifecycle" (pigments,
// alpha, index).
// Range:   400..780 nm; between the points, which are 10 nm apart, index and coefficients are
// linear. Error:   at the points 1e-6, the last digit of the authors' output. Between them, against
// their
//          coefficients at 1 nm, 0.008; 0.02 on the red edge, 690..720 nm.
#ifndef TSU_OPTICS_PROSPECT_H
#define TSU_OPTICS_PROSPECT_H

#include "optics/spectrum.h"

// Contents in the field's units, all >= 0; N >= 1.
struct tsu_i_prospect {
    double N;            // structure: plates
    double chlorophyll;  // Cab, ug/cm2
    double carotenoids;  // Car, ug/cm2
    double anthocyanins; // Ant, ug/cm2
    double brown;        // Cbrown, in units of a brown leaf
    double water;        // Cw, cm (g/cm2)
    double dry_matter;   // Cm, g/cm2
};

// R and T of one wavelength in nm, [400, 780].
void tsu_i_prospect_leaf(const struct tsu_i_prospect *leaf, double lambda, double *R, double *T);

// The same at all points of spectrum.h.
void tsu_i_prospect_spectrum(const struct tsu_i_prospect *leaf, double R[TSU_I_SPECTRUM_POINTS],
                             double T[TSU_I_SPECTRUM_POINTS]);

#endif

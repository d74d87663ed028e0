// Diffusion models of light that spreads sideways: dipole, better dipole, photon beams, multipole.
//
// A pencil beam of power 1 comes along the normal onto a half space or a slab with smooth walls to
// air. R(r) and T(r) are the power that leaves per area at distance r on the lit and on the far
// side (BSSRDF, a hemisphere of directions summed), without mirror reflection and unscattered
// light. The factor 1 - F(0) for light that enters is included everywhere. R(k) = int R(r) J0(k r)
// 2 pi r dr; R(0) is the total.
//
// With s' = sigma_s (1 - g), t' = sigma_a + s', a' = s' / t', l' = 1 / t':
//   DIPOLE     Jensen et al. 2001, "A Practical Model for Subsurface Light Transport", eq. 4; light
//              scattered once is taken as part of it
//   BETTER     d'Eon 2012, "A Better Dipole": Grosjean's diffusion coefficient, exitance from flux
//              and gradient. Light scattered twice and more: add tsu_i_single_* of the reduced
//              medium
//   BEAM       Habel, Christensen and Jarosz 2013, "Photon Beam Diffusion": BETTER averaged over
//              the beam, with the correction near the source of Pharr, Jakob and Humphreys 2016,
//              "Physically Based Rendering", section 15.5. Add tsu_i_single_* likewise
//   MULTIPOLE  Donner and Jensen 2005, "Light Diffusion in Multi-Layered Translucent Materials";
//              its series summed in closed form for totals and transforms
// Note on a source: Shinya's survey "Rendering techniques for realistic material property
// representation" prints sigma_tr = sqrt(sigma_a t'); the factor 3 of sqrt(3 sigma_a t') is
// missing.
//
// Error (tests/optics/diffusion_test.c). Totals of a half space, n 1.4, g 0, against transport:
//   a'        .1    .3    .5    .7    .8    .9   .95   .98   .99
//   DIPOLE  +41 % +40 % +37 % +29 % +21 % +10 %  +4 %  +1 %   0 %
//   BETTER   +2    +5    +5    +4    +4    +5    +6    +8    +9     with light scattered once
//   BEAM     +4    +9   +10    +8    +6    +4    +4    +4    +5     with light scattered once
// DIPOLE at a' .9 is +3 % for n 1.3 and +32 % for n 1.6; the others vary by 5 points.
// Profiles of the same, light scattered once added to all, against Monte Carlo (MCML), means over
// bands of r / l':
//            a'   .1 - .5  .5 - 1   1 - 2   2 - 4   4 - 8  8 - 12
//   DIPOLE  .95    +25 %   +68 %   +48 %     0 %   -15 %   -14 %
//   BETTER  .95    -16      +7     +19     +16     +10      +6
//   BEAM    .95     +3      +4      +5      +4      +2       0
//   DIPOLE  .99    +13 %   +48 %   +30 %    -8 %   -10 %    -4 %
//   BETTER  .99    -18      +2     +19     +14      +8      +5
//   BEAM    .99     +2      +3      +5      +5      +2      +1
// A half space in place of a slab of thickness d: R errs by C exp(-2 sigma_tr d), 2 % or less from
// sigma_tr d = 2 on. MULTIPOLE, totals of slabs over n 1.35 to 1.55 (R, T):
//   a' .98 and more, t' d 3 and more +5 %, -6 %; a' .95 +12 %, -15 %; a' .9 +25 %, -32 %;
//   a' .7 +58 %, -86 %; a' .5 +72 %, -99 %
// which is why leaves in red and blue (a' .1 to .5) are not for diffusion: slab_spread.h.
#ifndef TSU_OPTICS_DIFFUSION_H
#define TSU_OPTICS_DIFFUSION_H

enum {
    TSU_I_DIFFUSION_DIPOLE,
    TSU_I_DIFFUSION_BETTER,
    TSU_I_DIFFUSION_BEAM,
    TSU_I_DIFFUSION_MULTIPOLE
};

// Per unit of length. n [1, 2], g (-1, 1), thickness > 0, INFINITY: half space.
struct tsu_i_medium {
    double sigma_a, sigma_s, g, n, thickness;
};

// Whether a method's totals R and T are within TSU_I_DIFFUSION_BOUND, relative, for n up to 1.55,
// by itself or with light scattered once: BETTER and BEAM for any albedo that is not black, DIPOLE
// and MULTIPOLE for a' from ALBEDO on, MULTIPOLE for t' d from DEPTH on and sigma_tr d up to REACH
// (beyond, less than 1 % comes through), the half spaces for sigma_tr d from HALF_SPACE on. *value
// gets the number that decided.
#define TSU_I_DIFFUSION_BOUND 0.15
#define TSU_I_DIFFUSION_ALBEDO 0.95
#define TSU_I_DIFFUSION_ALBEDO_SINGLE 0.1
#define TSU_I_DIFFUSION_DEPTH 2.5
#define TSU_I_DIFFUSION_REACH 5.4
#define TSU_I_DIFFUSION_HALF_SPACE 2.0
enum {
    TSU_I_DIFFUSION_GOOD,
    TSU_I_DIFFUSION_ABSORBS, // *value: a'
    TSU_I_DIFFUSION_THIN,    // *value: t' d, or sigma_tr d of a half space
    TSU_I_DIFFUSION_THICK    // *value: sigma_tr d
};
int tsu_i_diffusion_check(int method, const struct tsu_i_medium *medium, double *value);

// Bessel function J0, x >= 0.
double tsu_i_bessel(double x);

// R and T (0 but for MULTIPOLE) at r > 0, and their transforms at k >= 0.
void tsu_i_diffusion_profile(int method, const struct tsu_i_medium *medium, double r,
                             double *reflected, double *through);
void tsu_i_diffusion_transform(int method, const struct tsu_i_medium *medium, double k,
                               double *reflected, double *through);

// Light scattered exactly once, by Henyey and Greenstein's function, with all reflections of beam
// and scattered ray at the walls: at r > 0, and the transforms (k = 0: totals within 1e-7 of R and
// T; others within 1e-3 of those). A thick slab's far wall may be INFINITY away.
void tsu_i_single_profile(const struct tsu_i_medium *medium, double r, double *reflected,
                          double *through);
void tsu_i_single_transform(const struct tsu_i_medium *medium, double k, double *reflected,
                            double *through);
// The same medium with isotropic scattering of s'.
struct tsu_i_medium tsu_i_medium_reduced(const struct tsu_i_medium *medium);

#endif

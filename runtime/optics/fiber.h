// A smooth circular dielectric fibre of unit radius: attenuation and azimuthal scattering.
//
// Geometry: inclination theta from the normal plane, impact parameter h = sin gamma_i in [-1, 1],
// azimuth phi = phi_r - phi_i with 0 straight back and pi straight through.
//
//   eta'   = sqrt(eta^2 - sin^2 theta) / cos theta        Bravais index
//   F      = unpolarised Fresnel at cos(incidence) = cos theta cos gamma_i
//   s      = 2 cos gamma_t / cos theta_t                  length of one internal segment
//   T      = exp(-sigma_a s)
//   A_0    = F,  A_p = (1 - F)^2 F^(p-1) T^p
//   Phi_p  = 2 p gamma_t - 2 gamma_i + p pi               exit azimuth
//
// Source: Marschner et al. 2003, "Light Scattering from Human Hair Fibers", sections 4 and 5, with
// the chord length corrected (the paper's 1 + cos 2 gamma_t is not the chord of the unit circle)
// and one refraction angle for both polarisations.
#ifndef TSU_OPTICS_FIBER_H
#define TSU_OPTICS_FIBER_H

enum { TSU_I_R, TSU_I_TT, TSU_I_TRT, TSU_I_RES, TSU_I_LOBES };

// What one impact parameter does, for all lobes.
struct tsu_i_ray {
    double fresnel; // F
    double segment; // s, fibre radii
    double gamma_i; // radians, [0, pi/2]
    double gamma_t; // radians
    double weight;  // dh of the quadrature over h in [0, 1]
};

// Node `index` of `panels * 16` over h in [0, 1] (by symmetry that is all of h), spaced in gamma_i,
// where every integrand is smooth. cos_theta in (0, 1].
struct tsu_i_ray tsu_i_fiber_ray(double eta, double cos_theta, int panels, int index);

// Phi_p of a ray, not wrapped, radians.
double tsu_i_fiber_azimuth(const struct tsu_i_ray *ray, int p);

// Azimuthal scattering N_p(phi), 1/rad, of R, TT, TRT and of the residual
// N_3 + Abar_>=4 / (2 pi), each convolved with a wrapped Gaussian of deviation beta_az:
//   N_p = 1/2 Int_-1^1 A_p(h) G(phi - Phi_p(h); beta_az) dh.
// eta (1, 3], theta (-pi/2, pi/2), sigma_a >= 0, beta_az [1, 60] degrees in radians.
// Error: below 1e-8 of the peak over phi.
void tsu_i_fiber_azimuthal(double eta, double theta, double sigma_a, double beta_az, double phi,
                           double n[TSU_I_LOBES]);

// Abar_p = 1/2 Int A_p dh for R, TT, TRT and all of p >= 3. Sums to 1 at sigma_a = 0.
// Error: below 1e-12 for |theta| <= 89 degrees.
void tsu_i_fiber_attenuation(double eta, double theta, double sigma_a, double a[TSU_I_LOBES]);

// Fourier coefficients of N_p over phi, c_k = Int N_p cos(k phi) dphi, k = 0 .. orders - 1; c_0 is
// Abar_p. `orders` rows of TSU_I_LOBES values. They fall as exp(-k^2 beta_az^2 / 2), which
// tsu_i_fiber_orders() turns into a number of orders that leaves 1e-5 of c_0.
// eta (1, 3], theta (-pi/2, pi/2), sigma_a >= 0. Error: below 1e-9 of c_0.
enum { TSU_I_FIBER_ORDERS = 64 };
int tsu_i_fiber_orders(double beta_az);
void tsu_i_fiber_cosines(double eta, double theta, double sigma_a, double beta_az, int orders,
                         double c[][TSU_I_LOBES]);

// Share of the light that a fibre scatters when it is lit from everywhere alike:
// Int Sum_p Abar_p(theta) cos^2 theta dtheta / (pi/2). 1 at sigma_a = 0, falls with sigma_a.
double tsu_i_fiber_albedo(double eta, double sigma_a);

#endif

// Longitudinal scattering M of a fibre.
#ifndef TSU_OPTICS_LOBE_H
#define TSU_OPTICS_LOBE_H

// exp(-x) I_0(x), the scaled modified Bessel function, for all x >= 0. Error: below 1e-12 relative.
// Source: Abramowitz and Stegun 1964, 9.6.10 (series), 9.7.1 (asymptotic).
double tsu_i_lobe_i0e(double x);

// d'Eon's energy-conserving lobe with variance v = beta^2 at inclinations theta_i and theta_r:
//   M = csch(1/v)/(2v) exp(-sin theta_i sin theta_r / v) I_0(cos theta_i cos theta_r / v),
// evaluated as C(v) exp(-(1 + sin sin - cos |cos|)/v) I0e(cos |cos| / v), C = 1/(v (1-exp(-2/v))),
// which nowhere overflows. |cos| makes it defined for a theta_r shifted past a pole.
// Int M cos(theta_i) dtheta_i = 1 for every theta_r.
// Source: d'Eon et al. 2011, "An Energy-Conserving Hair Reflectance Model", eq. 7.
double tsu_i_lobe_deon(double theta_i, double theta_r, double beta);

// Marschner's Gaussian in theta_i + theta_r, divided by its normaliser:
//   g(theta_i + theta_r; beta) cos(theta_i) / (cos^2(theta_d) K), K so that Int M cos(theta_i)
//   dtheta_i = 1
// with K by quadrature. The named variant "gaussian" of the reference.
// Source: Marschner et al. 2003, section 5.1.
double tsu_i_lobe_gaussian(double theta_i, double theta_r, double beta);

#endif

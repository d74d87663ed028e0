// What a smooth boundary between two clear media reflects of unpolarised light.
//
// A direction is its Snell invariant k = n sin(theta), which refraction keeps; light is basic
// radiance L / n^2, which it keeps too. Then both sides reflect alike, and what is not reflected
// goes through.
//
// Source: Fresnel's equations, mean of both polarisations.
#ifndef TSU_OPTICS_FRESNEL_H
#define TSU_OPTICS_FRESNEL_H

// Share that goes through between indices n_a and n_b. `a` and `b` are the normal components
// n cos(theta) = sqrt(n^2 - k^2) on either side, [0, n]; 0 where there is no such direction (total
// reflection). Exact up to rounding, also where it is small; 1 where the indices are equal.
double tsu_i_fresnel_transmit(double n_a, double a, double n_b, double b);
// What it reflects: 1 - transmit, without the cancellation where that is small.
double tsu_i_fresnel_reflect(double n_a, double a, double n_b, double b);

// Two boundaries in a row with all reflections between them, incoherent: a thin clear plate. Shares
// that go through.
double tsu_i_fresnel_pair(double through_a, double through_b);

#endif

// What a smooth wall reflects of light inside a medium of index n, air outside, and its moments.
#ifndef TSU_OPTICS_FRESNEL_MOMENT_H
#define TSU_OPTICS_FRESNEL_MOMENT_H

// Unpolarised reflectance at a cosine inside; 1 beyond the critical angle.
double tsu_i_fresnel_inside(double n, double cosine);

// C1 = int_0^1 F(mu) mu dmu and C2 = int_0^1 F(mu) mu^2 dmu. Within 1e-12.
void tsu_i_fresnel_moments(double n, double *c1, double *c2);

#endif

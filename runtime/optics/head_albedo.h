// Albedo of thick hair over its absorption: solved at nodes, interpolated between them, inverted.
//
// Thick hair is a half space of parallel fibres (fiber_layer.h); its albedo is the radiance seen
// along its normal under uniform unit radiance. It falls as 1 - c sqrt(sigma_a) from 1 and levels
// off at what the surfaces alone reflect, so nodes are even in
//
//     t = sqrt(sigma_a) / (sqrt(sigma_a) + 0.15),   0 .. 1,
//
// where it is nearly a straight line; between them runs a monotone cubic.
//
// Sources: van de Hulst 1980, "Multiple Light Scattering", chapter 4 (half spaces by doubling);
// Fritsch and Carlson 1980, "Monotone Piecewise Cubic Interpolation" (the bound on slopes).
#ifndef TSU_OPTICS_HEAD_ALBEDO_H
#define TSU_OPTICS_HEAD_ALBEDO_H

#include "optics/strand_event.h"

#include <stddef.h>

enum { TSU_I_HEAD_NODES = 17 };
// The largest absorption: every fibre is black inside.
#define TSU_I_HEAD_DARKEST 1e6

// Absorption of a node: 0 for the first, TSU_I_HEAD_DARKEST, which is as good as infinity, for the
// last.
double tsu_i_head_sigma_a(int node);

// Azimuths of fiber_layer.h that a fibre takes: 5 for beta_az from 10 degrees on, 10 at 5 degrees.
int tsu_i_head_azimuths(double beta_az);

size_t tsu_i_head_doubles(int azimuths);
// Solve one half space seen with inclination theta. `memory`: tsu_i_head_doubles(azimuths).
// Error, of albedo, with tsu_i_head_azimuths(): 3e-4 from beta_az 10 degrees on, 1e-3 below; 4e-3
// for lobes of 1 degree, which the inclinations 5 degrees apart do not resolve.
double tsu_i_head_solve(const struct tsu_i_strand *strand, double theta, int azimuths,
                        double *memory);

// `albedo` holds the nodes' albedos and does not rise. The first: sigma_a >= 0 to albedo. The
// second, its inverse: an albedo in [the last node's, the first node's]. Error between nodes, of
// albedo: 3e-4 over all fibres, 5e-5 for the default one.
double tsu_i_head_forward(const double *albedo, double sigma_a);
double tsu_i_head_inverse(const double *albedo, double value);

#endif

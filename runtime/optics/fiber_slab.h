// A slab of parallel fibres seen fibre by fibre: what a renderer gets that blends the fibres along
// its view ray and asks a model of multiple scattering for each of them.
#ifndef TSU_OPTICS_FIBER_SLAB_H
#define TSU_OPTICS_FIBER_SLAB_H

#include "optics/two_stream.h"

// Light that a fibre sends to the viewer after more than one event; as tsu_i_two_stream_fields().
typedef struct tsu_i_fields (*tsu_i_fields_fn)(const void *data, double front, double behind,
                                               double direct);

// Radiance seen along the slab's projected normal when the viewer's side (*reflectance) or the side
// beyond (*transmittance, unscattered light included) is lit by uniform unit radiance.
//   c       cosine coefficients of N, summed over lobes
//   tau     fibres met by a straight way along the normal; may be infinite
// Error: quadrature below 2e-4.
void tsu_i_fiber_slab(int orders, const double *c, tsu_i_fields_fn fields, const void *data,
                      double tau, double *reflectance, double *transmittance);

#endif

// Light in plane layers of parallel fibres, solved: the adding-doubling method over the fibre's own
// scattering.
//
// Fibres lie parallel to the layer's surface at random, dilute: free paths in the plane normal to
// the fibres are exponential with mean 1, so depth is counted in fibres. A direction of travel is
// an inclination on a grid of 5 degrees and an azimuth from the inward normal on Gauss nodes, even
// part only, which is exact for light along the normal.
//
// Sources: Shinya et al. 2010 (hair as plane-parallel layers); van de Hulst 1980, "Multiple Light
// Scattering", chapter 4 (adding and doubling).
#ifndef TSU_OPTICS_FIBER_LAYER_H
#define TSU_OPTICS_FIBER_LAYER_H

#include "optics/strand_event.h"

#include <stddef.h>

enum {
    TSU_I_LAYER_THETAS = 31,      // inclinations, to 75 degrees
    TSU_I_LAYER_THETAS_MOST = 35, // to 85 degrees
    TSU_I_LAYER_AZIMUTHS = 12     // most azimuths in a half space
};

// Operators of one layer on powers: row is the direction that leaves, column the one that comes.
// Same from both sides. Direction t * (azimuths + 1) + a; azimuth number `azimuths` is the normal,
// which nothing reaches by chance: weight normal_weight.
struct tsu_i_layer {
    int thetas, azimuths, size;            // of a matrix, thetas * (azimuths + 1)
    double theta[TSU_I_LAYER_THETAS_MOST]; // inclinations of travel
    double phi[TSU_I_LAYER_AZIMUTHS + 1];  // radians from the normal, [0, pi/2)
    double *forward, *backward;           // one event: same and other half space
    double *through, *back;               // T and R at `tau`
    double *work[3];
    double tau;
};

// Doubles that a solution with so many azimuths needs.
size_t tsu_i_layer_doubles(int azimuths);

// Lay out `memory` and fill the events of one fibre. `centre` becomes a node of the inclinations of
// travel (minus the fixed direction's). azimuths [4, TSU_I_LAYER_AZIMUTHS]; 8 leave 1 %, 12 0.1 %
// of R and T.
void tsu_i_layer_begin(struct tsu_i_layer *layer, const struct tsu_i_strand *strand, double centre,
                       int azimuths, double *memory);
// The same with so many inclinations, odd, [TSU_I_LAYER_THETAS, TSU_I_LAYER_THETAS_MOST]: white hair
// sends light far along its fibres, and 35 leave 2e-4 of R of a thick white layer where 31 leave
// 3e-3.
size_t tsu_i_layer_wide_doubles(int thetas, int azimuths);
void tsu_i_layer_wide_begin(struct tsu_i_layer *layer, const struct tsu_i_strand *strand,
                            double centre, int thetas, int azimuths, double *memory);
// T and R of a thin layer: R and T of any multiple of it err by less than 0.1 % when tau is at most
// TSU_I_LAYER_THIN.
#define TSU_I_LAYER_THIN 0.0005
void tsu_i_layer_thin(struct tsu_i_layer *layer, double tau);
// Twice the layer.
void tsu_i_layer_double(struct tsu_i_layer *layer);

// Power that leaves on the lit and on the far side for light along the normal with inclination of
// travel theta[t].
void tsu_i_layer_powers(const struct tsu_i_layer *layer, int t, double *reflectance,
                        double *transmittance);

// Solve a layer of any tau for one fixed direction, as the reference: R, and T with unscattered
// light. `memory`: tsu_i_layer_wide_doubles(TSU_I_LAYER_THETAS_MOST, azimuths).
void tsu_i_layer_slab(const struct tsu_i_strand *strand, double theta, double tau, int azimuths,
                      double *memory, double *reflectance, double *transmittance);

#endif

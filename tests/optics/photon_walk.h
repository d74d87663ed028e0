// Random walk of photons in plane layers with Fresnel walls: the truth where no figures were
// carried over. Written apart from the library, of which it uses nothing.
//
// A pencil beam comes along the normal onto the first layer. All layers have one refractive index,
// outside is 1. Phase function: Henyey and Greenstein. Weights fall by the albedo at each
// scattering, and Russian roulette ends what is left (Wang, Jacques and Zheng 1995, "MCML", for
// the scheme). The layers may be bent to shells of a sphere.
#ifndef TESTS_OPTICS_PHOTON_WALK_H
#define TESTS_OPTICS_PHOTON_WALK_H

#include <stdint.h>

enum { PHOTON_LAYERS = 2, PHOTON_BINS = 400 };

struct photon_layer {
    double sigma_a, sigma_s, g, thickness; // per length; (-1, 1); INFINITY in the last: no far wall
};

struct photon_slab {
    double n;
    double bend; // 0: flat; radius of the middle of all layers, lit from outside; negative: from
                 // inside
    int layers;
    struct photon_layer layer[PHOTON_LAYERS];
};

// One side's light: per photon that comes, the share that enters included.
struct photon_side {
    double total, total_se;   // scattered light: without reflection of the wall itself and without
                              // `straight`
    double straight;          // never scattered
    double once;              // of `total`: scattered exactly once
    double square;            // sum of weight r^2 / photons
    double ring[PHOTON_BINS]; // share in [i, i + 1) widths of the bin; the last holds all beyond.
                              // Flat layers only
    double ring_se[PHOTON_BINS];
};

struct photon_result {
    struct photon_side r, t;
};

void photon_walk(const struct photon_slab *slab, double bin, long photons, uint64_t seed,
                 struct photon_result *result);

// Radius that holds `fraction` of one side's scattered light and `straight`, linear inside a bin.
double photon_radius(const struct photon_side *side, double bin, double fraction, double straight);

#endif

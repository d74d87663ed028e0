// Random walk of light in a slab or half space of parallel fibres: the truth where no figures were
// carried over. Written apart from the library, of which it uses nothing.
//
// Fibres lie parallel to the surface at random, dilute: the free path in the plane normal to them
// is exponential with mean 1. Light is followed from the viewer's end: at each meeting the
// direction that it comes from is the fixed one, whose inclination sets N and shifts the lobes.
// What leaves through a face is the radiance seen when that face is lit by uniform unit radiance.
#ifndef TESTS_MODELS_WALK_H
#define TESTS_MODELS_WALK_H

#include <stdint.h>

enum { WALK_OWN, WALK_GAUSSIAN }; // d'Eon's lobe; a Gaussian over its normaliser
enum { WALK_TAUS = 16 };

struct walk_fiber {
    double eta, sigma_a, beta_az;         // refractive index; per radius; radians
    double alpha_R, beta_R, scale_shifts; // radians; 0 textbook shifts, 1 real tilted scales
    int lobe;                             // WALK_*
};

// R and T (unscattered light included) and their standard errors.
struct walk_slab {
    double r, r_se, t, t_se;
};

// The same walks answer for all slabs: `taus` rises, `count` of them, at most WALK_TAUS; an
// infinite one takes a fibre that absorbs. theta is the inclination of the fixed direction.
void walk(const struct walk_fiber *fiber, double theta, int count, const double *taus, long walks,
          uint64_t seed, struct walk_slab *slabs);

#endif

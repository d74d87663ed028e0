// A leaf's BRDF and BTDF by the slab solver, in many pairs of directions at once: what the tests of
// the leaf models compare with.
#ifndef TSUYA_TESTS_LEAF_TRUTH_H
#define TSUYA_TESTS_LEAF_TRUTH_H

#include "optics/slab.h"

#include <tsuya/models/leaf.h>

enum { TRUTH_COSINES = 9, TRUTH_GAUSS = 8 };

extern const double truth_cosine[TRUTH_COSINES];

struct truth {
    struct tsu_i_slab slab;
    struct tsu_i_slab_desc desc;
    struct tsu_i_slab_layer layers[2];
    struct tsu_i_slab_direction directions[TRUTH_COSINES + TRUTH_GAUSS];
    double straight[2]
                   [2]; // [side][through]: share that the form adds for light that never scattered
    double *memory;
};

// Channel 0 of params. A node more or less in each interval changes nothing beyond 1e-6.
void truth_solve(struct truth *truth, const tsu_leaf_body_params *params, double pigment,
                 double thickness);
void truth_free(struct truth *truth);
// BRDF (through 0) or BTDF, 1/sr, light that never scattered spread as the model says.
double truth_value(const struct truth *truth, int side, int through, int in, int out, double phi);
// All light from directions[in] that goes to the lit side (without the outer surface's reflection)
// or through, light that never scattered included.
double truth_power(const struct truth *truth, int side, int through, int in);
// The same with light that never scattered spread as the model says.
double truth_spread(const struct truth *truth, int side, int through, int in);

#endif

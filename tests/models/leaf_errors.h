// Errors of a leaf model's form and table against the slab solver.
#ifndef TSUYA_TESTS_LEAF_ERRORS_H
#define TSUYA_TESTS_LEAF_ERRORS_H

#include "leaf_truth.h"
#include "sweep.h"

// Columns of "leaf-body" and its like.
enum { MU0 = 6, MU, PHI, KIND, SIDE, ABSORPTION, THICKNESS, COLUMNS };

struct worst {
    double reflected,
        transmitted; // of the peak, where the side has more than 0.02 of uniform light
    double dim;      // 1/sr, elsewhere
    double power;    // directional R or T
    double straight; // the same with unscattered light where it is
};

// Make the leaf the set's only material.
void leaf_set(struct sweep *sweep, const tsu_model *model, const tsu_leaf_body_params *params);
// A leaf at random, the same in all channels, and factors on it in columns ABSORPTION and
// THICKNESS.
void leaf_random(struct sweep *sweep, tsu_leaf_body_params *params);
void leaf_factors(struct sweep *sweep, double *in);
// Both sides, all directions; what is worse than in `worst` replaces it.
void leaf_compare(struct sweep *sweep, const struct truth *truth, double *in, struct worst *worst);
// The whole sweep of a model over so many leaves.
void leaf_sweep(struct sweep *sweep, const tsu_model *model, int leaves, struct worst *worst);
// Print a measured error beside the stated one; bound <= 0: none. 1 when all is fine.
int leaf_report(const tsu_model *model, const char *name, double measured, double bound);

#endif

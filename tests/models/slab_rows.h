// Slabs of random fibres with the random walk's answer, for the tests of multiple scattering; and
// what both models are held to in slabs where the answer is known.
#ifndef TESTS_MODELS_SLAB_ROWS_H
#define TESTS_MODELS_SLAB_ROWS_H

#include "sweep.h"
#include "walk.h"

// Columns of hair-multiple.
enum {
    SLAB_THETA,
    SLAB_SIGMA,
    SLAB_TAU,
    SLAB_ETA,
    SLAB_ALPHA,
    SLAB_BETA,
    SLAB_BETA_AZ,
    SLAB_SHIFTS,
    SLAB_CFG,
    SLAB_INPUTS
};
enum { SLAB_AF, SLAB_AB, SLAB_R, SLAB_T, SLAB_OUTPUTS };
enum { SLAB_TAUS = 7 };

// The default fibre at theta 0, white, tau 1.
void slab_default(double in[SLAB_INPUTS]);
// A fibre of eta 1.3..1.8, alpha_R -10..10, beta_R 4..15, beta_az 5..20 degrees, any shifts.
void slab_fiber(struct sweep *sweep, double in[SLAB_INPUTS]);
// Absorption 0..1, one in five white, the others' cubes uneven: light hair is the hard one; and
// theta -60..60 degrees.
void slab_draw(struct sweep *sweep, double in[SLAB_INPUTS]);
// The walk through slabs of tau 0.5, 1, 2, 4, 8, 16 and, unless next to nothing absorbs, a half
// space (1e9, its t is 0). Returns how many.
int slab_walk(const double in[SLAB_INPUTS], long walks, uint64_t seed, double taus[SLAB_TAUS],
              struct walk_slab slabs[SLAB_TAUS]);
void slab_print(const char *what, const double in[SLAB_INPUTS]);

// As sweep_material(), but the fibre's tables stay when only the absorption changes: they hold no
// colour. To be used alone on a sweep.
void slab_material(struct sweep *sweep, const tsu_model *model, uint32_t function,
                   const double in[SLAB_INPUTS]);

// White slabs at theta 0..75 degrees: the most that R + T exceeds 1 and falls short of it.
struct slab_white {
    double gain, loss;
};
// Fibres at corners of what the parameters accept; the first makes the most energy.
enum { SLAB_CORNER_FIBERS = 4 };
void slab_corner_fiber(int index, double in[SLAB_INPUTS]);
// table: 0 reference, 1 tables (slab_material() first).
void slab_white(struct sweep *sweep, const tsu_model *model, uint32_t function, int table,
                const double in[SLAB_INPUTS], struct slab_white *worst);
// Slabs of nothing, without end, of black fibres, seen along the fibres: how many of the answers
// are not what they must be.
int slab_corners(struct sweep *sweep, const tsu_model *model, uint32_t function, int table,
                 const double in[SLAB_INPUTS]);

#endif

// What the files of this model share.
#ifndef TSU_MODELS_LEAF_BODY_STATE_H
#define TSU_MODELS_LEAF_BODY_STATE_H

#include "models/model.h"

#include <tsuya/models/leaf_body.h>

// Table "body": columns are pigments, of texel A, then of texel B; rows are sets (see below), three
// channels of seven thicknesses each.
enum {
    LEAF_PIGMENTS = 16,
    LEAF_THICKNESSES = 7,
    LEAF_SETS = 3,
    LEAF_TEXELS = 2,
    LEAF_ROWS = LEAF_SETS * 3 * LEAF_THICKNESSES,
    LEAF_WIDTH = LEAF_PIGMENTS * LEAF_TEXELS,
    LEAF_HEIGHT = 64,
    LEAF_NUMBERS = 4 * LEAF_TEXELS // of one set, channel, pigment and thickness
};
// Sets: light and viewer below, on two sides, on top.
enum { LEAF_BELOW, LEAF_THROUGH, LEAF_TOP };

// A layer: reduced scattering depth and absorption depth.
struct leaf_layer {
    double scatter, absorption;
};

// Moments of uniform light from one side, the view's U as x: light along U^k, and quadratics in x
// of light times P and times P U, on the same and on the other side.
struct leaf_moments {
    float u[3], grazing; // the latter: of the cosine minus 1
    float p[2][3], pu[2][3];
};

struct leaf_state {
    // The key of the tables.
    float n;
    float scatter[2][3], absorption[2][3]; // top layer, bottom layer
    uint32_t coarse;
    // Not in the key.
    float pigment, thickness;
    float roughness; // of the coat, 0: none
    float walls[5];  // what walls let through: (a + c (x + y c))/(1 + c (z + w c)), x y z w a
    float entered;   // root of the share that passes a rough wall, over that of a smooth one
    struct leaf_moments moments;
};

#define LEAF_G TSU_LEAF_G

double tsu_i_leaf_pigment(int i);   // of column i
double tsu_i_leaf_thickness(int i); // of row i

// solve.c: two layers between smooth walls at nine cosines, of which five leave the leaf.
enum {
    LEAF_INNER = 4,
    LEAF_OUTER = 5,
    LEAF_NODES = LEAF_INNER + LEAF_OUTER,
    LEAF_MODES = 3,
    LEAF_MOMENTS = 2 * LEAF_OUTER + 8
};
struct leaf_frame {
    double n;
    double cosine[LEAF_NODES], weight[LEAF_NODES]; // inside; the last five are those outside
    double outer[LEAF_OUTER], outer_weight[LEAF_OUTER];
    double reflectance[LEAF_NODES]; // of a wall, from inside
    // Legendre sums P_m of the phase function into the same and the other half space.
    double onward[LEAF_MODES][LEAF_NODES * LEAF_NODES], back[LEAF_MODES][LEAF_NODES * LEAF_NODES];
};
// R and T at the nodes of one layer, of one mode.
struct leaf_operator {
    double r[LEAF_NODES * LEAF_NODES], t[LEAF_NODES * LEAF_NODES];
};
// Fourier modes of BRDF and BTDF over the walls' factors, all scattered light, without the
// unscattered; column is the direction that comes. 1/sr.
struct leaf_modes {
    double f[LEAF_SETS][LEAF_MODES][LEAF_OUTER * LEAF_OUTER];
    // Share of what is inside at the lit wall that leaves without scattering, over the walls'
    // factors: through, and back by the far wall.
    double through[LEAF_OUTER], back[LEAF_OUTER];
};
void tsu_i_leaf_frame(double n, struct leaf_frame *frame);
// A layer of one thickness, and the same twice as thick.
void tsu_i_leaf_layer(const struct leaf_frame *frame, const struct leaf_layer *layer, int mode,
                      struct leaf_operator *out);
void tsu_i_leaf_double(struct leaf_operator *layer);
// Both layers and the walls: mode `mode` of `out`. Rows of LEAF_THROUGH are directions below,
// columns above.
void tsu_i_leaf_walls(const struct leaf_frame *frame, const struct leaf_layer layers[2],
                      const struct leaf_operator operators[2], int mode, struct leaf_modes *out);

// fit.c: the form that the shader evaluates.
enum { LEAF_AZIMUTHS = 7, LEAF_SAMPLES = LEAF_OUTER * LEAF_OUTER * LEAF_AZIMUTHS, LEAF_TERMS = 8 };
struct leaf_fitter {
    int count[LEAF_SETS], which[LEAF_SETS][LEAF_TERMS]; // terms in the fit
    double solver[LEAF_SETS][LEAF_TERMS][LEAF_SAMPLES]; // values at samples to terms
};
// The form's terms: 1, U + V, UV (through: U - V), c_u + c_v - 2 (through: P (U - V)),
// UU + VV, Z, P - 1, P (U + V), where U = 1 - u and c is the cosine outside. u, v: cosines inside,
// below and above (or both on one side); z: tangential part of the cosine of scattering; P its
// phase function/(1 - g^2).
void tsu_i_leaf_terms(double n, int set, double u, double v, double z, double terms[LEAF_TERMS]);
void tsu_i_leaf_fitter(const struct leaf_frame *frame, uint32_t coarse, struct leaf_fitter *fitter);
// log2 of the value at normal incidence, then the other terms over it, in the order of the texels.
void tsu_i_leaf_fit(const struct leaf_frame *frame, const struct leaf_fitter *fitter,
                    const struct leaf_layer layers[2], const struct leaf_modes *modes, int set,
                    float numbers[LEAF_NUMBERS]);

// table.c
struct leaf_room {
    struct leaf_frame frame;
    struct leaf_fitter fitter;
    struct leaf_operator operators[LEAF_THICKNESSES][LEAF_MODES][2];
};
void tsu_i_leaf_bake(const void *state, uint32_t unit, void *scratch, float *texels);
void tsu_i_leaf_finish(const void *state, float *texels);

// read.c: both texels of a set and a channel, by factors of a fragment.
void tsu_i_leaf_read(const float *record, const struct tsu_i_texels *table, float pigment,
                     float thickness, int set, int channel, float a[4], float b[4]);

// walls.c
double tsu_i_leaf_walls_pass(const float walls[5], double cosine);
// Walls, moments and `entered` out of n and roughness.
void tsu_i_leaf_coated(struct leaf_state *state);
// Albedo of the coat at one cosine: GGX facets of index n, one bounce, by quadrature.
double tsu_i_leaf_coat_albedo(double n, double alpha, double cosine);
// The coat's BRDF. h: cosines to the half vector of normal and light.
double tsu_i_leaf_coat(double n, double alpha, double n_l, double n_v, double n_h, double l_h);
double tsu_i_leaf_wall_reflectance(double n, double outside);
double tsu_i_leaf_wall_mean(double n); // over uniform light
// What a coat leaves of light that passes a smooth wall at one cosine; twice that, energy is whole.
double tsu_i_leaf_coat_factor(double n, double alpha, double cosine);

// model.c; models that extend this one share them.
void tsu_i_leaf_body_prepare(const void *params, void *state);
void tsu_i_leaf_body_record(const void *state, const struct tsu_i_place *places, float *record);
extern const struct tsu_i_table tsu_i_leaf_tables[1];

// functions.c
enum { LEAF_FUNCTIONS = 7 };
extern const struct tsu_i_function tsu_i_leaf_functions[LEAF_FUNCTIONS];

#endif

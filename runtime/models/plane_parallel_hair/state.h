// What the files of this model share. It extends dual_scattering: same state, same record, one
// table in the place of two.
#ifndef TSU_MODELS_PLANE_PARALLEL_HAIR_STATE_H
#define TSU_MODELS_PLANE_PARALLEL_HAIR_STATE_H

#include "models/dual_scattering/state.h"
#include "optics/fiber_layer.h"

// Table "layer": 48 rows of fields over the view's inclination, 32 of shares over cos(theta_r), 24
// of each lobe over absorption.
enum {
    LAYER_WIDTH = 64,
    LAYER_ROWS = 48,
    LAYER_SHARE_ROWS = 32,
    LAYER_LOBE_ROWS = 24,
    LAYER_LOBES = LAYER_ROWS + LAYER_SHARE_ROWS, // first row of the lobes
    LAYER_HEIGHT = LAYER_LOBES + 2 * LAYER_LOBE_ROWS
};

// What is solved: absorptions, inclinations, and depths of the lobes.
enum { SOLVED_SIGMAS = 9, SOLVED_THETAS = 31, SOLVED_DEPTHS = 8 };

// Corrections of the closed form at one absorption and inclination, and lobes at one depth.
struct layer_fit {
    float ln_k, logit_r, back, on; // added to the closed form's
};
struct layer_lobes {
    float mean[2], variance[2]; // light that comes back, light that goes on
};
struct layer_solved {
    struct layer_fit fits[SOLVED_THETAS];
    struct layer_lobes lobes[SOLVED_DEPTHS];
};

double tsu_i_layer_sigma(int i);       // absorption i of SOLVED_SIGMAS
double tsu_i_layer_inclination(int i); // view inclination i of SOLVED_THETAS, radians
double tsu_i_layer_depth(int i);       // depth i of SOLVED_DEPTHS, fibres; the first is 0

// Light that an event sends on keeps its way for some fibres before it is diffuse: n fibres to a
// surface count as n - LAYER_DELAY (1 - 2^(-n/4)).
#define LAYER_DELAY 1.8f
// With that delay gamma is so much less than the closed form's (two_stream.h).
#define LAYER_GAMMA 0.02

// Axis of the fields, [0, 1]: sin(theta_r) (0.5 - LAYER_STEEP cos(theta_r)) + 0.5. Nearly even in
// theta_r, denser along the fibres, where k and r change fastest and sin(theta_r) stands still.
#define LAYER_STEEP 0.2f
double tsu_i_layer_row(int i); // inclination of row i of LAYER_ROWS, radians

// Axis of absorption of fields and shares: log2(sigma_a / LAYER_LEAST + 1) / LAYER_OCTAVES, held to
// [0, 1]. Finer than dual_scattering's below 0.001, where k is a root.
#define LAYER_LEAST 0.0005f
#define LAYER_OCTAVES 16.0f
float tsu_i_layer_place(float sigma_a);
double tsu_i_layer_column(int i); // absorption of column i of LAYER_WIDTH

// Row of the lobes, from the first: the place to LAYER_LOBE_POWER, denser where next to nothing
// absorbs, since a lobe between two rows has unit power only where they are alike. All channels of
// a material share its lobes, at the mean of their places.
#define LAYER_LOBE_POWER 0.75f
float tsu_i_layer_lobe(const float sigma_a[3]);

// solve.c: one absorption. Five azimuths leave 0.5 % of R and T.
enum {
    SOLVED_AZIMUTHS = 5,
    SOLVED_DIRECTIONS = TSU_I_LAYER_THETAS * (SOLVED_AZIMUTHS + 1),
    SOLVED_KEPT = SOLVED_DEPTHS - 1
};
struct layer_room {
    double solver[7 * SOLVED_DIRECTIONS * SOLVED_DIRECTIONS];
    float back[SOLVED_KEPT][SOLVED_DIRECTIONS * SOLVED_DIRECTIONS]; // layers of the depths past 0
    float through[SOLVED_KEPT][SOLVED_DIRECTIONS * SOLVED_DIRECTIONS];
};
void tsu_i_layer_solve(const struct dual_state *state, int sigma, struct layer_room *room,
                       struct layer_solved *solved);

// fit.c: reflectances and transmittances of one inclination, and what the shader makes of four
// numbers.
enum { FITTED_TAUS = 7 };
extern const double tsu_i_layer_taus[FITTED_TAUS];
struct layer_powers {
    double r[FITTED_TAUS], t[FITTED_TAUS];
};
void tsu_i_layer_fit(const struct tsu_i_strand *strand, double theta, double gamma,
                     const struct layer_powers *powers, struct layer_fit *fit);

// table.c
void tsu_i_layer_bake(const void *state, uint32_t unit, void *scratch, float *texels);
void tsu_i_layer_finish(const void *state, float *texels);

// functions.c
enum { LAYER_FUNCTIONS = 1 };
extern const struct tsu_i_function tsu_i_layer_functions[LAYER_FUNCTIONS];

#endif

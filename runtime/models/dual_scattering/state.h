// What the files of this model share. It extends marschner: its state begins with that model's and
// its record's first six vec4 are that model's.
#ifndef TSU_MODELS_DUAL_SCATTERING_STATE_H
#define TSU_MODELS_DUAL_SCATTERING_STATE_H

#include "models/marschner/state.h"
#include "optics/strand_event.h"
#include "optics/two_stream.h"

// Table "fields": 32 rows over cos(theta_r), over absorption.
// Table "spread": two bands of 16 rows over absorption, over fibres in front.
// Table "zinke": four bands like "fields", for that variant alone.
enum {
    FIELDS_WIDTH = 64,
    FIELDS_ROWS = 32,
    SPREAD_WIDTH = 32,
    SPREAD_ROWS = 16,
    SPREAD_HEIGHT = 2 * SPREAD_ROWS,
    ZINKE_BANDS = 4,
    ZINKE_HEIGHT = ZINKE_BANDS * FIELDS_ROWS,
    DUAL_TABLES = 4
};

// Texels from a band's first row to its last, a little less than there are.
#define DUAL_SPAN(rows) ((float)(rows)-1.0001f)

// Absorption on a texture axis: u = log2(sigma_a / SIGMA_LEAST + 1) / SIGMA_OCTAVES, held to [0,
// 1]: what absorbs more reflects at its surface only. Fibres in front: u = exp(-FRONT_RATE n).
#define SIGMA_LEAST 0.004f
#define SIGMA_OCTAVES 13.0f
#define FRONT_RATE 0.17328680f // log(2) / 4

struct dual_state {
    struct marschner_state fiber; // its bytes before sigma_a are the key of all tables
    float d_f, d_b;
    float gamma; // of two_stream.h
};

double tsu_i_dual_sigma_node(int i, int count); // absorption of column i
double tsu_i_dual_front_node(int i, int count);
float tsu_i_dual_sigma_place(float sigma_a); // u, [0, 1]
// u of a material, for lobes that all channels share: the channels' mean.
float tsu_i_dual_material_place(const struct marschner_state *fiber);
// The lobe of mean and variance as a, b, c of the record.
struct tsu_i_dual_moments;
void tsu_i_dual_lobe(const struct tsu_i_dual_moments *moments, float lobe[4]);
// What the shader makes of a lobe's unit power for a view at theta_r: its I0e is a fit
// (glsl/dual_scattering/eval.glsl) and errs by up to 3 % for wide lobes.
double tsu_i_dual_lobe_power(const float lobe[4], double theta_r);

// table.c
void tsu_i_dual_bake_fields(const void *state, uint32_t row, void *scratch, float *texels);
void tsu_i_dual_bake_spread(const void *state, uint32_t row, void *scratch, float *texels);
void tsu_i_dual_finish_fields(const void *state, float *texels);
void tsu_i_dual_bake_zinke(const void *state, uint32_t unit, void *scratch, float *texels);
void tsu_i_dual_finish_zinke(const void *state, float *texels);

// spread.c: mean and variance of theta_i + theta_r.
struct tsu_i_dual_moments {
    double mean, variance; // radians, radians squared
};
// Of the multiply scattered light behind `front` fibres, viewer's side [0] and beyond [1].
void tsu_i_dual_moments(const struct tsu_i_strand *strand, const struct tsu_i_event *event,
                        double front, struct tsu_i_dual_moments moments[2]);
// Of Zinke's f_back (Delta_b, sigma_b^2), and the variance that one forward event adds.
struct tsu_i_dual_zinke {
    double forward, back;         // a_f, a_b averaged
    double albedo;                // A_1 + A_3
    double shift, variance, step; // Delta_b, sigma_b^2, beta_f^2
};
void tsu_i_dual_zinke(const struct tsu_i_strand *strand, const struct tsu_i_event *event,
                      struct tsu_i_dual_zinke *out);

// sample.c: the shader's formulas in C.
// A slab drawn fibre by fibre out of a record like this model's.
struct tsu_i_dual_slab {
    const float *record;                          // d_b, d_f, gamma and the fibre's
    const struct tsu_i_texels *azimuthal, *lobes; // lobes: a, b, c over fibres in front
    float sigma_a, sin_r;
    float stream[4];   // k, r, shares back and on
    int columns, rows; // of `lobes`
    float row[2];      // in `lobes` of light that comes back, and that goes on
    float delay;       // fibres that diffuse light is spared near a surface, in time
};
void tsu_i_dual_slab(const struct tsu_i_dual_slab *slab, double tau, double out[4]);
void tsu_i_dual_sampled_exact(const void *state, const float *record,
                              const struct tsu_i_texels *tables, const double *in, double *out);
void tsu_i_dual_sampled_zinke(const void *state, const float *record,
                              const struct tsu_i_texels *tables, const double *in, double *out);

// functions.c
enum { DUAL_FUNCTIONS = 3 };
extern const struct tsu_i_function tsu_i_dual_functions[DUAL_FUNCTIONS];

#endif

// What the files of this model share.
#ifndef TSU_MODELS_MARSCHNER_STATE_H
#define TSU_MODELS_MARSCHNER_STATE_H

#include "models/model.h"

// The table's cell: a band of N below a band of paths, which are smoother and get fewer rows.
enum {
    MARSCHNER_WIDTH = 128,
    MARSCHNER_HEIGHT = 128,
    MARSCHNER_ROWS = 80,
    MARSCHNER_PATH_ROWS = MARSCHNER_HEIGHT - MARSCHNER_ROWS
};

// Texels from a band's first row to its last. A little less than there are: a cosine that rounds
// past 1 must not reach the next band.
#define MARSCHNER_SPAN(rows) ((float)(rows)-1.0001f)

struct marschner_state {
    float eta, beta_az; // key of the table: keep these two together and first
    double alpha[4], beta[4];
    float sigma_a[3];
};

// Lobe shifts and deviations in the order R, TT, TRT, residual.
void tsu_i_marschner_lobes(double alpha_R, double beta_R, double scale_shifts, double alpha[4],
                           double beta[4]);

// model.c: of the model's record.
void tsu_i_marschner_prepare(const void *params, void *state);
void tsu_i_marschner_record(const void *state, const struct tsu_i_place *places, float *record);

// table.c
void tsu_i_marschner_bake(const void *state, uint32_t row, void *scratch, float *texels);
void tsu_i_marschner_finish(const void *state, float *texels);
double tsu_i_marschner_worst(const void *state, const struct tsu_i_texels *tables);
double tsu_i_marschner_worst_residual(const void *state, const struct tsu_i_texels *tables);

// sample.c: the shader's formulas in C.
// One lobe as exponent and factor; products as in the shader. Bilinear fetch at texel coordinates
// that lie within a table of `width` x `height`.
struct marschner_view {
    float cos_r, cos2_half, products[4];
};
struct marschner_view tsu_i_marschner_view(float sin_i, float sin_r, float cos2_half);
void tsu_i_marschner_lobe(const float products[4], const float lobe[3], float *exponent,
                          float *factor);
void tsu_i_marschner_fetch(const struct tsu_i_texels *table, int width, int height, float x,
                           float y, float out[4]);
// The four lobes of a fibre.
void tsu_i_marschner_fiber(const float *record, const struct tsu_i_texels *table,
                           const struct marschner_view *view, float sigma_a, int fine,
                           float out[4]);
// N of the four lobes at phi after absorption.
void tsu_i_marschner_sample(const struct tsu_i_texels *table, float cos_r, float cos2_half,
                            float sigma_a, float n[4]);
void tsu_i_marschner_hair(const void *state, const float *record, const struct tsu_i_texels *tables,
                          const double *in, double *out);
void tsu_i_marschner_hair_fine(const void *state, const float *record,
                               const struct tsu_i_texels *tables, const double *in, double *out);
void tsu_i_marschner_azimuthal(const void *state, const float *record,
                               const struct tsu_i_texels *tables, const double *in, double *out);
void tsu_i_marschner_longitudinal(const void *state, const float *record,
                                  const struct tsu_i_texels *tables, const double *in, double *out);

// functions.c
enum { MARSCHNER_FUNCTIONS = 6 };
extern const struct tsu_i_function tsu_i_marschner_functions[MARSCHNER_FUNCTIONS];

#endif

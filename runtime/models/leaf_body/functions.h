// What "leaf-body" and "leaf" share: columns, and the answers.
#ifndef TSU_MODELS_LEAF_BODY_FUNCTIONS_H
#define TSU_MODELS_LEAF_BODY_FUNCTIONS_H

#include "models/leaf_body/state.h"
#include "optics/leaf_inverse.h"

// Enough for the inversion and for one slab in ten directions; the tests hold it against both.
enum { LEAF_ANSWER_BYTES = 2 << 20 };
size_t tsu_i_leaf_answer_bytes(void);

// Layers of faces; logs what is wrong, with the nearest that is possible.
tsu_status tsu_i_leaf_find(const tsu_context *context, const struct tsu_i_leaf_question *question,
                           void *scratch, struct tsu_i_leaf_inverse *out);
// The material of a row, over parameters that begin as tsu_leaf_body_params.
tsu_status tsu_i_leaf_material(const tsu_context *context, const double *in, void *scratch,
                               void *params);
// BRDF and BTDF (1/sr), reference; alpha 0: no coat. out: specular, reflected, transmitted.
tsu_status tsu_i_leaf_answer(const tsu_context *context, const double *in, double alpha,
                             void *scratch, double *out);
// The shader's, in float, for the same columns.
void tsu_i_leaf_sampled(const struct leaf_state *state, const float *record,
                        const struct tsu_i_texels *tables, const double *in, double *out);

#define LEAF_MATERIAL_COLUMNS                                                                      \
    TSU_I_MATERIAL("preset",                                                                       \
                   "none|young_green|mature_broadleaf|dark_shade|thick_waxy|grass|needle|"         \
                   "yellow_autumn|red_autumn|dry_brown",                                           \
                   "a leaf by name, R_bottom 1.4 R_top; none: the four columns after channel", 0,  \
                   9, 0),                                                                          \
        TSU_I_MATERIAL("channel", "r|g|b", "channel of the preset", 0, 2, 1),                      \
        TSU_I_MATERIAL("R_top", "1", "reflectance lit from above, at normal incidence", 0, 1,      \
                       0.129),                                                                     \
        TSU_I_MATERIAL("R_bottom", "1", "reflectance lit from below", 0, 1, 0.1806),               \
        TSU_I_MATERIAL("T", "1", "transmittance", 0, 1, 0.126),                                    \
        TSU_I_MATERIAL("n", "1", "refractive index", 1.2, 1.8, 1.45)

#define LEAF_FACTOR_COLUMNS                                                                        \
    TSU_I_FRAGMENT("absorption", "1", "factor on absorption", 0, 2, 1),                            \
        TSU_I_FRAGMENT("thickness", "1", "factor on all depths", 0.5, 2, 1)

#define LEAF_COLUMNS                                                                               \
    LEAF_MATERIAL_COLUMNS, TSU_I_FRAGMENT("mu0", "1", "cosine of the light, outside", 1e-3, 1, 1), \
        TSU_I_FRAGMENT("mu", "1", "cosine of the view, outside", 1e-3, 1, 1),                      \
        TSU_I_FRAGMENT("phi", "rad",                                                               \
                       "azimuth from the light's direction of travel to that of the light that "   \
                       "leaves; 0 is the mirror's",                                                \
                       -1e6, 1e6, 0),                                                              \
        TSU_I_FRAGMENT("kind", "R|T", "the side that is seen: the lit one, or the other", 0, 1,    \
                       0),                                                                         \
        TSU_I_FRAGMENT("side", "top|bottom", "the lit side", 0, 1, 0), LEAF_FACTOR_COLUMNS

#define LEAF_OUTPUTS                                                                               \
    TSU_I_OUTPUT("specular", "1/sr", "BRDF of the coat"),                                          \
        TSU_I_OUTPUT("reflected", "1/sr", "BRDF of the body"),                                     \
        TSU_I_OUTPUT("transmitted", "1/sr", "BTDF of the body")

#endif

// Scattering slabs as functions of the command, answered by the solver of optics/slab.h alone.
//
// slab         one layer between slides: powers, as the program iad names them.
// slab-bsdf    one layer: BRDF or BTDF of a pair of directions.
// slab-layers  a row is a whole stack. `layers` (1 to 6) says how many there are; layer k, counted
//              from the top, is in the columns nk (index), ak (albedo), bk (optical thickness, inf
//              allowed), gk and phasek: hg takes gk, rayleigh is 3/4 (1 + cos^2), moments takes the
//              Legendre moments chi1 to chi8 of the row (chi0 is 1). Columns left out take their
//              defaults: n 1, a 1, b 0, g 0, hg. Powers come out always; `f` is what `kind` asks
//              for, of light along mu0 (or a sky) from `side`: R and T are BRDF and BTDF towards
//              mu, phi; up and down the same inside, where the optical thickness above is `level`;
//              sky_up and sky_down radiance there under a sky of radiance 1; flux_up, flux_down,
//              sky_flux_up and sky_flux_down power that crosses the level.
#ifndef TSU_MODELS_LEAF_BODY_FUNCTIONS_SLAB_H
#define TSU_MODELS_LEAF_BODY_FUNCTIONS_SLAB_H

#include "models/model.h"

enum {
    SLAB_COLUMNS = 7,
    SLAB_OUTPUTS = 4,
    SLAB_BSDF_COLUMNS = 8,
    SLAB_LAYERS = 6,  // of a row of slab-layers
    SLAB_MOMENTS = 8, // chi1 ..
    SLAB_LAYER_COLUMNS = 5,
    SLAB_LAYERS_FIXED = 9, // columns before those of the layers
    SLAB_LAYERS_COLUMNS = SLAB_LAYERS_FIXED + SLAB_MOMENTS + SLAB_LAYERS * SLAB_LAYER_COLUMNS,
    SLAB_LAYERS_OUTPUTS = 8,
    // Room of any row, bytes. The tests hold them against tsu_i_slab_doubles().
    SLAB_BYTES = 6 << 20,
    SLAB_BSDF_BYTES = 3 << 20,
    SLAB_LAYERS_BYTES = 16 << 20
};

extern const tsu_value_info tsu_i_slab_inputs[], tsu_i_slab_outputs[];
extern const tsu_value_info tsu_i_slab_bsdf_inputs[], tsu_i_slab_bsdf_outputs[];
extern const tsu_value_info tsu_i_slab_layers_inputs[], tsu_i_slab_layers_outputs[];

// Nodes that are taken for a mean cosine g, the largest of all layers. Powers of one layer are
// right to 2e-8 (|g| to 0.95), 1e-6 (0.99), 4e-4 (0.999); radiances, relative and at the worst
// grazing directions, to 5e-6 (0.85), 2e-5 (0.9), 3e-3 (0.95), those of stacks to 2e-2 (0.95).
uint32_t tsu_i_slab_power_nodes(double g);
uint32_t tsu_i_slab_bsdf_nodes(double g, double n);
uint32_t tsu_i_slab_layers_nodes(double g);

// Slabs are no material of a model: its parameters stay as they are.
void tsu_i_slab_params(const double *in, void *params);
void tsu_i_slab_answer(const double *in, void *scratch, double *out);
void tsu_i_slab_bsdf_answer(const double *in, void *scratch, double *out);
// Fails where `level` is below the last layer.
tsu_status tsu_i_slab_layers_answer(const tsu_context *context, const double *in, void *scratch,
                                    double *out);

// Three elements of a model's list of functions.
#define SLAB_FUNCTION(n, h, inputs_, columns, outputs_, count, bytes)                              \
    .info = {.struct_size = sizeof(tsu_function_info),                                             \
             .flags = TSU_FUNCTION_REFERENCE_ONLY,                                                 \
             .name = n,                                                                            \
             .help = h,                                                                            \
             .input_count = columns,                                                               \
             .output_count = count},                                                               \
    .inputs = inputs_, .outputs = outputs_, .params = tsu_i_slab_params, .scratch_bytes = bytes
#define SLAB_FUNCTIONS                                                                             \
    {SLAB_FUNCTION("slab", "powers of a scattering slab with smooth walls, in air",                \
                   tsu_i_slab_inputs, SLAB_COLUMNS, tsu_i_slab_outputs, SLAB_OUTPUTS, SLAB_BYTES), \
     .solved = tsu_i_slab_answer},                                                                 \
        {SLAB_FUNCTION("slab-bsdf", "BRDF and BTDF of a scattering slab", tsu_i_slab_bsdf_inputs,  \
                       SLAB_BSDF_COLUMNS, tsu_i_slab_bsdf_outputs, 1, SLAB_BSDF_BYTES),            \
         .solved = tsu_i_slab_bsdf_answer},                                                        \
    {                                                                                              \
        SLAB_FUNCTION("slab-layers",                                                               \
                      "up to six layers, each of its own index, albedo and phase function: "       \
                      "powers from both sides, light that leaves and light inside",                \
                      tsu_i_slab_layers_inputs, SLAB_LAYERS_COLUMNS, tsu_i_slab_layers_outputs,    \
                      SLAB_LAYERS_OUTPUTS, SLAB_LAYERS_BYTES),                                     \
            .answer = tsu_i_slab_layers_answer                                                     \
    }

#endif

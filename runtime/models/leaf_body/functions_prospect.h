// "prospect" and "leaf-layers": what a leaf's layers are found from, and how they are.
#ifndef TSU_MODELS_LEAF_BODY_FUNCTIONS_PROSPECT_H
#define TSU_MODELS_LEAF_BODY_FUNCTIONS_PROSPECT_H

#include "models/leaf_body/functions.h"

enum { LEAF_PROSPECT_INPUTS = 8, LEAF_PROSPECT_OUTPUTS = 2 };
extern const tsu_value_info tsu_i_leaf_prospect_inputs[LEAF_PROSPECT_INPUTS];
extern const tsu_value_info tsu_i_leaf_prospect_outputs[LEAF_PROSPECT_OUTPUTS];
void tsu_i_leaf_prospect(const double *in, double *out);

enum { LEAF_LAYERS_INPUTS = 4, LEAF_LAYERS_OUTPUTS = 5 };
extern const tsu_value_info tsu_i_leaf_layers_inputs[LEAF_LAYERS_INPUTS];
extern const tsu_value_info tsu_i_leaf_layers_outputs[LEAF_LAYERS_OUTPUTS];
tsu_status tsu_i_leaf_layers(const tsu_context *context, const double *in, void *scratch,
                             double *out);

// No input of either belongs to the material.
void tsu_i_leaf_no_params(const double *in, void *params);

// Records, for the list of a model's functions.
#define LEAF_PROSPECT                                                                              \
    {                                                                                              \
        .info = {.struct_size = sizeof(tsu_function_info),                                         \
                 .flags = TSU_FUNCTION_REFERENCE_ONLY,                                             \
                 .name = "prospect",                                                               \
                 .help = "reflectance and transmittance of what a leaf is made of (PROSPECT-D)",   \
                 .input_count = LEAF_PROSPECT_INPUTS,                                              \
                 .output_count = LEAF_PROSPECT_OUTPUTS},                                           \
        .inputs = tsu_i_leaf_prospect_inputs, .outputs = tsu_i_leaf_prospect_outputs,              \
        .params = tsu_i_leaf_no_params, .reference = tsu_i_leaf_prospect                           \
    }
#define LEAF_LAYERS                                                                                \
    {                                                                                              \
        .info = {.struct_size = sizeof(tsu_function_info),                                         \
                 .flags = TSU_FUNCTION_REFERENCE_ONLY,                                             \
                 .name = "leaf-layers",                                                            \
                 .help = "layers of one channel from reflectance and transmittance",               \
                 .input_count = LEAF_LAYERS_INPUTS,                                                \
                 .output_count = LEAF_LAYERS_OUTPUTS},                                             \
        .inputs = tsu_i_leaf_layers_inputs, .outputs = tsu_i_leaf_layers_outputs,                  \
        .params = tsu_i_leaf_no_params, .scratch_bytes = LEAF_ANSWER_BYTES,                        \
        .answer = tsu_i_leaf_layers                                                                \
    }

#endif

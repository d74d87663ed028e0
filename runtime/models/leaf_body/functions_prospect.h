// "prospect": the biochemistry that a leaf's layers can be found from.
#ifndef TSU_MODELS_LEAF_BODY_FUNCTIONS_PROSPECT_H
#define TSU_MODELS_LEAF_BODY_FUNCTIONS_PROSPECT_H

#include "models/model.h"

enum { LEAF_PROSPECT_INPUTS = 8, LEAF_PROSPECT_OUTPUTS = 2 };
extern const tsu_value_info tsu_i_leaf_prospect_inputs[LEAF_PROSPECT_INPUTS];
extern const tsu_value_info tsu_i_leaf_prospect_outputs[LEAF_PROSPECT_OUTPUTS];
void tsu_i_leaf_prospect(const double *in, double *out);
// No input belongs to the material.
void tsu_i_leaf_prospect_params(const double *in, void *params);

// The record, for the list of a model's functions.
#define LEAF_PROSPECT                                                                              \
    {                                                                                              \
        .info = {.struct_size = sizeof(tsu_function_info),                                         \
                 .flags = TSU_FUNCTION_REFERENCE_ONLY,                                             \
                 .name = "prospect",                                                               \
                 .help = "reflectance and transmittance of what a leaf is made of (PROSPECT-D)",   \
                 .input_count = LEAF_PROSPECT_INPUTS,                                              \
                 .output_count = LEAF_PROSPECT_OUTPUTS},                                           \
        .inputs = tsu_i_leaf_prospect_inputs, .outputs = tsu_i_leaf_prospect_outputs,              \
        .params = tsu_i_leaf_prospect_params, .reference = tsu_i_leaf_prospect                     \
    }

#endif

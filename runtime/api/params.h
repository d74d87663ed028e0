// Typed parameters of any model, checked by their schema.
#ifndef TSU_API_PARAMS_H
#define TSU_API_PARAMS_H

#include "models/model.h"

enum { TSU_I_PARAMS_BYTES = 256 };

// Read host parameters over the model's defaults into `own` (TSU_I_PARAMS_BYTES) and check every
// field. TSU_E_STRUCT, TSU_E_PARAMETER; logged with field and range.
tsu_status tsu_i_params_read(const tsu_context *context, const tsu_model *model, const void *host,
                             void *own);

// Check one row of function inputs.
tsu_status tsu_i_inputs_check(const tsu_context *context, const tsu_model *model, uint32_t function,
                              const double *in);

// Zero the answer of a function that fails; `model`, `function` and `out` may name nothing.
void tsu_i_outputs_zero(const tsu_model *model, uint32_t function, double *out);

#endif

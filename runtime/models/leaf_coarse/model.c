#include "models/leaf_body/functions.h"

#include "models/leaf_body/parameters.h"
#include "models/values.h"

#include <tsuya/models/leaf_coarse.h>

#include <string.h>

typedef tsu_leaf_coarse_params params;

static const params defaults = {.struct_size = sizeof(params), LEAF_DEFAULTS};

static const tsu_parameter_info parameters[] = {LEAF_PARAMETERS(params)};

static const tsu_input_info inputs[] = {LEAF_INPUTS};

static const tsu_error_info errors[] = {
#include "models/leaf_coarse/errors.inc"
};

static const char *const snippets[] = {"leaf_body/eval.glsl", "leaf_coarse/eval.glsl", NULL};

static void prepare(const void *from, void *to)
{
    ((struct leaf_state *)to)->coarse = 1;
    tsu_i_leaf_body_prepare(from, to);
    tsu_i_leaf_coated(to);
}

static tsu_status answer(const tsu_context *context, const double *in, void *scratch, double *out)
{
    double all[3];
    const tsu_status status = tsu_i_leaf_answer(context, in, 0.0, scratch, all);
    memcpy(out, all + 1, 2 * sizeof *out);
    return status;
}

// Texel B of the table is 0, and the third number of A goes with P - 1.
static void sampled(const void *state, const float *record, const struct tsu_i_texels *tables,
                    const double *in, double *out)
{
    double all[3];
    tsu_i_leaf_sampled(state, record, tables, in, all);
    memcpy(out, all + 1, 2 * sizeof *out);
}

static const tsu_value_info leaf_inputs[] = {LEAF_COLUMNS};
static const tsu_value_info outputs[] = {LEAF_OUTPUTS};

static const struct tsu_i_function functions[] = {
    {.info = {.struct_size = sizeof(tsu_function_info),
              .name = "leaf-coarse",
              .help = "BRDF and BTDF of a leaf without its coat, by four numbers",
              .input_count = sizeof leaf_inputs / sizeof *leaf_inputs,
              .output_count = 2},
     .inputs = leaf_inputs,
     .outputs = outputs + 1,
     .probe = "leaf_coarse/probe_leaf.glsl",
     .scratch_bytes = LEAF_ANSWER_BYTES,
     .material = tsu_i_leaf_material,
     .answer = answer,
     .sampled = sampled}};

const struct tsu_model tsu_i_model_leaf_coarse = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .flags = TSU_MODEL_SURFACE,
             .name = "leaf_coarse",
             .title = "Leaf without gloss, four numbers of eight",
             .source = "M. Shinya, Rendering techniques for realistic material property "
                       "representation, section 3.3; van de Hulst 1980, Multiple Light Scattering",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .table_count = 1,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs,
             .function_count = sizeof functions / sizeof *functions},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .parameters = parameters,
    .tables = tsu_i_leaf_tables,
    .errors = errors,
    .inputs = inputs,
    .functions = functions,
    .snippets = snippets,
    .prepare = prepare,
    .record = tsu_i_leaf_body_record,
};

const tsu_model *tsu_leaf_coarse(void)
{
    return &tsu_i_model_leaf_coarse;
}

#include "models/leaf_body/functions.h"
#include "models/leaf_body/parameters.h"
#include "models/leaf_body/state.h"
#include "models/values.h"

#include <tsuya/models/leaf.h>

typedef tsu_leaf_params params;

// The body's functions read these as theirs.
_Static_assert(offsetof(params, n) == offsetof(tsu_leaf_body_params, n) &&
                   offsetof(params, thickness) == offsetof(tsu_leaf_body_params, thickness),
               "the parameters begin as leaf_body's");

static const params defaults = {.struct_size = sizeof(params), LEAF_DEFAULTS, .roughness = 0.35f};

static const tsu_parameter_info parameters[] = {
    LEAF_PARAMETERS(params),
    TSU_I_PARAMETER(params, roughness, 1, "1", 0, 0.05, 1, 0.35,
                    "width alpha of the GGX facets of the cuticle"),
};

static const tsu_input_info inputs[] = {LEAF_INPUTS, LEAF_FACE_INPUT};

static const tsu_variant_info variants[] = {{.struct_size = sizeof(tsu_variant_info),
                                             .name = "bent",
                                             .help = "with the geometric normal beside a bent one",
                                             .inputs = 127}};

static const tsu_error_info errors[] = {
#include "models/leaf/errors.inc"
};

static const char *const snippets[] = {"leaf_body/eval.glsl", "leaf_body/ambient.glsl",
                                       "leaf_body/uniform.glsl", "leaf/eval.glsl", NULL};

static void prepare(const void *from, void *to)
{
    struct leaf_state *state = to;
    tsu_i_leaf_body_prepare(from, to);
    state->roughness = ((const params *)from)->roughness;
    tsu_i_leaf_coated(state);
}

enum { ROUGHNESS = 13 }; // column, after LEAF_COLUMNS

static tsu_status material(const tsu_context *context, const double *in, void *scratch, void *to)
{
    ((params *)to)->roughness = (float)in[ROUGHNESS];
    return tsu_i_leaf_material(context, in, scratch, to);
}

static tsu_status answer(const tsu_context *context, const double *in, void *scratch, double *out)
{
    return tsu_i_leaf_answer(context, in, in[ROUGHNESS], scratch, out);
}

static void sampled(const void *state, const float *record, const struct tsu_i_texels *tables,
                    const double *in, double *out)
{
    tsu_i_leaf_sampled(state, record, tables, in, out);
}

static const tsu_value_info leaf_inputs[] = {
    LEAF_COLUMNS,
    TSU_I_MATERIAL("roughness", "1", "width alpha of the coat's GGX facets", 0.05, 1, 0.35)};
static const tsu_value_info outputs[] = {LEAF_OUTPUTS};

static const struct tsu_i_function functions[] = {
    {.info = {.struct_size = sizeof(tsu_function_info),
              .name = "leaf",
              .help = "BRDF and BTDF of a leaf, lobe by lobe",
              .input_count = sizeof leaf_inputs / sizeof *leaf_inputs,
              .output_count = sizeof outputs / sizeof *outputs},
     .inputs = leaf_inputs,
     .outputs = outputs,
     .probe = "leaf/probe_leaf.glsl",
     .scratch_bytes = LEAF_ANSWER_BYTES,
     .material = material,
     .answer = answer,
     .sampled = sampled}};

const struct tsu_model tsu_i_model_leaf = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .flags = TSU_MODEL_SURFACE,
             .name = "leaf",
             .title = "Leaf (two scattering layers under a rough cuticle)",
             .source = "M. Shinya, Rendering techniques for realistic material property "
                       "representation, section 3.3; Walter et al. 2007, Microfacet Models for "
                       "Refraction through Rough Surfaces",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .table_count = 1,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs,
             .function_count = sizeof functions / sizeof *functions,
             .variant_count = sizeof variants / sizeof *variants},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .parameters = parameters,
    .tables = tsu_i_leaf_tables,
    .errors = errors,
    .inputs = inputs,
    .variants = variants,
    .functions = functions,
    .snippets = snippets,
    .prepare = prepare,
    .record = tsu_i_leaf_body_record,
};

const tsu_model *tsu_leaf(void)
{
    return &tsu_i_model_leaf;
}

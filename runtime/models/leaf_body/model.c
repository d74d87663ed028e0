#include "models/leaf_body/state.h"

#include "models/leaf_body/parameters.h"
#include "models/values.h"
#include "optics/angle.h"

#include <math.h>
#include <string.h>

typedef tsu_leaf_body_params params;

static const params defaults = {.struct_size = sizeof(params), LEAF_DEFAULTS};

static const tsu_parameter_info parameters[] = {LEAF_PARAMETERS(params)};

static const tsu_input_info inputs[] = {LEAF_INPUTS, LEAF_FACE_INPUT};

static const tsu_variant_info variants[] = {{.struct_size = sizeof(tsu_variant_info),
                                             .name = "bent",
                                             .help = "with the geometric normal beside a bent one",
                                             .inputs = 127}};

static const tsu_error_info errors[] = {
#include "models/leaf_body/errors.inc"
};

const struct tsu_i_table tsu_i_leaf_tables[1] = {
    {.info = {.struct_size = sizeof(tsu_table_info),
              .name = "body",
              .axes = "x pigment, 16 columns from 0 to 2, twice: texels A and B; y 3 sets "
                      "(reflection below, transmission, reflection on top) x 3 channels x 7 "
                      "thicknesses from 0.5 to 2",
              .channels =
                  "A log2 of the value at normal incidence (1/sr) and the terms S, Q, P D; B "
                  "the terms U^2 + V^2, Z, P - 1, P S, all over that value",
              .width = LEAF_WIDTH,
              .height = LEAF_HEIGHT,
              .bytes = LEAF_WIDTH * LEAF_HEIGHT * 8},
     .key_offset = 0,
     .key_size = offsetof(struct leaf_state, pigment),
     .units = LEAF_PIGMENTS,
     .scratch_bytes = sizeof(struct leaf_room),
     .bake = tsu_i_leaf_bake,
     .finish = tsu_i_leaf_finish}};

static const char *const snippets[] = {"leaf_body/eval.glsl", "leaf_body/ambient.glsl",
                                       "leaf_body/uniform.glsl", NULL};

void tsu_i_leaf_body_prepare(const void *from, void *to)
{
    const params *p = from; // models that extend this one begin their parameters alike
    struct leaf_state *state = to;
    state->n = p->n;
    memcpy(state->scatter[0], p->scatter_top, sizeof p->scatter_top);
    memcpy(state->scatter[1], p->scatter_bottom, sizeof p->scatter_bottom);
    memcpy(state->absorption[0], p->absorption_top, sizeof p->absorption_top);
    memcpy(state->absorption[1], p->absorption_bottom, sizeof p->absorption_bottom);
    state->pigment = p->pigment;
    state->thickness = p->thickness;
}

static void prepare(const void *from, void *to)
{
    tsu_i_leaf_body_prepare(from, to);
    tsu_i_leaf_coated(to);
}

void tsu_i_leaf_body_record(const void *from, const struct tsu_i_place *places, float *out)
{
    const struct leaf_state *state = from;
    const float width = (float)places->width, height = (float)places->height;
    const double n = (double)state->n;
    out[0] = ((float)places->x + 0.5f) / width;
    out[1] = (float)(LEAF_PIGMENTS - 1) / width;
    out[2] = ((float)places->y + 0.5f) / height;
    out[3] = (float)(LEAF_THICKNESSES - 1) / height;
    out[4] = 0.5f * state->pigment;
    out[5] = 0.5f * state->thickness;
    out[6] = (float)(1.0 / (n * n));
    out[7] = (float)(1.0 - 1.0 / (n * n));
    memcpy(out + 8, state->walls, 4 * sizeof *out);
    out[12] = state->roughness * state->roughness;
    out[13] = state->entered;
    out[14] = (float)(n * n - 1.0);
    out[15] = state->walls[4];
    memcpy(out + 16, &state->moments, sizeof state->moments);
}

const struct tsu_model tsu_i_model_leaf_body = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .flags = TSU_MODEL_SURFACE,
             .name = "leaf_body",
             .title = "Leaf without gloss (two scattering layers)",
             .source = "M. Shinya, Rendering techniques for realistic material property "
                       "representation, section 3.3; van de Hulst 1980, Multiple Light Scattering",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .table_count = 1,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs,
             .function_count = LEAF_FUNCTIONS,
             .variant_count = sizeof variants / sizeof *variants},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .parameters = parameters,
    .tables = tsu_i_leaf_tables,
    .errors = errors,
    .inputs = inputs,
    .variants = variants,
    .functions = tsu_i_leaf_functions,
    .snippets = snippets,
    .prepare = prepare,
    .record = tsu_i_leaf_body_record,
};

const tsu_model *tsu_leaf_body(void)
{
    return &tsu_i_model_leaf_body;
}

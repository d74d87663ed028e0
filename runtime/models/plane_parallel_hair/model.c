#include "models/plane_parallel_hair/state.h"

#include "models/fiber_values.h"

#include <tsuya/models/plane_parallel_hair.h>
#include <tsuya/models/marschner.h>

#include <math.h>
#include <string.h>

typedef tsu_plane_parallel_hair_params params;

static const params defaults = {
    .struct_size = sizeof(params),
    TSU_I_FIBER_DEFAULTS,
    .d_f = 1.0f,
    .d_b = 1.0f,
};

static const tsu_parameter_info parameters[] = {
    TSU_I_FIBER_PARAMETERS(params, 1),
    TSU_I_MULTIPLE_PARAMETERS(params),
};

static const tsu_input_info inputs[] = {
    TSU_I_FIBER_INPUTS,
    TSU_I_MULTIPLE_INPUTS,
};

static const tsu_variant_info variants[] = {
    {.struct_size = sizeof(tsu_variant_info),
     .name = "finite",
     .help = "counts the fibres on the far side as well: thin hair and tips",
     .inputs = 0xff},
};

static const tsu_error_info errors[] = {
#include "models/plane_parallel_hair/errors.inc"
};

static const struct tsu_i_table tables[] = {
    {.info = {.struct_size = sizeof(tsu_table_info),
              .name = "azimuthal",
              .axes = "marschner's",
              .channels = "marschner's",
              .width = MARSCHNER_WIDTH,
              .height = MARSCHNER_HEIGHT,
              .bytes = MARSCHNER_WIDTH * MARSCHNER_HEIGHT * 8},
     .key_offset = offsetof(struct dual_state, fiber.eta),
     .key_size = 2 * sizeof(float),
     .units = MARSCHNER_HEIGHT,
     .bake = tsu_i_marschner_bake,
     .finish = tsu_i_marschner_finish},
    {.info = {.struct_size = sizeof(tsu_table_info),
              .name = "layer",
              .axes =
                  "48 rows: x log2(1 + 2000 sigma_a) / 16 in [0, 1], y sin(theta_r) (0.5 - 0.2 "
                  "cos(theta_r)) + 0.5; 32: y cos(theta_r) in [0, 1]; twice 24: x exp2(-front / 4) "
                  "in [0, 1], y x as before, to 3/4",
              .channels =
                  "k (log2(e) 2/pi), r, shares back and on; a_f, a_b; a, b, c of the lobes back "
                  "and on",
              .width = LAYER_WIDTH,
              .height = LAYER_HEIGHT,
              .bytes = LAYER_WIDTH * LAYER_HEIGHT * 8},
     .key_offset = offsetof(struct dual_state, fiber.eta),
     .key_size = offsetof(struct marschner_state, sigma_a) - offsetof(struct marschner_state, eta),
     .units = SOLVED_SIGMAS,
     .scratch_bytes = sizeof(struct layer_room),
     .bake = tsu_i_layer_bake,
     .finish = tsu_i_layer_finish}};

static const char *const snippets[] = {"marschner/longitudinal.glsl",
                                       "marschner/azimuthal.glsl",
                                       "marschner/eval.glsl",
                                       "dual_scattering/fields.glsl",
                                       "dual_scattering/eval.glsl",
                                       "plane_parallel_hair/eval.glsl",
                                       NULL};

static void prepare(const void *from, void *to)
{
    const params *p = from;
    struct dual_state *state = to;
    const tsu_marschner_params fiber = {.eta = p->eta,
                                        .alpha_R = p->alpha_R,
                                        .beta_R = p->beta_R,
                                        .beta_az = p->beta_az,
                                        .sigma_a = {p->sigma_a[0], p->sigma_a[1], p->sigma_a[2]},
                                        .scale_shifts = p->scale_shifts};
    tsu_i_marschner_prepare(&fiber, &state->fiber);
    state->d_f = p->d_f;
    state->d_b = p->d_b;
    state->gamma = (float)(tsu_i_two_stream_gamma(p->eta, p->beta_az) - LAYER_GAMMA);
}

static void record(const void *from, const struct tsu_i_place *places, float *out)
{
    const struct dual_state *state = from;
    const struct tsu_i_place *layer = places + 1;
    const float width = (float)layer->width, height = (float)layer->height;
    const float lobe = tsu_i_layer_lobe(state->fiber.sigma_a);
    tsu_i_marschner_record(&state->fiber, places, out);
    out[15] = state->gamma;
    // Over the integral of cos^4(phi/2).
    out[19] = state->d_b * 0.42441318f;
    out[22] = state->d_f * 0.42441318f;
    out[23] = (float)LAYER_LOBE_ROWS / height;
    out[24] = ((float)layer->x + (float)LAYER_WIDTH - 0.5f) / width;
    out[25] = ((float)layer->y + 0.5f) / height;
    out[26] = (float)(LAYER_WIDTH - 1) / (LAYER_OCTAVES * width);
    out[27] = DUAL_SPAN(LAYER_ROWS) / height;
    out[28] = ((float)layer->x + 0.5f) / width;
    out[29] = out[25] + ((float)LAYER_LOBES + lobe) / height;
    out[30] = (float)(LAYER_WIDTH - 1) / width;
}

const struct tsu_model tsu_i_model_plane_parallel_hair = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .name = "plane_parallel_hair",
             .title = "Hair in solved layers of hair",
             .source =
                 "Shinya et al. 2010, hair as plane-parallel layers; van de Hulst 1980, Multiple "
                 "Light Scattering",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .table_count = sizeof tables / sizeof *tables,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs,
             .variant_count = sizeof variants / sizeof *variants,
             .function_count = LAYER_FUNCTIONS},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .parameters = parameters,
    .tables = tables,
    .errors = errors,
    .inputs = inputs,
    .variants = variants,
    .functions = tsu_i_layer_functions,
    .snippets = snippets,
    .prepare = prepare,
    .record = record,
};

const tsu_model *tsu_plane_parallel_hair(void)
{
    return &tsu_i_model_plane_parallel_hair;
}

#include "models/dual_scattering/state.h"

#include "models/fiber_values.h"

#include <tsuya/models/dual_scattering.h>
#include <tsuya/models/marschner.h>

#include <string.h>

typedef tsu_dual_scattering_params params;

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
    {.struct_size = sizeof(tsu_variant_info),
     .name = "zinke",
     .help = "dual scattering as published in 2008",
     .inputs = 0xbf,
     .params_flags = TSU_DUAL_SCATTERING_ZINKE},
};

static const tsu_error_info errors[] = {
#include "models/dual_scattering/errors.inc"
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
              .name = "fields",
              .axes = "x log2(1 + 250 sigma_a) / 13 in [0, 1]; y cos(theta_r) in [0, 1]",
              .channels = "k (log2(e) 2/pi), r, shares back and on",
              .width = FIELDS_WIDTH,
              .height = FIELDS_ROWS,
              .bytes = FIELDS_WIDTH * FIELDS_ROWS * 8},
     .key_offset = offsetof(struct dual_state, fiber.eta),
     .key_size = 2 * sizeof(float),
     .units = FIELDS_ROWS,
     .bake = tsu_i_dual_bake_fields,
     .finish = tsu_i_dual_finish_fields},
    {.info = {.struct_size = sizeof(tsu_table_info),
              .name = "spread",
              .axes = "two bands of 16 rows: x exp2(-front / 4) in [0, 1], y absorption as in "
                      "fields",
              .channels = "a, b, c of the lobes back and on",
              .width = SPREAD_WIDTH,
              .height = SPREAD_HEIGHT,
              .bytes = SPREAD_WIDTH * SPREAD_HEIGHT * 8},
     .key_offset = offsetof(struct dual_state, fiber.eta),
     .key_size = offsetof(struct marschner_state, sigma_a) - offsetof(struct marschner_state, eta),
     .units = SPREAD_HEIGHT,
     .bake = tsu_i_dual_bake_spread},
    {.info = {.struct_size = sizeof(tsu_table_info),
              .name = "zinke",
              .axes = "four bands with the axes of fields",
              .channels = "log2 a_f, A_1 + A_3, cosine coefficients of N; Delta_b, sigma_b^2, "
                          "beta_f^2, a_b",
              .width = FIELDS_WIDTH,
              .height = ZINKE_HEIGHT,
              .bytes = FIELDS_WIDTH * ZINKE_HEIGHT * 8,
              .params_flags = TSU_DUAL_SCATTERING_ZINKE},
     .key_offset = offsetof(struct dual_state, fiber.eta),
     .key_size = offsetof(struct marschner_state, sigma_a) - offsetof(struct marschner_state, eta),
     .units = FIELDS_ROWS,
     .bake = tsu_i_dual_bake_zinke,
     .finish = tsu_i_dual_finish_zinke}};

static const char *const snippets[] = {"marschner/longitudinal.glsl",
                                       "marschner/azimuthal.glsl",
                                       "marschner/eval.glsl",
                                       "dual_scattering/fields.glsl",
                                       "dual_scattering/eval.glsl",
                                       "dual_scattering/zinke.glsl",
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
    state->gamma = (float)tsu_i_two_stream_gamma(p->eta, p->beta_az);
}

static void record(const void *from, const struct tsu_i_place *places, float *out)
{
    const struct dual_state *state = from;
    const struct tsu_i_place *fields = places + 1, *spread = places + 2, *zinke = places + 3;
    const float width = (float)fields->width, height = (float)fields->height;
    tsu_i_marschner_record(&state->fiber, places, out);
    out[15] = state->gamma;
    // Over the integral of cos^4(phi/2).
    out[19] = state->d_b * 0.42441318f;
    out[22] = state->d_f * 0.42441318f;
    out[23] = (float)SPREAD_ROWS / height;
    out[24] = ((float)fields->x + (float)FIELDS_WIDTH - 0.5f) / width;
    out[25] = ((float)fields->y + 0.5f) / height;
    out[26] = (float)(FIELDS_WIDTH - 1) / (SIGMA_OCTAVES * width);
    out[27] = DUAL_SPAN(FIELDS_ROWS) / height;
    const float u = tsu_i_dual_material_place(&state->fiber);
    out[28] = ((float)spread->x + 0.5f) / width;
    out[29] = ((float)spread->y + 0.5f + u * DUAL_SPAN(SPREAD_ROWS)) / height;
    out[30] = (float)(SPREAD_WIDTH - 1) / width;
    out[31] = zinke->width ? (float)zinke->y + (float)zinke->x / 65536.0f : -1.0f;
}

const struct tsu_model tsu_i_model_dual_scattering = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .name = "dual_scattering",
             .title = "Dual scattering in a head of hair",
             .source = "Zinke et al. 2008, Dual Scattering Approximation for Fast Multiple "
                       "Scattering in Hair; Chandrasekhar 1960, Radiative Transfer",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .table_count = sizeof tables / sizeof *tables,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs,
             .variant_count = sizeof variants / sizeof *variants,
             .function_count = DUAL_FUNCTIONS},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .known_flags = TSU_DUAL_SCATTERING_ZINKE,
    .parameters = parameters,
    .tables = tables,
    .errors = errors,
    .inputs = inputs,
    .variants = variants,
    .functions = tsu_i_dual_functions,
    .snippets = snippets,
    .prepare = prepare,
    .record = record,
};

const tsu_model *tsu_dual_scattering(void)
{
    return &tsu_i_model_dual_scattering;
}

#include "models/marschner/state.h"

#include "models/fiber_values.h"
#include "optics/angle.h"
#include "optics/fiber.h"

#include <tsuya/models/marschner.h>

#include <math.h>
#include <string.h>

typedef tsu_marschner_params params;

static const params defaults = {
    .struct_size = sizeof(params),
    TSU_I_FIBER_DEFAULTS,
};

static const tsu_parameter_info parameters[] = {
    TSU_I_FIBER_PARAMETERS(params, 0),
};

static const tsu_input_info inputs[] = {
    TSU_I_FIBER_INPUTS,
};

static const tsu_error_info errors[] = {
#include "models/marschner/errors.inc"
};

static const struct tsu_i_table tables[] = {
    {.info = {.struct_size = sizeof(tsu_table_info),
              .name = "azimuthal",
              .axes = "x sin(phi/2) - cos(phi/2) in [-1, 1]; y two bands of cos(theta_r) in [0, "
                      "1], 80 and 48 rows",
              .channels = "lower band N of R, TT, TRT, residual (1/rad); upper band L, V of TT, L "
                          "of TRT, L of the residual (log2(e) fibre radii)",
              .width = MARSCHNER_WIDTH,
              .height = MARSCHNER_HEIGHT,
              .bytes = MARSCHNER_WIDTH * MARSCHNER_HEIGHT * 8},
     .key_offset = offsetof(struct marschner_state, eta),
     .key_size = 2 * sizeof(float),
     .units = MARSCHNER_HEIGHT,
     .bake = tsu_i_marschner_bake,
     .finish = tsu_i_marschner_finish}};

static const struct tsu_i_measure measures[] = {{"azimuthal_all", tsu_i_marschner_worst},
                                                {"residual_all", tsu_i_marschner_worst_residual}};

static const char *const snippets[] = {"marschner/longitudinal.glsl", "marschner/azimuthal.glsl",
                                       "marschner/eval.glsl", NULL};

void tsu_i_marschner_lobes(double alpha_R, double beta_R, double scale_shifts, double alpha[4],
                           double beta[4])
{
    static const double textbook[4] = {1.0, -0.5, -1.5, -2.5}, scales[4] = {1.0, -0.92, -3.2, -1.2};
    static const double width[4] = {1.0, 0.5, 2.0, 2.0};
    for (int p = 0; p < 4; p++) {
        alpha[p] = alpha_R * (textbook[p] + scale_shifts * (scales[p] - textbook[p]));
        beta[p] = beta_R * width[p];
    }
}

void tsu_i_marschner_prepare(const void *from, void *to)
{
    const params *p = from;
    struct marschner_state *state = to;
    state->eta = p->eta;
    state->beta_az = p->beta_az;
    tsu_i_marschner_lobes(p->alpha_R, p->beta_R, p->scale_shifts, state->alpha, state->beta);
    memcpy(state->sigma_a, p->sigma_a, sizeof state->sigma_a);
}

void tsu_i_marschner_record(const void *from, const struct tsu_i_place *places, float *out)
{
    const struct marschner_state *state = from;
    for (int p = 0; p < 3; p++) {
        const double v = state->beta[p] * state->beta[p];
        const double c = 1.0 / (v * -expm1(-2.0 / v));
        out[4 * p + 0] = (float)(TSU_I_LOG2E * cos(state->alpha[p]) / v);
        out[4 * p + 1] = (float)(TSU_I_LOG2E * sin(state->alpha[p]) / v);
        // 3.09446921: scale of I0e's fit, see glsl/marschner/longitudinal.glsl.
        out[4 * p + 2] = (float)(log2(c) - TSU_I_LOG2E / v - 0.5 * log2(3.09446921));
    }
    const float width = (float)places->width, height = (float)places->height;
    out[3] = ((float)places->x + 64.0f) / width;
    out[7] = ((float)places->y + 0.5f) / height;
    out[11] = ((float)places->y + (float)MARSCHNER_ROWS + 0.5f) / height;
    out[12] = 63.5f / width;
    out[13] = MARSCHNER_SPAN(MARSCHNER_ROWS) / height;
    out[14] = MARSCHNER_SPAN(MARSCHNER_PATH_ROWS) / height;
    out[15] = state->eta;
    memcpy(out + 16, state->sigma_a, sizeof state->sigma_a);
    const double v = state->beta[TSU_I_RES] * state->beta[TSU_I_RES];
    out[20] = (float)(TSU_I_LOG2E * cos(state->alpha[TSU_I_RES]) / v);
    out[21] = (float)(TSU_I_LOG2E * sin(state->alpha[TSU_I_RES]) / v);
}

const struct tsu_model tsu_i_model_marschner = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .name = "marschner",
             .title = "Marschner fibre (R, TT, TRT, residual)",
             .source =
                 "Marschner et al. 2003, Light Scattering from Human Hair Fibers; d'Eon et al. "
                 "2011, An Energy-Conserving Hair Reflectance Model",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .table_count = sizeof tables / sizeof *tables,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs,
             .function_count = MARSCHNER_FUNCTIONS},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .parameters = parameters,
    .tables = tables,
    .measures = measures,
    .measure_count = sizeof measures / sizeof *measures,
    .errors = errors,
    .inputs = inputs,
    .functions = tsu_i_marschner_functions,
    .snippets = snippets,
    .prepare = tsu_i_marschner_prepare,
    .record = tsu_i_marschner_record,
};

const tsu_model *tsu_marschner(void)
{
    return &tsu_i_model_marschner;
}

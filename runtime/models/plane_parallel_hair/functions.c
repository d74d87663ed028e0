// What the model can be asked: "hair-multiple-plane_parallel".
#include "models/plane_parallel_hair/state.h"

#include "models/values.h"
#include "optics/fiber_layer.h"
#include "optics/strand_named.h"

#include <tsuya/models/plane_parallel_hair.h>

#include <math.h>

// Azimuths of the reference: 0.1 % of R and T.
enum { AZIMUTHS = 8, SIZE = TSU_I_LAYER_THETAS_MOST * (AZIMUTHS + 1) };

static void multiple_params(const double *in, void *params)
{
    tsu_plane_parallel_hair_params *p = params;
    const struct tsu_i_strand_columns columns = tsu_i_strand_named(in + 3, (int)in[8]);
    p->eta = (float)columns.eta;
    p->alpha_R = (float)columns.alpha_R;
    p->beta_R = (float)columns.beta_R;
    p->beta_az = (float)columns.beta_az;
    p->scale_shifts = (float)columns.scale_shifts;
    for (int k = 0; k < 3; k++)
        p->sigma_a[k] = (float)in[1];
}

static void reference(const double *in, void *scratch, double *out)
{
    const struct tsu_i_strand_columns columns = tsu_i_strand_named(in + 3, (int)in[8]);
    struct tsu_i_strand strand = {.eta = columns.eta,
                                  .sigma_a = in[1],
                                  .beta_az = columns.beta_az,
                                  .kind = columns.kind,
                                  .lobes = columns.lobes};
    struct tsu_i_event event;
    tsu_i_marschner_lobes(columns.alpha_R, columns.beta_R, columns.scale_shifts, strand.alpha,
                          strand.beta);
    tsu_i_strand_event(&strand, in[0], &event);
    const struct tsu_i_turn turn = tsu_i_strand_turn(&event);
    out[0] = turn.forward;
    out[1] = turn.backward;
    tsu_i_layer_slab(&strand, in[0], in[2], AZIMUTHS, scratch, out + 2, out + 3);
}

static void sampled(const void *opaque, const float *record, const struct tsu_i_texels *tables,
                    const double *in, double *out)
{
    const struct dual_state *state = opaque;
    const float row = LAYER_LOBES + tsu_i_layer_lobe(state->fiber.sigma_a);
    struct tsu_i_dual_slab slab = {.record = record,
                                   .azimuthal = tables,
                                   .lobes = tables + 1,
                                   .sigma_a = (float)in[1],
                                   .sin_r = (float)sin(in[0]),
                                   .columns = LAYER_WIDTH,
                                   .rows = LAYER_HEIGHT,
                                   .delay = LAYER_DELAY,
                                   .row = {row, row + LAYER_LOBE_ROWS}};
    const float cos_r = sqrtf(fabsf(1.0f - slab.sin_r * slab.sin_r));
    tsu_i_marschner_fetch(
        tables + 1, LAYER_WIDTH, LAYER_HEIGHT, tsu_i_layer_place(slab.sigma_a) * (LAYER_WIDTH - 1),
        (slab.sin_r * (0.5f - LAYER_STEEP * cos_r) + 0.5f) * DUAL_SPAN(LAYER_ROWS), slab.stream);
    tsu_i_dual_slab(&slab, in[2], out);
    float shares[4];
    tsu_i_marschner_fetch(
        tables + 1, LAYER_WIDTH, LAYER_HEIGHT, tsu_i_layer_place(slab.sigma_a) * (LAYER_WIDTH - 1),
        (float)fmax(cos(in[0]), 0.0) * DUAL_SPAN(LAYER_SHARE_ROWS) + LAYER_ROWS, shares);
    out[0] = shares[0];
    out[1] = shares[1];
}

static const tsu_value_info inputs[] = {TSU_I_STRAND_INPUTS};
static const tsu_value_info outputs[] = {TSU_I_STRAND_OUTPUTS};

const struct tsu_i_function tsu_i_layer_functions[LAYER_FUNCTIONS] = {
    {.info = {.struct_size = sizeof(tsu_function_info),
              .name = "hair-multiple-plane_parallel",
              .help = "slab of parallel fibres, the layer problem solved; shares aligned",
              .input_count = sizeof inputs / sizeof *inputs,
              .output_count = sizeof outputs / sizeof *outputs},
     .inputs = inputs,
     .outputs = outputs,
     .params = multiple_params,
     .scratch_bytes = (size_t)7 * SIZE * SIZE * sizeof(double),
     .solved = reference,
     .probe = "plane_parallel_hair/probe_multiple.glsl",
     .sampled = sampled}};

// What the model can be asked: "hair-multiple" and its variants.
#include "models/dual_scattering/state.h"

#include "models/values.h"
#include "optics/fiber_slab.h"
#include "optics/strand_named.h"

#include <tsuya/models/dual_scattering.h>

#include <math.h>

static void multiple_params(const double *in, void *params)
{
    tsu_dual_scattering_params *p = params;
    const struct tsu_i_strand_columns columns = tsu_i_strand_named(in + 3, (int)in[8]);
    p->eta = (float)columns.eta;
    p->alpha_R = (float)columns.alpha_R;
    p->beta_R = (float)columns.beta_R;
    p->beta_az = (float)columns.beta_az;
    p->scale_shifts = (float)columns.scale_shifts;
    for (int k = 0; k < 3; k++)
        p->sigma_a[k] = (float)in[1];
}

static void zinke_params(const double *in, void *params)
{
    multiple_params(in, params);
    ((tsu_dual_scattering_params *)params)->flags |= TSU_DUAL_SCATTERING_ZINKE;
}

static struct tsu_i_strand strand_of(const double *in)
{
    const struct tsu_i_strand_columns columns = tsu_i_strand_named(in + 3, (int)in[8]);
    struct tsu_i_strand strand = {.eta = columns.eta,
                                  .sigma_a = in[1],
                                  .beta_az = columns.beta_az,
                                  .kind = columns.kind,
                                  .lobes = columns.lobes};
    tsu_i_marschner_lobes(columns.alpha_R, columns.beta_R, columns.scale_shifts, strand.alpha,
                          strand.beta);
    return strand;
}

static struct tsu_i_fields stream_fields(const void *data, double front, double behind,
                                         double direct)
{
    return tsu_i_two_stream_fields(data, front, behind, direct);
}

static void exact_reference(const double *in, double *out)
{
    const struct tsu_i_strand strand = strand_of(in);
    double c[TSU_I_FIBER_ORDERS][TSU_I_LOBES], sum[TSU_I_FIBER_ORDERS];
    struct tsu_i_event event;
    const int orders = tsu_i_strand_cosines(&strand, in[0], c);
    tsu_i_strand_halves(orders, c, &event);
    for (int k = 0; k < orders; k++)
        sum[k] = c[k][0] + c[k][1] + c[k][2] + c[k][3];
    const struct tsu_i_turn turn = tsu_i_strand_turn(&event);
    const struct tsu_i_stream stream =
        tsu_i_two_stream(&turn, strand.eta, tsu_i_two_stream_gamma(strand.eta, strand.beta_az));
    out[0] = turn.forward;
    out[1] = turn.backward;
    tsu_i_fiber_slab(orders, sum, stream_fields, &stream, in[2], out + 2, out + 3);
}

static void zinke_reference(const double *in, double *out)
{
    const struct tsu_i_strand strand = strand_of(in);
    struct tsu_i_event event;
    struct tsu_i_dual_zinke zinke;
    tsu_i_strand_event(&strand, in[0], &event);
    tsu_i_dual_zinke(&strand, &event, &zinke);
    out[0] = zinke.forward;
    out[1] = zinke.back;
    out[2] = zinke.back + zinke.albedo;
    out[3] = pow(zinke.forward, in[2]);
}

static const tsu_value_info multiple_inputs[] = {TSU_I_STRAND_INPUTS};
static const tsu_value_info multiple_outputs[] = {TSU_I_STRAND_OUTPUTS};

#define MULTIPLE(n, h)                                                                             \
    {                                                                                              \
        .struct_size = sizeof(tsu_function_info), .name = n, .help = h,                            \
        .input_count = sizeof multiple_inputs / sizeof *multiple_inputs,                           \
        .output_count = sizeof multiple_outputs / sizeof *multiple_outputs                         \
    }

const struct tsu_i_function tsu_i_dual_functions[DUAL_FUNCTIONS] = {
    {.info = MULTIPLE("hair-multiple", "slab of parallel fibres, all orders; shares aligned"),
     .inputs = multiple_inputs,
     .outputs = multiple_outputs,
     .params = multiple_params,
     .reference = exact_reference,
     .probe = "dual_scattering/probe_multiple.glsl",
     .sampled = tsu_i_dual_sampled_exact},
    {.info = MULTIPLE("hair-multiple-exact", "the same by its variant's name"),
     .inputs = multiple_inputs,
     .outputs = multiple_outputs,
     .params = multiple_params,
     .reference = exact_reference,
     .probe = "dual_scattering/probe_multiple.glsl",
     .sampled = tsu_i_dual_sampled_exact},
    {.info = MULTIPLE("hair-multiple-zinke", "dual scattering as published; shares averaged"),
     .inputs = multiple_inputs,
     .outputs = multiple_outputs,
     .params = zinke_params,
     .reference = zinke_reference,
     .probe = "dual_scattering/probe_multiple_zinke.glsl",
     .params_flags = TSU_DUAL_SCATTERING_ZINKE,
     .sampled = tsu_i_dual_sampled_zinke}};

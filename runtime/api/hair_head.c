#include "base/desc.h"
#include "base/host.h"
#include "models/marschner/state.h"
#include "models/values.h"
#include "optics/head_albedo.h"

#include <tsuya/hair_color.h>

#include <string.h>

_Static_assert((int)TSU_HAIR_HEAD_NODES == (int)TSU_I_HEAD_NODES, "the curve holds the nodes");

// Solutions under way at once; each has memory of its own.
enum { LANES = 8 };

static const tsu_hair_head_desc defaults = {.struct_size = sizeof defaults,
                                            .eta = 1.55f,
                                            .alpha_R = (float)TSU_I_DEGREES(-7.5),
                                            .beta_R = (float)TSU_I_DEGREES(7.5),
                                            .beta_az = (float)TSU_I_DEGREES(10)};

static const double default_albedo[TSU_I_HEAD_NODES] = {
#include "optics/head_default.inc"
};

tsu_status tsu_hair_head_desc_init_sized(tsu_hair_head_desc *desc, size_t size)
{
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, sizeof defaults);
}

static int reject(const tsu_context *context, const char *field, float value, double low,
                  double high)
{
    if (value >= (float)low && value <= (float)high)
        return 0;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_COLOR,
              "tsu_hair_head_desc.%s = %g, expected [%g, %g]", field, (double)value, low, high);
    return 1;
}

static tsu_status check_desc(const tsu_context *context, const tsu_hair_head_desc *desc)
{
    if (desc->flags || desc->reserved) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS, "tsu_hair_head_desc.%s = %u, expected 0",
                  desc->flags ? "flags" : "reserved", desc->flags ? desc->flags : desc->reserved);
        return TSU_E_PARAMETER;
    }
    const double shift = TSU_I_DEGREES(20);
    if (reject(context, "eta", desc->eta, 1.2, 2.0) ||
        reject(context, "alpha_R", desc->alpha_R, -shift, shift) ||
        reject(context, "beta_R", desc->beta_R, TSU_I_DEGREES(2), TSU_I_DEGREES(30)) ||
        reject(context, "beta_az", desc->beta_az, TSU_I_DEGREES(5), TSU_I_DEGREES(30)) ||
        reject(context, "scale_shifts", desc->scale_shifts, 0.0, 1.0))
        return TSU_E_PARAMETER;
    return TSU_OK;
}

struct work {
    struct tsu_i_strand strand;
    int azimuths, first;
    double *memory;
    double *albedo;
};

static void solve_node(void *data, uint32_t lane)
{
    const struct work *work = data;
    const int node = work->first + (int)lane;
    struct tsu_i_strand strand = work->strand;
    strand.sigma_a = tsu_i_head_sigma_a(node);
    work->albedo[node] = tsu_i_head_solve(&strand, 0.0, work->azimuths,
                                          work->memory + lane * tsu_i_head_doubles(work->azimuths));
}

static tsu_status solve(const tsu_context *context, const tsu_hair_head_desc *desc, double *albedo)
{
    struct work work = {.strand = {.eta = (double)desc->eta,
                                   .beta_az = (double)desc->beta_az,
                                   .kind = TSU_I_STRAND_DEON,
                                   .lobes = TSU_I_LOBES},
                        .azimuths = tsu_i_head_azimuths((double)desc->beta_az),
                        .albedo = albedo};
    tsu_i_marschner_lobes((double)desc->alpha_R, (double)desc->beta_R, (double)desc->scale_shifts,
                          work.strand.alpha, work.strand.beta);
    const uint32_t lanes = context->desc.jobs ? LANES : 1;
    const size_t doubles = lanes * tsu_i_head_doubles(work.azimuths);
    work.memory = tsu_i_alloc(context, doubles, sizeof *work.memory);
    if (!work.memory)
        return TSU_E_MEMORY;
    albedo[0] = 1.0;
    for (work.first = 1; work.first < TSU_I_HEAD_NODES; work.first += (int)lanes)
        tsu_i_jobs(context, solve_node, &work, lanes);
    tsu_i_free(context, work.memory, doubles, sizeof *work.memory);
    // The last two differ by less than the solutions err.
    for (int i = TSU_I_HEAD_NODES - 2; i > 0; i--)
        if (albedo[i] < albedo[i + 1])
            albedo[i] = albedo[i + 1];
    return TSU_OK;
}

tsu_status tsu_hair_head_curve_solve(tsu_context *context, const tsu_hair_head_desc *desc,
                                     tsu_hair_head_curve *curve)
{
    if (!curve)
        return TSU_E_PARAMETER;
    if (!context)
        return tsu_i_desc_fail(curve, sizeof *curve, TSU_E_PARAMETER);
    tsu_hair_head_desc own;
    tsu_status status =
        tsu_i_desc_read(context, "tsu_hair_head_desc", desc, &own, sizeof own, sizeof own);
    if (status == TSU_OK)
        status = check_desc(context, &own);
    tsu_hair_head_curve made = {.struct_size = sizeof made};
    uint32_t size = 0;
    if (status == TSU_OK) {
        memcpy(&size, curve, sizeof size);
        status = size < sizeof made ? TSU_E_STRUCT : TSU_OK;
    }
    if (status == TSU_OK) {
        made.eta = own.eta;
        made.alpha_R = own.alpha_R;
        made.beta_R = own.beta_R;
        made.beta_az = own.beta_az;
        made.scale_shifts = own.scale_shifts;
        own.struct_size = sizeof defaults;
        if (memcmp(&own, &defaults, sizeof own))
            status = solve(context, &own, made.albedo);
        else
            memcpy(made.albedo, default_albedo, sizeof made.albedo);
    }
    return status == TSU_OK ? tsu_i_desc_write(curve, &made, sizeof made)
                            : tsu_i_desc_fail(curve, sizeof *curve, status);
}

// Read a curve and three numbers for either direction; *out is zero until it succeeds.
static tsu_status begin(const tsu_context *context, const tsu_hair_head_curve *curve,
                        const double in[3], double out[3], tsu_hair_head_curve *own,
                        double values[3])
{
    for (int k = 0; k < 3; k++)
        values[k] = in ? in[k] : 0.0;
    if (out)
        out[0] = out[1] = out[2] = 0.0;
    if (!in || !out)
        return TSU_E_PARAMETER;
    const tsu_status status =
        tsu_i_desc_read(context, "tsu_hair_head_curve", curve, own, sizeof *own, sizeof *own);
    if (status != TSU_OK)
        return status;
    int whole = own->albedo[0] == 1.0 && own->albedo[TSU_I_HEAD_NODES - 1] > 0.0;
    for (int i = 1; i < TSU_I_HEAD_NODES; i++)
        whole = whole && own->albedo[i] <= own->albedo[i - 1];
    if (whole)
        return TSU_OK;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_COLOR,
              "tsu_hair_head_curve.albedo does not fall from 1; fill it with "
              "tsu_hair_head_curve_solve()");
    return TSU_E_PARAMETER;
}

tsu_status tsu_hair_head_albedo(tsu_context *context, const tsu_hair_head_curve *curve,
                                const double sigma_a[3], double albedo[3])
{
    tsu_hair_head_curve own;
    double values[3];
    const tsu_status status = begin(context, curve, sigma_a, albedo, &own, values);
    if (status != TSU_OK)
        return status;
    for (int k = 0; k < 3; k++)
        if (!(values[k] >= 0.0 && values[k] <= TSU_I_HEAD_DARKEST)) {
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_COLOR, "sigma_a = %g, expected [%g, %g]",
                      values[k], 0.0, TSU_I_HEAD_DARKEST);
            return TSU_E_PARAMETER;
        }
    for (int k = 0; k < 3; k++)
        albedo[k] = tsu_i_head_forward(own.albedo, values[k]);
    return TSU_OK;
}

tsu_status tsu_hair_head_sigma_a(tsu_context *context, const tsu_hair_head_curve *curve,
                                 const double albedo[3], double sigma_a[3])
{
    tsu_hair_head_curve own;
    double values[3];
    const tsu_status status = begin(context, curve, albedo, sigma_a, &own, values);
    if (status != TSU_OK)
        return status;
    const double least = own.albedo[TSU_I_HEAD_NODES - 1];
    for (int k = 0; k < 3; k++)
        if (!(values[k] > least && values[k] <= 1.0)) {
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_COLOR,
                      "head_albedo = %g, expected (%g, 1]: black hair of eta %g reflects that much "
                      "at its surfaces",
                      values[k], least, (double)own.eta);
            return TSU_E_PARAMETER;
        }
    for (int k = 0; k < 3; k++)
        sigma_a[k] = tsu_i_head_inverse(own.albedo, values[k]);
    return TSU_OK;
}

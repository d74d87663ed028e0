#include "base/desc.h"
#include "base/host.h"
#include "optics/diffusion.h"
#include "optics/slab_blur.h"

#include <tsuya/leaf_scale.h>

#include <math.h>
#include <string.h>

_Static_assert((int)TSU_LEAF_GAUSSIANS == (int)TSU_I_GAUSSIANS, "a scale holds the Gaussians");

enum { CHANNELS = TSU_I_BLUR_CHANNELS };

tsu_status tsu_leaf_scale_desc_init_sized(tsu_leaf_scale_desc *desc, size_t size)
{
    const tsu_leaf_scale_desc defaults = {.struct_size = sizeof defaults,
                                          .method = TSU_LEAF_TRANSPORT,
                                          .gaussians = 4,
                                          .n = 1.45f,
                                          .g = 0.5f,
                                          .thickness = 0.2f,
                                          .share_top = 0.5f,
                                          .scatter_top = {1.0f, 1.0f, 1.0f},
                                          .absorption_top = {1.2f, 0.3f, 2.4f},
                                          .scatter_bottom = {1.0f, 1.0f, 1.0f},
                                          .absorption_bottom = {1.2f, 0.3f, 2.4f},
                                          .fraction = 0.9f};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, sizeof defaults);
}

static int reject(const tsu_context *context, const char *field, double value, double low,
                  double high)
{
    // Bounds are written in decimals, fields are float.
    if ((float)value >= (float)low && (float)value <= (float)high)
        return 0;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF, "%s = %g, expected [%g, %g]", field, value, low,
              high);
    return 1;
}

static tsu_status check(const tsu_context *context, const tsu_leaf_scale_desc *desc)
{
    if (desc->flags & ~(uint32_t)TSU_LEAF_LIT_BELOW) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS,
                  "tsu_leaf_scale_desc.flags = %u, expected TSU_LEAF_LIT_BELOW or 0", desc->flags);
        return TSU_E_PARAMETER;
    }
    if (reject(context, "tsu_leaf_scale_desc.method", desc->method, TSU_LEAF_TRANSPORT,
               TSU_LEAF_PHOTON_BEAM) ||
        reject(context, "tsu_leaf_scale_desc.gaussians", desc->gaussians, 2, TSU_LEAF_GAUSSIANS) ||
        reject(context, "tsu_leaf_scale_desc.n", (double)desc->n, 1.0, 2.0) ||
        reject(context, "tsu_leaf_scale_desc.g", (double)desc->g, 0.0, 0.8) ||
        reject(context, "tsu_leaf_scale_desc.thickness", (double)desc->thickness, 1e-3, 1e3) ||
        reject(context, "tsu_leaf_scale_desc.share_top", (double)desc->share_top, 0.05, 0.95) ||
        reject(context, "tsu_leaf_scale_desc.fraction", (double)desc->fraction, 0.05, 0.99) ||
        reject(context, "tsu_leaf_scale_desc.reserved", (double)desc->reserved, 0.0, 0.0))
        return TSU_E_PARAMETER;
    static const char *const names[] = {
        "tsu_leaf_scale_desc.scatter_top", "tsu_leaf_scale_desc.absorption_top",
        "tsu_leaf_scale_desc.scatter_bottom", "tsu_leaf_scale_desc.absorption_bottom"};
    const float *const fields[] = {desc->scatter_top, desc->absorption_top, desc->scatter_bottom,
                                   desc->absorption_bottom};
    for (int f = 0; f < 4; f++)
        for (int c = 0; c < CHANNELS; c++)
            if (reject(context, names[f], (double)fields[f][c], 0.0, f % 2 ? 10.0 : 5.0))
                return TSU_E_PARAMETER;
    return TSU_OK;
}

static struct tsu_i_spread_slab slab_of(const tsu_leaf_scale_desc *desc, int c)
{
    const double g = (double)desc->g, top = (double)desc->thickness * (double)desc->share_top;
    const struct tsu_i_spread_layer layers[2] = {
        {(double)desc->scatter_top[c] / (1.0 - g), (double)desc->absorption_top[c], top},
        {(double)desc->scatter_bottom[c] / (1.0 - g), (double)desc->absorption_bottom[c],
         (double)desc->thickness - top}};
    const int first = desc->flags & TSU_LEAF_LIT_BELOW ? 1 : 0;
    return (struct tsu_i_spread_slab){
        .n = (double)desc->n, .g = g, .layers = 2, .layer = {layers[first], layers[1 - first]}};
}

// Both layers as one.
static struct tsu_i_medium medium_of(const struct tsu_i_spread_slab *slab)
{
    struct tsu_i_medium medium = {.g = slab->g, .n = slab->n};
    for (int i = 0; i < slab->layers; i++) {
        medium.sigma_a += slab->layer[i].absorption;
        medium.sigma_s += slab->layer[i].scatter;
        medium.thickness += slab->layer[i].thickness;
    }
    medium.sigma_a /= medium.thickness;
    medium.sigma_s /= medium.thickness;
    return medium;
}

struct work {
    struct tsu_i_spread_slab slab[CHANNELS];
    int method; // TSU_I_DIFFUSION_*, or -1
    unsigned char *memory;
    size_t bytes;
    struct tsu_i_transforms reflected, through;
    struct tsu_i_spread total[CHANNELS];
    int failed[CHANNELS];
};

static void diffuse(int method, const struct tsu_i_medium *medium, double k, double *reflected,
                    double *through)
{
    tsu_i_diffusion_transform(method, medium, k, reflected, through);
    if (method == TSU_I_DIFFUSION_BETTER || method == TSU_I_DIFFUSION_BEAM) {
        struct tsu_i_medium reduced = tsu_i_medium_reduced(medium);
        double once, nothing;
        reduced.thickness = INFINITY;
        tsu_i_single_transform(&reduced, k, &once, &nothing);
        *reflected += once;
    }
}

static void sample_channel(void *data, uint32_t index)
{
    struct work *work = data;
    const int c = (int)index;
    void *memory = work->memory + index * work->bytes;
    const struct tsu_i_medium medium = medium_of(work->slab + c);
    work->failed[c] = !tsu_i_spread_solve(work->slab + c, 0.0, memory, work->total + c);
    for (int i = 0; i < work->reflected.samples; i++) {
        const double k = work->reflected.k[i];
        double *r = work->reflected.value[c] + i, *t = work->through.value[c] + i;
        struct tsu_i_spread one = work->total[c];
        if (work->method >= 0) {
            diffuse(work->method, &medium, k, r, t);
            continue;
        }
        if (k > 0.0 && !tsu_i_spread_solve(work->slab + c, k, memory, &one))
            work->failed[c] = 1;
        *r = fmax(one.reflected, 0.0);
        *t = fmax(one.through, 0.0);
    }
}

static double off(double value, double truth)
{
    return truth > 0.0 ? fabs(value / truth - 1.0) : 0.0;
}

// Whether a method may be used; the numbers go to the result.
static int refuse(const tsu_context *context, const tsu_leaf_scale_desc *desc,
                  const struct work *work, tsu_leaf_scale *made)
{
    static const char *const reason[] = {
        "", "its reduced albedo is too low", "it is too thin, in mean free paths",
        "it is too thick, in 1 / sigma_tr", "R or T is too far off"};
    int refused = 0;
    for (int c = 0; c < CHANNELS && work->method >= 0; c++) {
        const struct tsu_i_medium medium = medium_of(work->slab + c);
        double value, error = off(work->reflected.value[c][0], work->total[c].reflected);
        if (work->method == TSU_I_DIFFUSION_MULTIPOLE)
            error = fmax(error, off(work->through.value[c][0],
                                    work->total[c].through + work->total[c].straight));
        int why = tsu_i_diffusion_check(work->method, &medium, &value);
        if (!why && error > TSU_I_DIFFUSION_BOUND) {
            why = TSU_LEAF_TOTAL;
            value = error;
        }
        made->refusal[c] = why;
        made->refusal_value[c] = why ? (float)value : 0.0f;
        made->total_error[c] = (float)error;
        if (!why)
            continue;
        refused = 1;
        tsu_i_log(
            context, TSU_LOG_ERROR, TSU_LOG_LEAF,
            "tsu_leaf_scale_desc.method = %d is refused for channel %d: %s (%g); R or T would "
            "be off by %g of itself",
            (int)desc->method, c, reason[why], value, error);
    }
    return refused;
}

static void write_side(const struct tsu_i_transforms *transforms, const tsu_leaf_scale_desc *desc,
                       float blur[24], float radius[3], float *error)
{
    const double thickness = (double)desc->thickness;
    struct tsu_i_gaussians own[CHANNELS];
    *error = fmaxf(*error, (float)tsu_i_blur_fit(transforms, (int)desc->gaussians, thickness, own));
    for (int c = 0; c < CHANNELS; c++) {
        // The best that six can do for this channel alone.
        struct tsu_i_transforms alone = *transforms;
        struct tsu_i_gaussians best;
        alone.profiles = 1;
        memcpy(alone.value[0], transforms->value[c], sizeof alone.value[0]);
        tsu_i_blur_fit(&alone, TSU_I_GAUSSIANS, thickness, &best);
        radius[c] = (float)tsu_i_gaussians_radius(&best, 0.0, (double)desc->fraction);
        for (int j = 0; j < own[c].count; j++) {
            blur[4 * j + 3] = (float)sqrt(own[c].variance[j]);
            if (transforms->value[c][0] > 0.0)
                blur[4 * j + c] = (float)(own[c].weight[j] / transforms->value[c][0]);
        }
    }
}

static tsu_status solve(const tsu_context *context, const tsu_leaf_scale_desc *desc,
                        tsu_leaf_scale *made)
{
    static const int methods[] = {-1, TSU_I_DIFFUSION_MULTIPOLE, TSU_I_DIFFUSION_DIPOLE,
                                  TSU_I_DIFFUSION_BETTER, TSU_I_DIFFUSION_BEAM};
    struct work work = {.method = methods[desc->method - TSU_LEAF_TRANSPORT]};
    for (int c = 0; c < CHANNELS; c++)
        work.slab[c] = slab_of(desc, c);
    work.bytes = tsu_i_spread_bytes(work.slab);
    work.memory = tsu_i_alloc(context, CHANNELS, work.bytes);
    if (!work.memory)
        return TSU_E_MEMORY;
    tsu_i_blur_frequencies(work.slab, CHANNELS, &work.reflected);
    work.through = work.reflected;
    tsu_i_jobs(context, sample_channel, &work, CHANNELS);
    tsu_i_free(context, work.memory, CHANNELS, work.bytes);
    for (int c = 0; c < CHANNELS; c++)
        if (work.failed[c]) {
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF,
                      "tsu_leaf_scale_desc: no convergence for scatter_top = %g, scatter_bottom = "
                      "%g, g = %g",
                      (double)desc->scatter_top[c], (double)desc->scatter_bottom[c],
                      (double)desc->g);
            return TSU_E_LIMIT;
        }
    if (refuse(context, desc, &work, made))
        return TSU_E_LIMIT;
    made->gaussians = desc->gaussians;
    made->thickness = desc->thickness;
    made->fraction = desc->fraction;
    for (int c = 0; c < CHANNELS; c++) {
        made->reflectance[c] = (float)work.reflected.value[c][0];
        made->transmittance[c] = (float)work.through.value[c][0];
        made->straight[c] = (float)work.total[c].straight;
    }
    write_side(&work.reflected, desc, made->reflected, made->reflected_radius, &made->fit_error);
    write_side(&work.through, desc, made->transmitted, made->transmitted_radius, &made->fit_error);
    return TSU_OK;
}

tsu_status tsu_leaf_scale_solve(tsu_context *context, const tsu_leaf_scale_desc *desc,
                                tsu_leaf_scale *scale)
{
    if (!scale)
        return TSU_E_PARAMETER;
    if (!context)
        return tsu_i_desc_fail(scale, sizeof *scale, TSU_E_PARAMETER);
    tsu_leaf_scale_desc own;
    tsu_leaf_scale made = {.struct_size = sizeof made};
    tsu_status status =
        tsu_i_desc_read(context, "tsu_leaf_scale_desc", desc, &own, sizeof own, sizeof own);
    if (status == TSU_OK)
        status = check(context, &own);
    if (status == TSU_OK)
        status = solve(context, &own, &made);
    if (status != TSU_OK && status != TSU_E_LIMIT)
        return tsu_i_desc_fail(scale, sizeof *scale, status);
    const tsu_status written = tsu_i_desc_write(scale, &made, sizeof made);
    return written == TSU_OK ? status : written;
}

// The Gaussians of one side and channel.
static struct tsu_i_gaussians side_of(const tsu_leaf_scale *scale, const float blur[24], int c)
{
    struct tsu_i_gaussians sum = {.count = (int)scale->gaussians};
    for (int j = 0; j < sum.count; j++) {
        sum.weight[j] = (double)blur[4 * j + c];
        sum.variance[j] = (double)blur[4 * j + 3] * (double)blur[4 * j + 3];
    }
    return sum;
}

// What curvature does, a length: the error is this over the radius.
static double bend_of(const tsu_leaf_scale *scale, const struct tsu_i_gaussians *sum, int side)
{
    const double thickness = (double)scale->thickness;
    const double wide = tsu_i_gaussians_radius(sum, 0.0, 0.9) / thickness;
    const double power = thickness * (side ? 0.5 : fmin(1.5 + 0.8 * wide, 3.2));
    return fmax(power, tsu_i_gaussians_spill(sum));
}

// The strip from which on the error is within the tolerance.
static double strip_of(const struct tsu_i_gaussians *sum, double tolerance)
{
    if (tolerance >= 0.5)
        return 0.0;
    double low = 0.0, high = tsu_i_gaussians_spill(sum) / tolerance;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(tsu_i_gaussians_strip(sum, middle) > tolerance ? &low : &high) = middle;
    }
    return high;
}

static int solved(const tsu_leaf_scale *scale)
{
    int good = scale->gaussians >= 2 && scale->gaussians <= TSU_LEAF_GAUSSIANS &&
               scale->thickness >= 1e-3f && scale->thickness <= 1e3f;
    for (int side = 0; side < 2 && good; side++) {
        const float *blur = side ? scale->transmitted : scale->reflected;
        const float *total = side ? scale->transmittance : scale->reflectance;
        for (int c = 0; c < CHANNELS; c++)
            good = good && total[c] >= 0.0f && total[c] <= 1.1f;
        for (uint32_t j = 0; j < scale->gaussians; j++)
            for (int c = 0; c < 4; c++)
                good = good && blur[4 * j + c] >= (c == 3 ? 1e-9f : 0.0f) && blur[4 * j + c] < 1e6f;
    }
    return good;
}

static void judge(const tsu_leaf_scale *scale, double pixel, double curvature, double tolerance,
                  tsu_leaf_verdict *made)
{
    for (int side = 0; side < 2; side++) {
        const float *total = side ? scale->transmittance : scale->reflectance;
        const double brightest = (double)fmaxf(fmaxf(total[0], total[1]), total[2]);
        for (int c = 0; c < CHANNELS; c++) {
            if (!(total[c] > 0.0f))
                continue;
            const double share = (double)total[c] / brightest, allowed = tolerance / share;
            const struct tsu_i_gaussians sum =
                side_of(scale, side ? scale->transmitted : scale->reflected, c);
            const double bend = bend_of(scale, &sum, side);
            made->pixel_error[side] =
                fmaxf(made->pixel_error[side], (float)(share * tsu_i_gaussians_strip(&sum, pixel)));
            made->curvature_error[side] =
                fmaxf(made->curvature_error[side], (float)(share * bend / curvature));
            made->pixel[side] = fmaxf(made->pixel[side], (float)strip_of(&sum, allowed));
            made->curvature[side] = fmaxf(made->curvature[side], (float)(bend / allowed));
        }
        if ((double)made->pixel_error[side] > tolerance)
            made->flags |= side ? TSU_LEAF_PIXEL_TRANSMITTED : TSU_LEAF_PIXEL_REFLECTED;
        if ((double)made->curvature_error[side] > tolerance)
            made->flags |= side ? TSU_LEAF_CURVED_TRANSMITTED : TSU_LEAF_CURVED_REFLECTED;
    }
}

tsu_status tsu_leaf_scale_judge(tsu_context *context, const tsu_leaf_scale *scale, double pixel_mm,
                                double curvature_mm, double tolerance, tsu_leaf_verdict *verdict)
{
    if (!verdict)
        return TSU_E_PARAMETER;
    if (!context)
        return tsu_i_desc_fail(verdict, sizeof *verdict, TSU_E_PARAMETER);
    tsu_leaf_scale own;
    const tsu_status status =
        tsu_i_desc_read(context, "tsu_leaf_scale", scale, &own, sizeof own, sizeof own);
    if (status != TSU_OK)
        return tsu_i_desc_fail(verdict, sizeof *verdict, status);
    if (reject(context, "pixel_mm", pixel_mm, 1e-6, 1e6) ||
        reject(context, "curvature_mm", curvature_mm, 1e-3, 1e9) ||
        reject(context, "tolerance", tolerance, 1e-3, 0.5))
        return tsu_i_desc_fail(verdict, sizeof *verdict, TSU_E_PARAMETER);
    if (!solved(&own)) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF,
                  "tsu_leaf_scale is not one that tsu_leaf_scale_solve() filled");
        return tsu_i_desc_fail(verdict, sizeof *verdict, TSU_E_PARAMETER);
    }
    tsu_leaf_verdict made = {.struct_size = sizeof made};
    judge(&own, pixel_mm, curvature_mm, tolerance, &made);
    return tsu_i_desc_write(verdict, &made, sizeof made);
}

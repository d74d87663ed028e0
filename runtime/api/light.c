#include "light/light.h"

#include "base/desc.h"
#include "base/host.h"

#include <math.h>
#include <string.h>

tsu_status tsu_light_desc_init_sized(tsu_light_desc *desc, size_t size)
{
    const tsu_light_desc defaults = {.struct_size = sizeof defaults,
                                     .kind = TSU_LIGHT_DIRECTIONAL,
                                     .samples = 13,
                                     .color = {1.0f, 1.0f, 1.0f},
                                     .direction = {0.0f, 1.0f, 0.0f},
                                     .least = 1e-3f,
                                     .x = {0.5f, 0.0f, 0.0f},
                                     .y = {0.0f, 0.0f, 0.5f}};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, sizeof defaults);
}

tsu_status tsu_environment_desc_init_sized(tsu_environment_desc *desc, size_t size)
{
    const tsu_environment_desc defaults = {
        .struct_size = sizeof defaults, .samples = 12, .threshold = 3.0f};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, sizeof defaults);
}

static int reject(const tsu_context *context, const char *what, const char *field, double value,
                  double low, double high)
{
    if (value >= low && value <= high)
        return 0;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LIGHT, "%s.%s = %g, expected [%g, %g]", what, field,
              value, low, high);
    return 1;
}

static int reject_light(const tsu_context *context, const char *field, double value, double low,
                        double high)
{
    return reject(context, "tsu_light_desc", field, value, low, high);
}

static double product(const float a[3], const float b[3])
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++)
        sum += (double)a[k] * (double)b[k];
    return sum;
}

static int reject_axes(const tsu_context *context, const tsu_light_desc *desc)
{
    const double x = sqrt(product(desc->x, desc->x)), y = sqrt(product(desc->y, desc->y));
    return reject_light(context, "x (its length)", x, 1e-6, 1e9) ||
           reject_light(context, "y (its length)", y, 1e-6, 1e9) ||
           reject_light(context, "x . y / (|x| |y|)", product(desc->x, desc->y) / (x * y), -1e-3,
                        1e-3) ||
           (desc->kind == TSU_LIGHT_DISK &&
            reject_light(context, "x (its length) / y (its length)", x / y, 0.999, 1.001));
}

static int reject_desc(const tsu_context *context, const tsu_light_desc *desc)
{
    if (desc->flags & ~(uint32_t)TSU_LIGHT_TWO_SIDED) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS,
                  "tsu_light_desc.flags = %u, expected TSU_LIGHT_* bits", desc->flags);
        return 1;
    }
    if (desc->kind < TSU_LIGHT_DIRECTIONAL || desc->kind > TSU_LIGHT_DISK) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LIGHT,
                  "tsu_light_desc.kind = %d, expected a TSU_LIGHT_* kind", (int)desc->kind);
        return 1;
    }
    if (reject_light(context, "samples", desc->samples, 1.0, TSU_LIGHT_SAMPLES) ||
        reject_light(context, "reserved", (double)desc->reserved, 0.0, 0.0))
        return 1;
    for (int k = 0; k < 3; k++)
        if (reject_light(context, "color", (double)desc->color[k], 0.0, 1e30))
            return 1;
    if (desc->kind == TSU_LIGHT_DIRECTIONAL)
        return reject_light(context, "direction (its length)",
                            sqrt(product(desc->direction, desc->direction)), 1e-6, 1e9) ||
               reject_light(context, "angle", (double)desc->angle, 0.0, 0.6);
    for (int k = 0; k < 3; k++)
        if (reject_light(context, "position", (double)desc->position[k], -1e9, 1e9))
            return 1;
    if (desc->kind == TSU_LIGHT_POINT)
        return reject_light(context, "least", (double)desc->least, 1e-6, 1e9);
    return reject_axes(context, desc);
}

tsu_status tsu_light_pack(tsu_context *context, const tsu_light_desc *desc, float record[16])
{
    if (!record)
        return TSU_E_PARAMETER;
    memset(record, 0, 16 * sizeof *record);
    if (!context)
        return TSU_E_PARAMETER;
    tsu_light_desc own;
    const tsu_status status =
        tsu_i_desc_read(context, "tsu_light_desc", desc, &own, sizeof own, sizeof own);
    if (status != TSU_OK)
        return status;
    if (reject_desc(context, &own))
        return TSU_E_PARAMETER;
    tsu_i_light_record(&own, record);
    return TSU_OK;
}

static int reject_environment(const tsu_context *context, const tsu_environment_desc *desc)
{
    const char *const what = "tsu_environment_desc";
    if (desc->flags) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS, "%s.flags = %u, expected 0", what,
                  desc->flags);
        return 1;
    }
    if (!desc->radiance) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_NULL, "%s.radiance is NULL", what);
        return 1;
    }
    return reject(context, what, "count", desc->count, 6.0, 134217728.0) ||
           reject(context, what, "samples", desc->samples, 1.0, TSU_LIGHT_SAMPLES) ||
           reject(context, what, "threshold", (double)desc->threshold, 1.0, 1e9) ||
           reject(context, what, "reserved", desc->reserved, 0.0, 0.0);
}

static int reject_samples(const tsu_context *context, const tsu_environment_desc *desc,
                          double *angle)
{
    static const char *const expected[] = {
        "", "a direction that is finite and not 0", "a radiance in [0, 1e30]",
        "a solid angle in [0, 12.6]"};
    uint32_t index = 0;
    const int wrong = tsu_i_environment_check(desc, &index, angle);
    if (wrong != TSU_I_SAMPLE_GOOD) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LIGHT,
                  "tsu_environment_desc.radiance, sample %u: expected %s", index, expected[wrong]);
        return 1;
    }
    return reject(context, "tsu_environment_desc", "radiance (sum of its solid angles)", *angle,
                  0.98 * 12.566370614359172, 1.02 * 12.566370614359172);
}

tsu_status tsu_environment_make(tsu_context *context, const tsu_environment_desc *desc,
                                tsu_environment *out)
{
    if (!out)
        return TSU_E_PARAMETER;
    if (!context)
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    tsu_environment_desc own;
    double angle = 0.0;
    tsu_status status =
        tsu_i_desc_read(context, "tsu_environment_desc", desc, &own, sizeof own, sizeof own);
    if (status == TSU_OK &&
        (reject_environment(context, &own) || reject_samples(context, &own, &angle)))
        status = TSU_E_PARAMETER;
    if (status != TSU_OK)
        return tsu_i_desc_fail(out, sizeof *out, status);
    tsu_environment result = {.struct_size = sizeof result};
    tsu_i_environment_make(&own, angle, &result);
    return tsu_i_desc_write(out, &result, sizeof result);
}

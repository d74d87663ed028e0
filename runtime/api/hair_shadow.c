#include "api/params.h"
#include "base/desc.h"
#include "base/host.h"
#include "hair_shadow/hair_shadow.h"

#include <tsuya/models/deep_opacity.h>
#include <tsuya/models/opacity_shadow.h>

#include <math.h>
#include <string.h>

tsu_status tsu_hair_shadow_desc_init_sized(tsu_hair_shadow_desc *desc, size_t size)
{
    const tsu_hair_shadow_desc defaults = {
        .struct_size = sizeof defaults,
        .flags = TSU_HAIR_SHADOW_BLEND_32F | TSU_HAIR_SHADOW_BLEND_16F,
        .radius = 1.0f,
        .light = {0.0f, 1.0f, 0.0f},
        .least_size = 16,
        .most_size = 512};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, sizeof defaults);
}

static int reject(const tsu_context *context, const char *field, double value, double low,
                  double high)
{
    if (value >= low && value <= high)
        return 0;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_HAIR_SHADOW,
              "tsu_hair_shadow_desc.%s = %g, expected [%g, %g]", field, value, low, high);
    return 1;
}

static int reject_flags(const tsu_context *context, const tsu_hair_shadow_desc *desc)
{
    const uint32_t known = TSU_HAIR_SHADOW_POINT | TSU_HAIR_SHADOW_ZERO_TO_ONE |
                           TSU_HAIR_SHADOW_BLEND_32F | TSU_HAIR_SHADOW_BLEND_16F;
    if (!(desc->flags & ~known))
        return 0;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS,
              "tsu_hair_shadow_desc.flags = %u, expected TSU_HAIR_SHADOW_* bits", desc->flags);
    return 1;
}

static int reject_numbers(const tsu_context *context, const tsu_hair_shadow_desc *desc)
{
    const int point = (desc->flags & TSU_HAIR_SHADOW_POINT) != 0;
    double way = 0.0;
    for (int i = 0; i < 3; i++) {
        if (reject(context, "centre", (double)desc->centre[i], -1e9, 1e9) ||
            reject(context, "light", (double)desc->light[i], -1e9, 1e9))
            return 1;
        way += (double)desc->light[i] * (double)desc->light[i];
    }
    return reject(context, "radius", (double)desc->radius, 1e-6, 1e9) ||
           (!point && reject(context, "light (its length)", sqrt(way), 1e-6, 2e9)) ||
           reject(context, "width", (double)desc->width, 0.0, 1e9) ||
           reject(context, "length", (double)desc->length, 0.0, 1e12) ||
           reject(context, "volume", (double)desc->volume, 0.0, 1e30) ||
           reject(context, "spacing", (double)desc->spacing, 0.0, 1e9) ||
           (desc->size && reject(context, "size", desc->size, 8.0, 8192.0)) ||
           reject(context, "most_size", desc->most_size, 8.0, 8192.0) ||
           reject(context, "least_size", desc->least_size, 8.0, desc->most_size) ||
           reject(context, "tile_x", desc->tile_x, 0.0, 65535.0) ||
           reject(context, "tile_y", desc->tile_y, 0.0, 65535.0) ||
           reject(context, "reserved", desc->reserved[0] | desc->reserved[1], 0.0, 0.0);
}

static tsu_status read_params(const tsu_context *context, const tsu_hair_shadow_desc *desc,
                              struct tsu_i_shadow_params *out)
{
    const tsu_model *model = desc->model ? desc->model : tsu_deep_opacity();
    if (!(model->info.flags & TSU_MODEL_SHADOW)) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_HAIR_SHADOW,
                  "tsu_hair_shadow_desc.model = %s, expected deep_opacity or opacity_shadow",
                  model->info.name);
        return TSU_E_PARAMETER;
    }
    unsigned char own[TSU_I_PARAMS_BYTES];
    const tsu_status status = tsu_i_params_read(context, model,
                                                desc->params ? desc->params : model->defaults, own);
    if (status != TSU_OK)
        return status;
    // Both techniques have one layout, which tests/abi holds.
    tsu_deep_opacity_params params;
    memcpy(&params, own, sizeof params);
    out->opacity = params.opacity;
    out->spacings = params.spacings;
    out->layers = params.layers;
    out->growth = params.growth;
    out->from_front = model == tsu_deep_opacity();
    if (params.layers != floorf(params.layers)) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_PARAMETER,
                  "tsu_%s_params.layers = %g, expected a whole number in [1, 8]", model->info.name,
                  (double)params.layers);
        return TSU_E_PARAMETER;
    }
    if (params.growth > 0.0f && params.growth < 1.0f) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_PARAMETER,
                  "tsu_%s_params.growth = %g, expected 0 or [1, 4]", model->info.name,
                  (double)params.growth);
        return TSU_E_PARAMETER;
    }
    return TSU_OK;
}

tsu_status tsu_hair_shadow_make(tsu_context *context, const tsu_hair_shadow_desc *desc,
                                tsu_hair_shadow_plan *out)
{
    if (!out)
        return TSU_E_PARAMETER;
    if (!context)
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    tsu_hair_shadow_desc own;
    struct tsu_i_shadow_params params;
    tsu_status status = tsu_i_desc_read(context, "tsu_hair_shadow_desc", desc, &own, sizeof own,
                                        sizeof own);
    if (status == TSU_OK && (reject_flags(context, &own) || reject_numbers(context, &own)))
        status = TSU_E_PARAMETER;
    if (status == TSU_OK)
        status = read_params(context, &own, &params);
    if (status != TSU_OK)
        return tsu_i_desc_fail(out, sizeof *out, status);
    tsu_hair_shadow_plan plan = {.struct_size = sizeof plan};
    tsu_i_shadow_plan(&own, &params, &plan);
    status = tsu_i_desc_write(out, &plan, sizeof plan);
    if (status == TSU_OK && plan.flags & TSU_HAIR_SHADOW_PARTIAL)
        tsu_i_log(context, TSU_LOG_WARNING, TSU_LOG_HAIR_SHADOW,
                  "the light is inside the hair, or within a thirtieth of its radius: only hair "
                  "within 76 degrees of the centre casts a shadow");
    return status;
}

tsu_status tsu_hair_shadow_target(const tsu_hair_shadow_plan *plan, uint32_t index,
                                  tsu_hair_shadow_target_info *out)
{
    if (!plan || index >= plan->target_count)
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    static const char *const names[3] = {"front", "layers", "deeper"};
    const uint32_t which = index + (tsu_i_shadow_from_front(plan) ? 0u : 1u);
    const tsu_hair_shadow_target_info info = {
        .struct_size = sizeof info,
        .name = names[which],
        .format = which == 0 ? TSU_FORMAT_DEPTH24 : plan->color,
        .clear = {which == 0 ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f}};
    return tsu_i_desc_write(out, &info, sizeof info);
}

tsu_status tsu_hair_shadow_pass(const tsu_hair_shadow_plan *plan, uint32_t index,
                                tsu_hair_shadow_pass_info *out)
{
    if (!plan || index >= plan->pass_count)
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    const int from_front = tsu_i_shadow_from_front(plan);
    const uint32_t all = (1u << plan->target_count) - 1u;
    tsu_hair_shadow_pass_info info = {.struct_size = sizeof info, .name = "front", .targets = 1,
                                      .depth_test = 1, .function = ""};
    if (!from_front || index == 1) {
        info.name = "layers";
        info.targets = from_front ? all & ~1u : all;
        info.depth_test = 0;
        info.blend_add = 1;
        info.function = from_front ? "tsu_deep_opacity_write" : "tsu_opacity_shadow_write";
    }
    return tsu_i_desc_write(out, &info, sizeof info);
}

size_t tsu_hair_shadow_floats(const tsu_hair_shadow_plan *plan)
{
    return plan ? (size_t)plan->size * plan->size * (1 + (size_t)plan->layers) : 0;
}

tsu_status tsu_hair_shadow_write(const tsu_hair_shadow_plan *plan, const float *points,
                                 const uint32_t *first, uint32_t strands, float *map)
{
    if (!plan || !map || (strands && (!points || !first)))
        return TSU_E_PARAMETER;
    tsu_i_shadow_write(plan, points, first, strands, map);
    return TSU_OK;
}

tsu_status tsu_hair_shadow_read(const tsu_hair_shadow_plan *plan, const float *map,
                                const float position[3], float shadow[4])
{
    if (!plan || !map || !position || !shadow)
        return TSU_E_PARAMETER;
    tsu_i_shadow_read(plan, map, position, shadow);
    return TSU_OK;
}

#include "base/desc.h"
#include "base/host.h"
#include "choose/decide.h"
#include "choose/drop.h"
#include "choose/reason.h"
#include "choose/trade.h"

#include <tsuya/choose.h>

#include <string.h>

// Radians of 2, 7.5 and 30 degrees.
#define BETA_LEAST 0.034906585f
#define BETA_USUAL 0.13089969f
#define BETA_MOST 0.52359878f

tsu_status tsu_choose_desc_init_sized(tsu_choose_desc *desc, size_t size)
{
    const tsu_choose_desc defaults = {.struct_size = sizeof defaults,
                                      .kind = TSU_CHOOSE_HAIR,
                                      .sigma_a = {0.5447f, 0.9061f, 1.781f},
                                      .beta_R = BETA_USUAL,
                                      .strand_pixels = 0.5f,
                                      .depth = 20.0f,
                                      .shadow = TSU_CHOOSE_SHADOW_MAPS,
                                      .R_top = {0.050f, 0.129f, 0.042f},
                                      .R_bottom = {0.070f, 0.181f, 0.059f},
                                      .T = {0.031f, 0.126f, 0.003f},
                                      .footprint = 1.0f,
                                      .curvature = 1e9f,
                                      .covered_pixels = 1e5f,
                                      .directional_lights = 1,
                                      .light_cosine = 0.5f,
                                      .samplers = 16,
                                      .memory = UINT32_MAX,
                                      .target = TSU_TARGET_330,
                                      .gpu = TSU_CHOOSE_NAVI21,
                                      .previous = TSU_TIER_NONE,
                                      .hysteresis = 0.1f};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, sizeof defaults);
}

static int reject(const tsu_context *context, const char *field, double value, double low,
                  double high)
{
    // Bounds are written in decimals, fields are float.
    if ((float)value >= (float)low && (float)value <= (float)high)
        return 0;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_CHOOSE, "tsu_choose_desc.%s = %g, expected [%g, %g]",
              field, value, low, high);
    return 1;
}

static int reject_wish(const tsu_context *context, const char *field, float value, double low,
                       double high)
{
    return value != 0.0f && reject(context, field, (double)value, low, high);
}

static int reject_color(const tsu_context *context, const char *field, const float value[3],
                        double high)
{
    for (int c = 0; c < 3; c++)
        if (reject(context, field, (double)value[c], 0.0, high))
            return 1;
    return 0;
}

static int reject_hair(const tsu_context *context, const tsu_choose_desc *desc)
{
    return reject_color(context, "sigma_a", desc->sigma_a, 1e6) ||
           reject(context, "beta_R", (double)desc->beta_R, (double)BETA_LEAST, (double)BETA_MOST) ||
           reject(context, "strand_pixels", (double)desc->strand_pixels, 1e-4, 1e4) ||
           reject(context, "depth", (double)desc->depth, 0.0, 1e6) ||
           reject(context, "curl", (double)desc->curl, 0.0, 1.0) ||
           reject(context, "shadow", desc->shadow, TSU_CHOOSE_SHADOW_NONE,
                  TSU_CHOOSE_SHADOW_MAPS) ||
           reject(context, "sky_share", (double)desc->sky_share, 0.0, 1.0) ||
           reject(context, "light_cosine", (double)desc->light_cosine, -1.0, 1.0);
}

static int reject_leaf(const tsu_context *context, const tsu_choose_desc *desc)
{
    if (reject_color(context, "R_top", desc->R_top, 1.0) ||
        reject_color(context, "R_bottom", desc->R_bottom, 1.0) ||
        reject_color(context, "T", desc->T, 1.0))
        return 1;
    for (int c = 0; c < 3; c++)
        if (reject(context, "R_top + T", (double)desc->R_top[c] + (double)desc->T[c], 0.0, 1.0) ||
            reject(context, "R_bottom + T", (double)desc->R_bottom[c] + (double)desc->T[c], 0.0,
                   1.0))
            return 1;
    return reject(context, "footprint", (double)desc->footprint, 1e-6, 1e6) ||
           reject(context, "curvature", (double)desc->curvature, 1e-3, 1e9) ||
           reject(context, "spread_R", (double)desc->spread_R, 0.0, 1e3) ||
           reject(context, "spread_T", (double)desc->spread_T, 0.0, 1e3);
}

static int reject_rest(const tsu_context *context, const tsu_choose_desc *desc)
{
    return reject(context, "covered_pixels", (double)desc->covered_pixels, 0.0, 1e12) ||
           reject(context, "directional_lights", desc->directional_lights, 0, 1000) ||
           reject(context, "point_lights", desc->point_lights, 0, 1000) ||
           reject(context, "area_lights", desc->area_lights, 0, 1000) ||
           reject(context, "environments", desc->environments, 0, 1000) ||
           reject(context, "target", desc->target, TSU_TARGET_330, TSU_TARGET_VULKAN) ||
           reject(context, "gpu", desc->gpu, TSU_CHOOSE_NAVI21, TSU_CHOOSE_GFX1100) ||
           reject_wish(context, "error_bound", desc->error_bound, 1e-6, 1e6) ||
           reject_wish(context, "luminance_bound", desc->luminance_bound, 1e-6, 1e6) ||
           reject_wish(context, "cost_budget", desc->cost_budget, 1e-3, 1e12) ||
           reject(context, "hysteresis", (double)desc->hysteresis, 0.0, 1.0);
}

static int reject_tier(const tsu_context *context, const char *what, const tsu_choose_desc *desc,
                       tsu_tier tier)
{
    if (tier >= 0 && (uint32_t)tier < tsu_i_trade.tier_count &&
        tsu_i_trade.tiers[tier].kind == desc->kind)
        return 0;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_CHOOSE, "%s = %d, expected a tier of %s", what,
              (int)tier, desc->kind == TSU_CHOOSE_HAIR ? "hair" : "leaves");
    return 1;
}

// Read and check a description.
static tsu_status read_desc(const tsu_context *context, const tsu_choose_desc *desc,
                            tsu_choose_desc *own)
{
    const uint32_t known = TSU_CHOOSE_BACKLIT | TSU_CHOOSE_PIGMENT_MAP | TSU_CHOOSE_COAT;
    const tsu_status status =
        tsu_i_desc_read(context, "tsu_choose_desc", desc, own, sizeof *own, sizeof *own);
    if (status != TSU_OK)
        return status;
    if (own->flags & ~known) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS,
                  "tsu_choose_desc.flags = %u, expected TSU_CHOOSE_* bits", own->flags);
        return TSU_E_PARAMETER;
    }
    if (reject(context, "kind", own->kind, TSU_CHOOSE_HAIR, TSU_CHOOSE_LEAF) ||
        (own->kind == TSU_CHOOSE_HAIR ? reject_hair : reject_leaf)(context, own) ||
        reject_rest(context, own))
        return TSU_E_PARAMETER;
    if (own->previous != TSU_TIER_NONE &&
        reject_tier(context, "tsu_choose_desc.previous", own, own->previous))
        return TSU_E_PARAMETER;
    return TSU_OK;
}

static void put_neighbour(const struct tsu_i_candidate *from, tsu_tier *tier, float *error,
                          float *cost)
{
    *tier = from ? from->tier : TSU_TIER_NONE;
    *error = from ? (float)from->error : 0.0f;
    *cost = from ? (float)from->cost : 0.0f;
}

static float above(double value, double limit)
{
    return limit > 0.0 && value > limit ? (float)(value / limit - 1.0) : 0.0f;
}

static tsu_choice made(const tsu_choose_desc *desc, const struct tsu_i_field *field,
                       const struct tsu_i_decision *decision)
{
    const struct tsu_i_candidate *c = decision->chosen;
    const struct tsu_i_trade_tier *tier = tsu_i_trade.tiers + c->tier;
    tsu_choice choice = {.struct_size = sizeof choice,
                         .flags = decision->held ? TSU_CHOICE_HELD : 0,
                         .status = decision->status,
                         .tier = c->tier,
                         .model = tsu_model_find(tier->model),
                         .variant = tier->variant,
                         .drop = tsu_i_drop(desc, c->tier),
                         .passes = c->passes,
                         .outside = field->outside,
                         .samplers = c->samplers,
                         .bytes = c->bytes,
                         .error = (float)c->error,
                         .error_high = (float)c->high,
                         .luminance = (float)c->luminance,
                         .luminance_high = (float)c->luminance_high,
                         .cost = (float)c->cost,
                         .frame_cost = (float)(c->cost * (double)desc->covered_pixels),
                         .miss = above(c->excess, 1.0),
                         .over = above(c->cost, (double)desc->cost_budget)};
    put_neighbour(decision->better, &choice.better, &choice.better_error, &choice.better_cost);
    put_neighbour(decision->cheaper, &choice.cheaper, &choice.cheaper_error, &choice.cheaper_cost);
    tsu_i_reason(desc, field, decision, choice.reason, sizeof choice.reason);
    return choice;
}

static tsu_status refuse(const tsu_context *context, const struct tsu_i_field *field)
{
    uint32_t lacks = ~0u;
    for (uint32_t i = 0; i < field->count; i++)
        lacks &= field->tiers[i].lacks;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_CHOOSE,
              "the host can have no tier: tsu_choose_desc.%s",
              lacks & TSU_LACKS_SAMPLERS ? "samplers is too small"
              : lacks & TSU_LACKS_MEMORY ? "memory is too small"
                                         : "samplers or memory is too small for what is wanted");
    return TSU_E_LIMIT;
}

tsu_status tsu_choose(tsu_context *context, const tsu_choose_desc *desc, tsu_choice *out)
{
    tsu_choose_desc own;
    struct tsu_i_field field;
    struct tsu_i_decision decision;
    tsu_status status = read_desc(context, desc, &own);
    if (status != TSU_OK)
        return tsu_i_desc_fail(out, sizeof *out, status);
    tsu_i_predict(&own, &field);
    tsu_i_decide(&own, &field, &decision);
    if (!decision.chosen)
        return tsu_i_desc_fail(out, sizeof *out, refuse(context, &field));
    const tsu_choice choice = made(&own, &field, &decision);
    return tsu_i_desc_write(out, &choice, sizeof choice);
}

static const struct tsu_i_candidate *of_tier(const struct tsu_i_field *field, tsu_tier tier)
{
    uint32_t i = 0;
    while (field->tiers[i].tier != tier)
        i++;
    return field->tiers + i;
}

tsu_status tsu_choose_predict(tsu_context *context, const tsu_choose_desc *desc, tsu_tier tier,
                              tsu_prediction *out)
{
    tsu_choose_desc own;
    struct tsu_i_field field;
    tsu_status status = read_desc(context, desc, &own);
    if (status == TSU_OK && reject_tier(context, "tier", &own, tier))
        status = TSU_E_PARAMETER;
    if (status != TSU_OK)
        return tsu_i_desc_fail(out, sizeof *out, status);
    tsu_i_predict(&own, &field);
    const struct tsu_i_candidate *c = of_tier(&field, tier);
    const tsu_prediction made = {.struct_size = sizeof made,
                                 .lacks = c->lacks,
                                 .outside = field.outside,
                                 .passes = c->passes,
                                 .samplers = c->samplers,
                                 .bytes = c->bytes,
                                 .error = (float)c->error,
                                 .error_high = (float)c->high,
                                 .luminance = (float)c->luminance,
                                 .luminance_high = (float)c->luminance_high,
                                 .cost = (float)c->cost};
    return tsu_i_desc_write(out, &made, sizeof made);
}

tsu_status tsu_choose_match(tsu_context *context, const tsu_choose_desc *desc, tsu_tier from,
                            tsu_tier to, float *gain)
{
    tsu_choose_desc own;
    struct tsu_i_field field;
    if (!gain)
        return TSU_E_PARAMETER;
    *gain = 0.0f;
    const tsu_status status = read_desc(context, desc, &own);
    if (status != TSU_OK)
        return status;
    if (reject_tier(context, "from", &own, from) || reject_tier(context, "to", &own, to))
        return TSU_E_PARAMETER;
    tsu_i_predict(&own, &field);
    *gain =
        (float)((1.0 + of_tier(&field, from)->luminance) / (1.0 + of_tier(&field, to)->luminance));
    return TSU_OK;
}

uint32_t tsu_tier_count(void)
{
    return tsu_i_trade.tier_count;
}

tsu_tier tsu_tier_find(const char *name)
{
    for (uint32_t i = 0; name && i < tsu_i_trade.tier_count; i++)
        if (strcmp(tsu_i_trade.tiers[i].name, name) == 0)
            return (tsu_tier)i;
    return TSU_TIER_NONE;
}

tsu_status tsu_tier_describe(tsu_tier tier, tsu_tier_info *out)
{
    if (tier < 0 || (uint32_t)tier >= tsu_i_trade.tier_count)
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    const struct tsu_i_trade_tier *from = tsu_i_trade.tiers + tier;
    tsu_tier_info info = {.struct_size = sizeof info,
                          .flags = from->flags,
                          .kind = from->kind,
                          .fetches = from->fetches,
                          .name = from->name,
                          .model = tsu_model_find(from->model),
                          .variant = from->variant,
                          .bytes = from->bytes,
                          .samplers = from->samplers};
    for (int i = 0; i < TSU_CHOOSE_GPUS; i++)
        info.clocks[i] = (float)from->clocks[i];
    for (int i = 0; i < TSU_TONES && from->rms; i++) {
        info.rms[i] = (float)from->rms->mean[i];
        info.luminance[i] = (float)from->luminance->mean[i];
    }
    return tsu_i_desc_write(out, &info, sizeof info);
}

const char *tsu_trade_source(void)
{
    return tsu_i_trade.source;
}

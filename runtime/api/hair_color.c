#include "base/desc.h"
#include "base/host.h"
#include "optics/fiber.h"
#include "optics/melanin.h"

#include <tsuya/hair_color.h>
#include <tsuya/model.h>

#include <math.h>

static const struct {
    const char *name;
    double eumelanin, pheomelanin;
} presets[] = {{"black", 8.0, 0.0},       {"dark_brown", 3.0, 0.1}, {"brown", 1.3, 0.0},
               {"light_brown", 0.7, 0.1}, {"dark_blond", 0.3, 0.1}, {"blond", 0.13, 0.08},
               {"platinum", 0.03, 0.02},  {"auburn", 0.9, 0.9},     {"red", 0.25, 1.1},
               {"ginger", 0.08, 0.6},     {"grey", 0.15, 0.0},      {"white", 0.0, 0.0}};

static tsu_status out_of_range(const tsu_context *context, const char *name, double value,
                               double low, double high)
{
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_COLOR, "%s = %g, expected [%g, %g]", name, value, low,
              high);
    return TSU_E_PARAMETER;
}

tsu_status tsu_hair_melanin(tsu_context *context, double eumelanin, double pheomelanin,
                            double sigma_a[3])
{
    if (!sigma_a)
        return TSU_E_PARAMETER;
    sigma_a[0] = sigma_a[1] = sigma_a[2] = 0.0;
    if (!(eumelanin >= 0.0 && eumelanin <= 100.0))
        return out_of_range(context, "eumelanin", eumelanin, 0, 100);
    if (!(pheomelanin >= 0.0 && pheomelanin <= 100.0))
        return out_of_range(context, "pheomelanin", pheomelanin, 0, 100);
    tsu_i_melanin_absorption(eumelanin, pheomelanin, sigma_a);
    return TSU_OK;
}

static tsu_status check(tsu_context *context, double eta, const double in[3], double out[3])
{
    if (!in || !out)
        return TSU_E_PARAMETER;
    out[0] = out[1] = out[2] = 0.0;
    return eta >= 1.2 && eta <= 2.0 ? TSU_OK : out_of_range(context, "eta", eta, 1.2, 2.0);
}

tsu_status tsu_hair_albedo(tsu_context *context, double eta, const double sigma_a[3],
                           double albedo[3])
{
    const double in[3] = {sigma_a ? sigma_a[0] : 0, sigma_a ? sigma_a[1] : 0,
                          sigma_a ? sigma_a[2] : 0};
    const tsu_status status = check(context, eta, sigma_a ? in : NULL, albedo);
    if (status != TSU_OK)
        return status;
    for (int k = 0; k < 3; k++)
        if (!(in[k] >= 0.0 && in[k] <= 1e6))
            return out_of_range(context, "sigma_a", in[k], 0, 1e6);
    for (int k = 0; k < 3; k++)
        albedo[k] = tsu_i_fiber_albedo(eta, in[k]);
    return TSU_OK;
}

// The albedo falls from 1 at 0 without end, convex: secant steps kept inside a bracket that halves.
static double invert(double eta, double albedo)
{
    if (albedo >= 1.0)
        return 0.0;
    double low = 0.0, high = 1.0;
    while (tsu_i_fiber_albedo(eta, high) > albedo && high < 1e6)
        high *= 2.0;
    double low_excess = 1.0 - albedo, high_excess = tsu_i_fiber_albedo(eta, high) - albedo;
    for (int i = 0; i < 100 && high - low > 1e-13 * high; i++) {
        const double secant = low + (high - low) * low_excess / (low_excess - high_excess);
        const double at = i % 3 == 2 ? 0.5 * (low + high) : secant;
        const double excess = tsu_i_fiber_albedo(eta, at) - albedo;
        if (excess > 0.0) {
            low = at;
            low_excess = excess;
        } else {
            high = at;
            high_excess = excess;
        }
        if (fabs(excess) < 1e-12)
            return at;
    }
    return 0.5 * (low + high);
}

tsu_status tsu_hair_sigma_a(tsu_context *context, double eta, const double albedo[3],
                            double sigma_a[3])
{
    const double in[3] = {albedo ? albedo[0] : 0, albedo ? albedo[1] : 0, albedo ? albedo[2] : 0};
    const tsu_status status = check(context, eta, albedo ? in : NULL, sigma_a);
    if (status != TSU_OK)
        return status;
    const double least = tsu_i_fiber_albedo(eta, 1e6);
    for (int k = 0; k < 3; k++)
        if (!(in[k] > least && in[k] <= 1.0)) {
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_COLOR,
                      "albedo = %g, expected (%g, 1]: a fibre of eta %g reflects that much at its "
                      "surface",
                      in[k], least, eta);
            return TSU_E_PARAMETER;
        }
    for (int k = 0; k < 3; k++)
        sigma_a[k] = invert(eta, in[k]);
    return TSU_OK;
}

uint32_t tsu_hair_preset_count(void)
{
    return (uint32_t)(sizeof presets / sizeof *presets);
}

tsu_status tsu_hair_preset(uint32_t index, tsu_hair_preset_info *out)
{
    if (index >= tsu_hair_preset_count())
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    tsu_hair_preset_info info = {.struct_size = sizeof info,
                                 .name = presets[index].name,
                                 .eumelanin = presets[index].eumelanin,
                                 .pheomelanin = presets[index].pheomelanin};
    tsu_i_melanin_absorption(info.eumelanin, info.pheomelanin, info.sigma_a);
    return tsu_i_desc_write(out, &info, sizeof info);
}

#include "api/set.h"
#include "base/host.h"
#include "models/leaf_body/state.h"

#include <math.h>
#include <string.h>

static tsu_status refuse(tsu_set *set, const char *name, double value, double low, double high)
{
    tsu_i_log(tsu_i_set_pool(set)->context, TSU_LOG_ERROR, TSU_LOG_PARAMETER,
              "%s with the material's own is %g, expected [%g, %g]", name, value, low, high);
    return TSU_E_PARAMETER;
}

tsu_status tsu_leaf_body_uniform(tsu_set *set, uint32_t material, float pigment, float thickness,
                                 float numbers[72])
{
    if (!numbers)
        return TSU_E_PARAMETER;
    memset(numbers, 0, 72 * sizeof *numbers);
    const float *const record = set ? tsu_set_record(set, material) : NULL;
    const tsu_model *model = NULL;
    if (!record || !tsu_set_params(set, material, &model) || model->tables != tsu_i_leaf_tables) {
        if (set)
            tsu_i_log(tsu_i_set_pool(set)->context, TSU_LOG_ERROR, TSU_LOG_PARAMETER,
                      "material %u is not a leaf of the set", material);
        return TSU_E_PARAMETER;
    }
    const double p = 2.0 * (double)(pigment * record[4]), t = 2.0 * (double)(thickness * record[5]);
    if (!(p >= 0.0 && p <= 2.0 + 1e-6))
        return refuse(set, "pigment", p, 0.0, 2.0);
    if (!(t >= 0.5 - 1e-6 && t <= 2.0 + 1e-6))
        return refuse(set, "thickness", t, 0.5, 2.0);
    tsu_set_info info;
    tsu_info_init_sized(&info, sizeof info);
    tsu_set_describe(set, &info);
    if (info.stale_count) {
        tsu_i_log(tsu_i_set_pool(set)->context, TSU_LOG_ERROR, TSU_LOG_STALE,
                  "the set has stale tables; call tsu_set_bake() first");
        return TSU_E_STATE;
    }
    // The first texel, as the record has it.
    const size_t x = (size_t)lrintf(record[0] * (float)info.width - 0.5f);
    const size_t y = (size_t)lrintf(record[2] * (float)info.height - 0.5f);
    const struct tsu_i_texels table = {tsu_set_texels(set) + 4 * (y * info.width + x), info.width};
    for (int s = 0; s < LEAF_SETS; s++)
        for (int c = 0; c < 3; c++) {
            float *const a = numbers + 24 * s + 4 * c, *const b = a + 12;
            tsu_i_leaf_read(record, &table, pigment, thickness, s, c, a, b);
            a[0] = exp2f(a[0]);
            for (int k = 0; k < 4; k++) {
                a[k] = k ? a[k] * a[0] : a[k];
                b[k] *= a[0];
            }
        }
    return TSU_OK;
}

// The table as the shader samples it.
#include "models/leaf_body/state.h"

#include "base/half.h"

#include <math.h>

static float clamp01(float x)
{
    return x > 0.0f ? x < 1.0f ? x : 1.0f : 0.0f;
}

static void texel(const struct tsu_i_texels *table, float x, float y, float out[4])
{
    const int i = x < LEAF_PIGMENTS - 2 ? (int)x : LEAF_PIGMENTS - 2;
    const float fx = x - (float)i;
    const int j = (int)y;
    const float fy = y - (float)j;
    for (int k = 0; k < 4; k++) {
        float row[2];
        for (int r = 0; r < 2; r++) {
            const uint16_t *at = table->texels + 4 * ((size_t)(j + r) * table->pitch + (size_t)i);
            row[r] = tsu_i_half_float(at[k]) * (1.0f - fx) + tsu_i_half_float(at[4 + k]) * fx;
        }
        out[k] = row[0] * (1.0f - fy) + row[1] * fy;
    }
}

void tsu_i_leaf_read(const float *record, const struct tsu_i_texels *table, float pigment,
                     float thickness, int set, int channel, float a[4], float b[4])
{
    const float p = pigment * record[4], t = thickness * record[5];
    const float x = clamp01(sqrtf(p)) * (LEAF_PIGMENTS - 1);
    const float y = fminf(clamp01(fminf(2.0f * t - 0.5f, t)) * (LEAF_THICKNESSES - 1),
                          LEAF_THICKNESSES - 1.001f);
    struct tsu_i_texels band = *table;
    band.texels += 4 * (size_t)((set * 3 + channel) * LEAF_THICKNESSES) * band.pitch;
    texel(&band, x, y, a);
    band.texels += (size_t)4 * LEAF_PIGMENTS;
    texel(&band, x, y, b);
}

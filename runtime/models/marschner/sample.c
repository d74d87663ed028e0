// The shader in C: the formulas of glsl/marschner in float, over the same texels and record.
#include "models/marschner/state.h"

#include "base/half.h"

#include <math.h>

static float clamp01(float x)
{
    return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
}

// Bilinear, at texel coordinates that lie within the table.
static void fetch(const struct tsu_i_texels *table, float x, float y, float out[4])
{
    const int i = x < 0.0f ? 0 : (int)x, j = (int)y;
    const int i1 = i < MARSCHNER_WIDTH - 1 ? i + 1 : i, j1 = j < MARSCHNER_HEIGHT - 1 ? j + 1 : j;
    const float fx = x - (float)i, fy = y - (float)j;
    const uint16_t *low = table->texels + 4 * (size_t)table->pitch * (size_t)j;
    const uint16_t *high = table->texels + 4 * (size_t)table->pitch * (size_t)j1;
    for (int k = 0; k < 4; k++) {
        const float a = tsu_i_half_float(low[4 * i + k]), b = tsu_i_half_float(low[4 * i1 + k]);
        const float c = tsu_i_half_float(high[4 * i + k]), d = tsu_i_half_float(high[4 * i1 + k]);
        const float lower = a + (b - a) * fx, upper = c + (d - c) * fx;
        out[k] = lower + (upper - lower) * fy;
    }
}

static void azimuthal(const struct tsu_i_texels *table, float cos_r, float cos2_half, float n[4],
                      float path[4])
{
    const float x = sqrtf(1.0f - cos2_half) - sqrtf(cos2_half);
    const float column = x * 63.5f + 63.5f;
    fetch(table, column, cos_r * MARSCHNER_SPAN(MARSCHNER_ROWS), n);
    fetch(table, column,
          cos_r * MARSCHNER_SPAN(MARSCHNER_PATH_ROWS) + (float)MARSCHNER_ROWS, path);
}

static float absorb_tt(const float path[4], float sigma_a, float exponent)
{
    return (clamp01(path[1] * sigma_a) - path[0]) * sigma_a + exponent;
}

void tsu_i_marschner_sample(const struct tsu_i_texels *table, float cos_r, float cos2_half,
                            float sigma_a, float n[4])
{
    float path[4];
    azimuthal(table, cos_r, cos2_half, n, path);
    n[1] *= exp2f(absorb_tt(path, sigma_a, 0.0f));
    n[2] *= exp2f(-path[2] * sigma_a);
    n[3] *= exp2f(-path[3] * sigma_a);
}

static void longitudinal(const float products[4], const float lobe[3], float *exponent,
                         float *factor)
{
    const float x = fabsf(lobe[0] * products[0] + lobe[1] * products[1]);
    *exponent = (lobe[2] - lobe[0] * products[2] + lobe[1] * products[3]) + x;
    const float m = clamp01(1.0f - 0.338199f * x);
    *factor = 1.0f / sqrtf(1.414916f * x + (m * m * m - 0.674258f));
}

static void multiply(float sin_i, float sin_r, float *cos_r, float products[4])
{
    const float cos_i = sqrtf(fabsf(1.0f - sin_i * sin_i));
    *cos_r = sqrtf(fabsf(1.0f - sin_r * sin_r));
    products[0] = cos_i * *cos_r + 1e-12f;
    products[1] = cos_i * sin_r;
    products[2] = sin_i * sin_r;
    products[3] = sin_i * *cos_r;
}

static void hair(const float *record, const struct tsu_i_texels *tables, const double *in, int fine,
                 double *out)
{
    float cos_r, products[4], n[4], path[4], exponent, factor;
    multiply((float)sin(in[0]), (float)sin(in[1]), &cos_r, products);
    const float half = (float)cos(0.5 * in[2]), sigma_a = (float)in[4];
    azimuthal(tables, cos_r, clamp01(half * half), n, path);
    longitudinal(products, record, &exponent, &factor);
    out[0] = n[0] * factor * exp2f(exponent);
    longitudinal(products, record + 4, &exponent, &factor);
    out[1] = n[1] * factor * exp2f(absorb_tt(path, sigma_a, exponent));
    longitudinal(products, record + 8, &exponent, &factor);
    out[2] = n[2] * factor * exp2f(exponent - path[2] * sigma_a);
    if (fine) {
        const float own[3] = {record[20], record[21], record[10]};
        longitudinal(products, own, &exponent, &factor);
    }
    out[3] = n[3] * factor * exp2f(exponent - path[3] * sigma_a);
    out[4] = out[0] + out[1] + out[2] + out[3];
}

void tsu_i_marschner_hair(const void *state, const float *record,
                          const struct tsu_i_texels *tables, const double *in, double *out)
{
    (void)state;
    hair(record, tables, in, 0, out);
}

void tsu_i_marschner_hair_fine(const void *state, const float *record,
                               const struct tsu_i_texels *tables, const double *in, double *out)
{
    (void)state;
    hair(record, tables, in, 1, out);
}

void tsu_i_marschner_azimuthal(const void *state, const float *record,
                               const struct tsu_i_texels *tables, const double *in, double *out)
{
    (void)state;
    (void)record;
    float n[4];
    const float half = (float)cos(0.5 * in[4]);
    tsu_i_marschner_sample(tables, (float)cos(in[1]), clamp01(half * half), (float)in[2], n);
    for (int p = 0; p < 4; p++)
        out[p] = n[p];
}

void tsu_i_marschner_longitudinal(const void *state, const float *record,
                                  const struct tsu_i_texels *tables, const double *in,
                                  double *out)
{
    (void)state;
    (void)tables;
    float cos_r, products[4], exponent, factor;
    multiply((float)sin(in[0]), (float)sin(in[1]), &cos_r, products);
    longitudinal(products, record, &exponent, &factor);
    out[0] = factor * exp2f(exponent);
}

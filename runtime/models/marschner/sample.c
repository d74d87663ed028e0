// The shader in C: the formulas of glsl/marschner in float, over the same texels and record.
#include "models/marschner/state.h"

#include "base/half.h"

#include <math.h>

static float clamp01(float x)
{
    return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
}

// Bilinear, at texel coordinates that lie within the table.
void tsu_i_marschner_fetch(const struct tsu_i_texels *table, int width, int height, float x,
                           float y, float out[4])
{
    const int i = x < 0.0f ? 0 : (int)x, j = (int)y;
    const int i1 = i < width - 1 ? i + 1 : i, j1 = j < height - 1 ? j + 1 : j;
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

static void fetch(const struct tsu_i_texels *table, float x, float y, float out[4])
{
    tsu_i_marschner_fetch(table, MARSCHNER_WIDTH, MARSCHNER_HEIGHT, x, y, out);
}

static void azimuthal(const struct tsu_i_texels *table, float cos_r, float cos2_half, float n[4],
                      float path[4])
{
    const float x = sqrtf(1.0f - cos2_half) - sqrtf(cos2_half);
    const float column = x * 63.5f + 63.5f;
    fetch(table, column, cos_r * MARSCHNER_SPAN(MARSCHNER_ROWS), n);
    fetch(table, column, cos_r * MARSCHNER_SPAN(MARSCHNER_PATH_ROWS) + (float)MARSCHNER_ROWS, path);
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

void tsu_i_marschner_lobe(const float products[4], const float lobe[3], float *exponent,
                          float *factor)
{
    const float x = fabsf(lobe[0] * products[0] + lobe[1] * products[1]);
    *exponent = (lobe[2] - lobe[0] * products[2] + lobe[1] * products[3]) + x;
    const float m = clamp01(1.0f - 0.338199f * x);
    *factor = 1.0f / sqrtf(1.414916f * x + (m * m * m - 0.674258f));
}

struct marschner_view tsu_i_marschner_view(float sin_i, float sin_r, float cos2_half)
{
    const float cos_i = sqrtf(fabsf(1.0f - sin_i * sin_i));
    const float cos_r = sqrtf(fabsf(1.0f - sin_r * sin_r));
    return (struct marschner_view){
        cos_r, cos2_half, {cos_i * cos_r + 1e-12f, cos_i * sin_r, sin_i * sin_r, sin_i * cos_r}};
}

void tsu_i_marschner_fiber(const float *record, const struct tsu_i_texels *table,
                           const struct marschner_view *view, float sigma_a, int fine, float out[4])
{
    float n[4], path[4], exponent, factor;
    azimuthal(table, view->cos_r, view->cos2_half, n, path);
    tsu_i_marschner_lobe(view->products, record, &exponent, &factor);
    out[0] = n[0] * factor * exp2f(exponent);
    tsu_i_marschner_lobe(view->products, record + 4, &exponent, &factor);
    out[1] = n[1] * factor * exp2f(absorb_tt(path, sigma_a, exponent));
    tsu_i_marschner_lobe(view->products, record + 8, &exponent, &factor);
    out[2] = n[2] * factor * exp2f(exponent - path[2] * sigma_a);
    if (fine) {
        const float own[3] = {record[20], record[21], record[10]};
        tsu_i_marschner_lobe(view->products, own, &exponent, &factor);
    }
    out[3] = n[3] * factor * exp2f(exponent - path[3] * sigma_a);
}

static void hair(const float *record, const struct tsu_i_texels *tables, const double *in, int fine,
                 double *out)
{
    float lobes[4];
    const float half = (float)cos(0.5 * in[2]);
    const struct marschner_view view =
        tsu_i_marschner_view((float)sin(in[0]), (float)sin(in[1]), clamp01(half * half));
    tsu_i_marschner_fiber(record, tables, &view, (float)in[4], fine, lobes);
    out[4] = 0.0;
    for (int p = 0; p < 4; p++) {
        out[p] = lobes[p];
        out[4] += out[p];
    }
}

void tsu_i_marschner_hair(const void *state, const float *record, const struct tsu_i_texels *tables,
                          const double *in, double *out)
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
                                  const struct tsu_i_texels *tables, const double *in, double *out)
{
    (void)state;
    (void)tables;
    float exponent, factor;
    const struct marschner_view view =
        tsu_i_marschner_view((float)sin(in[0]), (float)sin(in[1]), 1.0f);
    tsu_i_marschner_lobe(view.products, record, &exponent, &factor);
    out[0] = factor * exp2f(exponent);
}

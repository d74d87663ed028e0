// The shader in C: the formulas of glsl/dual_scattering in float, over the same texels and record.
#include "models/dual_scattering/state.h"

#include <math.h>

#define HALF_PI 1.57079633f
#define PI 3.14159265f

struct columns {
    float place, cos_r; // texture axes of absorption and inclination, [0, 1]
};

// Band of a table with the axes of "fields".
static void field(const struct tsu_i_texels *table, int bands, struct columns at, int band,
                  float out[4])
{
    tsu_i_marschner_fetch(table, FIELDS_WIDTH, bands * FIELDS_ROWS, at.place * (FIELDS_WIDTH - 1),
                          at.cos_r * DUAL_SPAN(FIELDS_ROWS) + (float)(band * FIELDS_ROWS), out);
}

static float lobe_value(const float lobe[4], const float products[4])
{
    const float argument = fabsf(lobe[0] * products[0] + lobe[1] * products[1]);
    const float exponent = (lobe[2] - lobe[0] * products[2] + lobe[1] * products[3]) + argument;
    return exp2f(exponent) /
           sqrtf(fmaxf(1.4022f * argument - 0.5655f, 0.5824f * argument + 0.3167f));
}

static float fiber(const struct tsu_i_dual_slab *m, const struct marschner_view *view)
{
    float lobes[4];
    tsu_i_marschner_fiber(m->record, m->azimuthal, view, m->sigma_a, 0, lobes);
    return lobes[0] + lobes[1] + lobes[2] + lobes[3];
}

static float finite(const struct tsu_i_dual_slab *m, const struct marschner_view *view, float front,
                    float behind, float direct)
{
    const float *s = m->stream;
    const float single = powf(direct, m->record[15]);
    const float above = front - m->delay * (1.0f - expf(-FRONT_RATE * front));
    const float below = behind - m->delay * (1.0f - expf(-FRONT_RATE * behind));
    const float x = exp2f(-above * s[0]), z = exp2f(-2.0f * below * s[0]) * s[1];
    const float p = s[3] * s[1] + s[2], q = s[2] * s[1] + s[3];
    const float scale = x / (1.0f - x * s[1] * (x * z));
    const float column = expf(-FRONT_RATE * front) * (float)(m->columns - 1);
    const float c = view->cos2_half, d = 1.0f - c;
    float lobe[2][4];
    for (int far = 0; far < 2; far++)
        tsu_i_marschner_fetch(m->lobes, m->columns, m->rows, column, m->row[far], lobe[far]);
    // The record's d_b and d_f, over the integral of cos^4(phi/2).
    const float near = m->record[19] * c * c * lobe_value(lobe[0], view->products);
    const float far = m->record[22] * d * d * lobe_value(lobe[1], view->products);
    const float multiple = ((p - q * z) * near + (q - p * z) * far) * scale -
                           single * (s[2] * near + s[3] * far);
    return direct * fiber(m, view) + fmaxf(multiple, 0.0f);
}

void tsu_i_dual_slab(const struct tsu_i_dual_slab *m, double whole, double out[4])
{
    enum { AZIMUTHS = 12, DEPTHS = 24, INCLINATIONS = 80 };
    const float tau = (float)fmin(whole, 1e4), seen = 1.0f - expf(-tau);
    const float deepest = fminf(tau, 20.0f);
    double forward = m->stream[3], backward = m->stream[2], r = 0.0, through = 0.0;
    tsu_i_two_stream_halves(&backward, &forward);
    const double restore = tsu_i_two_stream_restore(forward + backward);
    for (int i = 0; i < INCLINATIONS; i++) {
        const float theta = PI * (((float)i + 0.5f) / INCLINATIONS - 0.5f);
        for (int a = 0; a < AZIMUTHS; a++) {
            const float phi = HALF_PI * ((float)a + 0.5f) / AZIMUTHS, half = cosf(0.5f * phi);
            const struct marschner_view near =
                tsu_i_marschner_view(sinf(theta), m->sin_r, half * half);
            const struct marschner_view far =
                tsu_i_marschner_view(sinf(theta), m->sin_r, 1.0f - half * half);
            for (int d = 0; d < DEPTHS; d++) {
                const float u = ((float)d + 0.5f) / DEPTHS, mu = cosf(phi);
                const float depth = -logf(1.0f - seen * u), level = u * deepest;
                const float above = depth / mu, under = fmaxf(tau - level, 0.0f) / mu;
                r += cosf(theta) *
                     finite(m, &near, above, fmaxf(tau - depth, 0.0f) / mu, expf(-above));
                through +=
                    expf(-level) * cosf(theta) * finite(m, &far, under, level / mu, expf(-under));
            }
        }
    }
    const double weight = 2.0 * (HALF_PI / AZIMUTHS) * (PI / INCLINATIONS) / DEPTHS;
    out[0] = forward * restore;
    out[1] = backward * restore;
    out[2] = r * weight * seen;
    out[3] = through * weight * deepest + exp(-tau);
}

static struct tsu_i_dual_slab material_of(const void *opaque, const float *record,
                                          const struct tsu_i_texels *tables, const double *in)
{
    const struct dual_state *state = opaque;
    const float row = tsu_i_dual_material_place(&state->fiber) * DUAL_SPAN(SPREAD_ROWS);
    return (struct tsu_i_dual_slab){.record = record,
                                    .azimuthal = tables,
                                    .lobes = tables + 2,
                                    .sigma_a = (float)in[1],
                                    .sin_r = (float)sin(in[0]),
                                    .columns = SPREAD_WIDTH,
                                    .rows = SPREAD_HEIGHT,
                                    .row = {row, row + SPREAD_ROWS}};
}

void tsu_i_dual_sampled_exact(const void *state, const float *record,
                              const struct tsu_i_texels *tables, const double *in, double *out)
{
    struct tsu_i_dual_slab m = material_of(state, record, tables, in);
    const struct columns at = {tsu_i_dual_sigma_place(m.sigma_a), (float)fmax(cos(in[0]), 0.0)};
    field(tables + 1, 1, at, 0, m.stream);
    tsu_i_dual_slab(&m, in[2], out);
}

static float widened(const float products[4], float shift, float variance)
{
    const float scale = 1.44269504f / variance;
    const float lobe[3] = {cosf(shift) * scale, sinf(shift) * scale,
                           -log2f(variance * (1.0f - exp2f(-2.0f * scale))) - scale - 0.81484518f};
    float exponent, factor;
    tsu_i_marschner_lobe(products, lobe, &exponent, &factor);
    return factor * exp2f(exponent);
}

static float azimuth(float c0, float c1, float c3, float cos_phi)
{
    const float cos_3phi = (4.0f * cos_phi * cos_phi - 3.0f) * cos_phi;
    return fmaxf(0.15915494f * c0 + 0.20264237f * c1 * cos_phi - 0.06754746f * c3 * cos_3phi, 0.0f);
}

static float zinke(const struct tsu_i_dual_slab *m, const struct dual_state *state,
                   const struct tsu_i_texels *tables, const struct marschner_view *view,
                   struct columns at, float front, float direct)
{
    float whole[4], tt[4], trt[4], spread[4];
    field(tables + 3, ZINKE_BANDS, at, 0, whole);
    field(tables + 3, ZINKE_BANDS, at, 1, tt);
    field(tables + 3, ZINKE_BANDS, at, 2, trt);
    field(tables + 3, ZINKE_BANDS, at, 3, spread);
    const float cos_phi = 2.0f * view->cos2_half - 1.0f, added = front * spread[2];
    const float through = (1.0f - direct) * state->d_f * exp2f(front * whole[0]);
    float moved[3];
    for (int p = 0; p < 3; p++) {
        const double beta = state->fiber.beta[p];
        moved[p] =
            widened(view->products, (float)state->fiber.alpha[p], (float)(beta * beta) + added);
    }
    float sum = direct * fiber(m, view) +
                through * (azimuth(whole[2], whole[3], tt[3], cos_phi) * moved[0] +
                           azimuth(tt[0], tt[1], tt[2], cos_phi) * moved[1] +
                           azimuth(trt[0], trt[1], trt[2], cos_phi) * moved[2]);
    if (cos_phi > 0.0f)
        sum += state->d_b * whole[1] / PI *
               (direct * widened(view->products, spread[0], spread[1]) +
                through * widened(view->products, spread[0], spread[1] + added));
    return sum;
}

void tsu_i_dual_sampled_zinke(const void *state, const float *record,
                              const struct tsu_i_texels *tables, const double *in, double *out)
{
    enum { AZIMUTHS = 96, INCLINATIONS = 96 };
    const struct tsu_i_dual_slab m = material_of(state, record, tables, in);
    const float sin_r = (float)sin(in[0]), tau = (float)fmin(in[2], 1e4);
    const struct columns at = {tsu_i_dual_sigma_place(m.sigma_a), (float)fmax(cos(in[0]), 0.0)};
    double back = 0.0, all = 0.0, behind = 0.0;
    for (int a = 0; a < AZIMUTHS; a++) {
        const float half = cosf(PI * ((float)a + 0.5f) / AZIMUTHS), cos2_half = half * half;
        for (int i = 0; i < INCLINATIONS; i++) {
            const float theta = PI * (((float)i + 0.5f) / INCLINATIONS - 0.5f);
            const struct marschner_view view = tsu_i_marschner_view(sinf(theta), sin_r, cos2_half);
            const float near = cosf(theta) * zinke(&m, state, tables, &view, at, 0.0f, 0.0f);
            all += near;
            back += cos2_half > 0.5f ? near : 0.0f;
            behind += cosf(theta) * zinke(&m, state, tables, &view, at, tau, 0.0f);
        }
    }
    float whole[4], spread[4];
    field(tables + 3, ZINKE_BANDS, at, 0, whole);
    field(tables + 3, ZINKE_BANDS, at, 3, spread);
    out[0] = exp2f(whole[0]);
    out[1] = spread[3];
    out[2] = back * (2.0 * PI / AZIMUTHS) * (PI / INCLINATIONS);
    out[3] = behind / all;
}

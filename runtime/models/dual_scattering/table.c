// The tables. All quantities are colourless functions of absorption, so a colour bakes nothing.
//
// "fields", rows cos(theta_r) = j/31, columns absorption (tsu_i_dual_sigma_node):
//   log2(e) (2/pi) k, r, spread backward and forward shares of the first event (two_stream.h)
// "spread", over fibres in front (columns) and absorption, in two bands:
//   0  a, b, c of the lobe of light that comes back
//   1  the same of light that goes on
// "zinke", rows and columns of "fields" in each band:
//   0  log2 of a_f, A_1 + A_3; c_0 and c_1 of R
//   1  c_0, c_1, c_3 of TT;           c_3 of R
//   2  c_0, c_1, c_3 of TRT and the residual together
//      (c_k: cosine coefficients of N)
//   3  Delta_b, sigma_b^2, beta_f^2, a_b
#include "models/dual_scattering/state.h"

#include "optics/angle.h"

#include <math.h>
#include <string.h>

double tsu_i_dual_sigma_node(int i, int count)
{
    const double u = SIGMA_OCTAVES * i / (count - 1);
    return (double)SIGMA_LEAST * (exp2(u) - 1.0);
}

double tsu_i_dual_front_node(int i, int count)
{
    return -log(fmax((double)i / (count - 1), 1e-6)) / (double)FRONT_RATE;
}

float tsu_i_dual_sigma_place(float sigma_a)
{
    const float u = log2f(sigma_a / SIGMA_LEAST + 1.0f) / SIGMA_OCTAVES;
    return u < 0.0f ? 0.0f : u > 1.0f ? 1.0f : u;
}

float tsu_i_dual_material_place(const struct marschner_state *fiber)
{
    float u = 0.0f;
    for (int k = 0; k < 3; k++)
        u += tsu_i_dual_sigma_place(fiber->sigma_a[k]) / 3.0f;
    return u;
}

// Row 0 of a band is the limit of grazing view: everything is reflected.
static double inclination(int row, int rows)
{
    return acos(fmax((double)row / (rows - 1), 1e-3));
}

static struct tsu_i_strand strand_of(const struct marschner_state *fiber, double sigma_a)
{
    struct tsu_i_strand strand = {.eta = fiber->eta,
                                  .sigma_a = sigma_a,
                                  .beta_az = fiber->beta_az,
                                  .kind = TSU_I_STRAND_DEON,
                                  .lobes = TSU_I_LOBES};
    memcpy(strand.alpha, fiber->alpha, sizeof strand.alpha);
    memcpy(strand.beta, fiber->beta, sizeof strand.beta);
    return strand;
}

void tsu_i_dual_bake_fields(const void *state, uint32_t row, void *scratch, float *texels)
{
    (void)scratch;
    const struct marschner_state *fiber = &((const struct dual_state *)state)->fiber;
    const double theta = inclination((int)row, FIELDS_ROWS);
    for (int i = 0; i < FIELDS_WIDTH; i++) {
        const struct tsu_i_strand strand = strand_of(fiber, tsu_i_dual_sigma_node(i, FIELDS_WIDTH));
        struct tsu_i_event event;
        tsu_i_strand_event(&strand, theta, &event);
        const struct tsu_i_turn turn = tsu_i_strand_turn(&event);
        const struct tsu_i_stream stream = tsu_i_two_stream(&turn, strand.eta, 1.0);
        texels[4 * i + 0] = (float)(TSU_I_LOG2E * 2.0 / TSU_I_PI * stream.k);
        texels[4 * i + 1] = (float)stream.r;
        texels[4 * i + 2] = (float)stream.backward;
        texels[4 * i + 3] = (float)stream.forward;
    }
}

void tsu_i_dual_bake_zinke(const void *state, uint32_t unit, void *scratch, float *texels)
{
    (void)scratch;
    // A unit is one inclination: row `unit` of all bands.
    const struct marschner_state *fiber = &((const struct dual_state *)state)->fiber;
    const double theta = inclination((int)unit, FIELDS_ROWS);
    const int orders = tsu_i_fiber_orders(fiber->beta_az);
    for (int i = 0; i < FIELDS_WIDTH; i++) {
        const struct tsu_i_strand strand = strand_of(fiber, tsu_i_dual_sigma_node(i, FIELDS_WIDTH));
        double c[TSU_I_FIBER_ORDERS][TSU_I_LOBES];
        struct tsu_i_event event;
        struct tsu_i_dual_zinke zinke;
        tsu_i_fiber_cosines(strand.eta, theta, strand.sigma_a, strand.beta_az, orders, c);
        tsu_i_strand_halves(orders, c, &event);
        tsu_i_dual_zinke(&strand, &event, &zinke);
        float *out = texels + 4 * i;
        const int band = 4 * FIELDS_WIDTH;
        out[0] = (float)log2(fmax(zinke.forward, 1e-4));
        out[1] = (float)zinke.albedo;
        out[2] = (float)c[0][TSU_I_R];
        out[3] = (float)c[1][TSU_I_R];
        for (int k = 0; k < 3; k++) {
            const int order = k == 2 ? 3 : k;
            out[band + k] = (float)c[order][TSU_I_TT];
            out[2 * band + k] = (float)(c[order][TSU_I_TRT] + c[order][TSU_I_RES]);
        }
        out[band + 3] = (float)c[3][TSU_I_R];
        out[2 * band + 3] = 0.0f;
        out[3 * band + 0] = (float)zinke.shift;
        out[3 * band + 1] = (float)zinke.variance;
        out[3 * band + 2] = (float)zinke.step;
        out[3 * band + 3] = (float)zinke.back;
    }
}

void tsu_i_dual_lobe(const struct tsu_i_dual_moments *moments, float out[4])
{
    const double v = moments->variance, c = 1.0 / (v * -expm1(-2.0 / v));
    out[0] = (float)(TSU_I_LOG2E * cos(moments->mean) / v);
    out[1] = (float)(TSU_I_LOG2E * sin(moments->mean) / v);
    // 3.09446921: scale of I0e's fit, see glsl/marschner/longitudinal.glsl.
    out[2] = (float)(log2(c) - TSU_I_LOG2E / v - 0.5 * log2(3.09446921));
    out[3] = 0.0f;
}

double tsu_i_dual_lobe_power(const float lobe[4], double theta_r)
{
    enum { NODES = 48 };
    const double step = TSU_I_PI / NODES, cos_r = cos(theta_r), sin_r = sin(theta_r);
    double sum = 0.0;
    for (int i = 0; i < NODES; i++) {
        const double in = (i + 0.5) * step - 0.5 * TSU_I_PI, c = cos(in), s = sin(in);
        const double x = fabs(cos_r * c * lobe[0] + c * sin_r * lobe[1]);
        const double root = fmax(1.4022 * x - 0.5655, 0.5824 * x + 0.3167);
        sum += c * exp2(lobe[2] - lobe[0] * s * sin_r + lobe[1] * s * cos_r + x) / sqrt(root);
    }
    return sum * step;
}

// Of a white fibre's light the closed form keeps all but little: its lobes must not add more.
static void keep_power(float lobe[4])
{
    const double side = 40.0 * TSU_I_PI / 180.0;
    const double most = fmax(tsu_i_dual_lobe_power(lobe, -side), tsu_i_dual_lobe_power(lobe, side));
    lobe[2] -= (float)log2(fmax(most - 0.015, 1.0));
}

void tsu_i_dual_bake_spread(const void *state, uint32_t row, void *scratch, float *texels)
{
    (void)scratch;
    const struct marschner_state *fiber = &((const struct dual_state *)state)->fiber;
    struct tsu_i_event event;
    // Normal incidence stands for all: the shares change little with inclination. Below 0.02 the
    // generating function has no finite moments in a thick volume.
    const double sigma_a = tsu_i_dual_sigma_node((int)row % SPREAD_ROWS, SPREAD_ROWS);
    const struct tsu_i_strand strand = strand_of(fiber, fmax(sigma_a, 0.02));
    tsu_i_strand_event(&strand, 0.0, &event);
    for (int i = 0; i < SPREAD_WIDTH; i++) {
        struct tsu_i_dual_moments moments[2];
        tsu_i_dual_moments(&strand, &event, tsu_i_dual_front_node(i, SPREAD_WIDTH), moments);
        tsu_i_dual_lobe(moments + (row >= SPREAD_ROWS), texels + 4 * i);
        keep_power(texels + 4 * i);
    }
}

// Knots for bilinear interpolation: a sixteenth of the second difference along each axis splits the
// error between the knots and the middles of a parabola. In place, row by row: `above` keeps what a
// row was.
static void knots(float *texels, int width, int rows)
{
    float above[4 * FIELDS_WIDTH], now[4 * FIELDS_WIDTH];
    const int pitch = 4 * width;
    for (int j = 0; j < rows; j++) {
        float *row = texels + j * pitch;
        memcpy(now, row, (size_t)pitch * sizeof *now);
        for (int i = 0; i < pitch; i++) {
            float bend = 0.0f;
            if (i >= 4 && i < pitch - 4)
                bend += now[i - 4] - 2.0f * now[i] + now[i + 4];
            if (j > 0 && j < rows - 1)
                bend += above[i] - 2.0f * now[i] + row[pitch + i];
            row[i] = now[i] - bend * (1.0f / 16.0f);
        }
        memcpy(above, now, (size_t)pitch * sizeof *now);
    }
}

void tsu_i_dual_finish_fields(const void *state, float *texels)
{
    (void)state;
    knots(texels, FIELDS_WIDTH, FIELDS_ROWS);
}

void tsu_i_dual_finish_zinke(const void *state, float *texels)
{
    (void)state;
    for (int band = 0; band < ZINKE_BANDS; band++)
        knots(texels + band * FIELDS_ROWS * 4 * FIELDS_WIDTH, FIELDS_WIDTH, FIELDS_ROWS);
}

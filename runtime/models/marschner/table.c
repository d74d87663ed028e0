// The azimuthal table: N without absorption, and effective path lengths that carry any absorption.
//
// Lower band, 80 rows: N_R, N_TT, N_TRT, N_RES at sigma_a = 0, 1/rad.
// Upper band, 48 rows: log2(e) times
//   L, V   of TT:  ln(N_TT(sigma)/N_TT(0)) / sigma = V sigma - L, exact at sigma_a 0.5 and 2
//   L_TRT          the same without V, exact at sigma_a 0.5
//   L_RES          with N_RES: the exponential through the true values at two absorptions of the
//                  row (below), close to the one with the least error over all absorptions
// Columns: sin(phi/2) - cos(phi/2) = -1 + 2 i/127. Rows: cos(theta_r) = j/79 and j/47.
#include "models/marschner/state.h"

#include "optics/angle.h"
#include "optics/fiber.h"
#include "optics/quadrature.h"

#include <math.h>
#include <string.h>

enum { BINS = 256, PANELS = 6, RAYS = PANELS * TSU_I_QUADRATURE_PANEL, WIDTH = MARSCHNER_WIDTH };

// Panels over gamma_i: neighbouring rays of p = 3, the fastest in phi, leave within about beta.
static int panels_for(float beta)
{
    const int panels = (int)ceilf(0.52f / beta);
    return panels < 2 ? 2 : panels > PANELS ? PANELS : panels;
}

static const double tt_sigma[2] = {0.5, 2.0};
static const double trt_sigma = 0.5;
// The residual mixes paths of very different length near grazing: an exponential exact at sigma_a =
// 0 would err by 4 % of its peak. These are in units of the row's mean path; they leave 1.8 %.
static const double res_sigma[2] = {0.14, 1.45};

// What all rays of a row share.
struct spread {
    float phi[WIDTH];               // of the columns, radians
    unsigned char column[BINS + 1]; // last column at or before phi = bin pi/BINS
    float beta;
};

// exp(-x) for x in [0, 80], relative error below 2e-7: fast enough to be the bake's inner loop, and
// the same bits everywhere, which expf is not.
static float exp_minus(float x)
{
    const float y = -1.44269504f * x;
    const float rounded = (y + 12582912.0f) - 12582912.0f;
    const float f = y - rounded;
    const float p =
        1.0f +
        f * (0.693147181f +
             f * (0.240226507f + f * (0.0555041087f + f * (0.00961812911f + f * 0.00133335581f))));
    const int32_t exponent = ((int32_t)rounded + 127) << 23;
    float scale;
    memcpy(&scale, &exponent, sizeof scale);
    return p * scale;
}

static void prepare_columns(struct spread *s, float beta)
{
    int column = 0;
    for (int i = 0; i < WIDTH; i++)
        s->phi[i] = (float)(0.5 * TSU_I_PI +
                            2.0 * asin((-1.0 + 2.0 * i / (WIDTH - 1)) * 0.707106781186547524));
    for (int bin = 0; bin <= BINS; bin++) {
        while (column < WIDTH - 1 && s->phi[column + 1] <= (float)(bin * TSU_I_PI / BINS))
            column++;
        s->column[bin] = (unsigned char)column;
    }
    s->beta = beta;
}

// Add one image of a Gaussian at `centre` with `count` weights to as many rows of `sums`.
static void deposit(const struct spread *s, double centre, int count, const float *weights,
                    float sums[][WIDTH])
{
    const double reach = 5.5 * s->beta;
    if (centre + reach < 0.0 || centre - reach > TSU_I_PI)
        return;
    const double to_bin = BINS / TSU_I_PI;
    const int low = (int)fmax((centre - reach) * to_bin, 0.0);
    const int high = (int)fmin((centre + reach) * to_bin, BINS - 1) + 1;
    const int first = s->column[low], last = s->column[high];
    float g[WIDTH];
    const float c = (float)centre, scale = 1.0f / s->beta;
    for (int i = first; i <= last; i++) {
        const float z = (s->phi[i] - c) * scale;
        g[i] = exp_minus(0.5f * z * z);
    }
    for (int k = 0; k < count; k++)
        for (int i = first; i <= last; i++)
            sums[k][i] += weights[k] * g[i];
}

static void deposit_ray(const struct spread *s, double exit, int count, const float *weights,
                        float sums[][WIDTH])
{
    const double phi = fabs(tsu_i_angle_wrap(exit));
    deposit(s, phi, count, weights, sums);
    deposit(s, -phi, count, weights, sums);
    deposit(s, 2.0 * TSU_I_PI - phi, count, weights, sums);
}

// At grazing view the residual's mean path grows without limit; past this length nothing is left of
// it at any absorption that the eye can tell from none, and halves stay exact enough to
// interpolate.
#define LONGEST 48.0

// Effective path -ln(part/whole)/sigma; where both vanish in the Gaussian's tail, that of the mean.
static double path(double part, double whole, double mean, double sigma)
{
    const double floor_value = 1e-9;
    const double length = -log((part + floor_value * mean) / (whole + floor_value)) / sigma;
    return fmin(length, LONGEST);
}

struct row {
    float r[1][WIDTH], tt[3][WIDTH], trt[2][WIDTH], res[2][WIDTH];
    double mean_tt[2], mean_trt, mean_res; // transmittance of the whole lobe
    double res_sigma[2];
};

static void scatter(const struct marschner_state *state, double cos_theta, struct row *row)
{
    struct spread spread;
    struct tsu_i_ray rays[RAYS];
    const int panels = panels_for(state->beta_az), count = panels * TSU_I_QUADRATURE_PANEL;
    prepare_columns(&spread, state->beta_az);

    const double norm = 1.0 / (state->beta_az * sqrt(2.0 * TSU_I_PI));
    double sums[4][3] = {{0}}, rest[2] = {0};
    memset(row, 0, sizeof *row);
    double length = 0.0, weight = 0.0;
    for (int i = 0; i < count; i++) {
        rays[i] = tsu_i_fiber_ray(state->eta, cos_theta, panels, i);
        const double f = rays[i].fresnel, one = rays[i].weight * (1.0 - f) * f * f;
        weight += one;
        length += one * (3.0 + f / (1.0 - f)) * rays[i].segment;
    }
    for (int k = 0; k < 2; k++)
        row->res_sigma[k] = res_sigma[k] * fmax(weight / length, 1.0 / LONGEST);
    for (int i = 0; i < count; i++) {
        const struct tsu_i_ray ray = rays[i];
        const double f = ray.fresnel, through = ray.weight * (1.0 - f) * (1.0 - f);
        const double half = 0.5 * norm;
        const double t1 = exp(-tt_sigma[0] * ray.segment), t2 = exp(-tt_sigma[1] * ray.segment);
        const double t = exp(-trt_sigma * ray.segment);
        const double u[2] = {exp(-row->res_sigma[0] * ray.segment),
                             exp(-row->res_sigma[1] * ray.segment)};
        const float w_r[1] = {(float)(half * ray.weight * f)};
        const float w_tt[3] = {(float)(half * through), (float)(half * through * t1),
                               (float)(half * through * t2)};
        const float w_trt[2] = {(float)(half * through * f), (float)(half * through * f * t * t)};
        const double third[2] = {through * f * f * u[0] * u[0] * u[0],
                                 through * f * f * u[1] * u[1] * u[1]};
        const float w_res[2] = {(float)(half * third[0]), (float)(half * third[1])};
        deposit_ray(&spread, tsu_i_fiber_azimuth(&ray, 0), 1, w_r, row->r);
        deposit_ray(&spread, tsu_i_fiber_azimuth(&ray, 1), 3, w_tt, row->tt);
        deposit_ray(&spread, tsu_i_fiber_azimuth(&ray, 2), 2, w_trt, row->trt);
        deposit_ray(&spread, tsu_i_fiber_azimuth(&ray, 3), 2, w_res, row->res);
        sums[0][0] += through;
        sums[0][1] += through * t1;
        sums[0][2] += through * t2;
        sums[1][0] += through * f;
        sums[1][1] += through * f * t * t;
        for (int k = 0; k < 2; k++) {
            sums[2][k] += third[k];
            rest[k] += third[k] * f * u[k] / (1.0 - f * u[k]);
        }
    }
    row->mean_tt[0] = sums[0][1] / sums[0][0];
    row->mean_tt[1] = sums[0][2] / sums[0][0];
    row->mean_trt = sums[1][1] / sums[1][0];
    row->mean_res = sums[2][1] / sums[2][0];
    for (int i = 0; i < WIDTH; i++) {
        row->res[0][i] += (float)(rest[0] / (2.0 * TSU_I_PI));
        row->res[1][i] += (float)(rest[1] / (2.0 * TSU_I_PI));
    }
}

void tsu_i_marschner_bake(const void *opaque, uint32_t unit, void *scratch, float *texels)
{
    (void)scratch;
    const int is_path = unit >= MARSCHNER_ROWS;
    const double cos_theta = is_path ? (double)(unit - MARSCHNER_ROWS) / (MARSCHNER_PATH_ROWS - 1)
                                     : (double)unit / (MARSCHNER_ROWS - 1);
    struct row row;
    // Row 0 is the limit of grazing view: everything is reflected.
    scatter(opaque, fmax(cos_theta, 1e-4), &row);
    for (int i = 0; i < WIDTH; i++) {
        float *texel = texels + 4 * i;
        const double res_path =
            path(row.res[1][i], row.res[0][i], row.mean_res, row.res_sigma[1] - row.res_sigma[0]);
        if (!is_path) {
            texel[0] = row.r[0][i];
            texel[1] = row.tt[0][i];
            texel[2] = row.trt[0][i];
            texel[3] = row.res[0][i] * (float)exp(res_path * row.res_sigma[0]);
            continue;
        }
        const double near_l = path(row.tt[1][i], row.tt[0][i], row.mean_tt[0], tt_sigma[0]);
        const double far_l = path(row.tt[2][i], row.tt[0][i], row.mean_tt[1], tt_sigma[1]);
        const double v = fmax(0.0, (near_l - far_l) / (tt_sigma[1] - tt_sigma[0]));
        texel[0] = (float)(TSU_I_LOG2E * (near_l + v * tt_sigma[0]));
        texel[1] = (float)(TSU_I_LOG2E * v);
        texel[2] =
            (float)(TSU_I_LOG2E * path(row.trt[1][i], row.trt[0][i], row.mean_trt, trt_sigma));
        texel[3] = (float)(TSU_I_LOG2E * res_path);
    }
}

// Knots for bilinear interpolation: a share of the second difference is taken off along each axis,
// which halves the largest error of interpolating the samples themselves. A sixteenth would do for
// a parabola; 1/13 balances the error at and between the knots on the caustics, the sharpest ridges
// of the table. Even in phi at both ends.
void tsu_i_marschner_finish(const void *opaque, float *texels)
{
    (void)opaque;
    static const int pitch = 4 * WIDTH;
    float before[4 * WIDTH], now[4 * WIDTH];
    memcpy(before, texels, sizeof before);
    for (int j = 0; j < MARSCHNER_ROWS; j++) {
        float *row = texels + j * pitch;
        memcpy(now, row, sizeof now);
        for (int i = 0; i < WIDTH; i++)
            for (int k = 0; k < 4; k++) {
                const int left = i > 0 ? i - 1 : 1, right = i < WIDTH - 1 ? i + 1 : WIDTH - 2;
                const float value = now[4 * i + k];
                float bend = now[4 * left + k] - 2.0f * value + now[4 * right + k];
                if (j > 0 && j < MARSCHNER_ROWS - 1)
                    bend += before[4 * i + k] - 2.0f * value + row[pitch + 4 * i + k];
                row[4 * i + k] = fmaxf(value - bend * (1.0f / 13.0f), 0.5f * value);
            }
        memcpy(before, now, sizeof before);
    }
}

// Largest error over phi, at and between the columns, with theta_r at and between the rows and a
// spread of absorptions: of R+TT+TRT in units of their peak, of the residual in units of its peak
// without absorption.
static double worst(const void *opaque, const struct tsu_i_texels *tables, int residual)
{
    static const double sigmas[] = {0.0, 0.3, 1.0, 2.0, 5.0};
    const struct marschner_state *state = opaque;
    double largest = 0.0;
    for (int row = 14; row < 2 * (MARSCHNER_ROWS - 1); row += 5) {
        const double cos_theta = 0.5 * row / (MARSCHNER_ROWS - 1);
        double peak = 0.0;
        for (size_t s = 0; s < sizeof sigmas / sizeof *sigmas; s++) {
            const double sigma_a = residual ? 0.1 * sigmas[s] : sigmas[s];
            double error = 0.0;
            if (!residual)
                peak = 0.0;
            for (int i = 0; i <= 2 * (WIDTH - 1); i++) {
                const double phi = 0.5 * TSU_I_PI + 2.0 * asin(((double)i / (WIDTH - 1) - 1.0) *
                                                               0.707106781186547524);
                const double half = cos(0.5 * phi);
                double exact[4];
                float table[4];
                tsu_i_fiber_azimuthal(state->eta, acos(cos_theta), sigma_a, state->beta_az, phi,
                                      exact);
                tsu_i_marschner_sample(tables, (float)cos_theta, (float)(half * half),
                                       (float)sigma_a, table);
                const double sum = exact[0] + exact[1] + exact[2];
                const double sampled = (double)table[0] + (double)table[1] + (double)table[2];
                peak = fmax(peak, residual ? exact[3] : sum);
                error = fmax(error, residual ? fabs(table[3] - exact[3]) : fabs(sampled - sum));
            }
            largest = fmax(largest, error / peak);
        }
    }
    return largest;
}

double tsu_i_marschner_worst(const void *state, const struct tsu_i_texels *tables)
{
    return worst(state, tables, 0);
}

double tsu_i_marschner_worst_residual(const void *state, const struct tsu_i_texels *tables)
{
    return worst(state, tables, 1);
}

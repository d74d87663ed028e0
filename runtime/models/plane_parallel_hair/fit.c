// From a solved layer to the four numbers that the shader reads.
#include "models/plane_parallel_hair/state.h"

#include "optics/angle.h"
#include "optics/quadrature.h"

#include <math.h>
#include <string.h>

const double tsu_i_layer_taus[FITTED_TAUS] = {0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 512.0};

// What layers without absorption are asked to lose: with less a white head, which is no layer,
// gives over 1.03 of what it gets (tests/demo/furnace_test.py). Asked of the fit, it is taken from
// the side that can spare it.
#define WHITE_LOST 0.015

enum { PHIS = 8, DEPTHS = 16, UNKNOWNS = 4, ROWS = 3 * FITTED_TAUS + UNKNOWNS };

// One way to the light out of one depth.
struct way {
    double above, below;               // fibres on it, from the fibre to either surface, delayed
    double near, far;                  // weights of the two distributions times the depth's
    double single_above, single_below; // direct^gamma
};
struct ways {
    struct way ways[FITTED_TAUS][PHIS * DEPTHS];
    double r[FITTED_TAUS], t[FITTED_TAUS]; // single and unscattered light
};

static double delayed(double fibres)
{
    return fibres - (double)LAYER_DELAY * (1.0 - exp(-(double)FRONT_RATE * fibres));
}

static void lay_out(const struct tsu_i_strand *strand, double theta, double gamma,
                    struct ways *ways)
{
    double c[TSU_I_FIBER_ORDERS][TSU_I_LOBES];
    const int orders = tsu_i_strand_cosines(strand, theta, c);
    for (int k = 0; k < orders; k++)
        c[k][0] = c[k][0] + c[k][1] + c[k][2] + c[k][3];
    for (int i = 0; i < FITTED_TAUS; i++) {
        const double tau = tsu_i_layer_taus[i], deepest = fmin(tau, 16.0);
        ways->r[i] = 0.0;
        ways->t[i] = exp(-tau);
        for (int j = 0; j < PHIS * DEPTHS; j++) {
            // Midpoints over azimuth do for so smooth a sum.
            const double phi = 0.5 * TSU_I_PI * (j / DEPTHS + 0.5) / PHIS, mu = cos(phi);
            double share;
            const double depth = tsu_i_quadrature_node(0.0, deepest, 1, j % DEPTHS, &share);
            const double weight = TSU_I_PI / PHIS * share * exp(-depth);
            const double half = 0.5 * (1.0 + mu), scale = weight * 4.0 / (3.0 * TSU_I_PI);
            struct way *way = &ways->ways[i][j];
            const double above = depth / mu, below = (tau - depth) / mu;
            way->near = scale * half * half;
            way->far = scale * (1.0 - half) * (1.0 - half);
            way->single_above = exp(-gamma * above);
            way->single_below = exp(-gamma * below);
            way->above = delayed(above);
            way->below = delayed(below);
            double back = 0.5 * c[0][0], on = 0.5 * c[0][0];
            for (int k = 1; k < orders; k++) {
                back += c[k][0] * cos(k * phi);
                on += (k % 2 ? -1.0 : 1.0) * c[k][0] * cos(k * phi);
            }
            ways->r[i] += weight * back / TSU_I_PI * exp(-above);
            ways->t[i] += weight * on / TSU_I_PI * exp(-below);
        }
    }
}

// R and T of all layers for x = (ln k, logit r, back, on).
static void evaluate(const struct ways *ways, const double x[UNKNOWNS], struct layer_powers *powers)
{
    const double k = exp(x[0]) * (2.0 / TSU_I_PI), r = 1.0 / (1.0 + exp(-x[1]));
    const double b = x[2], f = x[3], p = f * r + b, q = f + b * r;
    for (int i = 0; i < FITTED_TAUS; i++) {
        double sum_r = ways->r[i], sum_t = ways->t[i];
        for (int j = 0; j < PHIS * DEPTHS; j++) {
            const struct way *way = &ways->ways[i][j];
            const double above = exp(-k * way->above), below = exp(-k * way->below);
            const double loop = 1.0 / fmax(1.0 - r * r * above * above * below * below, 1e-15);
            double z = r * below * below, scale = above * loop;
            double same = (p - q * z) * scale - b * way->single_above;
            double other = (q - p * z) * scale - f * way->single_above;
            sum_r += fmax(way->near * same + way->far * other, 0.0);
            z = r * above * above;
            scale = below * loop;
            same = (p - q * z) * scale - b * way->single_below;
            other = (q - p * z) * scale - f * way->single_below;
            sum_t += fmax(way->far * same + way->near * other, 0.0);
        }
        powers->r[i] = sum_r;
        powers->t[i] = sum_t;
    }
}

// In units of the error allowed, 5 % or 0.01, which the second stage squares for the sake of the
// largest; then what layers without absorption lose too little. The last rows hold the unknowns near
// the closed form where the layers say little about them, so that neighbours in inclination and
// absorption find the same of several minima and may be interpolated.
static void residuals(const struct ways *ways, const struct layer_powers *truth, int squared,
                      const double start[UNKNOWNS], const double x[UNKNOWNS], double out[ROWS])
{
    static const double loose[UNKNOWNS] = {0.5, 0.5, 1.0, 0.6};
    struct layer_powers powers;
    evaluate(ways, x, &powers);
    for (int i = 0; i < FITTED_TAUS; i++) {
        out[2 * i] = (powers.r[i] - truth->r[i]) / fmax(0.05 * truth->r[i], 0.01);
        out[2 * i + 1] = (powers.t[i] - truth->t[i]) / fmax(0.05 * truth->t[i], 0.01);
    }
    for (int i = 0; squared && i < 2 * FITTED_TAUS; i++)
        out[i] *= fabs(out[i]);
    for (int i = 0; i < FITTED_TAUS; i++) {
        const double whole = truth->r[i] + truth->t[i];
        out[2 * FITTED_TAUS + i] =
            whole > 0.999 ? fmax(powers.r[i] + powers.t[i] - whole + WHITE_LOST, 0.0) / 0.02 : 0.0;
    }
    for (int k = 0; k < UNKNOWNS; k++)
        out[3 * FITTED_TAUS + k] = loose[k] * (x[k] - start[k]);
}

static double square(const double row[ROWS])
{
    double sum = 0.0;
    for (int i = 0; i < ROWS; i++)
        sum += row[i] * row[i];
    return sum;
}

// Solve (J^T J + damping diag) step = -J^T row by elimination; UNKNOWNS is small.
static void normal_step(double jacobian[ROWS][UNKNOWNS], const double row[ROWS], double damping,
                        double step[UNKNOWNS])
{
    double a[UNKNOWNS][UNKNOWNS + 1];
    for (int i = 0; i < UNKNOWNS; i++) {
        for (int j = 0; j < UNKNOWNS; j++) {
            a[i][j] = 0.0;
            for (int n = 0; n < ROWS; n++)
                a[i][j] += jacobian[n][i] * jacobian[n][j];
        }
        a[i][i] *= 1.0 + damping;
        a[i][UNKNOWNS] = 0.0;
        for (int n = 0; n < ROWS; n++)
            a[i][UNKNOWNS] -= jacobian[n][i] * row[n];
    }
    for (int k = 0; k < UNKNOWNS; k++)
        for (int i = 0; i < UNKNOWNS; i++)
            if (i != k) {
                const double factor = a[i][k] / a[k][k];
                for (int j = k; j <= UNKNOWNS; j++)
                    a[i][j] -= factor * a[k][j];
            }
    for (int k = 0; k < UNKNOWNS; k++)
        step[k] = a[k][UNKNOWNS] / a[k][k];
}

// From x to the least sum of squares: Levenberg and Marquardt's steps.
static void descend(const struct ways *ways, const struct layer_powers *powers, int squared,
                    const double start[UNKNOWNS], double x[UNKNOWNS])
{
    double row[ROWS], damping = 1e-3;
    residuals(ways, powers, squared, start, x, row);
    for (int iteration = 0; iteration < 20; iteration++) {
        double jacobian[ROWS][UNKNOWNS];
        for (int k = 0; k < UNKNOWNS; k++) {
            double moved[UNKNOWNS], other[ROWS];
            memcpy(moved, x, sizeof moved);
            moved[k] += 1e-4;
            residuals(ways, powers, squared, start, moved, other);
            for (int n = 0; n < ROWS; n++)
                jacobian[n][k] = (other[n] - row[n]) * 1e4;
        }
        double step[UNKNOWNS], moved[UNKNOWNS], other[ROWS];
        int better = 0;
        for (int attempt = 0; attempt < 6 && !better; attempt++) {
            normal_step(jacobian, row, damping, step);
            for (int k = 0; k < UNKNOWNS; k++)
                moved[k] = x[k] + step[k];
            moved[1] = fmin(moved[1], 4.5); // r at most 0.989, as the closed form's floor
            residuals(ways, powers, squared, start, moved, other);
            better = square(other) < square(row);
            damping *= better ? 0.3 : 10.0;
        }
        if (!better)
            break;
        const double gain = square(row) - square(other);
        memcpy(x, moved, sizeof moved);
        memcpy(row, other, sizeof row);
        if (gain < 1e-4)
            break;
    }
}

void tsu_i_layer_fit(const struct tsu_i_strand *strand, double theta, double gamma,
                     const struct layer_powers *powers, struct layer_fit *fit)
{
    struct ways ways;
    struct tsu_i_event event;
    tsu_i_strand_event(strand, theta, &event);
    const struct tsu_i_turn turn = tsu_i_strand_turn(&event);
    const struct tsu_i_stream stream = tsu_i_two_stream(&turn, strand->eta, gamma);
    lay_out(strand, theta, gamma, &ways);
    const double start[UNKNOWNS] = {log(stream.k), log(stream.r / (1.0 - stream.r)),
                                    stream.backward, stream.forward};
    double x[UNKNOWNS];
    memcpy(x, start, sizeof x);
    descend(&ways, powers, 0, start, x);
    descend(&ways, powers, 1, start, x);
    fit->ln_k = (float)(x[0] - start[0]);
    fit->logit_r = (float)(x[1] - start[1]);
    fit->back = (float)(x[2] - start[2]);
    fit->on = (float)(x[3] - start[3]);
}

// Solved layers against the random walk in slabs of parallel fibres: the solution itself, and the
// tables that its shader reads.
#include "slab_truth.h"
#include "sweep.h"

#include <tsuya/models/plane_parallel_hair.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { THETA, SIGMA, TAU, ETA, ALPHA, BETA, BETA_AZ, SHIFTS, CFG, INPUTS };
static const double degree = 0.0174532925199432958;
static int failures;

static void hold(const char *what, double value, double bound)
{
    const int good = value <= bound;
    printf("%-60s %.5f (bound %.5f)%s\n", what, value, bound, good ? "" : "  FAILED");
    failures += !good;
}

static void defaults(double *in)
{
    const double fiber[INPUTS] = {0, 0, 1, 1.55, -7.5 * degree, 7.5 * degree, 10 * degree, 0, 0};
    memcpy(in, fiber, sizeof fiber);
}

static void slabs(struct sweep *sweep)
{
    double square[2] = {0, 0}, largest[2] = {0, 0}, share = 0.0;
    int count = 0;
    for (size_t i = 0; i < sizeof slab_truth / sizeof *slab_truth; i++) {
        const struct slab_truth *t = slab_truth + i;
        double in[INPUTS], out[4], table[4];
        defaults(in);
        in[THETA] = t->theta_deg * degree;
        in[SIGMA] = t->sigma_a;
        in[TAU] = t->tau > 0 ? t->tau : 1e9;
        in[CFG] = 1;
        sweep_reference(sweep, tsu_plane_parallel_hair(), 0, in, out);
        sweep_material(sweep, tsu_plane_parallel_hair(), 0, in);
        sweep_table(sweep, 0, in, table);
        for (int k = 0; k < (t->tau > 0 ? 2 : 1); k++) {
            const double truth = k ? t->t : t->r, se = k ? t->t_se : t->r_se;
            const double z = (out[2 + k] - truth) / se;
            const double miss = fabs(table[2 + k] - truth) / fmax(0.05 * truth, 0.01);
            square[k] += z * z;
            largest[0] = fmax(largest[0], fabs(z));
            largest[1] = fmax(largest[1], miss);
            count++;
            if (getenv("TSUYA_PRINT"))
                printf("sigma %g theta %g tau %g %c: solved %.4f table %.4f truth %.4f z %.1f miss "
                       "%.2f\n",
                       t->sigma_a, t->theta_deg, t->tau, "RT"[k], out[2 + k], table[2 + k], truth,
                       z, miss);
        }
        for (int k = 0; k < 2; k++)
            share = fmax(share, fabs(table[k] - out[k]));
    }
    hold("solution against the random walk: rms z", sqrt((square[0] + square[1]) / count), 1.3);
    hold("largest z", largest[0], 4.5);
    hold("tables: largest error over the larger of 5 % and 0.01", largest[1],
         sweep_stated(tsu_plane_parallel_hair(), "slab"));
    hold("shares, tables", share, 1e-3);
}

int main(void)
{
    struct sweep sweep;
    sweep_open(&sweep, 1);
    slabs(&sweep);
    sweep_close(&sweep);
    return failures != 0;
}

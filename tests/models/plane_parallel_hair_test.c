// Solved layers against the random walk in slabs of parallel fibres: the solution itself, and the
// tables that its shader reads.
#include "slab_rows.h"
#include "slab_truth.h"

#include <tsuya/models/plane_parallel_hair.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 0.0174532925199432958;
static int failures;

static void hold(const char *what, double value, double bound)
{
    const int good = value <= bound;
    printf("%-60s %.5f (bound %.5f)%s\n", what, value, bound, good ? "" : "  FAILED");
    failures += !good;
}

// Error over the larger of 5 % and 0.01.
static double miss(double value, double truth, double noise)
{
    return fmax(fabs(value - truth) - noise, 0.0) / fmax(0.05 * truth, 0.01);
}

static void slabs(struct sweep *sweep, size_t stride)
{
    double square[2] = {0, 0}, largest[2] = {0, 0}, share = 0.0;
    int count = 0;
    for (size_t i = 0; i < sizeof slab_truth / sizeof *slab_truth; i += stride) {
        const struct slab_truth *t = slab_truth + i;
        double in[SLAB_INPUTS], out[4], table[4];
        slab_default(in);
        in[SLAB_THETA] = t->theta_deg * degree;
        in[SLAB_SIGMA] = t->sigma_a;
        in[SLAB_TAU] = t->tau > 0 ? t->tau : 1e9;
        in[SLAB_CFG] = 1;
        sweep_reference(sweep, tsu_plane_parallel_hair(), 0, in, out);
        slab_material(sweep, tsu_plane_parallel_hair(), 0, in);
        sweep_table(sweep, 0, in, table);
        for (int k = 0; k < (t->tau > 0 ? 2 : 1); k++) {
            const double truth = k ? t->t : t->r, se = k ? t->t_se : t->r_se;
            const double z = (out[2 + k] - truth) / se;
            const double off = miss(table[2 + k], truth, 0.0);
            square[k] += z * z;
            largest[0] = fmax(largest[0], fabs(z));
            largest[1] = fmax(largest[1], off);
            count++;
            if (getenv("TSUYA_PRINT"))
                printf("sigma %g theta %g tau %g %c: solved %.4f table %.4f truth %.4f z %.1f miss "
                       "%.2f\n",
                       t->sigma_a, t->theta_deg, t->tau, "RT"[k], out[2 + k], table[2 + k], truth,
                       z, off);
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

// Fibres that no table holds, against our own walk: what is left of an error when three standard
// errors of the walk are taken off. `solve`: of so many rows one asks the reference, which is slow.
static void fibers(struct sweep *sweep, int count, int draws, long walks, int solve)
{
    const tsu_model *model = tsu_plane_parallel_hair();
    double worst[2] = {0, 0}, mean = 0.0;
    int values = 0, solved = 0, beyond = 0;
    for (int f = 0; f < count; f++) {
        double in[SLAB_INPUTS], taus[SLAB_TAUS];
        slab_fiber(sweep, in);
        for (int d = 0; d < draws; d++) {
            struct walk_slab slabs[SLAB_TAUS];
            slab_draw(sweep, in);
            const int rows = slab_walk(in, walks, (uint64_t)(f * draws + d), taus, slabs);
            slab_material(sweep, model, 0, in);
            for (int i = 0; i < rows; i++) {
                const int both = (i + f + d) % solve == 0;
                in[SLAB_TAU] = taus[i];
                for (int place = both ? 0 : 1; place < 2; place++) {
                    double out[SLAB_OUTPUTS];
                    if (place)
                        sweep_table(sweep, 0, in, out);
                    else
                        sweep_reference(sweep, model, 0, in, out);
                    for (int k = 0; k < (taus[i] < 1e9 ? 2 : 1); k++) {
                        const double truth = k ? slabs[i].t : slabs[i].r;
                        const double noise = 3.0 * (k ? slabs[i].t_se : slabs[i].r_se);
                        const double off = miss(out[SLAB_R + k], truth, noise);
                        worst[place] = fmax(worst[place], off);
                        mean += place ? fabs(out[SLAB_R + k] - truth) : 0.0;
                        values += place;
                        beyond += place && off > 1.0;
                        if (off > 0.5 && getenv("TSUYA_PRINT")) {
                            printf("%d %c %.4f walk %.4f miss %.2f ", place, "RT"[k],
                                   out[SLAB_R + k], truth, off);
                            slab_print("fibre", in);
                        }
                    }
                }
                solved += both;
            }
        }
    }
    printf("%d values of R and T of %d random fibres, %d rows solved\n", values, count, solved);
    hold("solution: largest error over the larger of 5 % and 0.01", worst[0],
         sweep_stated(model, "slab_solved"));
    hold("tables: the same", worst[1], sweep_stated(model, "slab_all"));
    hold("tables: share of values beyond 5 % and 0.01", (double)beyond / values,
         sweep_stated(model, "slab_all_beyond"));
    hold("tables: mean error of R and T", mean / values, sweep_stated(model, "slab_all_mean"));
}

// Views nearly along the fibres, where curls point at the viewer: the tables against the walk.
static void steep(struct sweep *sweep, int count, long walks)
{
    static const double absorptions[4] = {0.1, 0.5, 2.0, 20.0};
    static const double angles[6] = {-88, -84, -78, 78, 84, 88};
    const tsu_model *model = tsu_plane_parallel_hair();
    double worst = 0.0;
    for (int f = 0; f < count; f++) {
        double in[SLAB_INPUTS], taus[SLAB_TAUS], out[SLAB_OUTPUTS];
        if (f)
            slab_fiber(sweep, in);
        else
            slab_default(in);
        for (int i = 0; i < 24; i++) {
            struct walk_slab slabs[SLAB_TAUS];
            in[SLAB_THETA] = angles[i % 6] * degree;
            in[SLAB_SIGMA] = absorptions[i / 6];
            const int rows = slab_walk(in, walks, (uint64_t)(1000 + 24 * f + i), taus, slabs);
            slab_material(sweep, model, 0, in);
            for (int t = 0; t < rows; t++) {
                in[SLAB_TAU] = taus[t];
                sweep_table(sweep, 0, in, out);
                for (int k = 0; k < (taus[t] < 1e9 ? 2 : 1); k++) {
                    const double truth = k ? slabs[t].t : slabs[t].r;
                    const double noise = 3.0 * (k ? slabs[t].t_se : slabs[t].r_se);
                    const double off = fmax(fabs(out[SLAB_R + k] - truth) - noise, 0.0);
                    worst = fmax(worst, off);
                    if (off > 0.02 && getenv("TSUYA_PRINT")) {
                        printf("%c %.4f walk %.4f off %.3f ", "RT"[k], out[SLAB_R + k], truth, off);
                        slab_print("fibre", in);
                    }
                }
            }
        }
    }
    hold("tables, theta beyond 75 degrees: largest error", worst,
         sweep_stated(model, "slab_steep"));
}

static void white(struct sweep *sweep, int count)
{
    const tsu_model *model = tsu_plane_parallel_hair();
    struct slab_white worst = {0.0, 0.0};
    for (int f = 0; f < count; f++) {
        double in[SLAB_INPUTS];
        if (f)
            slab_fiber(sweep, in);
        else
            slab_default(in);
        slab_material(sweep, model, 0, in);
        slab_white(sweep, model, 0, 1, in, &worst);
        hold("corners, answers out of bounds", slab_corners(sweep, model, 0, 1, in), 0.0);
        if (f == 0 || getenv("TSUYA_LONG")) {
            struct slab_white solved = {0.0, 0.0};
            slab_white(sweep, model, 0, 0, in, &solved);
            hold("white slabs, solution, R + T from 1", fmax(solved.gain, solved.loss), 2e-3);
        }
    }
    hold("white slabs, R + T above 1", worst.gain, sweep_stated(model, "slab_white_gain"));
    hold("white slabs, R + T below 1", worst.loss, sweep_stated(model, "slab_white_loss"));
    struct slab_white far = {0.0, 0.0};
    for (int f = 0; f < (getenv("TSUYA_LONG") ? SLAB_CORNER_FIBERS : 1); f++) {
        double in[SLAB_INPUTS];
        slab_corner_fiber(f, in);
        slab_material(sweep, model, 0, in);
        slab_white(sweep, model, 0, 1, in, &far);
    }
    hold("white slabs of far fibres, R + T above 1", far.gain,
         sweep_stated(model, "slab_white_far"));
}

int main(void)
{
    const int many = getenv("TSUYA_LONG") != NULL;
    struct sweep sweep;
    sweep_open(&sweep, 1);
    slabs(&sweep, many ? 1 : 3);
    fibers(&sweep, many ? 60 : 3, many ? 4 : 2, many ? 100000 : 40000, many ? 9 : 6);
    steep(&sweep, many ? 12 : 2, many ? 40000 : 10000);
    white(&sweep, many ? 30 : 2);
    sweep_close(&sweep);
    return failures != 0;
}

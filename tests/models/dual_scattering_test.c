// Dual scattering against the transport of light in slabs of parallel fibres: the reference, and
// the tables through the shader's twin in C.
#include "slab_rows.h"
#include "slab_truth.h"

#include <tsuya/models/dual_scattering.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXACT = 1, ZINKE = 2 };
static const double degree = 0.0174532925199432958;
// Materials of ZINKE have the tables of both.
static int failures;

static void hold(const char *what, double value, double bound)
{
    const int good = value <= bound;
    printf("%-60s %.5f (bound %.5f)%s\n", what, value, bound, good ? "" : "  FAILED");
    failures += !good;
}

static void shares(struct sweep *sweep)
{
    double worst[2] = {0, 0}, table[2] = {0, 0};
    for (size_t i = 0; i < sizeof event_truth / sizeof *event_truth; i++) {
        const struct event_truth *t = event_truth + i;
        double in[SLAB_INPUTS], out[4];
        slab_default(in);
        in[SLAB_THETA] = t->theta_deg * degree;
        in[SLAB_SIGMA] = t->sigma_a;
        in[SLAB_CFG] = t->cfg;
        const double aligned[2] = {t->af, t->ab}, averaged[2] = {t->afz, t->abz};
        for (int variant = EXACT; variant <= ZINKE; variant++) {
            const double *truth = variant == EXACT ? aligned : averaged;
            sweep_reference(sweep, tsu_dual_scattering(), (uint32_t)variant, in, out);
            for (int k = 0; k < 2; k++)
                worst[variant - 1] = fmax(worst[variant - 1], fabs(out[k] - truth[k]));
            if (t->cfg != 1)
                continue;
            slab_material(sweep, tsu_dual_scattering(), (uint32_t)variant, in);
            sweep_table(sweep, (uint32_t)variant, in, out);
            for (int k = 0; k < 2; k++)
                table[variant - 1] = fmax(table[variant - 1], fabs(out[k] - truth[k]));
        }
    }
    hold("aligned shares, reference", worst[0], 1e-5);
    hold("averaged shares, reference", worst[1], 1e-5);
    hold("aligned shares, tables", table[0], 1e-3);
    hold("averaged shares, tables", table[1], 1e-3);
}

// Mean absolute error of R and T over the truth's rows.
static void slabs(struct sweep *sweep)
{
    double sum[2][2] = {{0}}, largest[2] = {0};
    int count = 0;
    for (size_t i = 0; i < sizeof slab_truth / sizeof *slab_truth; i++) {
        const struct slab_truth *t = slab_truth + i;
        double in[SLAB_INPUTS], out[4];
        slab_default(in);
        in[SLAB_THETA] = t->theta_deg * degree;
        in[SLAB_SIGMA] = t->sigma_a;
        in[SLAB_TAU] = t->tau > 0 ? t->tau : 1e9;
        in[SLAB_CFG] = 1;
        slab_material(sweep, tsu_dual_scattering(), ZINKE, in);
        for (int variant = EXACT; variant <= ZINKE; variant++)
            for (int place = 0; place < 2; place++) {
                if (place)
                    sweep_table(sweep, (uint32_t)variant, in, out);
                else
                    sweep_reference(sweep, tsu_dual_scattering(), (uint32_t)variant, in, out);
                const double r = fabs(out[2] - t->r),
                             through = t->tau > 0 ? fabs(out[3] - t->t) : 0;
                sum[variant - 1][place] += t->tau > 0 ? r + through : r;
                if (variant == EXACT)
                    largest[place] = fmax(largest[place], fmax(r, through));
                if (getenv("TSUYA_PRINT"))
                    printf("%d %d sigma %g theta %g tau %g: R %.4f %.4f T %.4f %.4f\n", variant,
                           place, t->sigma_a, t->theta_deg, t->tau, out[2], t->r, out[3], t->t);
            }
        count += t->tau > 0 ? 2 : 1;
    }
    const double stated = sweep_stated(tsu_dual_scattering(), "slab");
    hold("exact, reference: mean error of R and T", sum[0][0] / count, stated);
    hold("exact, tables", sum[0][1] / count, stated);
    hold("largest, both", fmax(largest[0], largest[1]),
         sweep_stated(tsu_dual_scattering(), "slab_most"));
    hold("zinke, reference: mean error from 0.15", fabs(sum[1][0] / count - 0.15), 0.02);
    hold("zinke, tables", fabs(sum[1][1] / count - 0.15), 0.02);
    hold("exact over zinke", sum[0][1] / sum[1][1], 0.25);
}

// Fibres that no table holds, against our own walk.
static void fibers(struct sweep *sweep, int count, int draws, long walks)
{
    double sum[2][2] = {{0}}, largest = 0.0;
    int values = 0;
    for (int f = 0; f < count; f++) {
        double in[SLAB_INPUTS], taus[SLAB_TAUS], own = 0.0;
        slab_fiber(sweep, in);
        const int before = values;
        for (int d = 0; d < draws; d++) {
            struct walk_slab slabs[SLAB_TAUS];
            slab_draw(sweep, in);
            const int rows = slab_walk(in, walks, (uint64_t)(f * draws + d), taus, slabs);
            slab_material(sweep, tsu_dual_scattering(), ZINKE, in);
            for (int i = 0; i < rows; i++) {
                const int parts = taus[i] < 1e9 ? 2 : 1;
                in[SLAB_TAU] = taus[i];
                for (int variant = EXACT; variant <= ZINKE; variant++)
                    for (int place = 0; place < 2; place++) {
                        double out[SLAB_OUTPUTS];
                        if (place)
                            sweep_table(sweep, (uint32_t)variant, in, out);
                        else
                            sweep_reference(sweep, tsu_dual_scattering(), (uint32_t)variant, in,
                                            out);
                        for (int k = 0; k < parts; k++) {
                            const double off =
                                fabs(out[SLAB_R + k] - (k ? slabs[i].t : slabs[i].r));
                            sum[variant - 1][place] += off;
                            if (variant == ZINKE)
                                continue;
                            own += place ? off : 0.0;
                            largest = fmax(largest, off);
                            if (off > 0.05 && getenv("TSUYA_PRINT")) {
                                printf("%d %c off by %.4f ", place, "RT"[k], off);
                                slab_print("fibre", in);
                            }
                        }
                    }
                values += parts;
            }
        }
        if (getenv("TSUYA_PRINT")) {
            printf("mean %.4f ", own / (values - before));
            slab_print("fibre", in);
        }
    }
    const double stated = sweep_stated(tsu_dual_scattering(), "slab_all");
    printf("%d values of R and T of %d random fibres\n", values, count);
    hold("exact, reference: mean error", sum[0][0] / values, stated);
    hold("exact, tables", sum[0][1] / values, stated);
    hold("exact: largest error, both", largest,
         sweep_stated(tsu_dual_scattering(), "slab_all_most"));
    hold("exact over zinke, reference", sum[0][0] / sum[1][0], 0.25);
    hold("exact over zinke, tables", sum[0][1] / sum[1][1], 0.25);
}

static void white(struct sweep *sweep, int count)
{
    struct slab_white worst = {0.0, 0.0};
    for (int f = 0; f < count; f++) {
        double in[SLAB_INPUTS];
        if (f)
            slab_fiber(sweep, in);
        else
            slab_default(in);
        slab_material(sweep, tsu_dual_scattering(), EXACT, in);
        for (int table = 0; table < 2; table++) {
            slab_white(sweep, tsu_dual_scattering(), EXACT, table, in, &worst);
            hold("corners, answers out of bounds",
                 slab_corners(sweep, tsu_dual_scattering(), EXACT, table, in), 0.0);
        }
    }
    hold("white slabs, R + T above 1", worst.gain,
         sweep_stated(tsu_dual_scattering(), "slab_white_gain"));
    hold("white slabs, R + T below 1", worst.loss,
         sweep_stated(tsu_dual_scattering(), "slab_white_loss"));
    struct slab_white far = {0.0, 0.0};
    for (int f = 0; f < SLAB_CORNER_FIBERS; f++) {
        double in[SLAB_INPUTS];
        slab_corner_fiber(f, in);
        slab_material(sweep, tsu_dual_scattering(), EXACT, in);
        slab_white(sweep, tsu_dual_scattering(), EXACT, 1, in, &far);
    }
    hold("white slabs of far fibres, R + T above 1", far.gain,
         sweep_stated(tsu_dual_scattering(), "slab_white_far"));
}

int main(void)
{
    const int many = getenv("TSUYA_LONG") != NULL;
    struct sweep sweep;
    sweep_open(&sweep, 1);
    shares(&sweep);
    slabs(&sweep);
    fibers(&sweep, many ? 60 : 6, many ? 4 : 2, many ? 100000 : 20000);
    white(&sweep, many ? 30 : 3);
    sweep_close(&sweep);
    return failures != 0;
}

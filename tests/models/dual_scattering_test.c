// Dual scattering against the transport of light in slabs of parallel fibres, and its shader's twin
// in C against its double-precision form.
#include "slab_truth.h"
#include "sweep.h"

#include <tsuya/models/dual_scattering.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { THETA, SIGMA, TAU, ETA, ALPHA, BETA, BETA_AZ, SHIFTS, CFG, INPUTS };
enum { EXACT = 1, ZINKE = 2 };
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

static void shares(struct sweep *sweep)
{
    double worst[2] = {0, 0}, table[2] = {0, 0};
    for (size_t i = 0; i < sizeof event_truth / sizeof *event_truth; i++) {
        const struct event_truth *t = event_truth + i;
        double in[INPUTS], out[4];
        defaults(in);
        in[THETA] = t->theta_deg * degree;
        in[SIGMA] = t->sigma_a;
        in[CFG] = t->cfg;
        const double aligned[2] = {t->af, t->ab}, averaged[2] = {t->afz, t->abz};
        for (int variant = EXACT; variant <= ZINKE; variant++) {
            const double *truth = variant == EXACT ? aligned : averaged;
            sweep_reference(sweep, tsu_dual_scattering(), (uint32_t)variant, in, out);
            for (int k = 0; k < 2; k++)
                worst[variant - 1] = fmax(worst[variant - 1], fabs(out[k] - truth[k]));
            if (t->cfg != 1)
                continue;
            sweep_material(sweep, tsu_dual_scattering(), (uint32_t)variant, in);
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
        double in[INPUTS], out[4];
        defaults(in);
        in[THETA] = t->theta_deg * degree;
        in[SIGMA] = t->sigma_a;
        in[TAU] = t->tau > 0 ? t->tau : 1e9;
        in[CFG] = 1;
        for (int variant = EXACT; variant <= ZINKE; variant++)
            for (int place = 0; place < 2; place++) {
                if (place) {
                    sweep_material(sweep, tsu_dual_scattering(), (uint32_t)variant, in);
                    sweep_table(sweep, (uint32_t)variant, in, out);
                } else
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
    printf("largest %.4f %.4f\n", largest[0], largest[1]);
    hold("zinke, reference: mean error from 0.15", fabs(sum[1][0] / count - 0.15), 0.02);
    hold("zinke, tables", fabs(sum[1][1] / count - 0.15), 0.02);
    hold("exact over zinke", sum[0][1] / sum[1][1], 0.25);
}

int main(void)
{
    struct sweep sweep;
    sweep_open(&sweep, 1);
    shares(&sweep);
    slabs(&sweep);
    sweep_close(&sweep);
    return failures != 0;
}

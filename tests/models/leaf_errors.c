#include "leaf_errors.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

static double value(struct sweep *sweep, double *in, int side, int through, double mu0, double mu,
                    double phi)
{
    double out[2];
    in[MU0] = mu0;
    in[MU] = mu;
    in[PHI] = phi;
    in[KIND] = through;
    in[SIDE] = side;
    sweep_table(sweep, 0, in, out);
    return out[through];
}

// Directional R or T of the table.
static double power(struct sweep *sweep, double *in, int side, int through, double mu0)
{
    enum { COSINES = 24, PHIS = 8 };
    double sum = 0.0;
    for (int i = 0; i < COSINES; i++)
        for (int k = 0; k < PHIS; k++) {
            const double mu = (i + 0.5) / COSINES;
            sum += mu * value(sweep, in, side, through, mu0, mu, (k + 0.5) * pi / PHIS);
        }
    return sum * 2.0 * pi / (COSINES * PHIS);
}

void leaf_compare(struct sweep *sweep, const struct truth *truth, double *in, struct worst *worst)
{
    enum { PHIS = 7 };
    for (int side = 0; side < 2; side++)
        for (int through = 0; through < 2; through++) {
            double peak = 0.0, error = 0.0;
            for (int i = 0; i < TRUTH_COSINES; i++)
                for (int o = 0; o < TRUTH_COSINES; o++)
                    for (int k = 0; k < PHIS; k++) {
                        const double phi = k * pi / (PHIS - 1);
                        const double f = truth_value(truth, side, through, i, o, phi);
                        const double t =
                            value(sweep, in, side, through, truth_cosine[i], truth_cosine[o], phi);
                        peak = fmax(peak, f);
                        error = fmax(error, fabs(t - f));
                    }
            const double hemisphere =
                through ? truth->slab.diffuse_transmittance[side] : truth_power(truth, side, 0, 6);
            double *const most = through ? &worst->transmitted : &worst->reflected;
            if (hemisphere > 0.02) {
                *most = fmax(*most, error / peak);
            } else {
                worst->dim = fmax(worst->dim, error);
            }
            for (int i = 2; i < TRUTH_COSINES; i += 2) {
                const double all = truth_power(truth, side, through, i);
                const double table = power(sweep, in, side, through, truth_cosine[i]);
                const double spread = truth_spread(truth, side, through, i);
                worst->power = fmax(worst->power, fabs(table - spread));
                worst->straight = fmax(worst->straight, fabs(table - all));
            }
        }
}

// A leaf of one channel, the set's only material.
void leaf_set(struct sweep *sweep, const tsu_model *model, const tsu_leaf_body_params *params)
{
    uint32_t material;
    if (sweep->set)
        tsu_set_destroy(sweep->set);
    tsu_set_desc desc;
    tsu_set_desc_init(&desc);
    if (tsu_set_create(sweep->context, &desc, &sweep->set) != TSU_OK ||
        tsu_set_add(sweep->set, model, params, &material) != TSU_OK ||
        tsu_set_bake(sweep->set) != TSU_OK)
        abort();
}

static double grow(struct sweep *sweep, double low, double high)
{
    return low * pow(high / low, sweep_between(sweep, 0.0, 1.0));
}

void leaf_random(struct sweep *sweep, tsu_leaf_body_params *params)
{
    tsu_leaf_body_params_init(params);
    params->n = (float)sweep_between(sweep, 1.35, 1.55);
    const double absorption = grow(sweep, 0.02, 6.0), share = sweep_between(sweep, 0.0, 1.0);
    for (int c = 0; c < 3; c++) {
        params->scatter_top[c] = (float)grow(sweep, 0.05, 0.5);
        params->scatter_bottom[c] = (float)grow(sweep, 1.6, 4.5);
        params->absorption_top[c] = (float)(share * absorption);
        params->absorption_bottom[c] = (float)((1.0 - share) * absorption);
    }
}

void leaf_factors(struct sweep *sweep, double *in)
{
    in[ABSORPTION] = grow(sweep, 0.25, 2.0);
    in[THICKNESS] = grow(sweep, 0.5, 2.0);
}

void leaf_sweep(struct sweep *sweep, const tsu_model *model, int leaves, struct worst *worst)
{
    for (int i = 0; i < leaves; i++) {
        tsu_leaf_body_params params;
        leaf_random(sweep, &params);
        leaf_set(sweep, model, &params);
        for (int k = 0; k < 4; k++) {
            double in[COLUMNS] = {0, 1, 0.1, 0.1, 0.1, 1.45, 1, 1, 0, 0, 0, 1, 1};
            struct truth truth;
            leaf_factors(sweep, in);
            truth_solve(&truth, &params, in[ABSORPTION], in[THICKNESS]);
            leaf_compare(sweep, &truth, in, worst);
            truth_free(&truth);
        }
    }
}

int leaf_report(const tsu_model *model, const char *name, double measured, double bound)
{
    const double stated = sweep_stated(model, name);
    const int fine = measured <= stated && (bound <= 0.0 || stated <= bound);
    printf("%-14s measured %.5f  stated %.5f%s\n", name, measured, stated,
           fine ? "" : "  <-- too large");
    return fine;
}

// What leaf_body states about its errors, measured again: the form and the table against the slab
// solver, both sides, all azimuths, over pigment and thickness; energy and reciprocity.
//
//   leaf_body_test      a sample, no measured error may exceed the stated one
//   leaf_body_test N    N times as many leaves; with TSUYA_LONG set, 12
#include "leaf_errors.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// Uniform light on each side in closed form, against the solver.
static void ambient(struct sweep *sweep, const struct truth *truth, const double *factors,
                    double *worst)
{
    double in[10] = {0, 1, 0.1, 0.1, 0.1, 1.45}, out[2];
    in[8] = factors[ABSORPTION];
    in[9] = factors[THICKNESS];
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < TRUTH_COSINES; i++) {
            in[6] = truth_cosine[i];
            in[7] = side;
            sweep_table(sweep, 1, in, out);
            for (int through = 0; through < 2; through++) {
                const double spread = truth_spread(truth, side, through, i);
                *worst = fmax(*worst, fabs(out[through] - spread));
            }
        }
}

// All of uniform light that a leaf without absorption gives back, less 1.
static double furnace(struct sweep *sweep, const tsu_leaf_body_params *leaf_params)
{
    tsu_leaf_body_params params = *leaf_params;
    for (int c = 0; c < 3; c++)
        params.absorption_top[c] = params.absorption_bottom[c] = 0.0f;
    leaf_set(sweep, tsu_leaf_body(), &params);
    double worst = 0.0, in[10] = {0, 1, 0.1, 0.1, 0.1, 1.45, 1, 0, 1, 1}, out[2];
    for (int side = 0; side < 2; side++) {
        enum { COSINES = 64 };
        double sum = 0.0;
        for (int i = 0; i < COSINES; i++) {
            const double mu = (i + 0.5) / COSINES;
            const double t = sqrt(1.0 - (1.0 - mu * mu) / (params.n * params.n));
            const double s = (mu - params.n * t) / (mu + params.n * t);
            const double p = (t - params.n * mu) / (t + params.n * mu);
            in[6] = mu;
            in[7] = side;
            sweep_table(sweep, 1, in, out);
            sum += 2.0 * mu / COSINES * (out[0] + out[1] + 0.5 * (s * s + p * p));
        }
        worst = fmax(worst, fabs(sum - 1.0));
    }
    return worst;
}

// The numbers of tsu_leaf_body_uniform() make what the table makes.
static double uniform_numbers(struct sweep *sweep)
{
    float numbers[72];
    double worst = 0.0, in[COLUMNS] = {0, 1, 0.1, 0.1, 0.1, 1.45, 1, 1, 0, 0, 0, 0.7, 1.3}, out[2];
    if (tsu_leaf_body_uniform(sweep->set, 0, 0.7f, 1.3f, numbers) != TSU_OK)
        return 1.0;
    // Straight down: S, Q, Z are 0, X is 0, P is known.
    const double n = 1.45, wall = 4.0 * n / ((1.0 + n) * (1.0 + n));
    for (int set = 0; set < 3; set++) {
        const double p = set == 1 ? 8.0 : 8.0 / 27.0;
        const double f = wall * wall * (numbers[24 * set] + numbers[24 * set + 14] * (p - 1.0));
        in[KIND] = set == 1;
        in[SIDE] = set == 0;
        sweep_table(sweep, 0, in, out);
        worst = fmax(worst, fabs(f / out[set == 1] - 1.0));
    }
    return worst;
}

int main(int argc, char **argv)
{
    const int scale = argc > 1 ? atoi(argv[1]) : getenv("TSUYA_LONG") ? 12 : 1;
    const tsu_model *const model = tsu_leaf_body();
    struct sweep sweep;
    struct worst worst = {0};
    double uniform = 0.0, white = 0.0;
    sweep_open(&sweep, 20121116);
    leaf_sweep(&sweep, model, 16 * scale, &worst);
    for (int i = 0; i < 6 * scale; i++) {
        tsu_leaf_body_params params;
        struct truth truth;
        double in[COLUMNS] = {0};
        leaf_random(&sweep, &params);
        leaf_set(&sweep, model, &params);
        leaf_factors(&sweep, in);
        truth_solve(&truth, &params, in[ABSORPTION], in[THICKNESS]);
        ambient(&sweep, &truth, in, &uniform);
        truth_free(&truth);
        white = fmax(white, furnace(&sweep, &params));
    }
    tsu_leaf_body_params params;
    tsu_leaf_body_params_init(&params);
    leaf_set(&sweep, model, &params);
    const double numbers = uniform_numbers(&sweep);
    sweep_close(&sweep);
    printf("numbers of one pigment and thickness against the table: %.1e\n", numbers);
    int fine = numbers < 3e-3; // the fit of the walls among it
    fine &= leaf_report(model, "ambient", uniform, 0.005);
    fine &= leaf_report(model, "furnace", white, 0.005);
    fine &= leaf_report(model, "reflected", worst.reflected, -1);
    fine &= leaf_report(model, "transmitted", worst.transmitted, -1);
    fine &= leaf_report(model, "dim", worst.dim, 1e-3);
    fine &= leaf_report(model, "power", worst.power, 0.005);
    fine &= leaf_report(model, "straight", worst.straight, -1);
    return fine ? 0 : 1;
}

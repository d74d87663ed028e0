#include "slab_rows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 0.0174532925199432958;

void slab_default(double in[SLAB_INPUTS])
{
    const double fiber[SLAB_INPUTS] = {0,           0, 1, 1.55, -7.5 * degree, 7.5 * degree,
                                       10 * degree, 0, 0};
    memcpy(in, fiber, sizeof fiber);
}

void slab_fiber(struct sweep *sweep, double in[SLAB_INPUTS])
{
    slab_default(in);
    in[SLAB_ETA] = sweep_corner(sweep, 1.3, 1.8);
    in[SLAB_ALPHA] = degree * sweep_corner(sweep, -10, 10);
    in[SLAB_BETA] = degree * sweep_corner(sweep, 4, 15);
    in[SLAB_BETA_AZ] = degree * sweep_corner(sweep, 5, 20);
    in[SLAB_SHIFTS] = sweep_corner(sweep, 0, 1);
}

void slab_corner_fiber(int index, double in[SLAB_INPUTS])
{
    slab_default(in);
    in[SLAB_ETA] = index < 2 ? 1.2 : 2.0;
    in[SLAB_ALPHA] = degree * (index % 2 ? 20 : -20);
    in[SLAB_BETA] = degree * (index < 3 ? 2 : 30);
    in[SLAB_BETA_AZ] = degree * 5;
}

void slab_draw(struct sweep *sweep, double in[SLAB_INPUTS])
{
    const double draw = fmax(sweep_between(sweep, -0.25, 1), 0.0);
    in[SLAB_SIGMA] = draw * draw * draw;
    in[SLAB_THETA] = sweep_degrees(sweep, -60, 60);
}

int slab_walk(const double in[SLAB_INPUTS], long walks, uint64_t seed, double taus[SLAB_TAUS],
              struct walk_slab slabs[SLAB_TAUS])
{
    const struct walk_fiber fiber = {.eta = in[SLAB_ETA],
                                     .sigma_a = in[SLAB_SIGMA],
                                     .beta_az = in[SLAB_BETA_AZ],
                                     .alpha_R = in[SLAB_ALPHA],
                                     .beta_R = in[SLAB_BETA],
                                     .scale_shifts = in[SLAB_SHIFTS],
                                     .lobe = in[SLAB_CFG] == 1 ? WALK_GAUSSIAN : WALK_OWN};
    const int count = in[SLAB_SIGMA] < 0.003 ? SLAB_TAUS - 1 : SLAB_TAUS;
    for (int i = 0; i < SLAB_TAUS; i++)
        taus[i] = i == SLAB_TAUS - 1 ? 1e9 : ldexp(0.5, i);
    walk(&fiber, in[SLAB_THETA], count, taus, walks, seed, slabs);
    return count;
}

void slab_print(const char *what, const double in[SLAB_INPUTS])
{
    printf("%s: theta %.1f sigma %.4f tau %g eta %.3f alpha %.1f beta %.1f beta_az %.1f "
           "shifts %.2f\n",
           what, in[SLAB_THETA] / degree, in[SLAB_SIGMA], in[SLAB_TAU], in[SLAB_ETA],
           in[SLAB_ALPHA] / degree, in[SLAB_BETA] / degree, in[SLAB_BETA_AZ] / degree,
           in[SLAB_SHIFTS]);
}

void slab_material(struct sweep *sweep, const tsu_model *model, uint32_t function,
                   const double in[SLAB_INPUTS])
{
    // Material 1 is the same fibre: it holds the tables while material 0 gives way to the next.
    double params[32];
    uint32_t material = 0;
    tsu_model_info info;
    tsu_set_info held;
    tsu_model_info_init(&info);
    tsu_set_info_init(&held);
    int good = tsu_set_describe(sweep->set, &held) == TSU_OK;
    if (held.material_count == 0)
        good = good && sweep_material(sweep, model, function, in);
    if (held.material_count == 2)
        good = good && tsu_set_remove(sweep->set, 1) == TSU_OK;
    good = good && tsu_model_describe(model, &info) == TSU_OK &&
           tsu_model_params_init(model, params, info.params_size) == TSU_OK &&
           tsu_function_params(sweep->context, model, function, in, params) == TSU_OK &&
           tsu_set_add(sweep->set, model, params, &material) == TSU_OK && material == 1;
    if (!good || !sweep_material(sweep, model, function, in)) {
        fprintf(stderr, "no material\n");
        exit(1);
    }
}

static void answer(struct sweep *sweep, const tsu_model *model, uint32_t function, int table,
                   const double in[SLAB_INPUTS], double out[SLAB_OUTPUTS])
{
    if (table)
        sweep_table(sweep, function, in, out);
    else
        sweep_reference(sweep, model, function, in, out);
}

void slab_white(struct sweep *sweep, const tsu_model *model, uint32_t function, int table,
                const double in[SLAB_INPUTS], struct slab_white *worst)
{
    static const double taus[] = {0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0, 400.0};
    double row[SLAB_INPUTS], out[SLAB_OUTPUTS];
    memcpy(row, in, sizeof row);
    row[SLAB_SIGMA] = 0.0;
    for (size_t t = 0; t < sizeof taus / sizeof *taus; t++)
        for (int k = 0; k < 2; k++) {
            // The steepest that are promised in every other slab.
            row[SLAB_THETA] = k == 0 && t % 2 ? 75.0 * degree : sweep_degrees(sweep, -75, 75);
            row[SLAB_TAU] = taus[t];
            answer(sweep, model, function, table, row, out);
            const double off = out[SLAB_R] + out[SLAB_T] - 1.0;
            if (getenv("TSUYA_PRINT")) {
                printf("%d R + T %+.4f ", table, off);
                slab_print("white", row);
            }
            worst->gain = fmax(worst->gain, off);
            worst->loss = fmax(worst->loss, -off);
        }
}

int slab_corners(struct sweep *sweep, const tsu_model *model, uint32_t function, int table,
                 const double in[SLAB_INPUTS])
{
    static const double sigmas[] = {0.0, 0.3, 1e6}, taus[] = {0.0, 1.0, 1e9};
    static const double thetas[] = {-90.0, 0.0, 60.0, 90.0};
    int bad = 0;
    for (int i = 0; i < 3 * 3 * 4; i++) {
        double row[SLAB_INPUTS], out[SLAB_OUTPUTS];
        memcpy(row, in, sizeof row);
        row[SLAB_SIGMA] = sigmas[i % 3];
        row[SLAB_TAU] = taus[i / 3 % 3];
        row[SLAB_THETA] = thetas[i / 9] * degree;
        answer(sweep, model, function, table, row, out);
        // A white slab may gain what the test of white slabs allows.
        const double most = row[SLAB_SIGMA] > 0.0 ? 1.0 : 1.016;
        int good = out[SLAB_R] >= 0.0 && out[SLAB_T] >= 0.0 && out[SLAB_R] <= 1.0 &&
                   out[SLAB_T] <= 1.0 && out[SLAB_R] + out[SLAB_T] <= most;
        if (row[SLAB_TAU] == 0.0)
            good = good && out[SLAB_R] == 0.0 && out[SLAB_T] == 1.0;
        if (row[SLAB_TAU] == 1e9 && row[SLAB_SIGMA] > 0.0)
            good = good && out[SLAB_T] < 1e-6;
        if (!good) {
            printf("%s: R %g T %g ", table ? "tables" : "reference", out[SLAB_R], out[SLAB_T]);
            slab_print("corner", row);
        }
        bad += !good;
    }
    return bad;
}

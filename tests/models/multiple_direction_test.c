// Along the fibres: the lobes of multiply scattered light in the tables of both models against the
// solved layers, at depths inside a half space.
#include "models/plane_parallel_hair/state.h"
#include "optics/dense.h"
#include "sweep.h"

#include <tsuya/models/dual_scattering.h>
#include <tsuya/models/marschner.h>
#include <tsuya/models/plane_parallel_hair.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { AZIMUTHS = 6, THETAS = TSU_I_LAYER_THETAS, SIZE = THETAS * (AZIMUTHS + 1), DEPTHS = 6 };
enum { EXACT, PLANE_PARALLEL, MODELS };
static const double pi = 3.14159265358979323846, degree = 0.0174532925199432958;
static const double depths[DEPTHS] = {0.0, 0.5, 1.0, 2.0, 4.0, 8.0};
static const double sigmas[4] = {0.02, 0.1, 0.3, 1.0};
static int failures;

struct error {
    double sum, most;
    int count;
};

static struct room {
    double solver[7 * SIZE * SIZE];
    double back[DEPTHS][SIZE * SIZE], through[DEPTHS][SIZE * SIZE];
    struct layer_room bake;
    float spread[SPREAD_HEIGHT][SPREAD_WIDTH][4];
    float layer[LAYER_HEIGHT][LAYER_WIDTH][4], unit[LAYER_HEIGHT / SOLVED_SIGMAS][LAYER_WIDTH][4];
} * room;

static void hold(const char *what, double value, double bound)
{
    const int good = value <= bound;
    printf("%-60s %.5f (bound %.5f)%s\n", what, value, bound, good ? "" : "  FAILED");
    failures += !good;
}

static void bake(const struct dual_state *state)
{
    for (uint32_t row = 0; row < 2 * SPREAD_ROWS; row++)
        tsu_i_dual_bake_spread(state, row, NULL, room->spread[row][0]);
    for (uint32_t unit = 0; unit < SOLVED_SIGMAS; unit++) {
        tsu_i_layer_bake(state, unit, &room->bake, room->unit[0][0]);
        memcpy(room->layer[unit], room->unit[0], sizeof room->layer[unit]);
    }
    tsu_i_layer_finish(state, room->layer[0][0]);
}

static double between(const float *texels, int width, double x, double y, int k)
{
    const int i = x < width - 1 ? (int)x : width - 2, j = (int)y;
    const float *low = texels + 4 * (j * width + i) + k, *high = low + 4 * width;
    return (low[0] * (1.0 - x + i) + low[4] * (x - i)) * (1.0 - y + j) +
           (high[0] * (1.0 - x + i) + high[4] * (x - i)) * (y - j);
}

// Power of a model's lobe over the inclinations of the grid, as its shader draws it.
static void model_lobe(int model, int far, double sigma_a, double front, double theta_r,
                       const double theta[THETAS], double power[THETAS])
{
    const int plane = model == PLANE_PARALLEL, width = plane ? LAYER_WIDTH : SPREAD_WIDTH;
    const int rows = plane ? LAYER_LOBE_ROWS : SPREAD_ROWS, first = plane ? LAYER_LOBES : 0;
    const float *texels = plane ? room->layer[0][0] : room->spread[0][0];
    const double x = exp(-(double)FRONT_RATE * front) * (width - 1);
    const float same = (float)sigma_a, all[3] = {same, same, same};
    const float row =
        plane ? tsu_i_layer_lobe(all) : tsu_i_dual_sigma_place(same) * DUAL_SPAN(SPREAD_ROWS);
    const double y = first + far * rows + (double)row;
    const double a = between(texels, width, x, y, 0), b = between(texels, width, x, y, 1);
    const double c = between(texels, width, x, y, 2), sin_r = sin(theta_r), cos_r = cos(theta_r);
    for (int t = 0; t < THETAS; t++) {
        const double s = sin(theta[t]), cos_i = cos(theta[t]);
        const double argument = fabs(a * cos_i * cos_r + b * cos_i * sin_r);
        const double root = fmax(1.4022 * argument - 0.5655, 0.5824 * argument + 0.3167);
        power[t] = exp2(c - a * s * sin_r + b * s * cos_r + argument) / sqrt(root) * cos_i *
                   (theta[1] - theta[0]);
    }
}

// Powers over the inclinations that leave through a layer of depths[d] above a half space, after a
// first event between the two; less what leaves at once.
//   far  0: the viewer's side is the thin one, 1: the far side is
static void solved_lobe(const struct tsu_i_layer *half_space, int d, int far, int node,
                        double power[THETAS])
{
    const int column = node * (AZIMUTHS + 1) + AZIMUTHS;
    double *loop = half_space->work[0], *product = half_space->work[1];
    double field[SIZE], toward[SIZE];
    for (int i = 0; i < SIZE; i++) {
        toward[i] = (far ? half_space->forward : half_space->backward)[i * SIZE + column];
        field[i] = toward[i];
        for (int j = 0; j < SIZE; j++)
            field[i] += half_space->back[i * SIZE + j] *
                        (far ? half_space->backward : half_space->forward)[j * SIZE + column];
    }
    memset(product, 0, SIZE * SIZE * sizeof *product);
    if (depths[d] > 0.0)
        tsu_i_dense_add(SIZE, half_space->back, room->back[d], product);
    for (int i = 0; i < SIZE * SIZE; i++)
        loop[i] = (i % (SIZE + 1) == 0) - product[i];
    tsu_i_dense_solve(SIZE, loop, 1, field);
    memset(power, 0, THETAS * sizeof *power);
    for (int i = 0; i < SIZE; i++) {
        double out = depths[d] > 0.0 ? 0.0 : field[i];
        for (int j = 0; depths[d] > 0.0 && j < SIZE; j++)
            out += room->through[d][i * SIZE + j] * field[j];
        out -= toward[i] * exp(-depths[d] / cos(half_space->phi[i % (AZIMUTHS + 1)]));
        power[i / (AZIMUTHS + 1)] += out;
    }
}

static void solve(const struct dual_state *state, double sigma_a, struct tsu_i_layer *layer)
{
    struct tsu_i_strand strand = {.eta = state->fiber.eta,
                                  .sigma_a = sigma_a,
                                  .beta_az = state->fiber.beta_az,
                                  .kind = TSU_I_STRAND_DEON,
                                  .lobes = TSU_I_LOBES};
    memcpy(strand.alpha, state->fiber.alpha, sizeof strand.alpha);
    memcpy(strand.beta, state->fiber.beta, sizeof strand.beta);
    tsu_i_layer_begin(layer, &strand, 0.0, AZIMUTHS, room->solver);
    tsu_i_layer_thin(layer, ldexp(1.0, -11));
    for (int d = 1; layer->tau < 512.0;) {
        tsu_i_layer_double(layer);
        if (d < DEPTHS && layer->tau == depths[d]) {
            memcpy(room->back[d], layer->back, sizeof room->back[d]);
            memcpy(room->through[d], layer->through, sizeof room->through[d]);
            d++;
        }
    }
}

static void measure(const struct dual_state *state, struct error errors[MODELS])
{
    bake(state);
    for (int s = 0; s < 4; s++) {
        struct tsu_i_layer layer;
        solve(state, sigmas[s], &layer);
        for (int i = 0; i < DEPTHS * 2 * 3; i++) {
            // Views at -30, 0 and 30 degrees; travel is against them.
            const int d = i % DEPTHS, far = i / DEPTHS % 2, view = i / DEPTHS / 2 - 1;
            double solved[THETAS], drawn[THETAS], whole = 0.0;
            solved_lobe(&layer, d, far, THETAS / 2 - 6 * view, solved);
            for (int t = 0; t < THETAS; t++)
                whole += solved[t];
            for (int model = 0; model < MODELS; model++) {
                double off = 0.0;
                model_lobe(model, far, sigmas[s], 0.5 * pi * depths[d], 30.0 * view * degree,
                           layer.theta, drawn);
                for (int t = 0; t < THETAS; t++)
                    off += fabs(drawn[t] - solved[t] / whole);
                errors[model].sum += off;
                errors[model].most = fmax(errors[model].most, off);
                errors[model].count++;
                if (getenv("TSUYA_PRINT"))
                    printf("%-15s sigma %.2f depth %.1f %-4s view %3d: %.3f\n",
                           model == EXACT ? "exact" : "plane_parallel", sigmas[s], depths[d],
                           far ? "on" : "back", 30 * view, off);
            }
        }
    }
}

static struct dual_state state_of(struct sweep *sweep, int index)
{
    tsu_marschner_params params;
    struct dual_state state;
    memset(&state, 0, sizeof state);
    tsu_marschner_params_init(&params);
    if (index) {
        params.eta = (float)sweep_between(sweep, 1.3, 1.8);
        params.alpha_R = (float)sweep_degrees(sweep, -10, 10);
        params.beta_R = (float)sweep_degrees(sweep, 4, 15);
        params.beta_az = (float)sweep_degrees(sweep, 5, 20);
        params.scale_shifts = (float)sweep_between(sweep, 0, 1);
    }
    tsu_i_marschner_prepare(&params, &state.fiber);
    state.gamma = (float)tsu_i_two_stream_gamma(params.eta, params.beta_az);
    return state;
}

int main(void)
{
    static const char *const names[MODELS] = {"exact", "plane_parallel"};
    const tsu_model *const models[MODELS] = {tsu_dual_scattering(), tsu_plane_parallel_hair()};
    struct error first[MODELS] = {{0.0, 0.0, 0}}, all[MODELS] = {{0.0, 0.0, 0}};
    struct sweep sweep = {.random = 9};
    room = malloc(sizeof *room);
    if (!room)
        return 1;
    for (int f = 0; f < (getenv("TSUYA_LONG") ? 12 : 2); f++) {
        const struct dual_state state = state_of(&sweep, f);
        measure(&state, f ? all : first);
    }
    for (int model = 0; model < MODELS; model++) {
        printf("%s\n", names[model]);
        hold("lobes, L1, mean, default fibre", first[model].sum / first[model].count,
             sweep_stated(models[model], "direction"));
        hold("lobes, L1, most, default fibre", first[model].most,
             sweep_stated(models[model], "direction_most"));
        hold("lobes, L1, mean, other fibres", all[model].sum / all[model].count,
             sweep_stated(models[model], "direction_all"));
    }
    free(room);
    return failures != 0;
}

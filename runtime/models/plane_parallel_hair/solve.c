// One absorption: the layers' powers and the distribution of what leaves them.
#include "models/plane_parallel_hair/state.h"

#include "optics/angle.h"
#include "optics/dense.h"
#include "optics/lobe.h"

#include <math.h>
#include <string.h>

enum { AZIMUTHS = SOLVED_AZIMUTHS, DIRECTIONS = SOLVED_DIRECTIONS, KEPT = SOLVED_KEPT };
// The thinnest layer is 2^-11; after 9 doublings it is 0.25.
enum { FIRST_DOUBLINGS = 9 };

double tsu_i_layer_sigma(int i)
{
    // Denser where hair is light: there most of what is seen has met many fibres.
    static const double nodes[SOLVED_SIGMAS] = {0.0,   0.0012, 0.006, 0.018, 0.035,
                                                0.075, 0.22,   0.75,  3.0};
    return nodes[i];
}

double tsu_i_layer_inclination(int i)
{
    return (i - SOLVED_THETAS / 2) * (5.0 * TSU_I_PI / 180.0);
}

double tsu_i_layer_depth(int i)
{
    return i ? ldexp(0.25, i - 1) : 0.0;
}

// The lobe of d'Eon's form nearest in L1 to powers over inclinations that leave, by a search that
// narrows around its best three times.
static void nearest_lobe(const double theta[TSU_I_LAYER_THETAS],
                         const double power[TSU_I_LAYER_THETAS], float *mean, float *variance)
{
    const double step = theta[1] - theta[0];
    double whole = 0.0, best = 1e30, centre = 0.1, spread = log(0.05), reach = 0.5, range = 2.2;
    for (int t = 0; t < TSU_I_LAYER_THETAS; t++)
        whole += power[t];
    *mean = 0.0f;
    *variance = 0.1f;
    if (!(whole > 1e-12))
        return;
    for (int zoom = 0; zoom < 4; zoom++) {
        const double m0 = centre, s0 = spread;
        for (int i = -5; i <= 5; i++)
            for (int j = -4; j <= 4; j++) {
                const double m = m0 + reach * i / 5.0;
                const double v = exp(fmin(s0 + range * j / 4.0, log(0.35)));
                double error = 0.0;
                for (int t = 0; t < TSU_I_LAYER_THETAS; t++)
                    error += fabs(power[t] / whole -
                                  tsu_i_lobe_deon(theta[t], -m, sqrt(v)) * cos(theta[t]) * step);
                if (error < best && fabs(m) <= 0.6) {
                    best = error;
                    centre = m;
                    spread = log(v);
                }
            }
        reach *= 0.3;
        range *= 0.35;
    }
    *mean = (float)centre;
    *variance = (float)exp(spread);
}

// Powers that leave through a layer of `front` fibres of depth above a half space, after a first
// event that the viewer's direction along the normal makes; over inclinations, less what leaves at
// once.
//   side  0: the viewer's side is the thin one, 1: the far side is
static void leave(struct layer_room *room, const struct tsu_i_layer *half_space, int depth,
                  int side, double power[TSU_I_LAYER_THETAS])
{
    const int n = DIRECTIONS, azimuths = AZIMUTHS + 1;
    const int column = TSU_I_LAYER_THETAS / 2 * azimuths + AZIMUTHS;
    double toward[DIRECTIONS], away[DIRECTIONS], *loop = half_space->work[0];
    // Travel towards the thin side after the event, and away from it.
    for (int i = 0; i < n; i++) {
        const size_t at = (size_t)i * (size_t)n + (size_t)column;
        toward[i] = side ? half_space->forward[at] : half_space->backward[at];
        away[i] = side ? half_space->backward[at] : half_space->forward[at];
    }
    double field[DIRECTIONS];
    memcpy(field, toward, sizeof field);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            field[i] += half_space->back[(size_t)i * (size_t)n + (size_t)j] * away[j];
    memset(power, 0, TSU_I_LAYER_THETAS * sizeof *power);
    if (depth) {
        double *turn = half_space->work[1];
        for (size_t i = 0; i < (size_t)n * (size_t)n; i++) {
            turn[i] = room->back[depth - 1][i];
            loop[i] = 0.0;
        }
        tsu_i_dense_add(n, half_space->back, turn, loop);
        for (size_t i = 0; i < (size_t)n * (size_t)n; i++)
            loop[i] = -loop[i];
        for (int i = 0; i < n; i++)
            loop[(size_t)i * (size_t)n + (size_t)i] += 1.0;
        tsu_i_dense_solve(n, loop, 1, field);
    }
    for (int i = 0; i < n; i++) {
        const double mu = cos(half_space->phi[i % azimuths]), t = tsu_i_layer_depth(depth);
        double out = depth ? 0.0 : field[i];
        if (depth)
            for (int j = 0; j < n; j++)
                out += room->through[depth - 1][(size_t)i * (size_t)n + (size_t)j] * field[j];
        power[i / azimuths] += fmax(out - toward[i] * exp(-t / mu), 0.0);
    }
}

void tsu_i_layer_solve(const struct dual_state *state, int sigma, struct layer_room *room,
                       struct layer_solved *solved)
{
    struct tsu_i_layer layer;
    struct layer_powers powers[SOLVED_THETAS];
    struct tsu_i_strand strand = {.eta = state->fiber.eta,
                                  .sigma_a = tsu_i_layer_sigma(sigma),
                                  .beta_az = state->fiber.beta_az,
                                  .kind = TSU_I_STRAND_DEON,
                                  .lobes = TSU_I_LOBES};
    memcpy(strand.alpha, state->fiber.alpha, sizeof strand.alpha);
    memcpy(strand.beta, state->fiber.beta, sizeof strand.beta);

    tsu_i_layer_begin(&layer, &strand, 0.0, AZIMUTHS, room->solver);
    tsu_i_layer_thin(&layer, ldexp(1.0, -11));
    for (int i = 0; i < FIRST_DOUBLINGS; i++)
        tsu_i_layer_double(&layer);
    int fitted = 0;
    for (int kept = 0; fitted < FITTED_TAUS; tsu_i_layer_double(&layer)) {
        if (kept < KEPT) {
            for (int i = 0; i < DIRECTIONS * DIRECTIONS; i++) {
                room->back[kept][i] = (float)layer.back[i];
                room->through[kept][i] = (float)layer.through[i];
            }
            kept++;
        }
        if (layer.tau != tsu_i_layer_taus[fitted])
            continue;
        for (int t = 0; t < SOLVED_THETAS; t++) {
            // Travel of the fixed direction: minus its inclination, on the grid of 5 degrees.
            const int node = TSU_I_LAYER_THETAS / 2 - (t - SOLVED_THETAS / 2);
            tsu_i_layer_powers(&layer, node, powers[t].r + fitted, powers[t].t + fitted);
        }
        if (++fitted == FITTED_TAUS)
            break;
    }
    for (int t = 0; t < SOLVED_THETAS; t++)
        tsu_i_layer_fit(&strand, tsu_i_layer_inclination(t), state->gamma, powers + t,
                        solved->fits + t);
    for (int d = 0; d < SOLVED_DEPTHS; d++)
        for (int side = 0; side < 2; side++) {
            double power[TSU_I_LAYER_THETAS];
            leave(room, &layer, d, side, power);
            nearest_lobe(layer.theta, power, solved->lobes[d].mean + side,
                         solved->lobes[d].variance + side);
        }
}

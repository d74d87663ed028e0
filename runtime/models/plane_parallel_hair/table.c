// The table "layer", colourless.
//
// Lower 48 rows, inclination theta_r (tsu_i_layer_row), columns absorption as in dual_scattering's
// "fields":
//     log2(e) (2/pi) k, r, shares back and on of the first event, as corrected, over the
//     lobes' powers
// 48 rows, cos(theta_r) = j/47: the fibre's own aligned shares forward and backward, for hosts that
// follow light themselves. Then twice 16 rows of absorption, columns fibres in front: a, b, c of
// the lobe of light that comes back and of light that goes on.
//
// A unit solves one absorption and leaves its numbers in its first row; the last touch reads all of
// them and writes the table.
#include "models/plane_parallel_hair/state.h"

#include "optics/angle.h"

#include <math.h>
#include <string.h>

_Static_assert(sizeof(struct layer_solved) <= LAYER_WIDTH * 4 * sizeof(float),
               "a unit's numbers fit its first row");

void tsu_i_layer_bake(const void *state, uint32_t unit, void *scratch, float *texels)
{
    struct layer_solved solved;
    memset(texels, 0, (size_t)LAYER_HEIGHT / SOLVED_SIGMAS * LAYER_WIDTH * 4 * sizeof *texels);
    tsu_i_layer_solve(state, (int)unit, scratch, &solved);
    memcpy(texels, &solved, sizeof solved);
}

double tsu_i_layer_row(int i)
{
    double low = -0.5 * TSU_I_PI, high = -low;
    for (int step = 0; step < 50; step++) {
        const double theta = 0.5 * (low + high);
        const double y = sin(theta) * (0.5 - (double)LAYER_STEEP * cos(theta)) + 0.5;
        *(y * (LAYER_ROWS - 1) > i ? &high : &low) = theta;
    }
    return 0.5 * (low + high);
}

// The steepest inclination solved.
#define STEEPEST (75.0 * TSU_I_PI / 180.0)

// Catmull-Rom through equally spaced values; x in [0, count - 1].
static double smooth(const double *values, int count, double x)
{
    const int i = x < 0.0 ? 0 : x > count - 2 ? count - 2 : (int)x;
    const double f = x - i;
    const double a = values[i > 0 ? i - 1 : 0], b = values[i], c = values[i + 1];
    const double d = values[i + 2 < count ? i + 2 : count - 1];
    return b +
           0.5 * f * (c - a + f * (2.0 * a - 5.0 * b + 4.0 * c - d + f * (3.0 * (b - c) + d - a)));
}

// Between the solved absorptions, straight over the axis of absorption; the last one's beyond.
// White fibres stand alone in the first column: k leaves their floor as a root of absorption, which
// the closed form knows, so that up to the first that absorbs its own correction holds.
static double over_sigma(const double values[SOLVED_SIGMAS], double u)
{
    double low = tsu_i_dual_sigma_place((float)tsu_i_layer_sigma(1));
    if (u < low)
        return values[1] + (values[0] - values[1]) * fmax(1.0 - u * (LAYER_WIDTH - 1), 0.0);
    for (int s = 1; s + 1 < SOLVED_SIGMAS; s++) {
        const double high = tsu_i_dual_sigma_place((float)tsu_i_layer_sigma(s + 1));
        if (u < high)
            return values[s] + (values[s + 1] - values[s]) * (u - low) / (high - low);
        low = high;
    }
    return values[SOLVED_SIGMAS - 1];
}

// Correction `which` at theta_r, up to the steepest inclination solved, and the place u of an
// absorption in [0, 1].
static double correction(const struct layer_solved solved[SOLVED_SIGMAS], int which, double theta,
                         double u)
{
    double values[SOLVED_SIGMAS];
    const double x = (theta + STEEPEST) / (2.0 * STEEPEST) * (SOLVED_THETAS - 1);
    for (int s = 0; s < SOLVED_SIGMAS; s++) {
        double over_theta[SOLVED_THETAS];
        for (int t = 0; t < SOLVED_THETAS; t++)
            over_theta[t] = (&solved[s].fits[t].ln_k)[which];
        values[s] = smooth(over_theta, SOLVED_THETAS, x);
    }
    return over_sigma(values, u);
}

static struct tsu_i_turn turn_of(const struct dual_state *state, double theta, int column)
{
    struct tsu_i_strand strand = {.eta = state->fiber.eta,
                                  .sigma_a = tsu_i_dual_sigma_node(column, LAYER_WIDTH),
                                  .beta_az = state->fiber.beta_az,
                                  .kind = TSU_I_STRAND_DEON,
                                  .lobes = TSU_I_LOBES};
    struct tsu_i_event event;
    memcpy(strand.alpha, state->fiber.alpha, sizeof strand.alpha);
    memcpy(strand.beta, state->fiber.beta, sizeof strand.beta);
    tsu_i_strand_event(&strand, theta, &event);
    return tsu_i_strand_turn(&event);
}

static double lobe_number(const struct layer_solved solved[SOLVED_SIGMAS], int which, double front,
                          double u)
{
    // Depth in fibres to the place on the axis of depths, 0 and doublings of 0.25.
    const double depth = front * (2.0 / TSU_I_PI);
    const double x =
        depth < 0.25 ? depth / 0.25 : fmin(1.0 + log2(depth / 0.25), SOLVED_DEPTHS - 1);
    const int i = x >= SOLVED_DEPTHS - 1 ? SOLVED_DEPTHS - 2 : (int)x;
    double values[SOLVED_SIGMAS];
    for (int s = 0; s < SOLVED_SIGMAS; s++) {
        const double low = (&solved[s].lobes[i].mean[0])[which];
        values[s] = low + (x - i) * ((&solved[s].lobes[i + 1].mean[0])[which] - low);
    }
    return over_sigma(values, u);
}

// What the shader makes of the lobes' unit power, both sides' mean behind a few fibres.
static double lobe_powers(const struct layer_solved *solved, double theta, double u)
{
    const double front = 8.0;
    double sum = 0.0;
    for (int side = 0; side < 2; side++) {
        float lobe[4];
        const struct tsu_i_dual_moments moments = {lobe_number(solved, side, front, u),
                                                   lobe_number(solved, 2 + side, front, u)};
        tsu_i_dual_lobe(&moments, lobe);
        sum += 0.5 * tsu_i_dual_lobe_power(lobe, theta);
    }
    return sum;
}

// Beyond the steepest inclination solved the first event is the closed form's, which is right along
// the fibres, where all is reflected, and its corrections fade. Later events happen less steeply: k
// and r move on by 0.4 of the inclination alone, which fits walks of light seen at 78 to 88
// degrees.
static void field(const struct dual_state *state, const struct layer_solved *solved, double theta,
                  int column, float out[4])
{
    const double inner = fmin(fmax(theta, -STEEPEST), STEEPEST);
    const double steep = theta == inner ? 1.0 : cos(theta) / cos(STEEPEST);
    const struct tsu_i_turn turn = turn_of(state, theta, column);
    const struct tsu_i_turn later = turn_of(state, inner + 0.4 * (theta - inner), column);
    const struct tsu_i_stream first = tsu_i_two_stream(&turn, state->fiber.eta, state->gamma);
    const struct tsu_i_stream stream = tsu_i_two_stream(&later, state->fiber.eta, state->gamma);
    const double u = (double)column / (LAYER_WIDTH - 1);
    const double logit = log(stream.r / (1.0 - stream.r)) + correction(solved, 1, inner, u);
    out[0] =
        (float)(TSU_I_LOG2E * 2.0 / TSU_I_PI * stream.k * exp(correction(solved, 0, inner, u)));
    out[1] = (float)(1.0 / (1.0 + exp(-logit)));
    const double powers = lobe_powers(solved, theta, u);
    out[2] = (float)((first.backward + steep * correction(solved, 2, inner, u)) / powers);
    out[3] = (float)((first.forward + steep * correction(solved, 3, inner, u)) / powers);
}

void tsu_i_layer_finish(const void *opaque, float *texels)
{
    const struct dual_state *state = opaque;
    struct layer_solved solved[SOLVED_SIGMAS];
    for (int s = 0; s < SOLVED_SIGMAS; s++)
        memcpy(solved + s, texels + s * LAYER_WIDTH * 4, sizeof *solved);
    for (int j = 0; j < LAYER_ROWS; j++) {
        const double theta = tsu_i_layer_row(j);
        const double fallen = acos(fmax((double)j / (LAYER_ROWS - 1), 1e-3));
        for (int i = 0; i < LAYER_WIDTH; i++) {
            const struct tsu_i_turn turn = turn_of(state, fallen, i);
            float *shares = texels + 4 * ((LAYER_ROWS + j) * LAYER_WIDTH + i);
            shares[0] = (float)turn.forward;
            shares[1] = (float)turn.backward;
            shares[2] = shares[3] = 0.0f;
            field(state, solved, theta, i, texels + 4 * (j * LAYER_WIDTH + i));
        }
    }
    for (int side = 0; side < 2; side++)
        for (int j = 0; j < LAYER_LOBE_ROWS; j++)
            for (int i = 0; i < LAYER_WIDTH; i++) {
                const double front = tsu_i_dual_front_node(i, LAYER_WIDTH);
                const double u = (double)j / (LAYER_LOBE_ROWS - 1);
                const struct tsu_i_dual_moments moments = {lobe_number(solved, side, front, u),
                                                           lobe_number(solved, 2 + side, front, u)};
                const int row = 2 * LAYER_ROWS + side * LAYER_LOBE_ROWS + j;
                tsu_i_dual_lobe(&moments, texels + 4 * (row * LAYER_WIDTH + i));
            }
}

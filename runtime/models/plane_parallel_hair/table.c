// The table "layer", colourless.
//
// Lower 48 rows, inclination theta_r (tsu_i_layer_row), columns absorption (tsu_i_layer_column):
//     log2(e) (2/pi) k, r, shares back and on of the first event, as corrected, over the
//     lobes' powers
// 32 rows, cos(theta_r) = j/31: the fibre's own aligned shares forward and backward, for hosts that
// follow light themselves. Then twice 24 rows over absorption (tsu_i_layer_lobe): a, b, c over
// fibres of the lobe of light that comes back and of light that goes on.
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

float tsu_i_layer_place(float sigma_a)
{
    const float u = log2f(sigma_a / LAYER_LEAST + 1.0f) / LAYER_OCTAVES;
    return u < 0.0f ? 0.0f : u > 1.0f ? 1.0f : u;
}

double tsu_i_layer_column(int i)
{
    return (double)LAYER_LEAST * (exp2((double)LAYER_OCTAVES * i / (LAYER_WIDTH - 1)) - 1.0);
}

float tsu_i_layer_lobe(const float sigma_a[3])
{
    float place = 0.0f;
    for (int k = 0; k < 3; k++)
        place += tsu_i_layer_place(sigma_a[k]) / 3.0f;
    return powf(place, LAYER_LOBE_POWER) * DUAL_SPAN(LAYER_LOBE_ROWS);
}

// Depths that lobe_powers() looks at: 1, 2, 4, 8, 16 fibres in front.
enum { LOBE_DEPTHS = 5 };

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

static double field_axis(double sigma_a)
{
    return (double)tsu_i_layer_place((float)sigma_a);
}

static double lobe_axis(double sigma_a)
{
    const float same = (float)sigma_a;
    return (double)tsu_i_layer_lobe((const float[]){same, same, same});
}

// Absorption of row j of the lobes.
static double lobe_row(int j)
{
    const double place = pow((double)j / (LAYER_LOBE_ROWS - 1), 1.0 / (double)LAYER_LOBE_POWER);
    return (double)LAYER_LEAST * (exp2((double)LAYER_OCTAVES * place) - 1.0);
}

// Between the solved absorptions, straight over the axis; the last one's beyond.
static double over_sigma(const double values[SOLVED_SIGMAS], double (*axis)(double), double sigma_a)
{
    double low = axis(0.0);
    for (int s = 0; s + 1 < SOLVED_SIGMAS; s++) {
        const double next = tsu_i_layer_sigma(s + 1), high = axis(next);
        if (sigma_a < next)
            return values[s] + (values[s + 1] - values[s]) * (axis(sigma_a) - low) / (high - low);
        low = high;
    }
    return values[SOLVED_SIGMAS - 1];
}

// Correction `which` at one solved absorption and theta_r, up to the steepest inclination solved.
static double correction(const struct layer_solved *solved, int which, double theta)
{
    double values[SOLVED_THETAS];
    for (int t = 0; t < SOLVED_THETAS; t++)
        values[t] = (&solved->fits[t].ln_k)[which];
    return smooth(values, SOLVED_THETAS,
                  (theta + STEEPEST) / (2.0 * STEEPEST) * (SOLVED_THETAS - 1));
}

static struct tsu_i_turn turn_of(const struct dual_state *state, double theta, double sigma_a)
{
    struct tsu_i_strand strand = {.eta = state->fiber.eta,
                                  .sigma_a = sigma_a,
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
                          double sigma_a)
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
    return over_sigma(values, lobe_axis, sigma_a);
}

// What the shader makes of the lobes' unit power: the mean over both sides and some depths.
static double lobe_powers(const float *texels, double theta, double sigma_a)
{
    const double row = lobe_axis(sigma_a);
    const int j = (int)row;
    double sum = 0.0;
    for (int side = 0; side < 2; side++)
        for (int depth = 0; depth < LOBE_DEPTHS; depth++) {
            const double x = exp(-(double)FRONT_RATE * (1 << depth)) * (LAYER_WIDTH - 1);
            const float *near =
                texels + 4 * ((LAYER_LOBES + side * LAYER_LOBE_ROWS + j) * LAYER_WIDTH + (int)x);
            float lobe[4];
            for (int c = 0; c < 4; c++)
                lobe[c] = (float)(near[c] + (row - j) * (near[4 * LAYER_WIDTH + c] - near[c]));
            sum += tsu_i_dual_lobe_power(lobe, theta) / (2 * LOBE_DEPTHS);
        }
    return sum;
}

// The four numbers of the closed form, corrected.
struct numbers {
    double k, r, back, on;
};

// With these corrections. Beyond the steepest inclination solved the first event is the closed
// form's, which is right along the fibres, where all is reflected, and its corrections fade. Later
// events happen less steeply: k and r move on by 0.4 of the inclination alone, which fits walks of
// light seen at 78 to 88 degrees.
static struct numbers corrected(const struct dual_state *state, const double corrections[4],
                                double theta, double sigma_a)
{
    const double inner = fmin(fmax(theta, -STEEPEST), STEEPEST);
    const double steep = theta == inner ? 1.0 : cos(theta) / cos(STEEPEST);
    const struct tsu_i_turn turn = turn_of(state, theta, sigma_a);
    const struct tsu_i_turn later = turn_of(state, inner + 0.4 * (theta - inner), sigma_a);
    const struct tsu_i_stream first = tsu_i_two_stream(&turn, state->fiber.eta, state->gamma);
    const struct tsu_i_stream stream = tsu_i_two_stream(&later, state->fiber.eta, state->gamma);
    const double logit = log(stream.r / (1.0 - stream.r)) + corrections[1];
    return (struct numbers){.k = stream.k * exp(corrections[0]),
                            .r = 1.0 / (1.0 + exp(-logit)),
                            .back = first.backward + steep * corrections[2],
                            .on = first.forward + steep * corrections[3]};
}

// Up to the first absorption solved that is none, k rises as a root from its floor, and what is
// straight is k^2 and the share that turns back, 2 k r / (1 - r^2).
static struct numbers nearly_white(const struct dual_state *state,
                                   const struct layer_solved solved[2], double theta, double inner,
                                   double sigma_a)
{
    struct numbers ends[2];
    double turned[2];
    for (int s = 0; s < 2; s++) {
        double corrections[4];
        for (int i = 0; i < 4; i++)
            corrections[i] = correction(solved + s, i, inner);
        ends[s] = corrected(state, corrections, theta, tsu_i_layer_sigma(s));
        turned[s] = 2.0 * ends[s].k * ends[s].r / (1.0 - ends[s].r * ends[s].r);
    }
    const struct numbers a = ends[0], b = ends[1];
    const double f = sigma_a / tsu_i_layer_sigma(1);
    const double k = sqrt(a.k * a.k + f * (b.k * b.k - a.k * a.k));
    const double back = turned[0] + f * (turned[1] - turned[0]);
    return (struct numbers){.k = k,
                            .r = back / (sqrt(k * k + back * back) + k),
                            .back = a.back + f * (b.back - a.back),
                            .on = a.on + f * (b.on - a.on)};
}

static void field(const struct dual_state *state, const struct layer_solved *solved,
                  const float *texels, double theta, int column, float out[4])
{
    const double inner = fmin(fmax(theta, -STEEPEST), STEEPEST);
    const double sigma_a = tsu_i_layer_column(column);
    struct numbers n;
    if (sigma_a < tsu_i_layer_sigma(1)) {
        n = nearly_white(state, solved, theta, inner, sigma_a);
    } else {
        double corrections[4];
        for (int i = 0; i < 4; i++) {
            double values[SOLVED_SIGMAS];
            for (int s = 0; s < SOLVED_SIGMAS; s++)
                values[s] = correction(solved + s, i, inner);
            corrections[i] = over_sigma(values, field_axis, sigma_a);
        }
        n = corrected(state, corrections, theta, sigma_a);
    }
    const double powers = lobe_powers(texels, theta, sigma_a);
    out[0] = (float)(TSU_I_LOG2E * 2.0 / TSU_I_PI * n.k);
    out[1] = (float)n.r;
    out[2] = (float)(n.back / powers);
    out[3] = (float)(n.on / powers);
}

void tsu_i_layer_finish(const void *opaque, float *texels)
{
    const struct dual_state *state = opaque;
    struct layer_solved solved[SOLVED_SIGMAS];
    for (int s = 0; s < SOLVED_SIGMAS; s++)
        memcpy(solved + s, texels + s * LAYER_WIDTH * 4, sizeof *solved);
    for (int side = 0; side < 2; side++)
        for (int j = 0; j < LAYER_LOBE_ROWS; j++)
            for (int i = 0; i < LAYER_WIDTH; i++) {
                const double front = tsu_i_dual_front_node(i, LAYER_WIDTH);
                const double sigma_a = lobe_row(j);
                const struct tsu_i_dual_moments moments = {
                    lobe_number(solved, side, front, sigma_a),
                    lobe_number(solved, 2 + side, front, sigma_a)};
                const int row = LAYER_LOBES + side * LAYER_LOBE_ROWS + j;
                float *lobe = texels + 4 * (row * LAYER_WIDTH + i);
                tsu_i_dual_lobe(&moments, lobe);
                // Its power in the shader, whose I0e is a fit, at a common inclination.
                lobe[2] -= (float)log2(tsu_i_dual_lobe_power(lobe, 0.35));
            }
    for (int j = 0; j < LAYER_SHARE_ROWS; j++) {
        const double fallen = acos(fmax((double)j / (LAYER_SHARE_ROWS - 1), 1e-3));
        for (int i = 0; i < LAYER_WIDTH; i++) {
            const struct tsu_i_turn turn = turn_of(state, fallen, tsu_i_layer_column(i));
            float *shares = texels + 4 * ((LAYER_ROWS + j) * LAYER_WIDTH + i);
            shares[0] = (float)turn.forward;
            shares[1] = (float)turn.backward;
            shares[2] = shares[3] = 0.0f;
        }
    }
    for (int j = 0; j < LAYER_ROWS; j++)
        for (int i = 0; i < LAYER_WIDTH; i++)
            field(state, solved, texels, tsu_i_layer_row(j), i, texels + 4 * (j * LAYER_WIDTH + i));
}

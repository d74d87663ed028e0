// Two layers of a leaf between its walls, by adding and doubling, at nine cosines.
//
// Sources: van de Hulst 1980, "Multiple Light Scattering", chapter 4; Wiscombe 1976, "On
// initialization, error and flux conservation in the doubling method", for the start.
#include "models/leaf_body/state.h"

#include "optics/angle.h"

#include <math.h>
#include <string.h>

enum { N = LEAF_NODES, NN = N * N };

// Gauss-Legendre rules on [0, 1].
static const double inner_node[LEAF_INNER] = {0.069431844202973714, 0.33000947820757187,
                                              0.66999052179242813, 0.93056815579702623};
static const double inner_weight[LEAF_INNER] = {0.17392742256872684, 0.3260725774312731,
                                                0.3260725774312731, 0.17392742256872684};
static const double outer_node[LEAF_OUTER] = {0.046910077030668018, 0.23076534494715845, 0.5,
                                              0.7692346550528415, 0.95308992296933193};
static const double outer_weight[LEAF_OUTER] = {0.11846344252809471, 0.2393143352496831,
                                                0.2844444444444445, 0.2393143352496831,
                                                0.11846344252809471};

// Normalised associated Legendre functions sqrt((l-m)!/(l+m)!) P_l^m without the phase (-1)^m.
static void legendre(int m, double x, double out[LEAF_MOMENTS])
{
    for (int l = 0; l < m; l++)
        out[l] = 0.0;
    const double sine2 = 1.0 - x * x;
    out[m] = m == 0 ? 1.0 : m == 1 ? sqrt(0.5 * sine2) : sqrt(0.375) * sine2;
    for (int l = m + 1; l < LEAF_MOMENTS; l++)
        out[l] = ((2 * l - 1) * x * out[l - 1] -
                  (l > m + 1 ? sqrt((l - 1.0) * (l - 1.0) - m * m) * out[l - 2] : 0.0)) /
                 sqrt((double)(l * l - m * m));
}

static double wall_reflectance(double n, double inside)
{
    const double sine2 = n * n * (1.0 - inside * inside);
    if (sine2 >= 1.0)
        return 1.0 - 1e-9; // light that nothing scatters goes to and fro, but not for ever
    const double outside = sqrt(1.0 - sine2);
    const double s = (n * inside - outside) / (n * inside + outside);
    const double p = (inside - n * outside) / (inside + n * outside);
    return 0.5 * (s * s + p * p);
}

void tsu_i_leaf_frame(double n, struct leaf_frame *frame)
{
    frame->n = n;
    const double critical = sqrt(1.0 - 1.0 / (n * n));
    for (int i = 0; i < LEAF_INNER; i++) {
        frame->cosine[i] = critical * inner_node[i];
        frame->weight[i] = critical * inner_weight[i];
    }
    for (int i = 0; i < LEAF_OUTER; i++) {
        const double outer = outer_node[i];
        const double inside = sqrt(1.0 - (1.0 - outer * outer) / (n * n));
        frame->outer[i] = outer;
        frame->outer_weight[i] = outer_weight[i];
        frame->cosine[LEAF_INNER + i] = inside;
        frame->weight[LEAF_INNER + i] = outer_weight[i] * outer / (n * n * inside);
    }
    double table[N][LEAF_MOMENTS];
    for (int m = 0; m < LEAF_MODES; m++) {
        for (int i = 0; i < N; i++) {
            frame->reflectance[i] = wall_reflectance(n, frame->cosine[i]);
            legendre(m, frame->cosine[i], table[i]);
        }
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                double even = 0.0, odd = 0.0, moment = 1.0;
                for (int l = 0; l < LEAF_MOMENTS; l++, moment *= LEAF_G) {
                    const double term = (2 * l + 1) * moment * table[i][l] * table[j][l];
                    if ((l + m) % 2)
                        odd += term;
                    else
                        even += term;
                }
                frame->onward[m][N * i + j] = even + odd;
                frame->back[m][N * i + j] = even - odd;
            }
    }
}

static void product(const double *a, const double *b, double *c)
{
    for (int i = 0; i < N; i++) {
        double row[N] = {0.0};
        for (int k = 0; k < N; k++)
            for (int j = 0; j < N; j++)
                row[j] += a[N * i + k] * b[N * k + j];
        memcpy(c + N * i, row, sizeof row);
    }
}

// x = a^-1 x; destroys a, whose diagonal dominates.
static inline void solve(int n, double *a, int columns, double *x)
{
    for (int k = 0; k < n; k++) {
        const double inverse = 1.0 / a[n * k + k];
        for (int i = k + 1; i < n; i++) {
            const double factor = a[n * i + k] * inverse;
            for (int j = k + 1; j < n; j++)
                a[n * i + j] -= factor * a[n * k + j];
            for (int j = 0; j < columns; j++)
                x[columns * i + j] -= factor * x[columns * k + j];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        const double inverse = 1.0 / a[n * k + k];
        for (int j = 0; j < columns; j++)
            x[columns * k + j] *= inverse;
        for (int i = 0; i < k; i++)
            for (int j = 0; j < columns; j++)
                x[columns * i + j] -= a[n * i + k] * x[columns * k + j];
    }
}

static void one_minus(const double *a, double *out)
{
    for (int i = 0; i < NN; i++)
        out[i] = (i % (N + 1) == 0) - a[i];
}

void tsu_i_leaf_double(struct leaf_operator *layer)
{
    double a[NN], x[NN], y[NN];
    product(layer->r, layer->r, x);
    one_minus(x, a);
    memcpy(x, layer->t, sizeof x);
    solve(N, a, N, x);       // downward light in the middle
    product(layer->r, x, a); // upward
    product(layer->t, a, y);
    for (int i = 0; i < NN; i++)
        layer->r[i] += y[i];
    product(layer->t, x, y);
    memcpy(layer->t, y, sizeof y);
}

// Depth at which the start is accurate to 1e-6.
static const double thin = 0.05;

void tsu_i_leaf_layer(const struct leaf_frame *frame, const struct leaf_layer *layer, int mode,
                      struct leaf_operator *out)
{
    const double scatter = layer->scatter / (1.0 - LEAF_G), depth = scatter + layer->absorption;
    const double albedo = depth > 0.0 ? scatter / depth : 0.0;
    int doublings = 0;
    double d = depth;
    for (; d > thin; doublings++)
        d *= 0.5;
    // One step of a trapezoidal rule: 1 + A and B of half the step.
    double a[NN], b[NN], x[NN], y[NN];
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            const double half = 0.5 * d / frame->cosine[i];
            const double share = 0.5 * albedo * frame->weight[j];
            const int k = N * i + j;
            a[k] = (i == j) * (1.0 + half) - half * share * frame->onward[mode][k];
            b[k] = half * share * frame->back[mode][k];
        }
    memcpy(x, b, sizeof x);
    memcpy(y, a, sizeof y);
    solve(N, y, N, x); // (1 + A)^-1 B
    product(b, x, y);
    for (int i = 0; i < NN; i++) {
        y[i] = a[i] - y[i];
        out->t[i] = 2.0 * (i % (N + 1) == 0);
    }
    solve(N, y, N, out->t); // 2 G
    // R = 2 G B (1 + A)^-1, which is 2 (1 + A)^-1 B G.
    product(x, out->t, out->r);
    for (int i = 0; i < N; i++)
        out->t[N * i + i] -= 1.0;
    while (doublings--)
        tsu_i_leaf_double(out);
}

// T from the other side: reciprocity.
static void reversed(const struct leaf_frame *frame, const double *t, double *out)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            out[N * i + j] = t[N * j + i] * (frame->cosine[j] * frame->weight[j]) /
                             (frame->cosine[i] * frame->weight[i]);
}

// The upper over the lower layer: R from above and below, T downward.
static void add(const struct leaf_operator *upper, const struct leaf_operator *lower, double *above,
                double *below, double *down)
{
    double a[NN], x[NN], y[NN], u[NN];
    product(upper->r, lower->r, x);
    one_minus(x, a);
    memcpy(x, upper->t, sizeof x);
    memcpy(u, a, sizeof u);
    solve(N, u, N, x);
    product(lower->t, x, down);
    product(lower->r, x, y);
    product(upper->t, y, above);
    product(upper->r, lower->t, y);
    solve(N, a, N, y);
    product(lower->t, y, below);
    for (int i = 0; i < NN; i++) {
        above[i] += upper->r[i];
        below[i] += lower->r[i];
    }
}

void tsu_i_leaf_walls(const struct leaf_frame *frame, const struct leaf_layer layers[2],
                      const struct leaf_operator operators[2], int mode, struct leaf_modes *out)
{
    enum { M = 2 * N, SOURCES = 2 * LEAF_OUTER };
    double above[NN], below[NN], down[NN], up[NN];
    add(operators, operators + 1, above, below, down);
    reversed(frame, down, up);
    // Light that leaves the walls inwards, from unit sources there: top first, then bottom.
    double a[M * M], x[M * SOURCES] = {0.0};
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            const double r = frame->reflectance[i];
            a[M * i + j] = (i == j) - r * above[N * i + j];
            a[M * i + N + j] = -r * up[N * i + j];
            a[M * (N + i) + j] = -r * down[N * i + j];
            a[M * (N + i) + N + j] = (i == j) - r * below[N * i + j];
        }
    for (int s = 0; s < LEAF_OUTER; s++) {
        x[SOURCES * (LEAF_INNER + s) + s] = 1.0;
        x[SOURCES * (N + LEAF_INNER + s) + LEAF_OUTER + s] = 1.0;
    }
    solve(M, a, SOURCES, x);
    const double depth = (layers[0].scatter + layers[1].scatter) / (1.0 - LEAF_G) +
                         layers[0].absorption + layers[1].absorption;
    for (int i = 0; i < LEAF_OUTER; i++)
        for (int j = 0; j < LEAF_OUTER; j++) {
            double top = 0.0, bottom = 0.0, through = 0.0;
            const int row = N * (LEAF_INNER + i);
            for (int k = 0; k < N; k++) {
                const double *from_top = x + SOURCES * k + j;
                const double *to_bottom = x + SOURCES * (N + k) + j;
                top += above[row + k] * from_top[0] + up[row + k] * to_bottom[0];
                through += down[row + k] * from_top[0] + below[row + k] * to_bottom[0];
                bottom +=
                    down[row + k] * from_top[LEAF_OUTER] + below[row + k] * to_bottom[LEAF_OUTER];
            }
            if (i == j) {
                // What never scattered and never left.
                const double e = exp(-depth / frame->cosine[LEAF_INNER + i]);
                const double r = frame->reflectance[LEAF_INNER + i];
                const double series = e / (1.0 - r * r * e * e);
                top -= r * e * series;
                bottom -= r * e * series;
                through -= series;
                out->through[i] = series;
                out->back[i] = r * e * series;
            }
            const double per =
                (mode ? 1.0 : 0.5) / (TSU_I_PI * frame->outer[j] * frame->outer_weight[j]);
            const int k = LEAF_OUTER * i + j;
            out->f[LEAF_TOP][mode][k] = top * per;
            out->f[LEAF_BELOW][mode][k] = bottom * per;
            out->f[LEAF_THROUGH][mode][k] = through * per;
        }
}

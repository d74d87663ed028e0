// The surface of a leaf: what it lets through, and the coat that takes the rest.
//
// Source of the coat: Walter et al. 2007, "Microfacet Models for Refraction through Rough
// Surfaces", eqs. 20 and 33; Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 99.
#include "models/leaf_body/state.h"

#include "optics/angle.h"
#include "optics/quadrature.h"

#include <math.h>

// Fresnel's reflectance at a cosine outside, both polarisations.
double tsu_i_leaf_wall_reflectance(double n, double outside)
{
    const double inside = sqrt(1.0 - (1.0 - outside * outside) / (n * n));
    const double s = (outside - n * inside) / (outside + n * inside);
    const double p = (inside - n * outside) / (inside + n * outside);
    return 0.5 * (s * s + p * p);
}

double tsu_i_leaf_coat(double n, double alpha, double n_l, double n_v, double n_h, double l_h)
{
    const double a2 = alpha * alpha, root = n_h * n_h * (a2 - 1.0) + 1.0;
    const double distribution = a2 / (TSU_I_PI * root * root);
    const double masking =
        0.5 / (n_l * sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * sqrt(n_l * n_l * (1.0 - a2) + a2));
    return distribution * masking * tsu_i_leaf_wall_reflectance(n, l_h);
}

double tsu_i_leaf_coat_albedo(double n, double alpha, double cosine)
{
    // Half vectors spread as D asks: equal shares of D n.h dw.
    enum { TILTS = 24, TURNS = 16 };
    const double a2 = alpha * alpha, sine = sqrt(fmax(1.0 - cosine * cosine, 0.0));
    double sum = 0.0;
    for (int i = 0; i < TILTS; i++) {
        const double x = (i + 0.5) / TILTS, share = x * x; // dense about the mirror
        const double n_h = sqrt((1.0 - share) / (1.0 + (a2 - 1.0) * share));
        const double tilt = sqrt(1.0 - n_h * n_h);
        for (int k = 0; k < TURNS; k++) {
            const double l_h = cosine * n_h + sine * tilt * cos(TSU_I_PI * (k + 0.5) / TURNS);
            const double n_l = 2.0 * l_h * n_h - cosine;
            if (l_h <= 0.0 || n_l <= 0.0)
                continue;
            const double masking = 0.5 / (n_l * sqrt(cosine * cosine * (1.0 - a2) + a2) +
                                          cosine * sqrt(n_l * n_l * (1.0 - a2) + a2));
            sum += 2.0 * x * tsu_i_leaf_wall_reflectance(n, l_h) * masking * n_l * 4.0 * l_h / n_h;
        }
    }
    return sum / (TILTS * TURNS);
}

double tsu_i_leaf_walls_pass(const float w[5], double c)
{
    return ((double)w[4] + c * ((double)w[0] + (double)w[1] * c)) /
           (1.0 + c * ((double)w[2] + (double)w[3] * c));
}

static double passed(const struct leaf_state *state, double cosine)
{
    const double n = (double)state->n, alpha = (double)state->roughness;
    return 1.0 - (alpha > 0.0 ? tsu_i_leaf_coat_albedo(n, alpha, cosine)
                              : tsu_i_leaf_wall_reflectance(n, cosine));
}

// The form through five cosines; at 0 nothing passes a smooth wall.
static void fit_walls(const struct leaf_state *state, float walls[5])
{
    static const double rough[5] = {0.01, 0.1, 0.3, 0.6, 1.0};
    static const double smooth[5] = {0.0, 0.06, 0.22, 0.55, 0.95};
    const double *const at = state->roughness > 0.0f ? rough : smooth;
    double m[5][6];
    for (int i = 0; i < 5; i++) {
        const double c = at[i], y = passed(state, c);
        m[i][0] = c;
        m[i][1] = c * c;
        m[i][2] = -y * c;
        m[i][3] = -y * c * c;
        m[i][4] = 1.0;
        m[i][5] = y;
    }
    for (int k = 0; k < 5; k++) {
        int pivot = k;
        for (int i = k + 1; i < 5; i++)
            pivot = fabs(m[i][k]) > fabs(m[pivot][k]) ? i : pivot;
        for (int j = 0; j < 6; j++) {
            const double swap = m[k][j];
            m[k][j] = m[pivot][j];
            m[pivot][j] = swap;
        }
        for (int i = 0; i < 5; i++) {
            const double factor = i == k ? 0.0 : m[i][k] / m[k][k];
            for (int j = k; j < 6; j++)
                m[i][j] -= factor * m[k][j];
        }
    }
    for (int k = 0; k < 5; k++)
        walls[k] = (float)(m[k][5] / m[k][k]);
}

enum { COSINES = 24, TURNS = 8 };

static double node(int i)
{
    const double x = (i + 0.5) / COSINES; // dense at grazing, where walls bend
    return x * x;
}

static double node_weight(int i)
{
    return 2.0 * (i + 0.5) / COSINES / COSINES;
}

// Share of uniform light that passes.
static double passed_mean(const float walls[5])
{
    double sum = 0.0;
    for (int i = 0; i < COSINES; i++)
        sum += 2.0 * node(i) * node_weight(i) * tsu_i_leaf_walls_pass(walls, node(i));
    return sum;
}

static void moments_at(const struct leaf_state *state, double x, int through, double u[4],
                       double *p, double *pu)
{
    const double n = (double)state->n, view = 1.0 - x;
    u[0] = u[1] = u[2] = u[3] = *p = *pu = 0.0;
    for (int i = 0; i < COSINES; i++) {
        const double c = node(i), inside = sqrt(1.0 - (1.0 - c * c) / (n * n));
        const double weight =
            2.0 * TSU_I_PI * c * node_weight(i) * tsu_i_leaf_walls_pass(state->walls, c);
        const double U = 1.0 - inside;
        double phase = 0.0;
        for (int k = 0; k < TURNS; k++) {
            const double z = sqrt((1.0 - inside * inside) * (1.0 - view * view)) *
                             cos(TSU_I_PI * (k + 0.5) / TURNS);
            const double base =
                1.0 + LEAF_G * LEAF_G - 2.0 * LEAF_G * (z + (through ? 1.0 : -1.0) * inside * view);
            phase += 1.0 / (base * sqrt(base) * TURNS);
        }
        u[0] += weight;
        u[1] += weight * U;
        u[2] += weight * U * U;
        u[3] += weight * (c - 1.0);
        *p += weight * phase;
        *pu += weight * phase * U;
    }
}

// a + b x + c x^2 through values at 0, most/2 and most.
static void quadratic(const double y[3], double most, float out[3])
{
    out[0] = (float)y[0];
    out[1] = (float)((-3.0 * y[0] + 4.0 * y[1] - y[2]) / most);
    out[2] = (float)((2.0 * y[0] - 4.0 * y[1] + 2.0 * y[2]) / (most * most));
}

void tsu_i_leaf_coated(struct leaf_state *state)
{
    struct leaf_state smooth = *state;
    smooth.roughness = 0.0f;
    fit_walls(&smooth, smooth.walls);
    fit_walls(state, state->walls);
    // Walls pass light twice, but their share of energy counts once.
    const double entered = sqrt(passed_mean(state->walls) / passed_mean(smooth.walls));
    state->entered = (float)entered;
    for (int k = 0; k < 5; k++)
        if (k != 2 && k != 3)
            state->walls[k] = (float)((double)state->walls[k] / entered);
    const double n = (double)state->n, most = 1.0 - sqrt(1.0 - 1.0 / (n * n));
    for (int through = 0; through < 2; through++) {
        double p[3], pu[3], u[4];
        for (int k = 0; k < 3; k++)
            moments_at(state, 0.5 * k * most, through, u, p + k, pu + k);
        for (int k = 0; k < 3; k++)
            state->moments.u[k] = (float)u[k];
        state->moments.grazing = (float)u[3];
        quadratic(p, most, state->moments.p[through]);
        quadratic(pu, most, state->moments.pu[through]);
    }
}

// Mean of a smooth wall's reflectance over uniform light, and the same of what the coat leaves.
static double reflected_mean(double n, double alpha)
{
    double sum = 0.0;
    for (int i = 0; i < 64; i++) {
        double weight;
        const double mu = tsu_i_quadrature_node(0.0, 1.0, 4, i, &weight);
        sum += 2.0 * mu * weight *
               (alpha > 0.0 ? tsu_i_leaf_coat_albedo(n, alpha, mu)
                            : tsu_i_leaf_wall_reflectance(n, mu));
    }
    return sum;
}

double tsu_i_leaf_wall_mean(double n)
{
    return reflected_mean(n, 0.0);
}

double tsu_i_leaf_coat_factor(double n, double alpha, double cosine)
{
    const double entered = sqrt((1.0 - reflected_mean(n, alpha)) / (1.0 - tsu_i_leaf_wall_mean(n)));
    return (1.0 - tsu_i_leaf_coat_albedo(n, alpha, cosine)) /
           (1.0 - tsu_i_leaf_wall_reflectance(n, cosine)) / entered;
}

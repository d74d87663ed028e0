// Slabs against another method altogether: discrete ordinates solved through the eigenvalues of the
// transfer matrix (LAPACK), on nodes of another kind. No doubling, no adding, no cut moments, no
// restored single scattering.
//
// With s = I_up + I_down and d = I_up - I_down, M s' = (1 - (D+ - D-) W) d and
// M d' = (1 - (D+ + D-) W) s; a symmetric product of both has the eigenvalues k^2 (the
// plane-parallel form in M. Shinya's survey, "Rendering techniques for realistic material property
// representation", its equation 11, in the symmetric form of Nakajima and Tanaka 1986).
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "slab_support.h"

#include "optics/angle.h"
#include "optics/phase.h"
#include "optics/quadrature.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { HALF = 24, MOST = 2 * HALF, MOMENTS = 48 };

static const int UP = 1, DOWN = 0;

struct eigen {
    int count;
    double n, albedo, depth, chi[MOMENTS];
    double mu[MOST], weight[MOST], outside[MOST], mirror[MOST];
    // Of one mode: rates, and the streams of a solution that falls from the top.
    double k[MOST], rising[MOST][MOST], falling[MOST][MOST];
    // Of one source: how much of each, from the top and from the bottom.
    double from_top[MOST], from_bottom[MOST];
};

// Gauss nodes in the outer cosine, and on the cosines beyond total reflection.
static void place(struct eigen *e)
{
    double x[HALF], w[HALF];
    tsu_i_quadrature_gauss(HALF, x, w);
    const double critical = sqrt(1.0 - 1.0 / (e->n * e->n));
    e->count = e->n > 1.0 ? 2 * HALF : HALF;
    for (int i = 0; i < HALF; i++) {
        const double outside = 0.5 * (1.0 + x[i]);
        const double mu = sqrt(1.0 - (1.0 - outside * outside) / (e->n * e->n));
        const double s = (outside - e->n * mu) / (outside + e->n * mu);
        const double p = (e->n * outside - mu) / (e->n * outside + mu);
        e->mu[i] = mu;
        e->weight[i] = 0.5 * w[i] * outside / (e->n * e->n * mu);
        e->outside[i] = outside;
        e->mirror[i] = 0.5 * (s * s + p * p);
        if (e->count > HALF) {
            e->mu[HALF + i] = 0.5 * critical * (1.0 + x[i]);
            e->weight[HALF + i] = 0.5 * critical * w[i];
            e->outside[HALF + i] = 0.0;
            e->mirror[HALF + i] = 1.0;
        }
    }
}

// Half of albedo times the mode of the phase function, to the same (sign 1) or other half space.
static double scatter(const struct eigen *e, int mode, const double *a, const double *b, int sign)
{
    double sum = 0.0;
    for (int l = mode; l < MOMENTS; l++)
        sum += (sign < 0 && (l + mode) % 2 ? -1.0 : 1.0) * (2.0 * l + 1.0) * e->chi[l] *
               a[l - mode] * b[l - mode];
    return 0.5 * e->albedo * sum;
}

static void decompose(struct eigen *e, int mode)
{
    static double functions[MOST][MOMENTS], minus[MOST * MOST], plus[MOST * MOST];
    static double product[MOST * MOST], both[MOST][MOST];
    const int n = e->count;
    for (int i = 0; i < n; i++)
        tsu_i_phase_mode((uint32_t)mode, MOMENTS, e->mu[i], functions[i]);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const double same = scatter(e, mode, functions[i], functions[j], 1);
            const double other = scatter(e, mode, functions[i], functions[j], -1);
            const double root = sqrt(e->weight[i] * e->weight[j]);
            const double over = sqrt(e->mu[i] * e->mu[j]), one = i == j ? 1.0 : 0.0;
            minus[i * n + j] = (one - root * (same - other)) / over;
            plus[i * n + j] = (one - root * (same + other)) / over;
            both[i][j] = one - (same + other) * e->weight[j];
        }
    assert_int_equal(LAPACKE_dpotrf(LAPACK_ROW_MAJOR, 'L', n, minus, n), 0);
    // L^T plus L.
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double sum = 0.0;
            for (int a = i; a < n; a++)
                for (int b = j; b < n; b++)
                    sum += minus[a * n + i] * plus[a * n + b] * minus[b * n + j];
            product[i * n + j] = sum;
        }
    assert_int_equal(LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'V', 'L', n, product, n, e->k), 0);
    for (int j = 0; j < n; j++) {
        double sum[MOST];
        e->k[j] = sqrt(fmax(e->k[j], 0.0));
        for (int i = 0; i < n; i++) {
            sum[i] = 0.0;
            for (int a = 0; a <= i; a++)
                sum[i] += minus[i * n + a] * product[a * n + j];
            sum[i] /= sqrt(e->weight[i] * e->mu[i]);
        }
        for (int i = 0; i < n; i++) {
            double difference = 0.0;
            for (int a = 0; a < n; a++)
                difference -= both[i][a] * sum[a];
            difference /= e->k[j] * e->mu[i];
            e->rising[i][j] = 0.5 * (sum[i] + difference);
            e->falling[i][j] = 0.5 * (sum[i] - difference);
        }
    }
}

// Amplitudes for a radiance of 1 that comes in through the top wall along node `in`.
static void light(struct eigen *e, int in)
{
    static double matrix[4 * MOST * MOST], right[2 * MOST];
    static lapack_int pivots[2 * MOST];
    const int n = e->count, rows = 2 * n;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            const double left = exp(-e->k[j] * e->depth);
            const double g = e->rising[i][j], h = e->falling[i][j], r = e->mirror[i];
            matrix[i * rows + j] = h - r * g;
            matrix[i * rows + n + j] = (g - r * h) * left;
            matrix[(n + i) * rows + j] = (g - r * h) * left;
            matrix[(n + i) * rows + n + j] = h - r * g;
        }
        right[i] = i == in ? 1.0 : 0.0;
        right[n + i] = 0.0;
    }
    assert_int_equal(LAPACKE_dgesv(LAPACK_ROW_MAJOR, rows, 1, matrix, rows, pivots, right, 1), 0);
    memcpy(e->from_top, right, (size_t)n * sizeof(double));
    memcpy(e->from_bottom, right + n, (size_t)n * sizeof(double));
}

static double stream(const struct eigen *e, int node, int up, double tau)
{
    double sum = 0.0;
    for (int j = 0; j < e->count; j++) {
        const double top = exp(-e->k[j] * tau), bottom = exp(-e->k[j] * (e->depth - tau));
        const double g = e->rising[node][j], h = e->falling[node][j];
        sum += e->from_top[j] * (up ? g : h) * top + e->from_bottom[j] * (up ? h : g) * bottom;
    }
    return sum;
}

struct question {
    const char *name;
    double n, albedo, depth;
    // chi_l = share g^l + (1 - share) h^l
    double share, g, h;
    int modes;
};

static void near(const char *what, const char *name, double value, double expected,
                 double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s, %s: %.12g, eigenvalues %.12g +- %g", name, what, value, expected, tolerance);
}

enum { IN = 4, OUT = 11, BEYOND = HALF + 9 };

// What is asked of both: radiance at azimuth phi, of one direction outside and one inside.
struct sums {
    double brdf, btdf, up, down;
};

static void ask(const struct question *q)
{
    static struct eigen e;
    double chi[MOMENTS], g = 1.0, h = 1.0;
    const double phi = 0.7, tau = 0.3 * q->depth;
    e = (struct eigen){.n = q->n, .albedo = q->albedo, .depth = q->depth};
    for (int l = 0; l < MOMENTS; l++, g *= q->g, h *= q->h)
        e.chi[l] = chi[l] = q->share * g + (1.0 - q->share) * h;
    place(&e);
    const struct tsu_i_slab_layer layer = {
        .n = q->n, .albedo = q->albedo, .depth = q->depth, .chi = chi, .chi_count = MOMENTS};
    struct slab_case c = slab_of(&layer, 1, 20);
    const int inside = q->n > 1.0 ? BEYOND : OUT + 3;
    slab_direction(&c, e.outside[IN], 1.0);
    slab_direction(&c, e.outside[OUT], 1.0);
    slab_direction(&c, e.mu[inside], q->n);
    c.desc.modes = MOMENTS;
    c.desc.inside_wanted = 1;
    c.desc.level_depth = tau;
    assert_null(slab_solve(&c));
    struct sums sums = {0.0, 0.0, 0.0, 0.0};
    for (int m = 0; m < q->modes; m++) {
        decompose(&e, m);
        light(&e, IN);
        const double unit = (m ? 2.0 : 1.0) * cos(m * phi) * (1.0 - e.mirror[IN]) /
                            (2.0 * TSU_I_PI * e.mu[IN] * e.weight[IN]);
        const double outwards = unit * (1.0 - e.mirror[OUT]) / (q->n * q->n);
        sums.brdf += outwards * stream(&e, OUT, UP, 0.0);
        sums.btdf += outwards * stream(&e, OUT, DOWN, q->depth);
        sums.up += unit * stream(&e, inside, UP, tau);
        sums.down += unit * stream(&e, inside, DOWN, tau);
        if (m > 0)
            continue;
        double back = 0.0, through = 0.0, risen = 0.0, fallen = 0.0;
        for (int i = 0; i < e.count; i++) {
            const double flux =
                e.weight[i] * e.mu[i] * (1.0 - e.mirror[IN]) / (e.weight[IN] * e.mu[IN]);
            back += flux * (1.0 - e.mirror[i]) * stream(&e, i, UP, 0.0);
            through += flux * (1.0 - e.mirror[i]) * stream(&e, i, DOWN, q->depth);
            risen += flux * stream(&e, i, UP, tau);
            fallen += flux * stream(&e, i, DOWN, tau);
        }
        near("reflectance", q->name, c.solved.reflectance[0][0], e.mirror[IN] + back, 2e-8);
        near("transmittance", q->name, c.solved.transmittance[0][0], through, 2e-8);
        near("flux up", q->name, c.solved.inside_up[0][0], risen, 2e-7);
        near("flux down", q->name, c.solved.inside_down[0][0], fallen, 2e-7);
    }
    const struct sums ours = {tsu_i_slab_brdf(&c.solved, 0, 0, 1, phi),
                              tsu_i_slab_btdf(&c.solved, 0, 0, 1, phi),
                              tsu_i_slab_inside(&c.solved, 0, UP, 0, 2, phi),
                              tsu_i_slab_inside(&c.solved, 0, DOWN, 0, 2, phi)};
    print_message("%-28s %.1e %.1e %.1e %.1e\n", q->name, fabs(ours.brdf / sums.brdf - 1.0),
                  fabs(ours.btdf / sums.btdf - 1.0), fabs(ours.up / sums.up - 1.0),
                  fabs(ours.down / sums.down - 1.0));
    near("BRDF", q->name, ours.brdf / sums.brdf, 1.0, 2e-6);
    near("BTDF", q->name, ours.btdf / sums.btdf, 1.0, 2e-6);
    near("radiance up", q->name, ours.up / sums.up, 1.0, 2e-6);
    near("radiance down", q->name, ours.down / sums.down, 1.0, 2e-6);
    slab_free(&c);
}

static void eigenvalues_agree(void **state)
{
    (void)state;
    // Whiter slabs are beyond the eigenvalues: the least one drowns in the rounding of the largest.
    const struct question questions[] = {
        {"isotropic", 1.0, 0.9, 1.0, 1.0, 0.0, 0.0, 1},
        {"thick", 1.0, 0.99, 32.0, 1.0, 0.0, 0.0, 1},
        {"nearly white, thick", 1.0, 0.9999, 32.0, 1.0, 0.0, 0.0, 1},
        {"forward", 1.0, 0.95, 4.0, 1.0, 0.5, 0.0, 30},
        {"thin", 1.0, 0.9, 0.3, 1.0, 0.4, 0.0, 24},
        {"both peaks", 1.0, 0.98, 3.0, 0.6, 0.6, -0.5, 40},
        {"walls, isotropic", 1.45, 0.9, 2.0, 1.0, 0.0, 0.0, 1},
        {"walls, forward", 1.45, 0.95, 4.0, 1.0, 0.6, 0.0, 36},
        {"walls, nearly white, thick", 1.33, 0.9999, 64.0, 1.0, 0.5, 0.0, 24},
        {"walls, thin", 1.5, 0.99, 1e-3, 1.0, 0.3, 0.0, 20},
        {"walls, both peaks", 2.0, 0.8, 1.0, 0.7, 0.55, -0.4, 36},
    };
    for (size_t i = 0; i < sizeof questions / sizeof *questions; i++)
        ask(questions + i);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(eigenvalues_agree)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

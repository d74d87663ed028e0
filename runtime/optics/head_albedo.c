#include "optics/head_albedo.h"

#include "optics/angle.h"
#include "optics/fiber_layer.h"

#include <math.h>

enum { LAST = TSU_I_HEAD_NODES - 1 };
static const double scale = 0.15; // sqrt(sigma_a) in the middle of the axis

// Places on the axis count nodes.
static double place_of(double sigma_a)
{
    const double root = sqrt(sigma_a);
    return LAST * root / (root + scale);
}

static double absorption_of(double place)
{
    const double root = scale * place / (LAST - place);
    return root * root < TSU_I_HEAD_DARKEST ? root * root : TSU_I_HEAD_DARKEST;
}

double tsu_i_head_sigma_a(int node)
{
    return absorption_of(node);
}

int tsu_i_head_azimuths(double beta_az)
{
    const int azimuths = (int)ceil(50.0 * TSU_I_PI / 180.0 / beta_az - 1e-6);
    return azimuths < 5 ? 5 : azimuths > 10 ? 10 : azimuths;
}

size_t tsu_i_head_doubles(int azimuths)
{
    return tsu_i_layer_wide_doubles(TSU_I_LAYER_THETAS_MOST, azimuths);
}

double tsu_i_head_solve(const struct tsu_i_strand *strand, double theta, int azimuths,
                        double *memory)
{
    // What is left out is of the order of the light that comes back after crossing the layer
    // twice; a layer without absorption never gets there.
    const double enough = 2e-3;
    const int doublings = 40;
    struct tsu_i_layer layer;
    tsu_i_layer_wide_begin(&layer, strand, -theta, TSU_I_LAYER_THETAS_MOST, azimuths, memory);
    tsu_i_layer_thin(&layer, 2.0 * TSU_I_LAYER_THIN);
    int node = 0;
    for (int t = 1; t < layer.thetas; t++)
        if (fabs(layer.theta[t] + theta) < fabs(layer.theta[node] + theta))
            node = t;
    double albedo = 0.0, through = 1.0;
    for (int i = 0; i < doublings && through > enough; i++) {
        tsu_i_layer_double(&layer);
        tsu_i_layer_powers(&layer, node, &albedo, &through);
    }
    return albedo;
}

// Slope at a node, per node: of fourth order, held within what keeps the cubics from rising.
static double slope(const double *y, int i)
{
    static const double weights[5][5] = {{-25, 48, -36, 16, -3},
                                         {-3, -10, 18, -6, 1},
                                         {1, -8, 0, 8, -1},
                                         {-1, 6, -18, 10, 3},
                                         {3, -16, 36, -48, 25}};
    const int from = i < 2 ? 0 : i > LAST - 2 ? LAST - 4 : i - 2;
    double fall = 0.0;
    for (int k = 0; k < 5; k++)
        fall -= weights[i - from][k] * y[from + k] / 12.0;
    const double before = i > 0 ? y[i - 1] - y[i] : y[0] - y[1];
    const double after = i < LAST ? y[i] - y[i + 1] : before;
    return -fmin(fmax(fall, 0.0), 3.0 * fmin(before, after));
}

// Cubic of one interval as polynomial in its own [0, 1].
static void cubic(const double *y, int i, double c[4])
{
    const double rise = y[i + 1] - y[i], left = slope(y, i), right = slope(y, i + 1);
    c[0] = y[i];
    c[1] = left;
    c[2] = 3.0 * rise - 2.0 * left - right;
    c[3] = left + right - 2.0 * rise;
}

double tsu_i_head_forward(const double *albedo, double sigma_a)
{
    const double place = place_of(sigma_a);
    const int i = place < LAST ? (int)place : LAST - 1;
    const double x = place - i;
    double c[4];
    cubic(albedo, i, c);
    return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

double tsu_i_head_inverse(const double *albedo, double value)
{
    int i = 0;
    while (i < LAST - 1 && albedo[i + 1] > value)
        i++;
    double c[4], low = 0.0, high = 1.0;
    cubic(albedo, i, c);
    for (int step = 0; step < 60; step++) {
        const double x = 0.5 * (low + high);
        if (c[0] + x * (c[1] + x * (c[2] + x * c[3])) > value)
            low = x;
        else
            high = x;
    }
    return absorption_of(i + low);
}

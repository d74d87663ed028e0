#include "optics/fiber_layer.h"

#include "optics/angle.h"
#include "optics/dense.h"
#include "optics/quadrature.h"

#include <math.h>
#include <string.h>

enum { MOST_THETAS = TSU_I_LAYER_THETAS_MOST, MOST = TSU_I_LAYER_AZIMUTHS + 1 };
static const double step = TSU_I_PI / 36.0;
// Small beside every other weight, so that the normal's node takes part in no balance.
static const double normal_weight = 1e-12;

size_t tsu_i_layer_wide_doubles(int thetas, int azimuths)
{
    const size_t n = (size_t)thetas * (size_t)(azimuths + 1);
    return 7 * n * n;
}

size_t tsu_i_layer_doubles(int azimuths)
{
    return tsu_i_layer_wide_doubles(TSU_I_LAYER_THETAS, azimuths);
}

// Gauss-Legendre nodes on [0, pi/2].
static void azimuth_nodes(int count, double *phi, double *weight)
{
    tsu_i_quadrature_gauss(count, phi, weight);
    for (int i = 0; i < count; i++) {
        phi[i] = 0.25 * TSU_I_PI * (1.0 + phi[i]);
        weight[i] *= 0.25 * TSU_I_PI;
    }
}

// Column block of one inclination of travel: light that comes with it leaves along all others.
static void event_columns(struct tsu_i_layer *layer, const struct tsu_i_strand *strand, int in,
                          const double *weight)
{
    const int thetas = layer->thetas, azimuths = layer->azimuths + 1, n = layer->size;
    const double theta = -layer->theta[in]; // the fixed direction's
    const int split = strand->kind != TSU_I_STRAND_DEON && strand->kind != TSU_I_STRAND_GAUSSIAN;
    double c[TSU_I_FIBER_ORDERS][TSU_I_LOBES], share[TSU_I_LOBES][MOST_THETAS];
    const int orders = tsu_i_fiber_orders(strand->beta_az);
    double whole[TSU_I_LOBES] = {0};
    for (int p = 0; p < strand->lobes; p++)
        for (int t = 0; t < thetas; t++) {
            share[p][t] = tsu_i_strand_lobe(strand, p, theta, layer->theta[t]);
            whole[p] += share[p][t];
        }
    if (!split)
        tsu_i_strand_cosines(strand, theta, c);
    // Powers that the columns should sum to: kept exactly, or nothing would conserve energy.
    struct tsu_i_event event;
    tsu_i_strand_event(strand, theta, &event);
    double should = 0.0;
    for (int p = 0; p < strand->lobes; p++)
        should += event.forward[p] + event.backward[p];
    for (int a = 0; a < azimuths; a++) {
        const int column = in * azimuths + a;
        double sum = 0.0;
        for (int t = 0; t < thetas; t++) {
            if (split)
                tsu_i_fiber_cosines(strand->eta, 0.5 * (layer->theta[t] - theta), strand->sigma_a,
                                    strand->beta_az, orders, c);
            for (int b = 0; b < azimuths; b++) {
                double same = 0.0, turned = 0.0;
                for (int k = 0; k < orders; k++) {
                    double mixed = 0.0;
                    for (int p = 0; p < strand->lobes; p++)
                        mixed += c[k][p] * share[p][t] /
                                 (strand->kind == TSU_I_STRAND_LITERAL ? 1.0 / step : whole[p]);
                    // phi = 0 scatters straight back.
                    const double term = (k ? 2.0 : 1.0) * mixed * cos(k * layer->phi[a]) *
                                        cos(k * layer->phi[b]) / TSU_I_PI;
                    turned += term;
                    same += k % 2 ? -term : term;
                }
                const size_t at = (size_t)(t * azimuths + b) * (size_t)n + (size_t)column;
                layer->forward[at] = weight[b] * same;
                layer->backward[at] = weight[b] * turned;
                sum += weight[b] * (same + turned);
            }
        }
        const double scale = sum > 0.0 ? should / sum : 0.0;
        for (int row = 0; row < n; row++) {
            layer->forward[(size_t)row * (size_t)n + (size_t)column] *= scale;
            layer->backward[(size_t)row * (size_t)n + (size_t)column] *= scale;
        }
    }
}

void tsu_i_layer_begin(struct tsu_i_layer *layer, const struct tsu_i_strand *strand, double centre,
                       int azimuths, double *memory)
{
    tsu_i_layer_wide_begin(layer, strand, centre, TSU_I_LAYER_THETAS, azimuths, memory);
}

void tsu_i_layer_wide_begin(struct tsu_i_layer *layer, const struct tsu_i_strand *strand,
                            double centre, int thetas, int azimuths, double *memory)
{
    double weight[MOST];
    layer->thetas = thetas;
    layer->azimuths = azimuths;
    layer->size = thetas * (azimuths + 1);
    layer->tau = 0.0;
    const size_t entries = (size_t)layer->size * (size_t)layer->size;
    double **const matrices[] = {&layer->forward, &layer->backward, &layer->through, &layer->back,
                                 &layer->work[0], &layer->work[1],  &layer->work[2]};
    for (size_t i = 0; i < sizeof matrices / sizeof *matrices; i++)
        *matrices[i] = memory + i * entries;
    // Even steps about 0 and less than half a step off, so that `centre` is a node.
    const double offset = centre - step * floor(centre / step + 0.5);
    for (int t = 0; t < thetas; t++)
        layer->theta[t] = step * (t - thetas / 2) + offset;
    azimuth_nodes(azimuths, layer->phi, weight);
    layer->phi[azimuths] = 0.0;
    weight[azimuths] = normal_weight;
    for (int t = 0; t < thetas; t++)
        event_columns(layer, strand, t, weight);
}

// At most one event, and that at once: conserves energy, and what it leaves out is of order tau.
void tsu_i_layer_thin(struct tsu_i_layer *layer, double tau)
{
    const int n = layer->size, azimuths = layer->azimuths + 1;
    for (int j = 0; j < n; j++) {
        const double passed = exp(-tau / cos(layer->phi[j % azimuths]));
        for (int i = 0; i < n; i++) {
            const size_t at = (size_t)i * (size_t)n + (size_t)j;
            layer->through[at] = layer->forward[at] * (1.0 - passed) + (i == j ? passed : 0.0);
            layer->back[at] = layer->backward[at] * (1.0 - passed);
        }
    }
    layer->tau = tau;
}

// X = (1 - R R)^-1 T; R' = R + T R X, T' = T X.
void tsu_i_layer_double(struct tsu_i_layer *layer)
{
    const int n = layer->size;
    const size_t bytes = (size_t)n * (size_t)n * sizeof(double);
    double *loop = layer->work[0], *x = layer->work[1], *turned = layer->work[2];
    memset(loop, 0, bytes);
    tsu_i_dense_add(n, layer->back, layer->back, loop);
    for (size_t i = 0; i < (size_t)n * (size_t)n; i++)
        loop[i] = -loop[i];
    for (int i = 0; i < n; i++)
        loop[(size_t)i * (size_t)n + (size_t)i] += 1.0;
    memcpy(x, layer->through, bytes);
    tsu_i_dense_solve(n, loop, n, x);
    memset(turned, 0, bytes);
    tsu_i_dense_add(n, layer->back, x, turned);
    tsu_i_dense_add(n, layer->through, turned, layer->back);
    memset(turned, 0, bytes);
    tsu_i_dense_add(n, layer->through, x, turned);
    memcpy(layer->through, turned, bytes);
    layer->tau *= 2.0;
}

void tsu_i_layer_powers(const struct tsu_i_layer *layer, int t, double *reflectance,
                        double *transmittance)
{
    const int n = layer->size, azimuths = layer->azimuths + 1;
    const size_t column = (size_t)(t * azimuths + layer->azimuths);
    *reflectance = *transmittance = 0.0;
    for (int i = 0; i < n; i++) {
        *reflectance += layer->back[(size_t)i * (size_t)n + column];
        *transmittance += layer->through[(size_t)i * (size_t)n + column];
    }
}

void tsu_i_layer_slab(const struct tsu_i_strand *strand, double theta, double tau, int azimuths,
                      double *memory, double *reflectance, double *transmittance)
{
    struct tsu_i_layer layer;
    // 512 fibres of a white volume still let through a little; what more would change is below
    // 1e-3.
    const double depth = fmin(tau, 512.0);
    int doublings = 0;
    while (ldexp(depth, -doublings) > TSU_I_LAYER_THIN)
        doublings++;
    tsu_i_layer_wide_begin(&layer, strand, -theta, TSU_I_LAYER_THETAS_MOST, azimuths, memory);
    tsu_i_layer_thin(&layer, ldexp(depth, -doublings));
    for (int i = 0; i < doublings; i++)
        tsu_i_layer_double(&layer);
    int node = 0;
    for (int t = 1; t < layer.thetas; t++)
        if (fabs(layer.theta[t] + theta) < fabs(layer.theta[node] + theta))
            node = t;
    tsu_i_layer_powers(&layer, node, reflectance, transmittance);
}

// One homogeneous layer: a thin one solved at once, then doubled.
//
// In a thin layer of optical thickness d the source is constant over depth: with x = d / mu a
// stream leaves I exp(-x) + (1 - exp(-x)) S, and its mean inside is f I + (1 - f) S, f = (1 -
// exp(-x)) / x. S = scattering(mean of all streams) is linear in S and solved; power balances
// exactly. Up and down are even and odd halves.
//
// Nodes that are no Gauss rule of mu do not integrate the cut phase function to exactly 1. What a
// node's light loses that way is counted as not scattered at all: its extinction is 1 - albedo
// times the deficit, which goes to 0 with more nodes.
#include "optics/slab_work.h"

#include "optics/dense.h"
#include "optics/phase.h"

#include <math.h>
#include <string.h>

// Largest thin layer, also over the most grazing cosine that is asked for.
static const double start = 1.0 / 4096.0, start_grazing = 1.0 / 64.0;
// Doublings at most: to a depth at which a conservative half space lets 1e-18 through.
enum { DOUBLINGS = 80 };

// Moments of a layer and delta-M: the first one that is cut is the share that goes straight on.
// Phase functions with another sign there have no forward peak; theirs are just cut.
static void cut_moments(const struct tsu_i_slab_layer *layer, int moments,
                        struct tsu_i_slab_scattering *out)
{
    double forward = 0.0, rest = 1.0; // rest: 1 - forward
    if (layer->chi) {
        const uint32_t cut = (uint32_t)moments;
        if (layer->chi_count > cut && layer->chi[cut] > 0.0 && layer->chi[cut - 1] > 0.0)
            forward = layer->chi[cut] < 1.0 ? layer->chi[cut] : 0.0;
        rest = 1.0 - forward;
        for (uint32_t l = 0; l < cut; l++)
            out->chi[l] = l < layer->chi_count ? (layer->chi[l] - forward) / rest : 0.0;
    } else if (layer->g > 0.0) {
        const double log_g = log(layer->g);
        rest = -expm1(moments * log_g);
        for (int l = 0; l < moments; l++)
            out->chi[l] = exp(l * log_g) * -expm1((moments - l) * log_g) / rest;
    } else {
        double power = 1.0;
        for (int l = 0; l < moments; l++, power *= layer->g)
            out->chi[l] = power;
    }
    out->chi[0] = 1.0;
    for (out->moments = moments; out->moments > 1; out->moments--)
        if (fabs(out->chi[out->moments - 1]) > 1e-15)
            break;
    out->stretch = (1.0 - layer->albedo) + layer->albedo * rest; // 1 - albedo forward
    out->restored = layer->albedo / out->stretch;
    out->albedo = out->restored * rest;
    out->absorption = (1.0 - layer->albedo) / out->stretch;
}

// Legendre functions of mode m in a layer, a row a node. A direction has its own value, a node the
// mean with its Lagrange polynomial: then each moment of the phase function acts on the polynomial
// through the nodes without aliasing, however many there are. Odd modes go like sin(theta) at
// theta = 0, and so does their polynomial.
static void mean_functions(struct tsu_i_slab_work *work, double n, int mode, int count, int reach)
{
    const size_t pitch = (size_t)work->moments;
    double *const out = work->functions, *values = out + (size_t)work->count * pitch;
    if (work->functions_n == n && work->functions_mode == mode && work->functions_count >= count)
        return;
    work->functions_n = n;
    work->functions_mode = mode;
    work->functions_count = count;
    for (int i = 0; i < reach; i++) {
        memset(out + (size_t)i * pitch, 0, pitch * sizeof *out);
        if (i < work->users)
            tsu_i_phase_mode((uint32_t)mode, (uint32_t)count,
                             fmin(tsu_i_slab_normal(work, i, n) / n, 1.0), out + (size_t)i * pitch);
    }
    for (int first = work->users, q = 0; first < reach; first += work->nodes)
        for (const int end = q + work->fine; q < end; q++) {
            const double high = work->index[first];
            const double square = work->fine_normal2[q];
            const double normal = sqrt(square + (n - high) * (n + high));
            const double *share = work->basis + (size_t)q * (size_t)work->nodes;
            tsu_i_phase_mode((uint32_t)mode, (uint32_t)count, fmin(normal / n, 1.0), values);
            for (int i = 0; i < work->nodes; i++) {
                const size_t node = (size_t)(first + i);
                double factor = share[i] * tsu_i_slab_normal(work, first + i, n) / normal;
                if (mode % 2)
                    factor *= sqrt((high * high - square) / (high * high - work->normal2[node]));
                tsu_i_dense_rows(1, &factor, values, pitch, count - mode, out + node * pitch);
            }
        }
}

static int reach_of(const struct tsu_i_slab_work *work, double n)
{
    int reach = work->count;
    while (reach > work->users && !(tsu_i_slab_normal(work, reach - 1, n) > 0.0))
        reach--;
    return reach;
}

void tsu_i_slab_scattering(struct tsu_i_slab_work *work, const struct tsu_i_slab_layer *layer,
                           struct tsu_i_slab_scattering *out)
{
    const int reach = reach_of(work, layer->n);
    const size_t pitch = (size_t)work->moments;
    cut_moments(layer, work->moments, out);
    mean_functions(work, layer->n, 0, out->moments, reach);
    double *integral = work->functions + (size_t)work->count * pitch;
    memset(integral, 0, pitch * sizeof *integral);
    for (int i = work->users; i < reach; i++) {
        const double weight =
            0.5 * work->weight[i] / (layer->n * tsu_i_slab_normal(work, i, layer->n));
        tsu_i_dense_rows(1, &weight, work->functions + (size_t)i * pitch, pitch, out->moments,
                         integral);
    }
    for (int j = 0; j < work->count; j++)
        out->extinction[j] = 1.0;
    for (int j = 0; j < reach; j++) {
        double whole = 0.0;
        for (int l = 0; l < out->moments; l += 2)
            whole += (2.0 * l + 1.0) * out->chi[l] * integral[l] *
                     work->functions[(size_t)j * pitch + (size_t)l];
        out->extinction[j] -= out->albedo * (1.0 - whole);
    }
}

// Even or odd half of albedo times the mode's phase function, over the extinctions of the out node.
static void half_phase(const struct tsu_i_slab_work *work, int reach, int mode, int odd,
                       const struct tsu_i_slab_scattering *scattering, double *out)
{
    const int count = scattering->moments - mode;
    for (int i = 0; i < reach; i++) {
        const double *of_i = work->functions + (size_t)i * (size_t)work->moments;
        for (int j = 0; j < reach; j++) {
            const double *of_j = work->functions + (size_t)j * (size_t)work->moments;
            double sum = 0.0;
            for (int l = odd; l < count; l += 2)
                sum += (2.0 * (l + mode) + 1.0) * scattering->chi[l + mode] * of_i[l] * of_j[l];
            out[(size_t)i * (size_t)work->count + (size_t)j] =
                scattering->albedo * sum / scattering->extinction[i];
        }
    }
}

// Shares of a stream in `depth`: never scattered, and the rest.
static void extinguish(const struct tsu_i_slab_work *work, double n,
                       const struct tsu_i_slab_scattering *scattering, double depth)
{
    const struct tsu_i_slab_element *layer = &work->layer;
    for (int i = 0; i < work->count; i++) {
        const double normal = tsu_i_slab_normal(work, i, n);
        const double x = depth > 0.0 ? depth * scattering->extinction[i] * n / normal : 0.0;
        layer->mirror[0][i] = 0.0;
        layer->straight[i] = normal > 0.0 ? exp(-x) : 0.0;
        layer->lost[0][i] = normal > 0.0 ? -expm1(-x) : 1.0;
    }
}

static void thin(struct tsu_i_slab_work *work, double n,
                 const struct tsu_i_slab_scattering *scattering, double depth, int mode)
{
    struct tsu_i_slab_element *layer = &work->layer;
    const int reach = layer->reach;
    const size_t pitch = (size_t)work->count;
    // Of a stream: share that leaves it, mean of what comes in, mean of a unit source; mean over
    // the basic flux.
    double *leave = work->scratch[4], *mean = work->scratch[5], *own = work->scratch[6],
           *ones = work->scratch[7];
    for (int i = 0; i < reach; i++) {
        const double normal = tsu_i_slab_normal(work, i, n);
        const double x = depth * scattering->extinction[i] * n / normal;
        const double over = 0.5 / (n * normal);
        const double f = normal > 0.0 ? x > 0.0 ? -expm1(-x) / x : 1.0 : 0.0;
        leave[i] = normal > 0.0 ? -expm1(-x) : 0.0;
        mean[i] = normal > 0.0 ? f * over : 0.0;
        // 1 - f loses digits where x is small: then its series.
        own[i] =
            normal > 0.0
                ? (x > 0.02 ? 1.0 - f : x * (0.5 - x * (1.0 / 6 - x * (1.0 / 24 - x / 120)))) * over
                : 0.0;
        ones[i] = 1.0;
    }
    for (int odd = 0; odd < 2; odd++) {
        double *kernel = work->loop, *source = work->down[odd];
        half_phase(work, reach, mode, odd, scattering, kernel);
        for (size_t i = 0; i < (size_t)reach; i++)
            for (size_t j = 0; j < (size_t)reach; j++) {
                source[i * pitch + j] = kernel[i * pitch + j] * mean[j];
                kernel[i * pitch + j] *= own[j];
            }
        tsu_i_slab_eliminate(work, reach, kernel, ones, NULL, source, NULL);
    }
    for (size_t i = 0; i < (size_t)reach; i++)
        for (size_t j = 0; j < (size_t)reach; j++) {
            const double even = work->down[0][i * pitch + j], odd = work->down[1][i * pitch + j];
            layer->through[i * pitch + j] = 0.5 * leave[i] * (even + odd);
            layer->back[0][i * pitch + j] = 0.5 * leave[i] * (even - odd);
        }
    if (mode == 0) {
        // Twice the mean radiance of all streams times d (1 - albedo), over the flux that comes.
        double *held = work->scratch[8];
        const double lost = 2.0 * n * n * scattering->absorption * depth;
        tsu_i_slab_powers(work, reach, own, work->down[0], held);
        for (int j = 0; j < reach; j++)
            layer->absorbed[0][j] = lost * (held[j] + mean[j]);
    }
}

static double largest(const struct tsu_i_slab_work *work, int reach, const double *kernel)
{
    double most = 0.0;
    for (int i = 0; i < reach; i++)
        for (int j = 0; j < reach; j++)
            most = fmax(most, fabs(kernel[(size_t)i * (size_t)work->count + (size_t)j]));
    return most;
}

static void kept(const struct tsu_i_slab_work *work)
{
    const struct tsu_i_slab_element *layer = &work->layer;
    double *ones = work->scratch[1], *through = work->scratch[2];
    for (int j = 0; j < work->count; j++) {
        ones[j] = 1.0;
        through[j] = 0.0;
    }
    tsu_i_slab_powers(work, layer->reach, ones, layer->through, through);
    for (int j = 0; j < work->count; j++)
        layer->kept[0][j] = layer->straight[j] + layer->absorbed[0][j] + through[j];
}

void tsu_i_slab_layer(struct tsu_i_slab_work *work, double n,
                      const struct tsu_i_slab_scattering *scattering, double depth, int mode)
{
    struct tsu_i_slab_element *layer = &work->layer;
    const int reach = reach_of(work, n), scatters = mode < scattering->moments;
    layer->reach = 0;
    extinguish(work, n, scattering, depth);
    memcpy(layer->absorbed[0], layer->lost[0], (size_t)work->count * sizeof(double));
    if (!(scatters && scattering->albedo > 0.0 && depth > 0.0)) {
        kept(work);
        return;
    }
    mean_functions(work, n, mode, scattering->moments, reach);
    int doublings = 0;
    double most = start, piece = depth < ldexp(start, DOUBLINGS) ? depth : ldexp(start, DOUBLINGS);
    for (int u = 0; u < work->users; u++)
        if (tsu_i_slab_normal(work, u, n) > 0.0)
            most = fmin(most, start_grazing * tsu_i_slab_normal(work, u, n) / n);
    for (; piece > most; doublings++)
        piece *= 0.5;
    layer->reach = reach;
    thin(work, n, scattering, piece, mode);
    extinguish(work, n, scattering, piece);
    if (mode == 0)
        kept(work);
    for (int k = 0; k < doublings; k++) {
        tsu_i_slab_add(work, layer, layer, mode, 0);
        piece *= 2.0;
        extinguish(work, n, scattering, piece);
        if (mode == 0)
            kept(work);
        // Nothing comes through any more.
        if (largest(work, reach, layer->through) < (isinf(depth) ? 1e-20 : 1e-300))
            break;
    }
    if (isinf(depth)) {
        for (int i = 0; i < reach; i++)
            memset(layer->through + (size_t)i * (size_t)work->count, 0,
                   (size_t)reach * sizeof(double));
        extinguish(work, n, scattering, depth);
        kept(work);
    } else {
        extinguish(work, n, scattering, depth);
    }
}

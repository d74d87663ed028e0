// Where the nodes lie, and what boundaries let through there.
#include "optics/slab_work.h"

#include "optics/fresnel.h"
#include "optics/quadrature.h"

#include <math.h>
#include <string.h>

double tsu_i_slab_normal(const struct tsu_i_slab_work *work, int node, double n)
{
    const double own = work->index[node];
    const double square = work->normal2[node] + (n - own) * (n + own);
    return square > 0.0 ? sqrt(square) : 0.0;
}

double tsu_i_slab_boundary(const struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                           uint32_t below, int node, double *mirror)
{
    const uint32_t count = desc->layer_count;
    const double n_a = below > 0 ? desc->layers[below - 1].n : 1.0;
    const double n_b = below < count ? desc->layers[below].n : 1.0;
    const double slide = below == 0 ? desc->slide_top : below == count ? desc->slide_bottom : 1.0;
    const double a = tsu_i_slab_normal(work, node, n_a), b = tsu_i_slab_normal(work, node, n_b);
    if (slide == 1.0) {
        *mirror = tsu_i_fresnel_reflect(n_a, a, n_b, b);
        return tsu_i_fresnel_transmit(n_a, a, n_b, b);
    }
    const double s = tsu_i_slab_normal(work, node, slide);
    const double through = tsu_i_fresnel_pair(tsu_i_fresnel_transmit(n_a, a, slide, s),
                                              tsu_i_fresnel_transmit(slide, s, n_b, b));
    *mirror = 1.0 - through;
    return through;
}

int tsu_i_slab_indices(const struct tsu_i_slab_desc *desc, double *out)
{
    int count = 1;
    out[0] = 1.0;
    for (uint32_t i = 0; i < desc->layer_count; i++) {
        const double n = desc->layers[i].n;
        int at = count;
        while (at > 0 && out[at - 1] > n)
            at--;
        if (at > 0 && out[at - 1] == n)
            continue;
        memmove(out + at + 1, out + at, (size_t)(count - at) * sizeof *out);
        out[at] = n;
        count++;
    }
    return count;
}

// Indices closer than this are told apart less well: nodes that cluster at them would leave none
// for the rest.
static const double least_bend = 0.1;
// With air alone, nodes cluster at grazing directions, the more the thinner the slab is.
static const double air_bend = 0.5, least_air_bend = 0.01;

// An interval of k between two neighbouring indices, in v: the normal component in the upper one's
// medium is bend sinh(v), in that of the next one bend cosh(v), so that both are smooth. With no
// next one it is v.
struct interval {
    double bend, range;
};

// Normal component at x in [-1, 1], and d(k^2) / dx.
static double at(const struct interval *interval, double x, double *slope)
{
    const double v = 0.5 * interval->range * (1.0 + x);
    const double normal = interval->bend > 0.0 ? interval->bend * sinh(v) : v;
    *slope = normal * (interval->bend > 0.0 ? interval->bend * cosh(v) : 1.0) * interval->range;
    return normal;
}

// Nodes of one interval, and the fine nodes with the share of each in the mean around each node
// that the scattering takes: share(node, fine node) is the node's Lagrange polynomial times d(k^2)
// there over the node's own.
static void nodes_between(struct tsu_i_slab_work *work, int which, double low, double high,
                          double bend)
{
    const int count = work->nodes, fine = work->fine, first = work->users + which * count;
    const double most = sqrt((high - low) * (high + low));
    const struct interval interval = {bend, bend > 0.0 ? asinh(most / bend) : most};
    double x[TSU_I_SLAB_MOST_NODES], weight[TSU_I_SLAB_MOST_NODES], slope, sum = 0.0;
    const double *const fine_x = work->functions, *const fine_weight = fine_x + fine;
    tsu_i_quadrature_gauss(count, x, weight);
    for (int i = 0; i < count; i++) {
        const double normal = at(&interval, x[i], &slope);
        work->index[first + i] = high;
        work->normal2[first + i] = normal * normal;
        work->weight[first + i] = weight[i] * slope;
        sum += work->weight[first + i];
    }
    const double scale = (high - low) * (high + low) / sum;
    for (int i = 0; i < count; i++)
        work->weight[first + i] *= scale;
    for (int q = 0; q < fine; q++) {
        const double normal = at(&interval, fine_x[q], &slope);
        double share[TSU_I_SLAB_MOST_NODES], total = 0.0;
        work->fine_normal2[which * fine + q] = normal * normal;
        // Barycentric form: weights of Gauss-Legendre nodes.
        for (int i = 0; i < count; i++) {
            const double apart = fine_x[q] - x[i];
            const double pull = sqrt((1.0 - x[i] * x[i]) * weight[i]);
            share[i] = (i % 2 ? -pull : pull) / (apart != 0.0 ? apart : 1e-300);
            total += share[i];
        }
        for (int i = 0; i < count; i++)
            work->basis[(size_t)(which * fine + q) * (size_t)count + (size_t)i] =
                share[i] / total * fine_weight[q] * slope / work->weight[first + i];
    }
}

void tsu_i_slab_nodes(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc)
{
    double indices[TSU_I_SLAB_MOST_LAYERS + 2];
    const int count = tsu_i_slab_indices(desc, indices);
    double depth = 0.0;
    for (uint32_t i = 0; i < desc->layer_count; i++)
        depth += desc->layers[i].depth;
    for (int i = 0; i < work->users; i++) {
        const struct tsu_i_slab_direction *direction = desc->directions + i;
        const double normal = direction->n * direction->mu;
        work->index[i] = direction->n;
        work->normal2[i] = normal * normal;
        work->weight[i] = 0.0;
    }
    tsu_i_quadrature_gauss(work->fine, work->functions, work->functions + work->fine);
    for (int i = 0; i < count; i++) {
        const double next = i + 1 < count ? indices[i + 1] : indices[i];
        double bend = 0.0;
        if (next > indices[i])
            bend = fmax(sqrt((next - indices[i]) * (next + indices[i])), least_bend);
        else if (count == 1)
            bend = fmax(fmin(depth, air_bend), least_air_bend);
        nodes_between(work, i, i > 0 ? indices[i - 1] : 0.0, indices[i], bend);
    }
}

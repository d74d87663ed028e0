// Light that is scattered once, exactly: with every reflection of the beam before and of the
// scattered ray after at the walls between the layers.
//
// By reciprocity a scattered ray that gets to a place is a beam that leaves it, backwards; so a
// pair of directions is two beams, and in a homogeneous part each of them is one stream down and
// one up. ladder[variant][source][direction][part][2]: radiance of a beam of 1 where it comes into
// the part, down on its top and up on its bottom. Sources: from above the slab, from below it, from
// the level down, from the level up.
#include "optics/angle.h"
#include "optics/fresnel.h"
#include "optics/phase.h"
#include "optics/slab_work.h"

#include <math.h>

enum { SOURCES = 4, FROM_TOP = 0, FROM_BOTTOM = 1, LEVEL_DOWN = 2, LEVEL_UP = 3 };

// Attenuation: as the nodes have it, by the optical thickness after delta-M, by the one given.
enum { NODES, EXACT, GIVEN };

size_t tsu_i_slab_single_doubles(int users, uint32_t parts)
{
    return (size_t)2 * SOURCES * (size_t)users * parts * 2;
}

static double *rung(const struct tsu_i_slab_work *work, int variant, int source, size_t direction,
                    size_t part)
{
    const size_t at = ((size_t)(variant * SOURCES + source) * (size_t)work->users + direction);
    return work->ladder + (at * work->part_count + part) * 2;
}

// Attenuation over optical thickness along the normal; 0 where there is no such direction.
static double slope(const struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                    int variant, size_t direction, uint32_t layer, double *cosine)
{
    const struct tsu_i_slab_scattering *scattering = work->scattering + layer;
    const double n = desc->layers[layer].n;
    const double mu = fmin(tsu_i_slab_normal(work, (int)direction, n) / n, 1.0);
    *cosine = mu;
    if (!(mu > 0.0))
        return 0.0;
    return (variant == NODES   ? scattering->extinction[direction]
            : variant == GIVEN ? 1.0 / scattering->stretch
                               : 1.0) /
           mu;
}

enum { MOST_PARTS = TSU_I_SLAB_MOST_LAYERS + 1 };

// Of one direction: parts that let `pass` through, boundaries on top of each and below the last;
// reflection that the bottom end of a part sees below it, and its top end above.
struct way {
    uint32_t parts;
    double pass[MOST_PARTS], through[MOST_PARTS + 1], mirror[MOST_PARTS + 1];
    double floor[MOST_PARTS], ceiling[MOST_PARTS];
};

static double sum_of(double first, double ratio)
{
    return ratio < 1.0 ? first / (1.0 - ratio) : 0.0;
}

static void look(struct way *way)
{
    const uint32_t last = way->parts - 1;
    way->ceiling[0] = way->mirror[0];
    for (uint32_t p = 0; p < last; p++) {
        const double seen = way->pass[p] * way->pass[p] * way->ceiling[p];
        const double t = way->through[p + 1], r = way->mirror[p + 1];
        way->ceiling[p + 1] = r + sum_of(t * t * seen, r * seen);
    }
    way->floor[last] = way->mirror[last + 1];
    for (uint32_t p = last; p > 0; p--) {
        const double seen = way->pass[p] * way->pass[p] * way->floor[p];
        const double t = way->through[p], r = way->mirror[p];
        way->floor[p - 1] = r + sum_of(t * t * seen, r * seen);
    }
}

// A beam that comes to the boundary on top of part `first` from above.
static void descend(const struct tsu_i_slab_work *work, const struct way *way, int variant,
                    int source, size_t direction, uint32_t first, double beam)
{
    for (uint32_t p = first; p < way->parts; p++) {
        const double pass = way->pass[p];
        double *out = rung(work, variant, source, direction, p);
        out[0] = sum_of(beam * way->through[p], way->mirror[p] * pass * pass * way->floor[p]);
        out[1] = out[0] * pass * way->floor[p];
        beam = out[0] * pass;
    }
}

// And one that comes to the boundary below part `first - 1` from below.
static void ascend(const struct tsu_i_slab_work *work, const struct way *way, int variant,
                   int source, size_t direction, uint32_t first, double beam)
{
    for (uint32_t p = first; p-- > 0;) {
        const double pass = way->pass[p];
        double *out = rung(work, variant, source, direction, p);
        out[1] =
            sum_of(beam * way->through[p + 1], way->mirror[p + 1] * pass * pass * way->ceiling[p]);
        out[0] = out[1] * pass * way->ceiling[p];
        beam = out[1] * pass;
    }
}

static void set_way(const struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                    int variant, size_t direction, struct way *way)
{
    way->parts = work->part_count;
    for (uint32_t p = 0; p <= way->parts; p++) {
        const int split = desc->inside_wanted && p == work->level;
        const uint32_t below = p < way->parts ? work->parts[p].layer : desc->layer_count;
        way->mirror[p] = 0.0;
        way->through[p] =
            split ? 1.0 : tsu_i_slab_boundary(work, desc, below, (int)direction, way->mirror + p);
    }
    for (uint32_t p = 0; p < way->parts; p++) {
        const struct tsu_i_slab_part *part = work->parts + p;
        double mu;
        const double steep = slope(work, desc, variant, direction, part->layer, &mu);
        way->pass[p] = !(part->depth > 0.0) ? 1.0 : steep > 0.0 ? exp(-part->depth * steep) : 0.0;
    }
    look(way);
}

double tsu_i_slab_unscattered(const struct tsu_i_slab_work *work,
                              const struct tsu_i_slab_desc *desc, int side, int direction,
                              double *straight)
{
    struct way way;
    set_way(work, desc, GIVEN, (size_t)direction, &way);
    const uint32_t last = way.parts - 1, end = side ? way.parts : 0;
    double beam = 1.0;
    for (uint32_t p = 0; p <= last; p++) {
        const double loop = way.mirror[p] * way.pass[p] * way.pass[p] * way.floor[p];
        beam = sum_of(beam * way.through[p], loop) * way.pass[p];
    }
    *straight = beam * way.through[way.parts];
    const double far = side ? way.pass[last] * way.pass[last] * way.ceiling[last]
                            : way.pass[0] * way.pass[0] * way.floor[0];
    const double t = way.through[end], r = way.mirror[end];
    return r + sum_of(t * t * far, r * far);
}

void tsu_i_slab_single_begin(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc)
{
    struct way way;
    for (int variant = NODES; variant <= EXACT; variant++)
        for (size_t direction = 0; direction < (size_t)work->users; direction++) {
            set_way(work, desc, variant, direction, &way);
            descend(work, &way, variant, FROM_TOP, direction, 0, 1.0);
            ascend(work, &way, variant, FROM_BOTTOM, direction, way.parts, 1.0);
            if (!desc->inside_wanted)
                continue;
            const uint32_t level = work->level;
            const double over = way.pass[level - 1] * way.pass[level - 1] * way.ceiling[level - 1];
            const double under = way.pass[level] * way.pass[level] * way.floor[level];
            const double both = sum_of(1.0, over * under);
            descend(work, &way, variant, LEVEL_DOWN, direction, level, both);
            ascend(work, &way, variant, LEVEL_DOWN, direction, level, both * under);
            ascend(work, &way, variant, LEVEL_UP, direction, level, both);
            descend(work, &way, variant, LEVEL_UP, direction, level, both * over);
        }
}

// Once scattered light of one part, per phase function: into the other half space and into the same
// one, for a beam from either side; over both cosines.
static void part_single(double depth, double a, double b, double *back, double *through)
{
    const double low = fmin(a, b), apart = fabs(a - b), left = exp(-low * depth);
    *back = -expm1(-depth * (a + b)) / (a + b);
    *through = !(left > 0.0)         ? 0.0
               : apart * depth > 0.0 ? left * -expm1(-apart * depth) / apart
                                     : left * depth;
}

// Sum over parts; `phase` gives albedo times the phase function, [0] to the same half space, [1] to
// the other one.
static double single(const struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                     int variant, int source_in, size_t in, int source_out, size_t out,
                     const double (*phase)[2])
{
    double sum = 0.0;
    for (uint32_t p = 0; p < work->part_count; p++) {
        const struct tsu_i_slab_part *part = work->parts + p;
        const double *x = rung(work, variant, source_in, in, p);
        const double *y = rung(work, variant, source_out, out, p);
        const double n = desc->layers[part->layer].n;
        double mu_in, mu_out, back, through;
        const double a = slope(work, desc, variant, in, part->layer, &mu_in);
        const double b = slope(work, desc, variant, out, part->layer, &mu_out);
        if (!(a > 0.0 && b > 0.0 && part->depth > 0.0))
            continue;
        part_single(part->depth, a, b, &back, &through);
        sum += ((x[0] * y[0] + x[1] * y[1]) * phase[part->layer][1] * back +
                (x[0] * y[1] + x[1] * y[0]) * phase[part->layer][0] * through) /
               (4.0 * n * n * mu_in * mu_out);
    }
    return sum;
}

// The source whose beam, backwards, is the light that is asked for.
static int backwards(int side, int kind)
{
    switch (kind) {
    case TSU_I_SLAB_BACK:
        return side;
    case TSU_I_SLAB_THROUGH:
        return !side;
    case TSU_I_SLAB_UP:
        return LEVEL_DOWN;
    default:
        return LEVEL_UP;
    }
}

void tsu_i_slab_single_remove(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                              uint32_t mode)
{
    const size_t users = (size_t)work->users, pairs = users * users;
    const int kinds = desc->inside_wanted ? TSU_I_SLAB_KINDS : TSU_I_SLAB_UP;
    double phase[TSU_I_SLAB_MOST_LAYERS][2];
    for (size_t in = 0; in < users; in++)
        for (size_t out = 0; out < users; out++) {
            for (uint32_t i = 0; i < desc->layer_count; i++) {
                const struct tsu_i_slab_scattering *s = work->scattering + i;
                double *of_in = work->functions + (size_t)work->count * (size_t)work->moments;
                double *of_out = of_in + work->moments, mu_in, mu_out;
                slope(work, desc, NODES, in, i, &mu_in);
                slope(work, desc, NODES, out, i, &mu_out);
                tsu_i_phase_mode(mode, (uint32_t)s->moments, mu_in, of_in);
                tsu_i_phase_mode(mode, (uint32_t)s->moments, mu_out, of_out);
                phase[i][0] = phase[i][1] = 0.0;
                for (uint32_t l = 0; l + mode < (uint32_t)s->moments; l++) {
                    const double term = s->albedo * (2.0 * (l + mode) + 1.0) * s->chi[l + mode] *
                                        of_in[l] * of_out[l];
                    phase[i][0] += term;
                    phase[i][1] += l % 2 ? -term : term;
                }
            }
            for (int side = 0; side < 2; side++)
                for (int kind = 0; kind < kinds; kind++)
                    work->multiple[((size_t)(((int)mode * 2 + side) * TSU_I_SLAB_KINDS + kind)) *
                                       pairs +
                                   out * users + in] -=
                        single(work, desc, NODES, side, in, backwards(side, kind), out,
                               (const double(*)[2])phase);
        }
}

static double layer_phase(const struct tsu_i_slab_layer *layer, double cosine)
{
    cosine = fmax(fmin(cosine, 1.0), -1.0);
    return layer->chi ? tsu_i_phase_legendre(layer->chi, layer->chi_count, cosine)
                      : tsu_i_phase_henyey_greenstein(layer->g, cosine);
}

static double radiance(const struct tsu_i_slab *slab, int side, int kind, size_t in, size_t out,
                       double phi)
{
    const struct tsu_i_slab_desc *desc = slab->desc;
    const struct tsu_i_slab_work *work = slab->work;
    const size_t users = (size_t)work->users, pairs = users * users;
    double phase[TSU_I_SLAB_MOST_LAYERS][2], sum = 0.0;
    for (uint32_t i = 0; i < desc->layer_count; i++) {
        double mu_in, mu_out;
        slope(work, desc, EXACT, in, i, &mu_in);
        slope(work, desc, EXACT, out, i, &mu_out);
        const double across =
            sqrt((1.0 - mu_in) * (1.0 + mu_in) * (1.0 - mu_out) * (1.0 + mu_out)) * cos(phi);
        const double albedo = work->scattering[i].restored;
        phase[i][0] = albedo * layer_phase(desc->layers + i, across + mu_in * mu_out);
        phase[i][1] = albedo * layer_phase(desc->layers + i, across - mu_in * mu_out);
    }
    const size_t at = ((size_t)(side * TSU_I_SLAB_KINDS + kind)) * pairs + out * users + in;
    for (uint32_t m = slab->modes; m-- > 0;)
        sum +=
            (m ? 2.0 : 1.0) * cos(m * phi) * work->multiple[m * 2 * TSU_I_SLAB_KINDS * pairs + at];
    sum +=
        single(work, desc, EXACT, side, in, backwards(side, kind), out, (const double(*)[2])phase);
    return sum / TSU_I_PI;
}

double tsu_i_slab_brdf(const struct tsu_i_slab *slab, int side, uint32_t in, uint32_t out,
                       double phi)
{
    return radiance(slab, side, TSU_I_SLAB_BACK, in, out, phi);
}

double tsu_i_slab_btdf(const struct tsu_i_slab *slab, int side, uint32_t in, uint32_t out,
                       double phi)
{
    return radiance(slab, side, TSU_I_SLAB_THROUGH, in, out, phi);
}

double tsu_i_slab_inside(const struct tsu_i_slab *slab, int side, int up, uint32_t in, uint32_t out,
                         double phi)
{
    const double n = slab->desc->layers[slab->desc->level_layer].n;
    return n * n * radiance(slab, side, up ? TSU_I_SLAB_UP : TSU_I_SLAB_DOWN, in, out, phi);
}

#include "optics/slab.h"

#include "optics/slab_work.h"

#include <math.h>
#include <string.h>

enum { MOST_DIRECTIONS = 64, MOST_MOMENTS = 4096 };
static const double highest_index = 4.0;

static int within(double x, double low, double high)
{
    return x >= low && x <= high;
}

static const char *check_layer(const struct tsu_i_slab_layer *layer)
{
    if (!within(layer->n, 1.0, highest_index))
        return "layers.n is not in [1, 4]";
    if (!within(layer->albedo, 0.0, 1.0))
        return "layers.albedo is not in [0, 1]";
    if (!(layer->depth >= 0.0))
        return "layers.depth is not in [0, infinity]";
    if (!layer->chi)
        return layer->g > -1.0 && layer->g < 1.0 ? NULL : "layers.g is not in (-1, 1)";
    if (layer->chi_count < 1 || layer->chi_count > MOST_MOMENTS)
        return "layers.chi_count is not in [1, 4096]";
    for (uint32_t l = 0; l < layer->chi_count; l++)
        if (!within(layer->chi[l], -1.0, 1.0) || (l == 0 && layer->chi[l] != 1.0))
            return "layers.chi is not in [-1, 1], or does not begin with 1";
    return NULL;
}

const char *tsu_i_slab_check(const struct tsu_i_slab_desc *desc)
{
    if (!desc->layers || desc->layer_count < 1 || desc->layer_count > TSU_I_SLAB_MOST_LAYERS)
        return "layer_count is not in [1, 64]";
    for (uint32_t i = 0; i < desc->layer_count; i++) {
        const char *bad = check_layer(desc->layers + i);
        if (bad)
            return bad;
    }
    if (!within(desc->slide_top, 1.0, highest_index))
        return "slide_top is not in [1, 4]";
    if (!within(desc->slide_bottom, 1.0, highest_index))
        return "slide_bottom is not in [1, 4]";
    if (desc->nodes < 4 || desc->nodes > TSU_I_SLAB_MOST_NODES)
        return "nodes is not in [4, 128]";
    if (desc->modes < 1 || desc->modes > TSU_I_SLAB_MOMENTS * desc->nodes)
        return "modes is not in [1, 8 nodes]";
    if (desc->direction_count > MOST_DIRECTIONS || (desc->direction_count && !desc->directions))
        return "direction_count is not in [0, 64]";
    for (uint32_t i = 0; i < desc->direction_count; i++) {
        if (!(desc->directions[i].mu > 0.0 && desc->directions[i].mu <= 1.0))
            return "directions.mu is not in (0, 1]";
        if (!within(desc->directions[i].n, 1.0, highest_index))
            return "directions.n is not in [1, 4]";
    }
    if (!desc->inside_wanted)
        return NULL;
    if (desc->level_layer >= desc->layer_count)
        return "level_layer is not a layer";
    // A level at infinite depth would be nowhere.
    if (!(desc->level_depth >= 0.0 && desc->level_depth <= desc->layers[desc->level_layer].depth) ||
        isinf(desc->level_depth))
        return "level_depth is not in the layer";
    return NULL;
}

// Where everything lies; with no base, how much it is.
struct room {
    double *base;
    size_t used;
};

static double *take(struct room *room, size_t doubles)
{
    double *const at = room->base ? room->base + room->used : NULL;
    room->used += doubles;
    return at;
}

// Doubles that hold so many bytes.
static size_t whole(size_t bytes)
{
    return (bytes + sizeof(double) - 1) / sizeof(double);
}

static void element(struct room *room, struct tsu_i_slab_element *e, size_t count, int matrices,
                    int same)
{
    for (int side = 0; side < 2; side++) {
        const int own = !(side && same);
        e->back[side] = !own ? e->back[0] : matrices ? take(room, count * count) : NULL;
        e->mirror[side] = own ? take(room, count) : e->mirror[0];
        e->lost[side] = own ? take(room, count) : e->lost[0];
        e->absorbed[side] = own ? take(room, count) : e->absorbed[0];
        e->kept[side] = own ? take(room, count) : e->kept[0];
    }
    e->through = matrices ? take(room, count * count) : NULL;
    e->straight = take(room, count);
    e->reach = 0;
}

static struct tsu_i_slab_work *layout(const struct tsu_i_slab_desc *desc, struct room *room,
                                      struct tsu_i_slab_work *counted)
{
    double indices[TSU_I_SLAB_MOST_LAYERS + 1];
    double *const own = take(room, whole(sizeof(struct tsu_i_slab_work)));
    struct tsu_i_slab_work *const work = own ? (struct tsu_i_slab_work *)own : counted;
    const int users = (int)desc->direction_count;
    const int gauss = tsu_i_slab_indices(desc, indices) * (int)desc->nodes;
    const size_t n = (size_t)(users + gauss), moments = TSU_I_SLAB_MOMENTS * (size_t)desc->nodes;
    const size_t fine = moments + 2 * (size_t)desc->nodes;
    const size_t layers = desc->layer_count, pairs = (size_t)users * (size_t)users;
    work->users = users;
    work->count = (int)n;
    work->nodes = (int)desc->nodes;
    work->moments = (int)moments;
    work->fine = (int)fine;
    work->normal2 = take(room, n);
    work->index = take(room, n);
    work->weight = take(room, n);
    work->fine_normal2 = take(room, fine * (n - (size_t)users) / desc->nodes);
    work->basis = take(room, fine * (n - (size_t)users));
    work->scattering = (struct tsu_i_slab_scattering *)take(
        room, whole(layers * sizeof(struct tsu_i_slab_scattering)));
    for (size_t i = 0; i < layers; i++) {
        double *const chi = take(room, moments), *const extinction = take(room, n);
        if (room->base) {
            work->scattering[i].chi = chi;
            work->scattering[i].extinction = extinction;
        }
    }
    element(room, &work->above, n, 1, 0);
    element(room, &work->below, n, desc->inside_wanted != 0, 0);
    element(room, &work->layer, n, 1, 1);
    element(room, &work->boundary, n, 0, 0);
    work->loop = take(room, n * n);
    work->spare = take(room, n * n);
    for (int side = 0; side < 2; side++) {
        work->down[side] = take(room, n * n);
        work->up[side] = side == 0 || desc->inside_wanted ? take(room, n * n) : NULL;
        work->down_straight[side] = take(room, n);
        work->up_straight[side] = take(room, n);
    }
    for (int i = 0; i < TSU_I_SLAB_SCRATCH; i++)
        work->scratch[i] = take(room, n > moments ? n : moments);
    work->functions = take(room, (n + 2) * moments);
    work->results = take(room, 16 * (size_t)users);
    work->part_count = desc->layer_count + (desc->inside_wanted != 0);
    work->parts =
        (struct tsu_i_slab_part *)take(room, whole(work->part_count * sizeof *work->parts));
    work->ladder = take(room, tsu_i_slab_single_doubles(users, work->part_count));
    work->multiple = take(room, desc->modes * 2 * TSU_I_SLAB_KINDS * pairs);
    return work;
}

size_t tsu_i_slab_doubles(const struct tsu_i_slab_desc *desc)
{
    struct tsu_i_slab_work counted;
    struct room room = {NULL, 0};
    layout(desc, &room, &counted);
    return room.used;
}

static void copy_element(const struct tsu_i_slab_work *work, const struct tsu_i_slab_element *from,
                         struct tsu_i_slab_element *to)
{
    const size_t vector = (size_t)work->count * sizeof(double);
    const size_t row = (size_t)from->reach * sizeof(double), pitch = (size_t)work->count;
    for (int side = 0; side < 2; side++) {
        memcpy(to->mirror[side], from->mirror[side], vector);
        memcpy(to->lost[side], from->lost[side], vector);
        memcpy(to->absorbed[side], from->absorbed[side], vector);
        memcpy(to->kept[side], from->kept[side], vector);
        for (size_t i = 0; i < (size_t)from->reach; i++)
            memcpy(to->back[side] + i * pitch, from->back[side] + i * pitch, row);
    }
    memcpy(to->straight, from->straight, vector);
    for (size_t i = 0; i < (size_t)from->reach; i++)
        memcpy(to->through + i * pitch, from->through + i * pitch, row);
    to->reach = from->reach;
}

// Put one more element under a stack, which may be empty.
static void push(struct tsu_i_slab_work *work, struct tsu_i_slab_element *stack, int *empty,
                 const struct tsu_i_slab_element *element, int mode)
{
    if (*empty)
        copy_element(work, element, stack);
    else
        tsu_i_slab_add(work, stack, element, mode, 0);
    *empty = 0;
}

static void push_boundary(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                          struct tsu_i_slab_element *stack, int *empty, uint32_t below, int mode)
{
    struct tsu_i_slab_element *e = &work->boundary;
    int clear = 1;
    for (int i = 0; i < work->count; i++) {
        e->straight[i] = tsu_i_slab_boundary(work, desc, below, i, &e->mirror[0][i]);
        e->mirror[1][i] = e->mirror[0][i];
        e->kept[0][i] = e->kept[1][i] = e->straight[i];
        for (int side = 0; side < 2; side++)
            e->lost[side][i] = e->absorbed[side][i] = 0.0;
        clear &= e->straight[i] == 1.0;
    }
    if (!clear)
        push(work, stack, empty, e, mode);
}

// The whole slab of one mode into work->above.
static void solve_mode(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc, int mode)
{
    struct tsu_i_slab_element *stack = &work->above;
    int empty = 1;
    for (uint32_t p = 0; p < work->part_count; p++) {
        const struct tsu_i_slab_part *part = work->parts + p;
        if (desc->inside_wanted && p == work->level) {
            stack = &work->below;
            empty = 1;
        } else {
            push_boundary(work, desc, stack, &empty, part->layer, mode);
        }
        tsu_i_slab_layer(work, desc->layers[part->layer].n, work->scattering + part->layer,
                         part->depth, mode);
        push(work, stack, &empty, &work->layer, mode);
    }
    push_boundary(work, desc, stack, &empty, desc->layer_count, mode);
    if (desc->inside_wanted)
        tsu_i_slab_add(work, &work->above, &work->below, mode, 1);
}

// Scattered power of a transposed kernel or of one that is not.
static double power_out(const struct tsu_i_slab_work *work, const double *kernel, int transposed,
                        int in)
{
    double sum = 0.0;
    for (int i = work->users; i < work->above.reach; i++) {
        const size_t row = (size_t)(transposed ? in : i), column = (size_t)(transposed ? i : in);
        sum += work->weight[i] * kernel[row * (size_t)work->count + column];
    }
    return sum;
}

// Of a node: power back, through, down and up at the level.
static void node_powers(const struct tsu_i_slab_work *work, int side, int node, int inside,
                        double out[4])
{
    const struct tsu_i_slab_element *whole = &work->above;
    out[0] = whole->mirror[side][node] + power_out(work, whole->back[side], 0, node);
    out[1] = whole->straight[node] + power_out(work, whole->through, side, node);
    out[2] = out[3] = 0.0;
    if (!inside)
        return;
    out[2] = work->down_straight[side][node] + power_out(work, work->down[side], 0, node);
    out[3] = work->up_straight[side][node] + power_out(work, work->up[side], 0, node);
}

// Radiance at the level along a direction under a sky of radiance 1: outside are the nodes of the
// first interval, and their weights add up to 1.
static double sky(const struct tsu_i_slab_work *work, const double *straight, const double *kernel,
                  int direction, double n)
{
    double sum = straight[direction];
    if (work->above.reach > 0)
        for (int i = work->users; i < work->users + work->nodes; i++)
            sum += kernel[(size_t)direction * (size_t)work->count + (size_t)i] * work->weight[i];
    return n * n * sum;
}

static void powers(struct tsu_i_slab *slab, struct tsu_i_slab_work *work)
{
    const struct tsu_i_slab_desc *desc = slab->desc;
    const int inside = desc->inside_wanted != 0;
    const double n = inside ? desc->layers[desc->level_layer].n : 1.0;
    double *at = work->results;
    for (int side = 0; side < 2; side++) {
        double *of[8], total[4] = {0.0, 0.0, 0.0, 0.0}, node[4];
        for (int k = 0; k < 8; k++, at += work->users)
            of[k] = at;
        for (int u = 0; u < work->users; u++) {
            node_powers(work, side, u, inside, node);
            for (int k = 0; k < 4; k++)
                of[k][u] = node[k];
            of[4][u] = tsu_i_slab_unscattered(work, desc, side, u, of[5] + u);
            if (inside) {
                of[6][u] = sky(work, work->down_straight[side], work->down[side], u, n);
                of[7][u] = sky(work, work->up_straight[side], work->up[side], u, n);
            }
        }
        slab->reflectance[side] = of[0];
        slab->transmittance[side] = of[1];
        slab->inside_down[side] = inside ? of[2] : NULL;
        slab->inside_up[side] = inside ? of[3] : NULL;
        slab->specular[side] = of[4];
        slab->direct[side] = of[5];
        slab->sky_down[side] = inside ? of[6] : NULL;
        slab->sky_up[side] = inside ? of[7] : NULL;
        for (int i = work->users; i < work->users + work->nodes; i++) {
            node_powers(work, side, i, inside, node);
            for (int k = 0; k < 4; k++)
                total[k] += work->weight[i] * node[k];
        }
        slab->diffuse_reflectance[side] = total[0];
        slab->diffuse_transmittance[side] = total[1];
        slab->diffuse_inside_down[side] = total[2];
        slab->diffuse_inside_up[side] = total[3];
    }
}

// Kernels between directions. True while a mode adds something to any of them.
static int keep_mode(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                     uint32_t mode)
{
    const struct tsu_i_slab_element *whole = &work->above;
    const size_t users = (size_t)work->users, pitch = (size_t)work->count, pairs = users * users;
    const size_t size = 2 * TSU_I_SLAB_KINDS * pairs;
    double *const of_mode = work->multiple + mode * size;
    int changes = 0;
    memset(of_mode, 0, size * sizeof *of_mode);
    if (whole->reach == 0)
        return 0; // nothing scatters in this mode
    for (int side = 0; side < 2; side++)
        for (size_t out = 0; out < users; out++)
            for (size_t in = 0; in < users; in++) {
                const size_t at = out * pitch + in;
                double *to = of_mode + (size_t)side * TSU_I_SLAB_KINDS * pairs + out * users + in;
                to[TSU_I_SLAB_BACK * pairs] = whole->back[side][at];
                to[TSU_I_SLAB_THROUGH * pairs] = whole->through[side ? in * pitch + out : at];
                to[TSU_I_SLAB_UP * pairs] = desc->inside_wanted ? work->up[side][at] : 0.0;
                to[TSU_I_SLAB_DOWN * pairs] = desc->inside_wanted ? work->down[side][at] : 0.0;
            }
    tsu_i_slab_single_remove(work, desc, mode);
    for (size_t i = 0; i < size; i++)
        changes |= fabs(of_mode[i]) > 1e-9 * fabs(work->multiple[i]);
    return changes;
}

void tsu_i_slab_solve(struct tsu_i_slab *slab, const struct tsu_i_slab_desc *desc, double *memory)
{
    struct room room = {memory, 0};
    struct tsu_i_slab_work *const work = layout(desc, &room, NULL);
    uint32_t quiet = 0;
    slab->desc = desc;
    slab->work = work;
    tsu_i_slab_nodes(work, desc);
    work->functions_n = 0.0;
    for (uint32_t i = 0; i < desc->layer_count; i++)
        tsu_i_slab_scattering(work, desc->layers + i, work->scattering + i);
    work->level = 0;
    for (uint32_t i = 0, p = 0; i < desc->layer_count; i++) {
        const double stretch = work->scattering[i].stretch, depth = desc->layers[i].depth;
        const int split = desc->inside_wanted && i == desc->level_layer;
        if (split)
            work->parts[p++] = (struct tsu_i_slab_part){i, stretch * desc->level_depth};
        work->level = split ? p : work->level;
        work->parts[p++] =
            (struct tsu_i_slab_part){i, stretch * (split ? depth - desc->level_depth : depth)};
    }
    tsu_i_slab_single_begin(work, desc);
    for (slab->modes = 0; slab->modes < desc->modes && quiet < 2; slab->modes++) {
        solve_mode(work, desc, (int)slab->modes);
        if (slab->modes == 0)
            powers(slab, work);
        quiet = keep_mode(work, desc, slab->modes) ? 0 : quiet + 1;
    }
}

// Adding: what two stacks do together.
#include "optics/dense.h"
#include "optics/slab_work.h"

#include <string.h>

// out += a * b, kernels of so many nodes.
static void star(const struct tsu_i_slab_work *work, int a_reach, const double *a, int b_reach,
                 const double *b, double *out)
{
    const size_t pitch = (size_t)work->count, first = (size_t)work->users;
    const int inner = (a_reach < b_reach ? a_reach : b_reach) - work->users;
    double *weights = work->scratch[0];
    if (inner <= 0)
        return;
    for (size_t i = 0; i < (size_t)a_reach; i++) {
        for (size_t k = 0; k < (size_t)inner; k++)
            weights[k] = a[i * pitch + first + k] * work->weight[first + k];
        tsu_i_dense_rows(inner, weights, b + first * pitch, pitch, b_reach, out + i * pitch);
    }
}

// out += a with its rows, columns scaled.
static void scaled(const struct tsu_i_slab_work *work, int reach, const double *rows,
                   const double *columns, const double *a, double *out)
{
    const size_t pitch = (size_t)work->count;
    for (size_t i = 0; i < (size_t)reach; i++)
        for (size_t j = 0; j < (size_t)reach; j++)
            out[i * pitch + j] += a[i * pitch + j] * (rows ? rows[i] : columns[j]);
}

static void plain(const struct tsu_i_slab_work *work, int reach, const double *a, double *out)
{
    const size_t pitch = (size_t)work->count;
    for (size_t i = 0; i < (size_t)reach; i++)
        for (size_t j = 0; j < (size_t)reach; j++)
            out[i * pitch + j] += a[i * pitch + j];
}

static void transpose(const struct tsu_i_slab_work *work, int reach, const double *a, double *out)
{
    const size_t pitch = (size_t)work->count;
    for (size_t i = 0; i < (size_t)reach; i++)
        for (size_t j = 0; j < (size_t)reach; j++)
            out[i * pitch + j] = a[j * pitch + i];
}

// Zero from node `from` on, up to `reach`.
static void clear(const struct tsu_i_slab_work *work, int from, int reach, double *a)
{
    const size_t pitch = (size_t)work->count;
    for (int i = 0; i < reach; i++) {
        const int start = i < from ? from : 0;
        memset(a + (size_t)i * pitch + (size_t)start, 0, (size_t)(reach - start) * sizeof *a);
    }
}

void tsu_i_slab_powers(const struct tsu_i_slab_work *work, int reach, const double *v,
                       const double *kernel, double *out)
{
    double *weights = work->scratch[0];
    const size_t pitch = (size_t)work->count, first = (size_t)work->users;
    for (int j = 0; j < reach; j++)
        out[j] = 0.0;
    for (int i = work->users; i < reach; i++)
        weights[i] = work->weight[i] * v[i];
    if (reach > work->users)
        tsu_i_dense_rows(reach - work->users, weights + first, kernel + first * pitch, pitch, reach,
                         out);
}

double tsu_i_slab_power(const struct tsu_i_slab_work *work, int reach, const double *v,
                        const double *kernel, int i)
{
    double sum = 0.0;
    for (int j = work->users; j < reach; j++)
        sum += kernel[(size_t)i * (size_t)work->count + (size_t)j] * work->weight[j] * v[j];
    return sum;
}

void tsu_i_slab_eliminate(const struct tsu_i_slab_work *work, int reach, double *kernel,
                          const double *gap, double *balance, double *first, double *second)
{
    const size_t pitch = (size_t)work->count;
    const double *weight = work->weight;
    double *const right[2] = {first, second};
    double *inverse = work->scratch[0], *weights = work->scratch[1];
    const int sides = second ? 2 : 1;
    for (int k = work->users; k < reach; k++) {
        const double *row = kernel + (size_t)k * pitch;
        double pivot = gap[k] - row[k] * weight[k];
        if (balance) {
            pivot = balance[k];
            for (int i = k + 1; i < reach; i++)
                pivot += weight[i] * kernel[(size_t)i * pitch + (size_t)k];
        }
        // 0 only where nothing comes and nothing leaves: in a clear layer between two total
        // reflections.
        inverse[k] = pivot != 0.0 ? 1.0 / pivot : 0.0;
        const double share = weight[k] * inverse[k];
        if (balance)
            for (int j = k + 1; j < reach; j++)
                balance[j] += share * balance[k] * row[j];
        for (int i = k + 1; i < reach; i++) {
            double *other = kernel + (size_t)i * pitch;
            const double factor = other[k] * share;
            if (factor == 0.0)
                continue;
            tsu_i_dense_rows(1, &factor, row + k + 1, pitch, reach - k - 1, other + k + 1);
            for (int s = 0; s < sides; s++)
                tsu_i_dense_rows(1, &factor, right[s] + (size_t)k * pitch, pitch, reach,
                                 right[s] + (size_t)i * pitch);
        }
    }
    for (int i = reach - 1; i >= 0; i--) {
        const int from = i < work->users ? work->users : i + 1;
        for (int k = from; k < reach; k++)
            weights[k] = kernel[(size_t)i * pitch + (size_t)k] * weight[k];
        const double scale = i >= work->users ? inverse[i] : gap[i] != 0.0 ? 1.0 / gap[i] : 0.0;
        for (int s = 0; s < sides; s++) {
            double *out = right[s] + (size_t)i * pitch;
            tsu_i_dense_rows(reach - from, weights + from, right[s] + (size_t)from * pitch, pitch,
                             reach, out);
            for (int j = 0; j < reach; j++)
                out[j] *= scale;
        }
    }
}

// Shares of the never scattered light in `above` and `below`, out of add(): both may change.
struct shares {
    double *turn, *drop; // above: mirror from below, straight
    double *pass, *face; // below: straight, mirror from the top
    double *gap;         // 1 - turn face, from losses: exact also next to 0
};

static void add_straight(struct tsu_i_slab_work *work, struct tsu_i_slab_element *above,
                         const struct tsu_i_slab_element *below, const struct shares *old)
{
    for (int i = 0; i < work->count; i++) {
        const double turn = above->mirror[1][i], drop = above->straight[i];
        const double pass = below->straight[i], face = below->mirror[0][i];
        const double far = below->mirror[1][i];
        const double loss[4] = {above->lost[0][i], above->lost[1][i], below->lost[0][i],
                                below->lost[1][i]};
        const double gap = drop + loss[1] + turn * (pass + loss[2]);
        const double inverse = gap > 0.0 ? 1.0 / gap : 0.0;
        const double down = drop * inverse, up = pass * inverse;
        old->turn[i] = turn;
        old->drop[i] = drop;
        old->pass[i] = pass;
        old->face[i] = face;
        old->gap[i] = gap;
        work->down_straight[0][i] = down;
        work->up_straight[0][i] = down * face;
        work->down_straight[1][i] = up * turn;
        work->up_straight[1][i] = up;
        above->mirror[0][i] += drop * down * face;
        above->mirror[1][i] = far + pass * up * turn;
        above->straight[i] = down * pass;
        above->lost[0][i] = loss[0] + down * (loss[2] + face * loss[1]);
        above->lost[1][i] = loss[3] + up * (loss[1] + turn * loss[2]);
    }
}

// One way to and fro between the two, and what leaves it for good.
static void add_loop(struct tsu_i_slab_work *work, const struct tsu_i_slab_element *above,
                     const struct tsu_i_slab_element *below, int reach, const struct shares *old)
{
    clear(work, 0, reach, work->loop);
    scaled(work, below->reach, old->turn, NULL, below->back[0], work->loop);
    scaled(work, above->reach, NULL, old->face, above->back[1], work->loop);
    star(work, above->reach, above->back[1], below->reach, below->back[0], work->loop);
}

// Power of light going down between the two that meets what is `of_below`, or on its first way up
// what is `of_above`.
static void met(const struct tsu_i_slab_work *work, const struct tsu_i_slab_element *below,
                const double *face, const double *of_below, const double *of_above, double *out)
{
    memset(out, 0, (size_t)work->count * sizeof *out);
    tsu_i_slab_powers(work, below->reach, of_above, below->back[0], out);
    for (int j = 0; j < work->count; j++)
        out[j] += of_below[j] + face[j] * of_above[j];
}

// What is absorbed of light from either side: on the way in, and of what then goes down.
static void add_absorbed(struct tsu_i_slab_work *work, struct tsu_i_slab_element *above,
                         const struct tsu_i_slab_element *below, int reach,
                         const struct shares *old, const double *danger)
{
    double *first = work->scratch[1], *later = work->scratch[2];
    for (int side = above == below ? 0 : 1; side >= 0; side--) {
        memset(later, 0, (size_t)work->count * sizeof *later);
        tsu_i_slab_powers(work, reach, danger, work->down[side], later);
        for (int j = 0; j < work->count; j++) {
            first[j] = above->absorbed[0][j];
            if (side)
                first[j] =
                    below->absorbed[1][j] + old->pass[j] * above->absorbed[1][j] +
                    (j < below->reach ? tsu_i_slab_power(work, below->reach, above->absorbed[1],
                                                         below->through, j)
                                      : 0.0);
        }
        for (int j = 0; j < work->count; j++)
            above->absorbed[side][j] =
                first[j] + later[j] + work->down_straight[side][j] * danger[j];
    }
}

// What is not sent back. Where most of it is, what is sent back is held to the rest: the ripple of
// a phase function that the nodes do not carry would else show in a stack that absorbs nothing.
static void add_kept(const struct tsu_i_slab_work *work, struct tsu_i_slab_element *above)
{
    const int reach = above->reach;
    const size_t pitch = (size_t)work->count;
    double *ones = work->scratch[1], *through = work->scratch[2], *back = work->scratch[3];
    for (int j = 0; j < work->count; j++)
        ones[j] = 1.0;
    for (int side = above->kept[1] == above->kept[0] ? 0 : 1; side >= 0; side--) {
        memset(through, 0, pitch * sizeof *through);
        memset(back, 0, pitch * sizeof *back);
        if (side)
            for (int j = 0; j < reach; j++)
                through[j] = tsu_i_slab_power(work, reach, ones, above->through, j);
        else
            tsu_i_slab_powers(work, reach, ones, above->through, through);
        tsu_i_slab_powers(work, reach, ones, above->back[side], back);
        for (int j = 0; j < work->count; j++) {
            const double rest = above->lost[side][j] - above->absorbed[side][j] - through[j];
            above->kept[side][j] = above->straight[j] + above->absorbed[side][j] + through[j];
            back[j] = rest > 0.25 && back[j] > 0.25 ? rest / back[j] : 1.0;
        }
        for (size_t i = 0; i < (size_t)reach; i++)
            for (size_t j = 0; j < (size_t)reach; j++)
                above->back[side][i * pitch + j] *= back[j];
    }
}

void tsu_i_slab_add(struct tsu_i_slab_work *work, struct tsu_i_slab_element *above,
                    const struct tsu_i_slab_element *below, int mode, int between)
{
    const int a = above->reach, b = below->reach, reach = a > b ? a : b;
    const int same = above == below;
    double *balance = work->scratch[2], *danger = work->scratch[3];
    const struct shares old = {work->scratch[4], work->scratch[5], work->scratch[6],
                               work->scratch[7], work->scratch[8]};
    double **const down = work->down, **const up = work->up;
    add_straight(work, above, below, &old);
    if (mode == 0) {
        met(work, below, old.face, below->kept[0], above->kept[1], balance);
        met(work, below, old.face, below->absorbed[0], above->absorbed[1], danger);
    }
    clear(work, a, reach, above->back[0]);
    clear(work, a, reach, above->through);
    add_loop(work, above, below, reach, &old);
    clear(work, 0, reach, down[0]);
    scaled(work, reach, NULL, work->down_straight[0], work->loop, down[0]);
    plain(work, a, above->through, down[0]);
    if (!same) {
        transpose(work, b, below->through, work->spare);
        clear(work, 0, reach, down[1]);
        scaled(work, b, old.turn, NULL, work->spare, down[1]);
        scaled(work, a, NULL, old.pass, above->back[1], down[1]);
        star(work, a, above->back[1], b, work->spare, down[1]);
        scaled(work, reach, NULL, work->down_straight[1], work->loop, down[1]);
    }
    tsu_i_slab_eliminate(work, reach, work->loop, old.gap, mode == 0 ? balance : NULL, down[0],
                         same ? NULL : down[1]);
    if (between) {
        clear(work, 0, reach, up[1]);
        plain(work, b, work->spare, up[1]);
        scaled(work, reach, old.face, NULL, down[1], up[1]);
        scaled(work, b, NULL, work->down_straight[1], below->back[0], up[1]);
        star(work, b, below->back[0], reach, down[1], up[1]);
    }
    clear(work, 0, reach, up[0]);
    scaled(work, reach, old.face, NULL, down[0], up[0]);
    scaled(work, b, NULL, work->down_straight[0], below->back[0], up[0]);
    star(work, b, below->back[0], reach, down[0], up[0]);
    if (mode == 0)
        add_absorbed(work, above, below, reach, &old, danger);
    // Back to the top, back to the bottom, through; in the order in which the old ones are read.
    transpose(work, a, above->through, work->spare);
    scaled(work, a, NULL, work->up_straight[0], work->spare, above->back[0]);
    scaled(work, reach, old.drop, NULL, up[0], above->back[0]);
    star(work, a, work->spare, reach, up[0], above->back[0]);
    clear(work, 0, reach, work->spare);
    scaled(work, b, NULL, work->down_straight[0], below->through, work->spare);
    scaled(work, reach, old.pass, NULL, down[0], work->spare);
    star(work, b, below->through, reach, down[0], work->spare);
    if (!same) {
        clear(work, 0, reach, above->back[1]);
        plain(work, b, below->back[1], above->back[1]);
        scaled(work, b, NULL, work->down_straight[1], below->through, above->back[1]);
        scaled(work, reach, old.pass, NULL, down[1], above->back[1]);
        star(work, b, below->through, reach, down[1], above->back[1]);
    }
    double *const through = work->spare;
    work->spare = above->through;
    above->through = through;
    above->reach = reach;
    if (mode == 0)
        add_kept(work, above);
}

#include "optics/leaf_inverse.h"

#include "optics/slab.h"

#include <math.h>
#include <string.h>

// Nodes of slab.h for slopes and for values; faces err by 3e-4 and 1.3e-6.
enum { COARSE = 3, FINE = 8 };
enum { R_LIT, R_OTHER, T_LIT, FACES };
enum { SCATTER_DEEP, ABSORPTION_CLEAR, ABSORPTION_DEEP, SCATTER_CLEAR, UNKNOWNS };

static const double clear_scatter = 0.1;
static const double enough = 1e-8; // where Newton's steps stop
static const double good = 1e-6;   // where no other start is tried
// Depths: nothing is clearer or deeper. SCATTER_ and ABSORPTION_ of either layer are alike.
static const double least = 1e-7;
static const double most[UNKNOWNS] = {50, 60, 60, 50};
static const double dark = 1e-4; // added to faces before their logarithm

// A question in the frame of the leaf whose clear layer is on top: `mirrored` when that is the
// lower one.
struct search {
    double n, g;
    int mirrored;
    double asked[FACES];
    double floor[FACES]; // what is left of a face without its inside
    double weight[FACES];
    double *memory;
    int solutions;
};

// A place: logarithms of the depths, and the faces there.
struct place {
    double x[UNKNOWNS];
    double faces[FACES];
};

double tsu_i_leaf_surface(double n)
{
    const double r = (n - 1.0) / (n + 1.0);
    return r * r;
}

// Two layers, clear one first.
static void describe(double n, double g, const double depth[UNKNOWNS], int nodes,
                     struct tsu_i_slab_layer layers[2], struct tsu_i_slab_desc *desc)
{
    static const struct tsu_i_slab_direction normal = {.mu = 1.0, .n = 1.0};
    const double scatter[2] = {depth[SCATTER_CLEAR], depth[SCATTER_DEEP]};
    const double absorption[2] = {depth[ABSORPTION_CLEAR], depth[ABSORPTION_DEEP]};
    for (int i = 0; i < 2; i++) {
        const double whole = scatter[i] / (1.0 - g), all = whole + absorption[i];
        layers[i] = (struct tsu_i_slab_layer){
            .n = n, .albedo = all > 0.0 ? whole / all : 0.0, .depth = all, .g = g};
    }
    *desc = (struct tsu_i_slab_desc){.layers = layers,
                                     .layer_count = 2,
                                     .slide_top = 1.0,
                                     .slide_bottom = 1.0,
                                     .nodes = (uint32_t)nodes,
                                     .modes = 1,
                                     .directions = &normal,
                                     .direction_count = 1};
}

static void solve(double n, double g, const double depth[UNKNOWNS], int nodes, int lit,
                  double faces[FACES], double *memory)
{
    struct tsu_i_slab_layer layers[2];
    struct tsu_i_slab_desc desc;
    struct tsu_i_slab slab;
    describe(n, g, depth, nodes, layers, &desc);
    tsu_i_slab_solve(&slab, &desc, memory);
    faces[R_LIT] = slab.reflectance[lit][0];
    faces[R_OTHER] = slab.reflectance[1 - lit][0];
    faces[T_LIT] = slab.transmittance[lit][0];
}

size_t tsu_i_leaf_inverse_doubles(void)
{
    static const double depth[UNKNOWNS] = {1.0, 1.0, 1.0, 1.0};
    struct tsu_i_slab_layer layers[2];
    struct tsu_i_slab_desc desc;
    describe(1.5, 0.5, depth, FINE, layers, &desc);
    return tsu_i_slab_doubles(&desc);
}

void tsu_i_leaf_solve(double n, double g, const struct tsu_i_leaf_layers *layers,
                      struct tsu_i_leaf_faces *faces, double *memory)
{
    const double depth[UNKNOWNS] = {layers->scatter_bottom, layers->absorption_top,
                                    layers->absorption_bottom, layers->scatter_top};
    double value[FACES];
    solve(n, g, depth, FINE, TSU_I_SLAB_TOP, value, memory);
    *faces = (struct tsu_i_leaf_faces){
        .R_top = value[R_LIT], .R_bottom = value[R_OTHER], .T = value[T_LIT]};
}

static void measure(struct search *search, const double x[UNKNOWNS], int nodes, double faces[FACES])
{
    double depth[UNKNOWNS];
    for (int i = 0; i < UNKNOWNS; i++)
        depth[i] = exp(x[i]);
    const int lit = search->mirrored ? TSU_I_SLAB_BOTTOM : TSU_I_SLAB_TOP;
    solve(search->n, search->g, depth, nodes, lit, faces, search->memory);
    search->solutions++;
}

// What is still wrong: plain differences, or logarithms scaled so that both agree near the end.
static void wrong(const struct search *search, const double faces[FACES], int plain,
                  double out[FACES])
{
    for (int k = 0; k < FACES; k++) {
        const double scale = fmax(search->asked[k] - search->floor[k], 0.0) + dark;
        const double here = fmax(faces[k] - search->floor[k] + dark, 1e-2 * dark);
        out[k] =
            search->weight[k] * (plain ? faces[k] - search->asked[k] : scale * log(here / scale));
    }
}

static double square(const double v[FACES])
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

static double residual(const struct search *search, const double faces[FACES])
{
    double worst = 0.0;
    for (int k = 0; k < FACES; k++)
        worst = fmax(worst, search->weight[k] * fabs(faces[k] - search->asked[k]));
    return worst;
}

// Shortest step of the unknowns that takes r away, damped: -J^T (J J^T + damping)^-1 r.
static void step(double slopes[FACES][UNKNOWNS], const double r[FACES], double damping,
                 double out[UNKNOWNS])
{
    double a[FACES][FACES], y[FACES], trace = 1e-300;
    for (int i = 0; i < FACES; i++)
        for (int k = 0; k < FACES; k++) {
            a[i][k] = 0.0;
            for (int u = 0; u < UNKNOWNS; u++)
                a[i][k] += slopes[i][u] * slopes[k][u];
        }
    for (int i = 0; i < FACES; i++)
        trace += a[i][i];
    for (int i = 0; i < FACES; i++) {
        a[i][i] += damping * trace;
        y[i] = r[i];
    }
    for (int i = 0; i < FACES; i++) // positive definite: no pivots
        for (int k = i + 1; k < FACES; k++) {
            const double share = a[k][i] / a[i][i];
            for (int j = i; j < FACES; j++)
                a[k][j] -= share * a[i][j];
            y[k] -= share * y[i];
        }
    for (int i = FACES - 1; i >= 0; i--) {
        for (int k = i + 1; k < FACES; k++)
            y[i] -= a[i][k] * y[k];
        y[i] /= a[i][i];
    }
    double longest = 0.0;
    for (int u = 0; u < UNKNOWNS; u++) {
        out[u] = 0.0;
        for (int i = 0; i < FACES; i++)
            out[u] -= slopes[i][u] * y[i];
        longest = fmax(longest, fabs(out[u]));
    }
    for (int u = 0; u < UNKNOWNS && longest > 2.0; u++)
        out[u] *= 2.0 / longest;
}

// Slopes over the first `unknowns` of them.
static void differentiate(struct search *search, const struct place *at, int unknowns, int plain,
                          double slopes[FACES][UNKNOWNS])
{
    const double by = 1e-3;
    double faces[FACES], here[FACES], there[FACES];
    memset(slopes, 0, sizeof(double) * FACES * UNKNOWNS);
    measure(search, at->x, COARSE, faces);
    wrong(search, faces, plain, here);
    for (int u = 0; u < unknowns; u++) {
        double x[UNKNOWNS];
        memcpy(x, at->x, sizeof x);
        const double forth = x[u] + by > log(most[u]) ? -by : by;
        x[u] += forth;
        measure(search, x, COARSE, faces);
        wrong(search, faces, plain, there);
        for (int k = 0; k < FACES; k++)
            slopes[k][u] = (there[k] - here[k]) / forth;
    }
}

// Damped Newton steps from `at`, which is left at the best place.
static void descend(struct search *search, struct place *at, int unknowns, int plain, int steps)
{
    double r[FACES], damping = 1e-3;
    int slow = 0;
    measure(search, at->x, FINE, at->faces);
    wrong(search, at->faces, plain, r);
    for (int i = 0; i < steps && slow < 4 && residual(search, at->faces) > enough; i++) {
        double slopes[FACES][UNKNOWNS], before = square(r), now = before;
        differentiate(search, at, unknowns, plain, slopes);
        for (int attempt = 0; attempt < 8 && now >= before; attempt++) {
            struct place to;
            double move[UNKNOWNS], r_to[FACES];
            step(slopes, r, damping, move);
            for (int u = 0; u < UNKNOWNS; u++)
                to.x[u] = fmin(fmax(at->x[u] + move[u], log(least)), log(most[u]));
            measure(search, to.x, FINE, to.faces);
            wrong(search, to.faces, plain, r_to);
            now = square(r_to);
            if (now < before) {
                *at = to;
                memcpy(r, r_to, sizeof r);
                damping = fmax(0.1 * damping, 1e-12);
            } else {
                damping = fmax(8.0 * damping, 1e-6);
            }
        }
        if (now >= before)
            return;
        slow = now > 0.98 * before ? slow + 1 : 0;
    }
}

// Two starts, the best and the best of the other half of the grid, by logarithms of the faces.
static void starts(struct search *search, struct place found[2])
{
    static const double absorptions[] = {0.01, 0.1, 0.4, 1.2, 3.0, 6.0};
    static const double scatters[] = {0.02, 0.2, 0.9, 2.2, 6.0, 20.0};
    double best[2] = {INFINITY, INFINITY};
    for (int i = 0; i < 36; i++) {
        const int half = (i + i / 6) % 2;
        const double a = absorptions[i / 6], s = scatters[i % 6], share = half ? 0.5 : 0.3;
        struct place at = {.x = {log(s), log(share * a), log((1.0 - share) * a),
                                 log(fmin(clear_scatter, 0.5 * s))}};
        double off = 0.0;
        measure(search, at.x, COARSE, at.faces);
        for (int k = 0; k < FACES; k++) {
            const double asked = fmax(search->asked[k] - search->floor[k], 0.0) + dark;
            const double ratio = log(fmax(at.faces[k] - search->floor[k] + dark, dark) / asked);
            off += search->weight[k] * ratio * ratio;
        }
        if (off < best[half]) {
            best[half] = off;
            found[half] = at;
        }
    }
    if (best[1] < best[0]) {
        const struct place first = found[0];
        found[0] = found[1];
        found[1] = first;
    }
}

static void keep_better(const struct search *search, const struct place *now, struct place *best)
{
    if (residual(search, now->faces) < residual(search, best->faces))
        *best = *now;
}

// The clear layer's scattering held, then free, then from elsewhere, then the nearest.
static void invert(struct search *search, struct place *best)
{
    struct place start[2], at;
    starts(search, start);
    at = start[0];
    at.x[SCATTER_CLEAR] = log(clear_scatter);
    descend(search, &at, UNKNOWNS - 1, 0, 15);
    *best = at;
    for (int i = 0; i < 2 && residual(search, best->faces) > good; i++) {
        at = start[i];
        descend(search, &at, UNKNOWNS, 0, 30);
        keep_better(search, &at, best);
    }
    if (residual(search, best->faces) > good) {
        at = *best;
        descend(search, &at, UNKNOWNS, 1, 40);
        keep_better(search, &at, best);
    }
}

static double share(double x)
{
    return fmin(fmax(x, 0.0), 1.0);
}

static void open_search(const struct tsu_i_leaf_question *question, struct search *search,
                        double *memory)
{
    const struct tsu_i_leaf_faces *faces = &question->faces;
    const double surface = tsu_i_leaf_surface(question->n);
    *search =
        (struct search){.n = question->n,
                        .g = question->g,
                        .mirrored = faces->R_bottom < faces->R_top,
                        .asked = {share(faces->R_top), share(faces->R_bottom), share(faces->T)},
                        .floor = {surface, surface, 0.0},
                        .weight = {1.0, 1.0, 1.0},
                        .memory = memory};
}

static enum tsu_i_leaf_answer reason(const struct tsu_i_leaf_question *question)
{
    const struct tsu_i_leaf_faces *faces = &question->faces;
    const double surface = tsu_i_leaf_surface(question->n);
    if (fmax(faces->R_top, faces->R_bottom) + faces->T > 1.0)
        return TSU_I_LEAF_ENERGY;
    if (fmin(faces->R_top, faces->R_bottom) < surface || faces->T < 0.0)
        return TSU_I_LEAF_SURFACE;
    return TSU_I_LEAF_REACH;
}

static void answer(const struct search *search, const struct tsu_i_leaf_question *question,
                   const struct place *best, struct tsu_i_leaf_inverse *out)
{
    const double clear_s = exp(best->x[SCATTER_CLEAR]), clear_a = exp(best->x[ABSORPTION_CLEAR]);
    const double deep_s = exp(best->x[SCATTER_DEEP]), deep_a = exp(best->x[ABSORPTION_DEEP]);
    *out = (struct tsu_i_leaf_inverse){
        .layers = {.scatter_top = search->mirrored ? deep_s : clear_s,
                   .absorption_top = search->mirrored ? deep_a : clear_a,
                   .scatter_bottom = search->mirrored ? clear_s : deep_s,
                   .absorption_bottom = search->mirrored ? clear_a : deep_a},
        .faces = {.R_top = best->faces[R_LIT],
                  .R_bottom = best->faces[R_OTHER],
                  .T = best->faces[T_LIT]},
        .solutions = search->solutions};
    const double off[FACES] = {out->faces.R_top - question->faces.R_top,
                               out->faces.R_bottom - question->faces.R_bottom,
                               out->faces.T - question->faces.T};
    for (int k = 0; k < FACES; k++)
        out->residual = fmax(out->residual, fabs(off[k]));
    out->answer = out->residual <= TSU_I_LEAF_ENOUGH ? TSU_I_LEAF_REACHED : reason(question);
}

void tsu_i_leaf_invert(const struct tsu_i_leaf_question *question, struct tsu_i_leaf_inverse *out,
                       double *memory)
{
    struct search search;
    struct place best;
    open_search(question, &search, memory);
    invert(&search, &best);
    answer(&search, question, &best, out);
}

void tsu_i_leaf_invert_near(const struct tsu_i_leaf_question *question,
                            struct tsu_i_leaf_inverse *out, double *memory)
{
    tsu_i_leaf_invert(question, out, memory);
    if (out->answer == TSU_I_LEAF_REACHED)
        return;
    // All pigment in the clear layer, and no word about the other face.
    const int before = out->solutions;
    struct search search;
    struct place start[2];
    open_search(question, &search, memory);
    search.weight[R_OTHER] = 0.0;
    starts(&search, start);
    start[0].x[SCATTER_CLEAR] = log(clear_scatter);
    start[0].x[ABSORPTION_DEEP] = log(least);
    descend(&search, start, 2, 0, 30);
    struct tsu_i_leaf_question kept = *question;
    kept.faces.R_bottom = start[0].faces[R_OTHER];
    if (residual(&search, start[0].faces) <= TSU_I_LEAF_ENOUGH) {
        answer(&search, &kept, start, out);
        out->solutions += before;
        return;
    }
    // R_top and T are impossible by themselves: the nearest, the wish counting little.
    struct place best;
    search.weight[R_OTHER] = 0.1;
    invert(&search, &best);
    kept.faces.R_bottom = best.faces[R_OTHER];
    answer(&search, &kept, &best, out);
    out->solutions += before;
}

#include "optics/slab_spread.h"

#include "optics/angle.h"
#include "optics/fresnel_moment.h"
#include "optics/quadrature.h"

#include <math.h>
#include <string.h>

enum {
    CELLS = 48,
    NODES = CELLS + 1,
    HALF = 8, // cosines on each side of the critical angle
    COSINES = 2 * HALF,
    AZIMUTHS = 8, // in a quarter of the circle
    DEGREES = 12, // most L + 1
    FIELDS = DEGREES * (DEGREES + 1) / 2,
    STEPS = 96 // most iterations
};
static const double forward_bound = 0.03; // of the phase function left to `straight`
static const double enough = 1e-6;

// A complex number for each azimuth.
struct lanes {
    double re[AZIMUTHS], im[AZIMUTHS];
};

// Of a cell's optical path x along a direction: e^-x, f = (1 - e^-x) / x, (1 - f) / x.
struct path {
    struct lanes e, f, s;
};

struct cell {
    double width, extinction, scatter; // per length, delta-M
    double bend[4];                    // -width^2 / 12 times the second difference of 4 nodes
};

struct problem {
    int degrees, fields, size;
    struct cell cell[CELLS];
    double cosine[COSINES], weight[COSINES], reflectance[COSINES]; // weight: in the cosine
    double legendre[COSINES][FIELDS], source[COSINES][FIELDS];     // source: times phase moment
    double turn[AZIMUTHS][DEGREES];                                // cos(m phi)
    struct path path[COSINES][CELLS];
    double reflected, through; // of the last sweep
    double hessenberg[STEPS + 1][STEPS], turned[STEPS + 1], cosines[STEPS], sines[STEPS];
};

static int field(int l, int m)
{
    return l * (l + 1) / 2 + m;
}

static int degrees_of(double g)
{
    int degrees = 1;
    while (degrees < DEGREES && pow(fabs(g), degrees) > forward_bound)
        degrees++;
    return degrees;
}

size_t tsu_i_spread_bytes(const struct tsu_i_spread_slab *slab)
{
    const int degrees = degrees_of(slab->g);
    const size_t size = (size_t)(degrees * (degrees + 1) / 2 * NODES);
    return sizeof(struct problem) + (STEPS + 4) * size * sizeof(double);
}

// Nodes as those of Chebyshev in each layer; the parabola through a cell's nodes and their
// neighbours lies below the chord by width^2 / 12 of its second derivative in the mean.
static void set_cells(struct problem *p, const struct tsu_i_spread_slab *slab, double forward)
{
    int begin = 0;
    for (int i = 0; i < slab->layers; i++) {
        const struct tsu_i_spread_layer *layer = slab->layer + i;
        const int count = i + 1 < slab->layers ? CELLS / slab->layers : CELLS - begin;
        for (int c = 0; c < count; c++) {
            struct cell *cell = p->cell + begin + c;
            cell->width = layer->thickness * 0.5 *
                          (cos(TSU_I_PI * c / count) - cos(TSU_I_PI * (c + 1) / count));
            cell->scatter = layer->scatter * (1.0 - forward) / layer->thickness;
            cell->extinction = cell->scatter + layer->absorption / layer->thickness;
        }
        for (int c = 0; c < count; c++) {
            struct cell *cell = p->cell + begin + c;
            memset(cell->bend, 0, sizeof cell->bend);
            const int first = c > 0 ? c : 1, last = c + 1 < count ? c + 1 : count - 1;
            for (int node = first; node <= last; node++) {
                const double h0 = cell[node - c - 1].width, h1 = cell[node - c].width;
                const double share =
                    -cell->width * cell->width / 12.0 / (last - first + 1) * 2.0 / (h0 + h1);
                cell->bend[node - c] += share / h0;
                cell->bend[node - c + 1] -= share * (1.0 / h0 + 1.0 / h1);
                cell->bend[node - c + 2] += share / h1;
            }
        }
        begin += count;
    }
}

static void set_directions(struct problem *p, double n)
{
    double node[HALF], weight[HALF];
    const double critical = sqrt(1.0 - 1.0 / (n * n));
    tsu_i_quadrature_gauss(HALF, node, weight);
    for (int i = 0; i < HALF; i++) {
        const double x = 0.5 * (1.0 + node[i]), share = 0.5 * weight[i];
        const double inside = sqrt(1.0 - (1.0 - x * x) / (n * n));
        p->cosine[i] = fmax(critical * x, 1e-4); // n may be 1
        p->weight[i] = critical * share;
        p->cosine[HALF + i] = inside;
        p->weight[HALF + i] = share * x / (n * n * inside);
    }
    for (int i = 0; i < COSINES; i++)
        p->reflectance[i] = tsu_i_fresnel_inside(n, p->cosine[i]);
    for (int a = 0; a < AZIMUTHS; a++)
        for (int m = 0; m < DEGREES; m++)
            p->turn[a][m] = cos(m * 0.5 * TSU_I_PI * (a + 0.5) / AZIMUTHS);
}

// Spherical harmonics of a cosine without cos(m phi), of norm 1 on the sphere with it.
static void harmonics(int degrees, double cosine, double *out)
{
    double p[DEGREES][DEGREES], start = 1.0;
    const double sine = sqrt(1.0 - cosine * cosine);
    for (int m = 0; m < degrees; m++) {
        start *= m ? sqrt((2.0 * m - 1.0) / (2.0 * m)) * sine : 1.0;
        for (int l = m; l < degrees; l++) {
            p[l][m] = l == m       ? start
                      : l == m + 1 ? sqrt(2.0 * m + 1.0) * cosine * start
                                   : ((2.0 * l - 1.0) * cosine * p[l - 1][m] -
                                      sqrt((l - 1.0) * (l - 1.0) - m * m) * p[l - 2][m]) /
                                         sqrt((double)(l * l - m * m));
            out[field(l, m)] = sqrt((m ? 2.0 : 1.0) * (2.0 * l + 1.0) / (4.0 * TSU_I_PI)) * p[l][m];
        }
    }
}

static void set_path(struct path *path, int a, double re, double im)
{
    const double size = re * re + im * im, left = exp(-re);
    const double e[2] = {left * cos(im), -left * sin(im)};
    double f[2] = {1.0, 0.0}, s[2] = {0.5, 0.0};
    if (size < 1e-2) {
        double power[2] = {1.0, 0.0}, factorial = 1.0;
        for (int j = 1; j < 8; j++) {
            const double next = power[1] * im - power[0] * re;
            power[1] = -(power[0] * im + power[1] * re);
            power[0] = next;
            factorial *= j + 1;
            for (int part = 0; part < 2; part++) {
                f[part] += power[part] / factorial;
                s[part] += power[part] / (factorial * (j + 2));
            }
        }
    } else {
        f[0] = ((1.0 - e[0]) * re - e[1] * im) / size;
        f[1] = (-e[1] * re - (1.0 - e[0]) * im) / size;
        s[0] = ((1.0 - f[0]) * re - f[1] * im) / size;
        s[1] = (-f[1] * re - (1.0 - f[0]) * im) / size;
    }
    path->e.re[a] = e[0];
    path->e.im[a] = e[1];
    path->f.re[a] = f[0];
    path->f.im[a] = f[1];
    path->s.re[a] = s[0];
    path->s.im[a] = s[1];
}

static void set_paths(struct problem *p, double k)
{
    for (int i = 0; i < COSINES; i++)
        for (int c = 0; c < CELLS; c++) {
            const double way = p->cell[c].width / p->cosine[i];
            const double side = k * sqrt(1.0 - p->cosine[i] * p->cosine[i]) * way;
            for (int a = 0; a < AZIMUTHS; a++)
                set_path(&p->path[i][c], a, p->cell[c].extinction * way, side * p->turn[a][1]);
        }
}

static void set_problem(struct problem *p, const struct tsu_i_spread_slab *slab, double k)
{
    memset(p, 0, sizeof *p);
    p->degrees = degrees_of(slab->g);
    p->fields = p->degrees * (p->degrees + 1) / 2;
    p->size = p->fields * NODES;
    // g < 0 has no forward peak to leave out.
    const double forward = slab->g > 0.0 ? pow(slab->g, p->degrees) : 0.0;
    set_cells(p, slab, forward);
    set_directions(p, slab->n);
    for (int i = 0; i < COSINES; i++) {
        harmonics(p->degrees, p->cosine[i], p->legendre[i]);
        for (int l = 0; l < p->degrees; l++)
            for (int m = 0; m <= l; m++)
                p->source[i][field(l, m)] = p->legendre[i][field(l, m)] *
                                            ((l ? pow(slab->g, l) : 1.0) - forward) /
                                            (1.0 - forward);
    }
    set_paths(p, k);
}

static inline void multiply(const struct lanes *x, const struct lanes *y, struct lanes *out)
{
    for (int a = 0; a < AZIMUTHS; a++) {
        const double re = x->re[a] * y->re[a] - x->im[a] * y->im[a];
        out->im[a] = x->re[a] * y->im[a] + x->im[a] * y->re[a];
        out->re[a] = re;
    }
}

// Through a cell: `light` before it becomes the light behind it; the source goes from `begin` to
// `end`, each plus `bent`, times `scale`.
static inline void pass(const struct path *path, double scale, const struct lanes *begin,
                        const struct lanes *end, const struct lanes *bent, struct lanes *light)
{
    for (int a = 0; a < AZIMUTHS; a++) {
        const double f0 = path->f.re[a] - path->s.re[a], f1 = path->f.im[a] - path->s.im[a];
        const double b0 = scale * (begin->re[a] + bent->re[a]);
        const double b1 = scale * (begin->im[a] + bent->im[a]);
        const double e0 = scale * (end->re[a] + bent->re[a]);
        const double e1 = scale * (end->im[a] + bent->im[a]);
        const double re = path->e.re[a] * light->re[a] - path->e.im[a] * light->im[a] +
                          path->s.re[a] * e0 - path->s.im[a] * e1 + f0 * b0 - f1 * b1;
        light->im[a] = path->e.re[a] * light->im[a] + path->e.im[a] * light->re[a] +
                       path->s.re[a] * e1 + path->s.im[a] * e0 + f0 * b1 + f1 * b0;
        light->re[a] = re;
    }
}

// Source per steradian over the cosine, down and up, at the nodes.
static void set_source(const struct problem *p, int i, const double *moments, struct lanes *down,
                       struct lanes *up)
{
    for (int node = 0; node < NODES; node++) {
        const double *own = moments + node * p->fields;
        double sum[2][DEGREES] = {{0.0}};
        for (int l = 0; l < p->degrees; l++)
            for (int m = 0; m <= l; m++)
                sum[(l + m) & 1][m] += p->source[i][field(l, m)] * own[field(l, m)];
        memset(down + node, 0, sizeof *down);
        memset(up + node, 0, sizeof *up);
        for (int m = 0; m < p->degrees; m++) {
            const double same = (sum[0][m] + sum[1][m]) / p->cosine[i];
            const double other = (sum[0][m] - sum[1][m]) / p->cosine[i];
            double *d = m & 1 ? down[node].im : down[node].re;
            double *u = m & 1 ? up[node].im : up[node].re;
            for (int a = 0; a < AZIMUTHS; a++) {
                d[a] += same * p->turn[a][m];
                u[a] += other * p->turn[a][m];
            }
        }
    }
}

static void bend(const struct problem *p, const struct lanes *source, struct lanes *bent)
{
    memset(bent, 0, CELLS * sizeof *bent);
    for (int c = 0; c < CELLS; c++)
        for (int j = 0; j < 4; j++) {
            const double weight = p->cell[c].bend[j];
            if (weight == 0.0)
                continue;
            for (int a = 0; a < AZIMUTHS; a++) {
                bent[c].re[a] += weight * source[c - 1 + j].re[a];
                bent[c].im[a] += weight * source[c - 1 + j].im[a];
            }
        }
}

// What the walls send back: x downwards at the near one, y upwards at the far one, with
// x = r (near + all y), y = r (far + all x).
static void reflect(double r, const struct lanes *all, const struct lanes *near,
                    const struct lanes *far, struct lanes *x, struct lanes *y)
{
    struct lanes turned;
    multiply(all, far, &turned);
    multiply(all, all, x);
    for (int a = 0; a < AZIMUTHS; a++) {
        const double below[2] = {1.0 - r * r * x->re[a], -r * r * x->im[a]};
        // 0 in a clear slab, which keeps what no source sends.
        const double size = fmax(below[0] * below[0] + below[1] * below[1], 1e-300);
        const double above[2] = {r * (near->re[a] + r * turned.re[a]),
                                 r * (near->im[a] + r * turned.im[a])};
        x->re[a] = (above[0] * below[0] + above[1] * below[1]) / size;
        x->im[a] = (above[1] * below[0] - above[0] * below[1]) / size;
    }
    multiply(all, x, y);
    for (int a = 0; a < AZIMUTHS; a++) {
        y->re[a] = r * (far->re[a] + y->re[a]);
        y->im[a] = r * (far->im[a] + y->im[a]);
    }
}

// Add the radiance of one cosine, down and up at a node, to the node's moments.
static void add_moments(const struct problem *p, int i, const struct lanes *down,
                        const struct lanes *up, double *own)
{
    const double weight = p->weight[i] * 2.0 * TSU_I_PI / AZIMUTHS;
    double sum[2][DEGREES];
    for (int m = 0; m < p->degrees; m++) {
        const double *d = m & 1 ? down->im : down->re, *u = m & 1 ? up->im : up->re;
        double same = 0.0, other = 0.0;
        for (int a = 0; a < AZIMUTHS; a++) {
            same += p->turn[a][m] * (d[a] + u[a]);
            other += p->turn[a][m] * (d[a] - u[a]);
        }
        sum[0][m] = weight * same;
        sum[1][m] = weight * other;
    }
    for (int l = 0; l < p->degrees; l++)
        for (int m = 0; m <= l; m++)
            own[field(l, m)] += p->legendre[i][field(l, m)] * sum[(l + m) & 1][m];
}

static void sweep_cosine(struct problem *p, int i, const double *moments, double *out)
{
    struct lanes down[NODES], up[NODES], bent_down[CELLS], bent_up[CELLS];
    struct lanes light[NODES], far = {{0.0}, {0.0}}, near = far, all = far, back;
    const struct path *path = p->path[i];
    set_source(p, i, moments, down, up);
    bend(p, down, bent_down);
    bend(p, up, bent_up);
    for (int a = 0; a < AZIMUTHS; a++)
        all.re[a] = 1.0;
    for (int c = 0; c < CELLS; c++) {
        const double scale = p->cell[c].width * p->cell[c].scatter;
        pass(path + c, scale, down + c, down + c + 1, bent_down + c, &far);
        multiply(&all, &path[c].e, &all);
    }
    for (int c = CELLS - 1; c >= 0; c--)
        pass(path + c, p->cell[c].width * p->cell[c].scatter, up + c + 1, up + c, bent_up + c,
             &near);
    reflect(p->reflectance[i], &all, &near, &far, light, &back);
    for (int c = 0; c < CELLS; c++) {
        light[c + 1] = light[c];
        pass(path + c, p->cell[c].width * p->cell[c].scatter, down + c, down + c + 1, bent_down + c,
             light + c + 1);
    }
    const double leaves =
        (1.0 - p->reflectance[i]) * p->cosine[i] * p->weight[i] * 2.0 * TSU_I_PI / AZIMUTHS;
    for (int a = 0; a < AZIMUTHS; a++)
        p->through += leaves * light[CELLS].re[a];
    for (int c = CELLS; c >= 0; c--) {
        if (c < CELLS)
            pass(path + c, p->cell[c].width * p->cell[c].scatter, up + c + 1, up + c, bent_up + c,
                 &back);
        add_moments(p, i, light + c, &back, out + c * p->fields);
    }
    for (int a = 0; a < AZIMUTHS; a++)
        p->reflected += leaves * back.re[a];
}

// Moments of the radiance that sources of scattered `moments` make.
static void sweep(struct problem *p, const double *moments, double *out)
{
    memset(out, 0, (size_t)p->size * sizeof *out);
    p->reflected = p->through = 0.0;
    for (int i = 0; i < COSINES; i++)
        sweep_cosine(p, i, moments, out);
}

// Light that meets nothing in an optical depth: what leaves at the far side, and at the near one
// after mirror reflection by the far wall.
static void unmet(double n, double depth, double *ahead, double *back)
{
    const double root = (n - 1.0) / (n + 1.0), r = root * root, left = exp(-depth);
    *ahead = (1.0 - r) * (1.0 - r) * left / (1.0 - r * r * left * left);
    *back = r * left * *ahead;
}

// Moments of the light that met nothing; returns its optical depth.
static double straight(const struct problem *p, double n, double *moments)
{
    const double root = (n - 1.0) / (n + 1.0), r = root * root;
    double depth = 0.0, here = 0.0;
    for (int c = 0; c < CELLS; c++)
        depth += p->cell[c].extinction * p->cell[c].width;
    const double whole = exp(-depth), down = (1.0 - r) / (1.0 - r * r * whole * whole);
    memset(moments, 0, (size_t)p->size * sizeof *moments);
    for (int node = 0; node < NODES; node++) {
        const double d = down * exp(-here), u = r * whole * down * exp(here - depth);
        for (int l = 0; l < p->degrees; l++)
            moments[node * p->fields + field(l, 0)] =
                sqrt((2.0 * l + 1.0) / (4.0 * TSU_I_PI)) * (d + (l & 1 ? -u : u));
        here += node < CELLS ? p->cell[node].extinction * p->cell[node].width : 0.0;
    }
    return depth;
}

static double product(int size, const double *a, const double *b)
{
    double sum = 0.0;
    for (int i = 0; i < size; i++)
        sum += a[i] * b[i];
    return sum;
}

static void add(int size, double weight, const double *a, double *b)
{
    for (int i = 0; i < size; i++)
        b[i] += weight * a[i];
}

// One step of Arnoldi's and Givens' rotations: column j of 1 - sweep in the basis.
static void extend(struct problem *p, double *basis, int j)
{
    const int size = p->size;
    double *last = basis + (size_t)j * (size_t)size, *next = last + size;
    sweep(p, last, next);
    for (int i = 0; i < size; i++)
        next[i] = last[i] - next[i];
    for (int i = 0; i <= j; i++) {
        const double *other = basis + (size_t)i * (size_t)size;
        p->hessenberg[i][j] = product(size, next, other);
        add(size, -p->hessenberg[i][j], other, next);
    }
    const double left = sqrt(product(size, next, next));
    for (int i = 0; i < size && left > 0.0; i++)
        next[i] /= left;
    p->hessenberg[j + 1][j] = left;
    for (int i = 0; i < j; i++) {
        const double a = p->hessenberg[i][j], b = p->hessenberg[i + 1][j];
        p->hessenberg[i][j] = p->cosines[i] * a + p->sines[i] * b;
        p->hessenberg[i + 1][j] = p->cosines[i] * b - p->sines[i] * a;
    }
    const double size2 = hypot(p->hessenberg[j][j], left);
    p->cosines[j] = p->hessenberg[j][j] / size2;
    p->sines[j] = left / size2;
    p->hessenberg[j][j] = size2;
    p->turned[j + 1] = -p->sines[j] * p->turned[j];
    p->turned[j] *= p->cosines[j];
}

int tsu_i_spread_solve(const struct tsu_i_spread_slab *slab, double k, void *memory,
                       struct tsu_i_spread *out)
{
    struct problem *p = memory;
    set_problem(p, slab, k);
    const int size = p->size;
    double *basis = (double *)(p + 1), *moments = basis + (size_t)(STEPS + 1) * (size_t)size;
    double *work = moments + size;
    const double cut_depth = straight(p, slab->n, moments);
    // moments = straight + x, x - sweep(x) = sweep(straight).
    sweep(p, moments, basis);
    const double once = sqrt(product(size, basis, basis));
    int steps = 0;
    for (int i = 0; i < size && once > 0.0; i++)
        basis[i] /= once;
    p->turned[0] = once;
    while (steps < STEPS && fabs(p->turned[steps]) > enough * once)
        extend(p, basis, steps++);
    double x[STEPS];
    for (int i = steps - 1; i >= 0; i--) {
        x[i] = p->turned[i];
        for (int j = i + 1; j < steps; j++)
            x[i] -= p->hessenberg[i][j] * x[j];
        x[i] /= p->hessenberg[i][i];
    }
    for (int i = 0; i < steps; i++)
        add(size, x[i], basis + (size_t)i * (size_t)size, moments);
    sweep(p, moments, work);
    // What delta-M left in the beam did scatter.
    double depth = 0.0, ahead, back, cut_ahead, cut_back;
    for (int i = 0; i < slab->layers; i++)
        depth += slab->layer[i].scatter + slab->layer[i].absorption;
    unmet(slab->n, depth, &ahead, &back);
    unmet(slab->n, cut_depth, &cut_ahead, &cut_back);
    out->straight = ahead;
    out->reflected = p->reflected + cut_back - back;
    out->through = p->through + cut_ahead - ahead;
    return fabs(p->turned[steps]) <= 10.0 * enough * once;
}

#include "photon_walk.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

struct walker {
    const struct photon_slab *slab;
    uint64_t state[4];
    double wall[PHOTON_LAYERS + 1]; // depths
    double x, y, z, dx, dy, dz, weight;
    int layer, leaves; // leaves: at the far side, of the wall met last
    double centre;     // depth of the centre of a bent slab
};

// xoshiro256+, seeded by SplitMix64 (Blackman and Vigna 2018).
static void seed_random(struct walker *w, uint64_t seed)
{
    for (int i = 0; i < 4; i++) {
        uint64_t z = seed += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        w->state[i] = z ^ z >> 31;
    }
}

// Uniform in (0, 1).
static double uniform(struct walker *w)
{
    uint64_t *s = w->state;
    const uint64_t sum = s[0] + s[3], moved = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= moved;
    s[3] = s[3] << 45 | s[3] >> 19;
    return ((double)(sum >> 11) + 0.5) * 0x1p-53;
}

// Unpolarised reflectance seen from inside.
static double inside_fresnel(double n, double cosine)
{
    const double sine2 = n * n * (1.0 - cosine * cosine);
    if (sine2 >= 1.0)
        return 1.0;
    const double out = sqrt(1.0 - sine2);
    const double s = (n * cosine - out) / (n * cosine + out);
    const double p = (cosine - n * out) / (cosine + n * out);
    return 0.5 * (s * s + p * p);
}

static void turn(struct walker *w, double g)
{
    double c = 2.0 * uniform(w) - 1.0;
    if (fabs(g) > 1e-6) {
        const double q = (1.0 - g * g) / (1.0 + g * c);
        c = (1.0 + g * g - q * q) / (2.0 * g);
    }
    const double s = sqrt(fmax(1.0 - c * c, 0.0)), phi = 2.0 * pi * uniform(w);
    const double a = s * cos(phi), b = s * sin(phi);
    const double dx = w->dx, dy = w->dy, dz = w->dz, side = sqrt(dx * dx + dy * dy);
    if (side < 1e-9) {
        w->dx = a;
        w->dy = b;
        w->dz = dz > 0.0 ? c : -c;
    } else {
        w->dx = a * dx * dz / side - b * dy / side + c * dx;
        w->dy = a * dy * dz / side + b * dx / side + c * dy;
        w->dz = c * dz - a * side;
    }
    // Rounding must not add up.
    const double size = sqrt(w->dx * w->dx + w->dy * w->dy + w->dz * w->dz);
    w->dx /= size;
    w->dy /= size;
    w->dz /= size;
}

// Distance along the ray to a sphere around the centre of a bent slab, from a point that is
// outside of it (1) or inside (0); INFINITY: misses.
static double to_sphere(const struct walker *w, double radius, int outside)
{
    const double z = w->z - w->centre;
    const double along = w->x * w->dx + w->y * w->dy + z * w->dz;
    const double c = w->x * w->x + w->y * w->y + z * z - radius * radius;
    const double root = along * along - c;
    if (outside)
        return along < 0.0 && root > 0.0 ? fmax(-along - sqrt(root), 0.0) : INFINITY;
    return fmax(-along + sqrt(fmax(root, 0.0)), 0.0);
}

// Distance to the wall ahead; *next: the layer behind it, counted from the lit side.
static double to_wall(const struct walker *w, int *next)
{
    if (w->slab->bend == 0.0) {
        *next = w->layer + (w->dz > 0.0 ? 1 : -1);
        const double target = w->dz > 0.0 ? w->wall[w->layer + 1] : w->wall[w->layer];
        return w->dz == 0.0 ? INFINITY : fmax((target - w->z) / w->dz, 0.0);
    }
    // Lit from outside, deeper is nearer to the centre.
    const int inner = w->slab->bend > 0.0 ? 1 : 0, middle = w->layer;
    const double sphere[2] = {fabs(w->wall[middle] - w->centre),
                              fabs(w->wall[middle + 1] - w->centre)};
    const double in = to_sphere(w, sphere[inner], 1), out = to_sphere(w, sphere[1 - inner], 0);
    *next = middle + ((in < out) == (inner == 1) ? 1 : -1);
    return fmin(in, out);
}

// Go `depth` mean free paths, over walls between layers. 1: stands at an outer wall.
static int go(struct walker *w, double depth)
{
    for (;;) {
        const struct photon_layer *layer = w->slab->layer + w->layer;
        const double extinction = layer->sigma_a + layer->sigma_s;
        int next;
        const double reach = to_wall(w, &next);
        const double step = extinction > 0.0 ? depth / extinction : INFINITY;
        const int stops = step < reach;
        const double way = stops ? step : reach;
        w->x += way * w->dx;
        w->y += way * w->dy;
        w->z += way * w->dz;
        if (stops)
            return 0;
        if (w->slab->bend == 0.0)
            w->z = w->dz > 0.0 ? w->wall[w->layer + 1] : w->wall[w->layer];
        depth -= way * extinction;
        w->leaves = next > w->layer;
        if (next < 0 || next >= w->slab->layers)
            return 1;
        w->layer = next;
    }
}

// Meet an outer wall; 1: the photon leaves.
static int meet(struct walker *w)
{
    double normal[3] = {0.0, 0.0, 1.0};
    if (w->slab->bend != 0.0) {
        const double z = w->z - w->centre, size = sqrt(w->x * w->x + w->y * w->y + z * z);
        normal[0] = w->x / size;
        normal[1] = w->y / size;
        normal[2] = z / size;
    }
    const double across = w->dx * normal[0] + w->dy * normal[1] + w->dz * normal[2];
    if (uniform(w) >= inside_fresnel(w->slab->n, fmin(fabs(across), 1.0)))
        return 1;
    w->dx -= 2.0 * across * normal[0];
    w->dy -= 2.0 * across * normal[1];
    w->dz -= 2.0 * across * normal[2];
    return 0;
}

static void leave(struct photon_side *side, const struct walker *w, double bin, int scatterings)
{
    if (!scatterings) {
        side->straight += w->weight;
        return;
    }
    const double r = hypot(w->x, w->y);
    const int i = r < bin * (PHOTON_BINS - 1) ? (int)(r / bin) : PHOTON_BINS - 1;
    side->total += w->weight;
    side->total_se += w->weight * w->weight;
    side->once += scatterings == 1 ? w->weight : 0.0;
    side->square += w->weight * r * r;
    side->ring[i] += w->weight;
    side->ring_se[i] += w->weight * w->weight;
}

static void finish(struct photon_side *side, long photons)
{
    const double count = (double)photons;
    side->total /= count;
    side->straight /= count;
    side->once /= count;
    side->square /= count;
    side->total_se = sqrt(fmax(side->total_se / count - side->total * side->total, 0.0) / count);
    for (int i = 0; i < PHOTON_BINS; i++) {
        side->ring[i] /= count;
        side->ring_se[i] =
            sqrt(fmax(side->ring_se[i] / count - side->ring[i] * side->ring[i], 0.0) / count);
    }
}

void photon_walk(const struct photon_slab *slab, double bin, long photons, uint64_t seed,
                 struct photon_result *result)
{
    struct walker walker = {.slab = slab}, *w = &walker;
    seed_random(w, seed);
    memset(result, 0, sizeof *result);
    for (int i = 0; i < slab->layers; i++)
        w->wall[i + 1] = w->wall[i] + slab->layer[i].thickness;
    w->centre = slab->bend > 0.0 ? slab->bend + 0.5 * w->wall[slab->layers]
                                 : slab->bend + 0.5 * w->wall[slab->layers];
    const double entry = (slab->n - 1.0) / (slab->n + 1.0);
    for (long i = 0; i < photons; i++) {
        w->x = w->y = w->z = w->dx = w->dy = 0.0;
        w->dz = 1.0;
        w->weight = 1.0 - entry * entry;
        w->layer = 0;
        int scatterings = 0;
        double depth = -log(uniform(w));
        for (;;) {
            if (go(w, depth)) {
                if (meet(w)) {
                    leave(w->leaves ? &result->t : &result->r, w, bin, scatterings);
                    break;
                }
                depth = -log(uniform(w)); // no memory
                continue;
            }
            const struct photon_layer *layer = slab->layer + w->layer;
            w->weight *= layer->sigma_s / (layer->sigma_a + layer->sigma_s);
            if (w->weight < 0.02 && uniform(w) >= 0.1)
                break;
            w->weight *= w->weight < 0.02 ? 10.0 : 1.0;
            if (w->weight <= 0.0)
                break;
            turn(w, layer->g);
            depth = -log(uniform(w));
            scatterings++;
        }
    }
    finish(&result->r, photons);
    finish(&result->t, photons);
}

double photon_radius(const struct photon_side *side, double bin, double fraction, double straight)
{
    double sum = 0.0;
    for (int i = 0; i < PHOTON_BINS; i++)
        sum += side->ring[i];
    const double wanted = fraction * (sum + straight);
    double inside = straight;
    for (int i = 0; i < PHOTON_BINS - 1; i++) {
        if (inside + side->ring[i] >= wanted)
            return bin * (i + fmax(wanted - inside, 0.0) / fmax(side->ring[i], 1e-300));
        inside += side->ring[i];
    }
    return INFINITY;
}

#include "walk.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;
enum { R, TT, TRT, RES };

struct walker {
    const struct walk_fiber *fiber;
    double alpha[4], beta[4];
    uint64_t state[4];
    double theta, azimuth; // of travel; from the inward normal
    double depth, weight;
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

static double normal(struct walker *w)
{
    const double radius = sqrt(-2.0 * log(uniform(w)));
    return radius * cos(2.0 * pi * uniform(w));
}

// Marschner 2003, table 1 (shifts -1/2, -3/2 of R's); real tilted scales shift the later lobes by
// -0.92, -3.2 and -1.2.
static void set_lobes(struct walker *w, const struct walk_fiber *fiber)
{
    static const double shift[4] = {1.0, -0.5, -1.5, -2.5}, tilted[4] = {1.0, -0.92, -3.2, -1.2};
    static const double width[4] = {1.0, 0.5, 2.0, 2.0};
    for (int p = 0; p < 4; p++) {
        const double s = fiber->scale_shifts;
        w->alpha[p] = fiber->alpha_R * ((1.0 - s) * shift[p] + s * tilted[p]);
        w->beta[p] = fiber->beta_R * width[p];
    }
}

// Unpolarised Fresnel reflectance by the two refraction angles (Snell and the sine rule's forms).
static double fresnel(double eta, double cos_in)
{
    const double sin_out = sqrt(fmax(1.0 - cos_in * cos_in, 0.0)) / eta;
    const double cos_out = sqrt(1.0 - sin_out * sin_out);
    const double s = (eta * cos_out - cos_in) / (eta * cos_out + cos_in);
    const double p = (cos_out - eta * cos_in) / (cos_out + eta * cos_in);
    return 0.5 * (s * s + p * p);
}

// The inclination that leaves. d'Eon's lobe is the height of a von Mises-Fisher distribution of
// concentration 1/v about a direction of inclination alpha - theta (d'Eon 2013, "A Fiber Scattering
// Model with Non-Separable Lobes", section 4).
static double sample_own(struct walker *w, int p)
{
    const double fixed = -w->theta, axis = w->alpha[p] - fixed, v = w->beta[p] * w->beta[p];
    const double u = 1.0 + v * log(uniform(w) * (1.0 - exp(-2.0 / v)) + exp(-2.0 / v));
    const double around = sqrt(fmax(1.0 - u * u, 0.0)) * cos(2.0 * pi * uniform(w));
    return asin(fmin(fmax(u * sin(axis) + around * cos(axis), -1.0), 1.0));
}

// exp(-(out + theta - alpha)^2 / (2 beta^2)) (cos out / cos theta_d)^2 by rejection; with
// out = theta + 2 d, cos out / cos d = 2 cos(d + theta) - cos theta / cos d <= 2 - cos theta.
static double sample_gaussian(struct walker *w, int p)
{
    const double fixed = -w->theta, most = 2.0 - cos(fixed);
    for (;;) {
        const double out = w->alpha[p] - fixed + w->beta[p] * normal(w);
        if (fabs(out) >= 0.5 * pi)
            continue;
        const double ratio = cos(out) / cos(0.5 * (out - fixed)) / most;
        if (uniform(w) < ratio * ratio)
            return out;
    }
}

// One meeting with a fibre: an impact parameter, one order of internal reflection, a new direction.
static void meet(struct walker *w)
{
    const struct walk_fiber *fiber = w->fiber;
    const double sin_theta = sin(w->theta), cos_theta = fmax(cos(w->theta), 1e-9);
    const double h = 2.0 * uniform(w) - 1.0, eta2 = fiber->eta * fiber->eta;
    const double sin_t = h * cos_theta / sqrt(eta2 - sin_theta * sin_theta);
    const double cos_theta_t = sqrt(1.0 - sin_theta * sin_theta / eta2);
    const double f = fresnel(fiber->eta, cos_theta * sqrt(1.0 - h * h));
    const double segment = 2.0 * sqrt(1.0 - sin_t * sin_t) / cos_theta_t;
    // Without absorption order p >= 1 has probability (1 - F)^2 F^(p - 1).
    int order = 0;
    if (uniform(w) >= f)
        order = 1 + (int)fmin(log(uniform(w)) / log(f), 1e6);
    w->weight *= exp(-fiber->sigma_a * segment * order);
    double turn = 2.0 * pi * uniform(w);
    if (order < 4)
        turn = 2.0 * order * asin(sin_t) - 2.0 * asin(h) + order * pi + fiber->beta_az * normal(w);
    const int p = order < RES ? order : RES;
    const double theta = fiber->lobe == WALK_OWN ? sample_own(w, p) : sample_gaussian(w, p);
    w->theta = theta;
    // phi = 0 is straight back.
    w->azimuth += pi + turn;
}

static void follow(struct walker *w, int count, const double *taus, double r[], double t[])
{
    int reached = 0; // slabs that the walk has left on the far side
    for (;;) {
        w->depth -= log(uniform(w)) * cos(w->azimuth);
        while (reached < count && w->depth >= taus[reached])
            t[reached++] = w->weight;
        if (reached == count)
            return;
        if (w->depth <= 0.0) {
            for (int i = reached; i < count; i++)
                r[i] = w->weight;
            return;
        }
        meet(w);
        if (w->weight < 0.02) { // roulette
            if (uniform(w) >= 10.0 * w->weight)
                return;
            w->weight = 0.1;
        }
    }
}

void walk(const struct walk_fiber *fiber, double theta, int count, const double *taus, long walks,
          uint64_t seed, struct walk_slab *slabs)
{
    struct walker w = {.fiber = fiber};
    double sum[WALK_TAUS][4] = {{0}};
    set_lobes(&w, fiber);
    seed_random(&w, seed);
    for (long i = 0; i < walks; i++) {
        double r[WALK_TAUS] = {0}, t[WALK_TAUS] = {0};
        w.theta = -theta;
        w.azimuth = 0.0;
        w.depth = 0.0;
        w.weight = 1.0;
        follow(&w, count, taus, r, t);
        for (int k = 0; k < count; k++) {
            sum[k][0] += r[k];
            sum[k][1] += r[k] * r[k];
            sum[k][2] += t[k];
            sum[k][3] += t[k] * t[k];
        }
    }
    const double n = (double)walks;
    for (int k = 0; k < count; k++) {
        const double r = sum[k][0] / n, t = sum[k][2] / n;
        slabs[k].r = r;
        slabs[k].t = t;
        slabs[k].r_se = sqrt(fmax(sum[k][1] / n - r * r, 0.0) / n);
        slabs[k].t_se = sqrt(fmax(sum[k][3] / n - t * t, 0.0) / n);
    }
}

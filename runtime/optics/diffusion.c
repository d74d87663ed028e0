#include "optics/diffusion.h"

#include "optics/angle.h"
#include "optics/fresnel_moment.h"
#include "optics/quadrature.h"

#include <math.h>

// What all methods need of a medium.
struct terms {
    double total, albedo; // t', a'
    double transport;     // sigma_tr
    double d;             // diffusion coefficient
    double c1, c2, c_phi, c_e;
    double real, wall; // depth of the source, zb: 2 A D
    double enters;
};

static struct terms terms_of(int method, const struct tsu_i_medium *medium)
{
    struct terms t;
    const double reduced = medium->sigma_s * (1.0 - medium->g);
    const double root = (medium->n - 1.0) / (medium->n + 1.0);
    tsu_i_fresnel_moments(medium->n, &t.c1, &t.c2);
    t.total = medium->sigma_a + reduced;
    t.albedo = reduced / t.total;
    t.real = 1.0 / t.total;
    t.c_phi = 0.25 * (1.0 - 2.0 * t.c1);
    t.c_e = 0.5 * (1.0 - 3.0 * t.c2);
    const int better = method == TSU_I_DIFFUSION_BETTER || method == TSU_I_DIFFUSION_BEAM;
    t.d = better ? (2.0 * medium->sigma_a + reduced) / (3.0 * t.total * t.total)
                 : 1.0 / (3.0 * t.total);
    t.transport = sqrt(medium->sigma_a / t.d);
    const double a = (1.0 + (better ? 3.0 * t.c2 : 2.0 * t.c1)) / (1.0 - 2.0 * t.c1);
    t.wall = 2.0 * a * t.d;
    t.enters = 1.0 - root * root;
    return t;
}

// z (1 + s d) e^(-s d) / d^3, d^2 = r^2 + z^2.
static double pole(double transport, double r, double z)
{
    const double d = sqrt(r * r + z * z);
    return z * (1.0 + transport * d) * exp(-transport * d) / (d * d * d);
}

static double better_at(const struct terms *t, double r, double real)
{
    const double image = real + 2.0 * t->wall;
    const double dr = sqrt(r * r + real * real), dv = sqrt(r * r + image * image);
    const double flux = exp(-t->transport * dr) / dr - exp(-t->transport * dv) / dv;
    return t->enters * t->albedo * t->albedo / (4.0 * TSU_I_PI) *
           (t->c_e * (pole(t->transport, r, real) + pole(t->transport, r, image)) +
            t->c_phi / t->d * flux);
}

// Sources lie along the beam as light leaves it.
static double beam_at(const struct terms *t, double r)
{
    enum { PANELS = 6, COUNT = PANELS * TSU_I_QUADRATURE_PANEL };
    double sum = 0.0;
    for (int i = 0; i < COUNT; i++) {
        double weight;
        // Depth 24 l' x^3: dense where the source is near.
        const double x = tsu_i_quadrature_node(0.0, 1.0, PANELS, i, &weight);
        const double depth = 24.0 * x * x * x / t->total;
        const double near = sqrt(r * r + depth * depth) + depth;
        sum += weight * 72.0 * x * x * exp(-t->total * depth) * -expm1(-2.0 * t->total * near) *
               better_at(t, r, depth);
    }
    return sum;
}

static void multipole_at(const struct terms *t, double thickness, double r, double *reflected,
                         double *through)
{
    enum { PAIRS = 40 };
    const double period = 2.0 * (thickness + 2.0 * t->wall);
    *reflected = *through = 0.0;
    for (int i = -PAIRS; i <= PAIRS; i++) {
        const double real = i * period + t->real, image = i * period - t->real - 2.0 * t->wall;
        *reflected += pole(t->transport, r, real) - pole(t->transport, r, image);
        *through +=
            pole(t->transport, r, thickness - real) - pole(t->transport, r, thickness - image);
    }
    const double scale = t->enters * t->albedo / (4.0 * TSU_I_PI);
    *reflected *= scale;
    *through *= scale;
}

void tsu_i_diffusion_profile(int method, const struct tsu_i_medium *medium, double r,
                             double *reflected, double *through)
{
    const struct terms t = terms_of(method, medium);
    *reflected = *through = 0.0;
    if (method == TSU_I_DIFFUSION_DIPOLE)
        *reflected = t.enters * t.albedo / (4.0 * TSU_I_PI) *
                     (pole(t.transport, r, t.real) + pole(t.transport, r, t.real + 2.0 * t.wall));
    else if (method == TSU_I_DIFFUSION_BETTER)
        *reflected = better_at(&t, r, t.real);
    else if (method == TSU_I_DIFFUSION_BEAM)
        *reflected = beam_at(&t, r);
    else
        multipole_at(&t, medium->thickness, r, reflected, through);
}

// The mean of cos(x sin) over a quarter of the circle: exact to rounding while x is below the
// number of points.
double tsu_i_bessel(double x)
{
    const int points = 24 + (int)x;
    double sum = 0.0;
    for (int i = 0; i < points; i++)
        sum += cos(x * sin(0.5 * TSU_I_PI * (i + 0.5) / points));
    return sum / points;
}

// By radius: panels of equal ratio, from 1e-4 l' to where nothing is left.
static double beam_transform(const struct terms *t, double k)
{
    enum { PANELS = 24, COUNT = PANELS * TSU_I_QUADRATURE_PANEL };
    const double low = log(1e-4 / t->total), high = log(40.0 / fmax(t->transport, 0.02 * t->total));
    double sum = 0.0;
    for (int i = 0; i < COUNT; i++) {
        double weight;
        const double r = exp(tsu_i_quadrature_node(low, high, PANELS, i, &weight));
        sum += weight * 2.0 * TSU_I_PI * r * r * beam_at(t, r) * tsu_i_bessel(k * r);
    }
    return sum;
}

// sinh(q x) / sinh(q h), |x| <= h.
static double sinh_ratio(double q, double x, double h)
{
    if (q * h < 1e-6)
        return x / h;
    return (exp(q * (x - h)) - exp(-q * (x + h))) / -expm1(-2.0 * q * h);
}

void tsu_i_diffusion_transform(int method, const struct tsu_i_medium *medium, double k,
                               double *reflected, double *through)
{
    const struct terms t = terms_of(method, medium);
    const double q = sqrt(t.transport * t.transport + k * k), image = t.real + 2.0 * t.wall;
    const double scale = 0.5 * t.enters * t.albedo;
    *reflected = *through = 0.0;
    if (method == TSU_I_DIFFUSION_DIPOLE) {
        *reflected = scale * (exp(-q * t.real) + exp(-q * image));
    } else if (method == TSU_I_DIFFUSION_BETTER) {
        const double flux =
            q * t.wall < 1e-9 ? 2.0 * t.wall : exp(-q * t.real) * -expm1(-2.0 * q * t.wall) / q;
        *reflected = scale * t.albedo *
                     (t.c_e * (exp(-q * t.real) + exp(-q * image)) + t.c_phi / t.d * flux);
    } else if (method == TSU_I_DIFFUSION_BEAM) {
        *reflected = beam_transform(&t, k);
    } else {
        const double half = medium->thickness + 2.0 * t.wall;
        *reflected = scale * (sinh_ratio(q, half - t.real, half) +
                              sinh_ratio(q, medium->thickness - t.real, half));
        *through = scale * (sinh_ratio(q, image, half) + sinh_ratio(q, t.real, half));
    }
}

int tsu_i_diffusion_check(int method, const struct tsu_i_medium *medium, double *value)
{
    const struct terms t = terms_of(method, medium);
    const int slab = method == TSU_I_DIFFUSION_MULTIPOLE;
    const int alone = slab || method == TSU_I_DIFFUSION_DIPOLE;
    *value = t.albedo;
    if (!(t.albedo >= (alone ? TSU_I_DIFFUSION_ALBEDO : TSU_I_DIFFUSION_ALBEDO_SINGLE)))
        return TSU_I_DIFFUSION_ABSORBS;
    *value = medium->thickness * (slab ? t.total : sqrt(3.0 * medium->sigma_a * t.total));
    if (!(*value >= (slab ? TSU_I_DIFFUSION_DEPTH : TSU_I_DIFFUSION_HALF_SPACE)))
        return TSU_I_DIFFUSION_THIN;
    *value = medium->thickness * sqrt(3.0 * medium->sigma_a * t.total);
    if (slab && !(*value <= TSU_I_DIFFUSION_REACH))
        return TSU_I_DIFFUSION_THICK;
    return TSU_I_DIFFUSION_GOOD;
}

struct tsu_i_medium tsu_i_medium_reduced(const struct tsu_i_medium *medium)
{
    struct tsu_i_medium reduced = *medium;
    reduced.sigma_s *= 1.0 - medium->g;
    reduced.g = 0.0;
    return reduced;
}

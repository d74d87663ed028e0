#include "light/light.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

struct sample {
    double direction[3], radiance[3], angle; // unit; linear; share of the sphere times 4 pi
};

static int finite3(const float v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

int tsu_i_environment_check(const tsu_environment_desc *desc, uint32_t *index, double *angle)
{
    *angle = 0.0;
    for (uint32_t i = 0; i < desc->count; i++) {
        float d[3] = {0}, l[3] = {0}, w = 0.0f;
        desc->radiance(desc->user, i, d, l, &w);
        *index = i;
        double size = 0.0;
        for (int k = 0; k < 3; k++)
            size += (double)d[k] * (double)d[k];
        if (!finite3(d) || !(size > 1e-30))
            return TSU_I_SAMPLE_DIRECTION;
        for (int k = 0; k < 3; k++)
            if (!(l[k] >= 0.0f && l[k] <= 1e30f))
                return TSU_I_SAMPLE_RADIANCE;
        if (!(w >= 0.0f && w <= 12.6f))
            return TSU_I_SAMPLE_ANGLE;
        *angle += (double)w;
    }
    return TSU_I_SAMPLE_GOOD;
}

static struct sample take(const tsu_environment_desc *desc, uint32_t index, double angle)
{
    float d[3] = {0}, l[3] = {0}, w = 0.0f;
    desc->radiance(desc->user, index, d, l, &w);
    struct sample s;
    double size = 0.0;
    for (int k = 0; k < 3; k++)
        size += (double)d[k] * (double)d[k];
    for (int k = 0; k < 3; k++) {
        s.direction[k] = (double)d[k] / sqrt(size);
        s.radiance[k] = (double)l[k];
    }
    s.angle = (double)w * 4.0 * pi / angle;
    return s;
}

static double luminance(const double c[3])
{
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The dominant light: all above `bright` within a cone around `centre`.
struct dominant {
    double bright, centre[3], cosine;
};

// Share of a sample's radiance that is the dominant light's.
static double excess(const struct dominant *d, const struct sample *s)
{
    const double y = luminance(s->radiance);
    return y > d->bright && dot(s->direction, d->centre) > d->cosine ? 1.0 - d->bright / y : 0.0;
}

// The brightest cone of 25 degrees around the brightest sample, moved twice to its own middle.
static struct dominant find(const tsu_environment_desc *desc, double angle)
{
    struct dominant d = {0.0, {0.0, 1.0, 0.0}, 2.0};
    double mean = 0.0, most = 0.0;
    for (uint32_t i = 0; i < desc->count; i++) {
        const struct sample s = take(desc, i, angle);
        const double y = luminance(s.radiance);
        mean += y * s.angle / (4.0 * pi);
        if (y > most) {
            most = y;
            for (int k = 0; k < 3; k++)
                d.centre[k] = s.direction[k];
        }
    }
    d.bright = mean * (double)desc->threshold;
    if (!(most > d.bright))
        return d;
    d.cosine = cos(25.0 * pi / 180.0);
    for (int round = 0; round < 2; round++) {
        double sum[3] = {0.0, 0.0, 0.0};
        for (uint32_t i = 0; i < desc->count; i++) {
            const struct sample s = take(desc, i, angle);
            const double y = excess(&d, &s) * luminance(s.radiance) * s.angle;
            for (int k = 0; k < 3; k++)
                sum[k] += y * s.direction[k];
        }
        const double size = sqrt(dot(sum, sum));
        for (int k = 0; k < 3 && size > 0.0; k++)
            d.centre[k] = sum[k] / size;
    }
    return d;
}

// Real spherical harmonics of order 2 as polynomials, in the record's order, each with the factor
// that makes the projection of a polynomial itself: 1 / the integral of its square.
static void polynomials(const double d[3], double p[9])
{
    p[0] = 1.0;
    p[1] = d[0];
    p[2] = d[1];
    p[3] = d[2];
    p[4] = d[0] * d[1];
    p[5] = d[1] * d[2];
    p[6] = d[2] * d[0];
    p[7] = d[0] * d[0] - d[1] * d[1];
    p[8] = 3.0 * d[2] * d[2] - 1.0;
}

static double inverse_square(int j)
{
    return j == 0   ? 1.0 / (4.0 * pi)
           : j < 4  ? 3.0 / (4.0 * pi)
           : j < 7  ? 15.0 / (4.0 * pi)
           : j == 7 ? 15.0 / (16.0 * pi)
                    : 5.0 / (16.0 * pi);
}

// Largest factor in [0, 1] on all but the constant that leaves no colour negative, over directions
// some 4 degrees apart.
static double smoothing(double r[3][9])
{
    enum { DIRECTIONS = 2048 };
    double factor = 1.0;
    for (int i = 0; i < DIRECTIONS; i++) {
        const double z = 1.0 - (2.0 * i + 1.0) / DIRECTIONS, turn = pi * (3.0 - sqrt(5.0)) * i;
        const double side = sqrt(1.0 - z * z);
        const double d[3] = {side * cos(turn), side * sin(turn), z};
        double p[9];
        polynomials(d, p);
        for (int k = 0; k < 3; k++) {
            double rest = 0.0;
            for (int j = 1; j < 9; j++)
                rest += r[k][j] * p[j];
            if (r[k][0] + rest < 0.0)
                factor = fmin(factor, r[k][0] / -rest);
        }
    }
    return factor;
}

void tsu_i_environment_make(const tsu_environment_desc *desc, double angle, tsu_environment *out)
{
    const struct dominant d = find(desc, angle);
    double r[3][9] = {{0.0}}, taken[3] = {0.0}, bright = 0.0, along = 0.0;
    for (uint32_t i = 0; i < desc->count; i++) {
        const struct sample s = take(desc, i, angle);
        const double share = excess(&d, &s), y = share * luminance(s.radiance) * s.angle;
        double p[9];
        polynomials(s.direction, p);
        bright += y;
        along += y * dot(s.direction, d.centre);
        for (int k = 0; k < 3; k++) {
            taken[k] += share * s.radiance[k] * s.angle;
            for (int j = 0; j < 9; j++)
                r[k][j] += (1.0 - share) * s.radiance[k] * s.angle * p[j] * inverse_square(j);
        }
    }
    const double factor = smoothing(r);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 9; j++)
            out->record[4 * j + k] = (float)(r[k][j] * (j ? factor : 1.0));
    out->record[3] = (float)desc->samples;
    out->smoothing = (float)fmax(factor, 1e-30);

    // A disk of even radiance has the mean cosine (1 + cos(a)) / 2 from its centre.
    const double cosine = bright > 0.0 ? fmax(2.0 * along / bright - 1.0, cos(0.6)) : 1.0;
    out->light_angle = (float)fmin(acos(fmin(cosine, 1.0)), 0.6);
    for (int k = 0; k < 3; k++) {
        out->light_direction[k] = bright > 0.0 ? (float)d.centre[k] : (k == 1 ? 1.0f : 0.0f);
        // Its power L 2 pi (1 - cos(a)) as an irradiance L pi sin^2(a).
        out->light_irradiance[k] = (float)(taken[k] * 0.5 * (1.0 + cosine));
    }
}

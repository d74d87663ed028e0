#include "optics/angle.h"
#include "optics/diffusion.h"
#include "optics/fresnel_moment.h"
#include "optics/phase.h"
#include "optics/quadrature.h"

#include <math.h>

// The unscattered beam: power going down at the near wall, and going up at the far wall.
static void beam_of(const struct tsu_i_medium *medium, double *down, double *up)
{
    const double root = (medium->n - 1.0) / (medium->n + 1.0), f = root * root;
    const double left = exp(-(medium->sigma_a + medium->sigma_s) * medium->thickness);
    *down = (1.0 - f) / (1.0 - f * f * left * left);
    *up = f * left * *down;
}

// Power per depth and steradian that a depth sends along a cosine; sense 1: deeper, -1: back.
static double once(const struct tsu_i_medium *medium, double down, double up, double z,
                   double cosine, int sense)
{
    const double extinction = medium->sigma_a + medium->sigma_s;
    double sum =
        down * exp(-extinction * z) * tsu_i_phase_henyey_greenstein(medium->g, sense * cosine);
    if (up > 0.0)
        sum += up * exp(-extinction * (medium->thickness - z)) *
               tsu_i_phase_henyey_greenstein(medium->g, -sense * cosine);
    return medium->sigma_s / (4.0 * TSU_I_PI) * sum;
}

// Nothing is left of the beam beyond.
static double depth_of(const struct tsu_i_medium *medium)
{
    return fmin(medium->thickness, 40.0 / (medium->sigma_a + medium->sigma_s));
}

// A ray that is reflected `walls` times crosses its depth (sense -1) or the depth below it (1), and
// so many thicknesses.
static double profile_at(const struct tsu_i_medium *medium, double down, double up, double r,
                         int sense, int walls)
{
    enum { PANELS = 4, COUNT = PANELS * TSU_I_QUADRATURE_PANEL };
    const double extinction = medium->sigma_a + medium->sigma_s, n = medium->n;
    const double before = walls ? walls * medium->thickness : 0.0;
    // Beyond the critical angle nothing leaves: tan of the elevation is at least sqrt(n^2 - 1).
    const double low = atan2(fmax(before, r * sqrt(n * n - 1.0)), r);
    const double high = atan2(before + depth_of(medium), r);
    double sum = 0.0;
    for (int i = 0; i < COUNT && high > low; i++) {
        double weight;
        // Squared: F has a root at the critical angle.
        const double x = tsu_i_quadrature_node(0.0, 1.0, PANELS, i, &weight);
        const double angle = low + (high - low) * x * x, cosine = sin(angle);
        const double h = r * tan(angle) - before, way = r / cos(angle);
        const double f = tsu_i_fresnel_inside(n, cosine);
        // Height changes by way^2 / r d(angle); per area cosine / way^2.
        sum += weight * 2.0 * x * (high - low) * cosine / r * exp(-extinction * way) *
               pow(f, walls) * (1.0 - f) *
               once(medium, down, up, sense < 0 ? h : medium->thickness - h, cosine, sense);
    }
    return sum;
}

static double transform_at(const struct tsu_i_medium *medium, double down, double up, double k,
                           int sense, int walls)
{
    enum { COSINES = 2, DEPTHS = 4 };
    const double extinction = medium->sigma_a + medium->sigma_s, n = medium->n;
    const double most = depth_of(medium);
    double sum = 0.0;
    for (int i = 0; i < COSINES * TSU_I_QUADRATURE_PANEL; i++) {
        double weight, share;
        const double outside = tsu_i_quadrature_node(0.0, 1.0, COSINES, i, &weight);
        const double cosine = sqrt(1.0 - (1.0 - outside * outside) / (n * n));
        const double slope = sqrt(1.0 - cosine * cosine) / cosine;
        const double f = tsu_i_fresnel_inside(n, cosine);
        const double leaves = weight * outside / (n * n * cosine) * pow(f, walls) * (1.0 - f);
        for (int j = 0; j < DEPTHS * TSU_I_QUADRATURE_PANEL; j++) {
            const double x = tsu_i_quadrature_node(0.0, 1.0, DEPTHS, j, &share);
            const double z = most * x * x, left = sense < 0 ? z : medium->thickness - z;
            const double height = left + (walls ? walls * medium->thickness : 0.0);
            sum += leaves * share * 2.0 * x * most * 2.0 * TSU_I_PI *
                   exp(-extinction * height / cosine) * tsu_i_bessel(k * height * slope) *
                   once(medium, down, up, z, cosine, sense);
        }
    }
    return sum;
}

typedef double at(const struct tsu_i_medium *medium, double down, double up, double x, int sense,
                  int walls);

static void add_up(const struct tsu_i_medium *medium, at *value, double x, double *reflected,
                   double *through)
{
    enum { MOST_WALLS = 24 };
    const double depth = (medium->sigma_a + medium->sigma_s) * medium->thickness;
    double down, up;
    beam_of(medium, &down, &up);
    *reflected = *through = 0.0;
    for (int walls = 0; walls < MOST_WALLS && (walls == 0 || walls * depth < 30.0); walls++)
        for (int sense = -1; sense <= 1; sense += 2) {
            if (sense > 0 && isinf(medium->thickness))
                continue;
            // Each reflection turns the ray round.
            const int back = (sense < 0) == (walls % 2 == 0);
            *(back ? reflected : through) += value(medium, down, up, x, sense, walls);
        }
}

void tsu_i_single_profile(const struct tsu_i_medium *medium, double r, double *reflected,
                          double *through)
{
    add_up(medium, profile_at, r, reflected, through);
}

void tsu_i_single_transform(const struct tsu_i_medium *medium, double k, double *reflected,
                            double *through)
{
    add_up(medium, transform_at, k, reflected, through);
}

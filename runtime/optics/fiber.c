#include "optics/fiber.h"

#include "optics/angle.h"
#include "optics/quadrature.h"

#include <math.h>

static double fresnel(double eta, double cos_i)
{
    const double cos_t = sqrt(fmax(0.0, 1.0 - (1.0 - cos_i * cos_i) / (eta * eta)));
    const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return 0.5 * (s * s + p * p);
}

struct tsu_i_ray tsu_i_fiber_ray(double eta, double cos_theta, int panels, int index)
{
    double weight;
    const double gamma = tsu_i_quadrature_node(0.0, 0.5 * TSU_I_PI, panels, index, &weight);
    const double h = sin(gamma), sin2_theta = 1.0 - cos_theta * cos_theta;
    const double bravais = sqrt(eta * eta - sin2_theta) / cos_theta;
    const double sin_t = h / bravais;
    const double cos_theta_t = sqrt(1.0 - sin2_theta / (eta * eta));
    struct tsu_i_ray ray;
    ray.fresnel = fresnel(eta, cos_theta * cos(gamma));
    ray.segment = 2.0 * sqrt(1.0 - sin_t * sin_t) / cos_theta_t;
    ray.gamma_i = gamma;
    ray.gamma_t = asin(sin_t);
    ray.weight = weight * cos(gamma);
    return ray;
}

double tsu_i_fiber_azimuth(const struct tsu_i_ray *ray, int p)
{
    return 2 * p * ray->gamma_t - 2.0 * ray->gamma_i + p * TSU_I_PI;
}

// A_0..A_3 and all of p >= 4 of one ray.
static void attenuations(const struct tsu_i_ray *ray, double sigma_a, double a[5])
{
    const double f = ray->fresnel, t = exp(-sigma_a * ray->segment);
    const double through = (1.0 - f) * (1.0 - f);
    a[0] = f;
    a[1] = through * t;
    a[2] = a[1] * f * t;
    a[3] = a[2] * f * t;
    a[4] = a[3] * f * t / fmax(1.0 - f * t, 1e-300); // 0/0 at grazing: nothing enters
}

// Sum over the images of a Gaussian on the circle; x within [-pi, pi]. Images beyond the first
// neighbours are below 1e-16 up to beta = 40 degrees, below 1e-7 at 60.
static double wrapped_gaussian(double x, double beta)
{
    double sum = 0.0;
    for (int k = -1; k <= 1; k++) {
        const double z = (x + 2.0 * TSU_I_PI * k) / beta;
        if (z * z < 100.0)
            sum += exp(-0.5 * z * z);
    }
    return sum / (beta * sqrt(2.0 * TSU_I_PI));
}

// Enough panels that neighbouring exit azimuths lie within a fraction of beta even where Phi_p runs
// fastest (p = 3: up to 6 rad per rad of gamma).
static int panels_for(double beta_az)
{
    const int panels = (int)ceil(1.0 / beta_az);
    return panels < 4 ? 4 : panels;
}

void tsu_i_fiber_azimuthal(double eta, double theta, double sigma_a, double beta_az, double phi,
                           double n[TSU_I_LOBES])
{
    const double cos_theta = cos(theta);
    const int panels = panels_for(beta_az);
    for (int p = 0; p < TSU_I_LOBES; p++)
        n[p] = 0.0;
    for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
        const struct tsu_i_ray ray = tsu_i_fiber_ray(eta, cos_theta, panels, i);
        double a[5];
        attenuations(&ray, sigma_a, a);
        for (int p = 0; p < TSU_I_LOBES; p++) {
            const double exit = tsu_i_fiber_azimuth(&ray, p);
            const double g = wrapped_gaussian(tsu_i_angle_wrap(phi - exit), beta_az) +
                             wrapped_gaussian(tsu_i_angle_wrap(phi + exit), beta_az);
            n[p] += 0.5 * ray.weight * a[p] * g;
        }
        n[TSU_I_RES] += ray.weight * a[4] / (2.0 * TSU_I_PI);
    }
}

void tsu_i_fiber_attenuation(double eta, double theta, double sigma_a, double a[TSU_I_LOBES])
{
    const int panels = 8;
    for (int p = 0; p < TSU_I_LOBES; p++)
        a[p] = 0.0;
    for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
        const struct tsu_i_ray ray = tsu_i_fiber_ray(eta, cos(theta), panels, i);
        double one[5];
        attenuations(&ray, sigma_a, one);
        for (int p = 0; p < 5; p++)
            a[p < 3 ? p : 3] += ray.weight * one[p];
    }
}

int tsu_i_fiber_orders(double beta_az)
{
    const int orders = 2 + (int)(4.8 / beta_az);
    return orders > TSU_I_FIBER_ORDERS ? TSU_I_FIBER_ORDERS : orders;
}

void tsu_i_fiber_cosines(double eta, double theta, double sigma_a, double beta_az, int orders,
                         double c[][TSU_I_LOBES])
{
    const int panels = panels_for(beta_az);
    for (int k = 0; k < orders; k++)
        for (int p = 0; p < TSU_I_LOBES; p++)
            c[k][p] = 0.0;
    for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
        const struct tsu_i_ray ray = tsu_i_fiber_ray(eta, cos(theta), panels, i);
        double a[5];
        attenuations(&ray, sigma_a, a);
        for (int p = 0; p < TSU_I_LOBES; p++) {
            const double twice = 2.0 * cos(tsu_i_fiber_azimuth(&ray, p));
            double before = 0.5 * twice, now = 1.0; // cos((k - 1) Phi), cos(k Phi)
            for (int k = 0; k < orders; k++) {
                c[k][p] += ray.weight * a[p] * now;
                const double next = twice * now - before;
                before = now;
                now = next;
            }
        }
        c[0][TSU_I_RES] += ray.weight * a[4];
    }
    for (int k = 1; k < orders; k++)
        for (int p = 0; p < TSU_I_LOBES; p++)
            c[k][p] *= exp(-0.5 * k * k * beta_az * beta_az);
}

double tsu_i_fiber_albedo(double eta, double sigma_a)
{
    const int panels = 2;
    double sum = 0.0;
    for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
        double weight, a[TSU_I_LOBES];
        const double theta = tsu_i_quadrature_node(0.0, 0.5 * TSU_I_PI, panels, i, &weight);
        tsu_i_fiber_attenuation(eta, theta, sigma_a, a);
        sum += weight * cos(theta) * cos(theta) * (a[0] + a[1] + a[2] + a[3]);
    }
    return sum / (0.25 * TSU_I_PI);
}

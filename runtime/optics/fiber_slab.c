#include "optics/fiber_slab.h"

#include "optics/angle.h"
#include "optics/quadrature.h"

#include <math.h>

static double azimuthal(int orders, const double *c, double phi)
{
    double sum = 0.5 * c[0];
    for (int k = 1; k < orders; k++)
        sum += c[k] * cos(k * phi);
    return sum / TSU_I_PI;
}

void tsu_i_fiber_slab(int orders, const double *c, tsu_i_fields_fn fields, const void *data,
                      double tau, double *reflectance, double *transmittance)
{
    enum { NODES = TSU_I_QUADRATURE_PANEL, PANELS = 3 };
    // Past 40 fibres nothing is seen.
    const double scale = 4.0 / (3.0 * TSU_I_PI), far = fmin(tau, 1e6), deepest = fmin(tau, 40.0);
    double r = 0.0, t = exp(-tau);
    for (int i = 0; i < NODES; i++) {
        double weight;
        const double phi = tsu_i_quadrature_node(0.0, 0.5 * TSU_I_PI, 1, i, &weight);
        const double mu = cos(phi), half = 0.5 * (1.0 + mu);
        const double near = half * half * scale, beyond = (1.0 - half) * (1.0 - half) * scale;
        const double back = azimuthal(orders, c, phi), on = azimuthal(orders, c, TSU_I_PI - phi);
        for (int j = 0; j < PANELS * NODES; j++) {
            double share;
            const double depth = tsu_i_quadrature_node(0.0, deepest, PANELS, j, &share);
            const double above = depth / mu, below = (far - depth) / mu;
            const double from_above = exp(-above), from_below = exp(-below);
            const double w = 2.0 * weight * share * exp(-depth); // both signs of phi
            struct tsu_i_fields f = fields(data, above, below, from_above);
            r += w * (back * from_above + near * f.same + beyond * f.other);
            f = fields(data, below, above, from_below);
            t += w * (on * from_below + beyond * f.same + near * f.other);
        }
    }
    *reflectance = r;
    *transmittance = t;
}

#include "optics/fresnel_moment.h"

#include "optics/fresnel.h"
#include "optics/quadrature.h"

#include <math.h>

double tsu_i_fresnel_inside(double n, double cosine)
{
    const double outside2 = 1.0 - n * n * (1.0 - cosine * cosine);
    return outside2 > 0.0 ? tsu_i_fresnel_reflect(n, n * cosine, 1.0, sqrt(outside2)) : 1.0;
}

void tsu_i_fresnel_moments(double n, double *c1, double *c2)
{
    // Total reflection in closed form; above it in the outside cosine, in which F is smooth.
    const double critical = sqrt(1.0 - 1.0 / (n * n));
    *c1 = 0.5 * critical * critical;
    *c2 = critical * critical * critical / 3.0;
    enum { PANELS = 4, COUNT = PANELS * TSU_I_QUADRATURE_PANEL };
    for (int i = 0; i < COUNT; i++) {
        double weight;
        const double outside = tsu_i_quadrature_node(0.0, 1.0, PANELS, i, &weight);
        const double inside = sqrt(1.0 - (1.0 - outside * outside) / (n * n));
        const double share = weight * outside / (n * n) * tsu_i_fresnel_inside(n, inside);
        *c1 += share;
        *c2 += share * inside;
    }
}

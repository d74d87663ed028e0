#include "optics/quadrature.h"

#include "optics/angle.h"

#include <math.h>

// Positive nodes and weights of the 16-point rule (roots of the Legendre polynomial P_16).
static const double rule[8][2] = {
    {0.095012509837637454, 0.18945061045506859},
    {0.28160355077925892, 0.18260341504492361},
    {0.45801677765722737, 0.16915651939500262},
    {0.61787624440264377, 0.14959598881657676},
    {0.755404408355003, 0.12462897125553403},
    {0.86563120238783176, 0.095158511682492591},
    {0.9445750230732326, 0.062253523938647706},
    {0.98940093499164994, 0.027152459411754037},
};

double tsu_i_quadrature_node(double a, double b, int panels, int index, double *weight)
{
    const int panel = index / TSU_I_QUADRATURE_PANEL, k = index % TSU_I_QUADRATURE_PANEL;
    const double half = 0.5 * (b - a) / panels;
    const double middle = a + (2 * panel + 1) * half;
    *weight = rule[k / 2][1] * half;
    return middle + (k & 1 ? half : -half) * rule[k / 2][0];
}

void tsu_i_quadrature_gauss(int count, double *nodes, double *weights)
{
    for (int i = 0; 2 * i < count; i++) {
        const int middle = 2 * i + 1 == count;
        double x = middle ? 0.0 : cos(TSU_I_PI * (i + 0.75) / (count + 0.5)), slope = 1.0;
        // Newton's method.
        for (int again = 0; again < 50; again++) {
            double before = 1.0, now = x;
            for (int k = 2; k <= count; k++) {
                const double next = ((2.0 * k - 1.0) * x * now - (k - 1.0) * before) / k;
                before = now;
                now = next;
            }
            slope = count * (x * now - before) / (x * x - 1.0);
            const double move = now / slope;
            x -= move;
            if (fabs(move) < 1e-15)
                break;
        }
        nodes[i] = x;
        nodes[count - 1 - i] = -x;
        weights[i] = weights[count - 1 - i] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
}

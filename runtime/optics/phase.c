#include "optics/phase.h"

#include <math.h>

double tsu_i_phase_henyey_greenstein(double g, double cosine)
{
    // 1 + g^2 - 2 g cos without the cancellation at g = cos = 1.
    const double away = 1.0 - g, square = away * away + 2.0 * g * (1.0 - cosine);
    return (1.0 - g) * (1.0 + g) / (square * sqrt(square));
}

double tsu_i_phase_legendre(const double *chi, uint32_t count, double cosine)
{
    double before = 0.0, now = 1.0, sum = 0.0;
    for (uint32_t l = 0; l < count; l++) {
        sum += (2.0 * l + 1.0) * chi[l] * now;
        const double next = ((2.0 * l + 1.0) * cosine * now - l * before) / (l + 1.0);
        before = now;
        now = next;
    }
    return sum;
}

void tsu_i_phase_mode(uint32_t m, uint32_t count, double mu, double *out)
{
    const double sine = sqrt((1.0 - mu) * (1.0 + mu));
    double before = 0.0, now = 1.0;
    for (uint32_t k = 1; k <= m; k++)
        now *= sine * sqrt((2.0 * k - 1.0) / (2.0 * k));
    double root = 0.0; // sqrt(l^2 - m^2)
    for (uint32_t l = m; l < count; l++) {
        out[l - m] = now;
        const double up = sqrt((l + 1.0 - m) * (l + 1.0 + m));
        const double next = ((2.0 * l + 1.0) * mu * now - root * before) / up;
        before = now;
        now = next;
        root = up;
    }
}

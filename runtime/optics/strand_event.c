#include "optics/strand_event.h"

#include "optics/angle.h"
#include "optics/lobe.h"
#include "optics/quadrature.h"

#include <math.h>
#include <string.h>

// Int over |phi| < pi/2 of N is c_0/2 + (2/pi) Sum c_k sin(k pi/2)/k; Int N |phi| is c_0 pi/2 -
// (4/pi) Sum over odd k of c_k/k^2, and an incident azimuth averaged over a half circle leaves
// the weight |phi|/pi forward.
void tsu_i_strand_halves(int orders, double c[][TSU_I_LOBES], struct tsu_i_event *event)
{
    for (int p = 0; p < TSU_I_LOBES; p++) {
        double aligned = 0.0, mean = 0.0;
        for (int k = 1; k < orders; k += 2) {
            aligned += (k % 4 == 1 ? c[k][p] : -c[k][p]) / k;
            mean += c[k][p] / ((double)k * k);
        }
        event->backward[p] = 0.5 * c[0][p] + 2.0 / TSU_I_PI * aligned;
        event->forward[p] = c[0][p] - event->backward[p];
        event->backward_mean[p] = 0.5 * c[0][p] + 4.0 / (TSU_I_PI * TSU_I_PI) * mean;
        event->forward_mean[p] = c[0][p] - event->backward_mean[p];
    }
}

static double literal(const struct tsu_i_strand *strand, int p, double theta, double theta_out)
{
    const double z = (theta + theta_out - strand->alpha[p]) / strand->beta[p];
    const double cos_d = cos(0.5 * (theta_out - theta)), cos_out = cos(theta_out);
    const double g = exp(-0.5 * z * z) / (strand->beta[p] * sqrt(2.0 * TSU_I_PI));
    return cos_d < 1e-6 ? 0.0 : g * cos_out * cos_out / (cos_d * cos_d);
}

// Node of a quadrature over theta_out that meets in the lobe's centre.
enum { PANELS = 6, NODES = 2 * PANELS * TSU_I_QUADRATURE_PANEL };
static double node(const struct tsu_i_strand *strand, int p, double theta, int index,
                   double *weight)
{
    const double half_pi = 0.5 * TSU_I_PI, reach = 9.0 * strand->beta[p];
    const double centre = fmin(fmax(strand->alpha[p] - theta, -half_pi), half_pi);
    const int side = index / (PANELS * TSU_I_QUADRATURE_PANEL);
    const double low = side ? centre : fmax(centre - reach, -half_pi);
    const double high = side ? fmin(centre + reach, half_pi) : centre;
    return tsu_i_quadrature_node(low, high, PANELS, index % (PANELS * TSU_I_QUADRATURE_PANEL),
                                 weight);
}

static double normaliser(const struct tsu_i_strand *strand, int p, double theta)
{
    double sum = 0.0;
    for (int i = 0; i < NODES; i++) {
        double weight;
        const double out = node(strand, p, theta, i, &weight);
        sum += weight * literal(strand, p, theta, out);
    }
    return sum;
}

double tsu_i_strand_lobe(const struct tsu_i_strand *strand, int p, double theta, double theta_out)
{
    if (strand->kind == TSU_I_STRAND_DEON)
        return tsu_i_lobe_deon(theta_out, theta - strand->alpha[p], strand->beta[p]) *
               cos(theta_out);
    const double value = literal(strand, p, theta, theta_out);
    if (strand->kind == TSU_I_STRAND_LITERAL)
        return value;
    const double k = normaliser(strand, p, theta);
    return k > 0.0 ? value / k : 0.0;
}

int tsu_i_strand_cosines(const struct tsu_i_strand *strand, double theta, double c[][TSU_I_LOBES])
{
    const double steepest = TSU_I_PI / 2.0 - 1e-4;
    const int orders = tsu_i_fiber_orders(strand->beta_az);
    theta = fmin(fmax(theta, -steepest), steepest);
    if (strand->kind == TSU_I_STRAND_DEON || strand->kind == TSU_I_STRAND_GAUSSIAN) {
        tsu_i_fiber_cosines(strand->eta, theta, strand->sigma_a, strand->beta_az, orders, c);
        for (int k = 0; k < orders; k++)
            for (int p = strand->lobes; p < TSU_I_LOBES; p++)
                c[k][p] = 0.0;
        return orders;
    }
    memset(c, 0, (size_t)orders * sizeof *c);
    for (int p = 0; p < strand->lobes; p++) {
        const double whole =
            strand->kind == TSU_I_STRAND_LITERAL ? 1.0 : normaliser(strand, p, theta);
        for (int i = 0; i < NODES; i++) {
            double weight, one[TSU_I_FIBER_ORDERS][TSU_I_LOBES];
            const double out = node(strand, p, theta, i, &weight);
            const double share = weight * literal(strand, p, theta, out) / whole;
            if (share < 1e-9)
                continue;
            tsu_i_fiber_cosines(strand->eta, 0.5 * (out - theta), strand->sigma_a, strand->beta_az,
                                orders, one);
            for (int k = 0; k < orders; k++)
                c[k][p] += share * one[k][p];
        }
    }
    return orders;
}

void tsu_i_strand_event(const struct tsu_i_strand *strand, double theta, struct tsu_i_event *event)
{
    double c[TSU_I_FIBER_ORDERS][TSU_I_LOBES];
    const int orders = tsu_i_strand_cosines(strand, theta, c);
    tsu_i_strand_halves(orders, c, event);
}

struct tsu_i_turn tsu_i_strand_turn(const struct tsu_i_event *event)
{
    struct tsu_i_turn turn = {0.0, 0.0, 0.0, 0.0};
    for (int p = 0; p < TSU_I_LOBES; p++) {
        turn.forward += event->forward[p];
        turn.backward += event->backward[p];
        turn.forward_mean += event->forward_mean[p];
        turn.backward_mean += event->backward_mean[p];
    }
    return turn;
}

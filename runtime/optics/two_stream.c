#include "optics/two_stream.h"

#include "optics/angle.h"
#include "optics/quadrature.h"

#include <math.h>

static const double own_half = 0.5 + 4.0 / (3.0 * TSU_I_PI);

void tsu_i_two_stream_spread(double *same, double *other)
{
    const double s = *same, o = *other, scale = 1.0 / (2.0 * own_half - 1.0);
    *same = (own_half * s - (1.0 - own_half) * o) * scale;
    *other = (own_half * o - (1.0 - own_half) * s) * scale;
}

void tsu_i_two_stream_halves(double *same, double *other)
{
    const double s = *same, o = *other;
    *same = own_half * s + (1.0 - own_half) * o;
    *other = own_half * o + (1.0 - own_half) * s;
}

double tsu_i_two_stream_gamma(double eta, double beta_az)
{
    enum { NODES = 2 * TSU_I_QUADRATURE_PANEL };
    double c[TSU_I_FIBER_ORDERS][TSU_I_LOBES], n[NODES], a[NODES], mu[NODES];
    struct tsu_i_event event;
    const int orders = tsu_i_fiber_orders(beta_az);
    tsu_i_fiber_cosines(eta, 0.0, 0.0, beta_az, orders, c);
    tsu_i_strand_halves(orders, c, &event);
    struct tsu_i_turn turn = tsu_i_strand_turn(&event);
    tsu_i_two_stream_spread(&turn.backward, &turn.forward);
    // Both sides together: even orders.
    double direct = 0.0;
    for (int i = 0; i < NODES; i++) {
        double weight;
        const double phi = tsu_i_quadrature_node(0.0, 0.5 * TSU_I_PI, 2, i, &weight);
        mu[i] = cos(phi);
        n[i] = 0.0;
        for (int k = 0; k < orders; k += 2)
            for (int p = 0; p < TSU_I_LOBES; p++)
                n[i] += (k ? 2.0 : 1.0) * c[k][p] * cos(k * phi) / TSU_I_PI;
        const double s = 0.5 * (1.0 + mu[i]), o = 1.0 - s;
        a[i] = weight * (turn.backward + turn.forward) * (s * s + o * o) * 4.0 / (3.0 * TSU_I_PI);
        direct += weight * n[i] * exp(-1.0 / mu[i]);
    }
    double low = 0.3, high = 1.0;
    for (int step = 0; step < 40; step++) {
        const double gamma = 0.5 * (low + high);
        double sum = 0.0;
        for (int i = 0; i < NODES; i++)
            sum += a[i] * exp(-gamma / mu[i]);
        *(sum > direct ? &low : &high) = gamma;
    }
    return 0.5 * (low + high);
}

// A sum w above 0.95 keeps w (1 - LOST (20 w - 19)).
double tsu_i_two_stream_restore(double kept)
{
    const double a = 20.0 * TSU_I_TWO_STREAM_LOST, b = 1.0 + 19.0 * TSU_I_TWO_STREAM_LOST;
    return kept <= 0.95 ? 1.0 : (b - sqrt(fmax(b * b - 4.0 * a * kept, 0.0))) / (2.0 * a * kept);
}

struct tsu_i_stream tsu_i_two_stream(const struct tsu_i_turn *turn, double eta, double gamma)
{
    const double d = 0.5 * TSU_I_PI, whole = turn->forward_mean + turn->backward_mean;
    const double scale = whole > 1.0 ? 1.0 / whole : 1.0;
    // Only where next to nothing absorbs could the distributions' mismatch add up to a gain.
    const double near_white = fmax(20.0 * fmin(whole, 1.0) - 19.0, 0.0);
    const double kept = scale * (1.0 - TSU_I_TWO_STREAM_LOST * near_white);
    const double kappa = 0.66 + 0.4 * (fmin(fmax(eta, 1.2), 2.0) - 1.55);
    const double b = kappa * turn->backward_mean * scale;
    const double f = whole * scale - b;
    const double a = d * (1.0 - f), back = d * b;
    struct tsu_i_stream stream;
    // Without absorption k would be 0, r 1, and what leaves a slab a ratio of zeros; a fibre that
    // absorbs next to nothing keeps it a ratio of numbers that 16 bits hold.
    stream.k = fmax(sqrt(fmax(a * a - back * back, 0.0)), 0.014 * back);
    stream.r = back / (sqrt(stream.k * stream.k + back * back) + stream.k);
    stream.forward = turn->forward * kept;
    stream.backward = turn->backward * kept;
    stream.gamma = gamma;
    tsu_i_two_stream_spread(&stream.backward, &stream.forward);
    return stream;
}

struct tsu_i_fields tsu_i_two_stream_fields(const struct tsu_i_stream *stream, double front,
                                            double behind, double direct)
{
    const double k = stream->k * (2.0 / TSU_I_PI), r = stream->r;
    const double f = stream->forward, b = stream->backward;
    const double p = f * r + b, q = f + b * r;
    const double x = exp(-k * front), z = r * exp(-2.0 * k * behind);
    const double scale = x / fmax(1.0 - x * x * r * z, 1e-15);
    const double single = pow(direct, stream->gamma);
    struct tsu_i_fields fields;
    fields.same = fmax((p - q * z) * scale - b * single, 0.0);
    fields.other = fmax((q - p * z) * scale - f * single, 0.0);
    return fields;
}

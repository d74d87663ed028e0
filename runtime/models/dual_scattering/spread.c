// How far light spreads along the fibres on its way through the hair.
#include "models/dual_scattering/state.h"

#include "optics/angle.h"

#include <math.h>

// Widest lobe and largest shift that d'Eon's lobe follows; light that has met more fibres than that
// is spread over everything anyway.
#define VARIANCE_MOST 0.27
#define SHIFT_MOST 0.6

// Shares with every lobe weighted by exp(alpha L + beta^2 L^2 / 2): the generating function of
// theta_i + theta_r. All events shift and widen independently while inclinations are small, so the
// two-stream solution of the weighted shares generates the moments of all orders together.
static struct tsu_i_fields generate(const struct tsu_i_strand *strand,
                                    const struct tsu_i_event *event, double front, double l)
{
    struct tsu_i_event tilted = *event;
    for (int p = 0; p < TSU_I_LOBES; p++) {
        const double weight =
            exp(l * strand->alpha[p] + 0.5 * l * l * strand->beta[p] * strand->beta[p]);
        tilted.forward[p] *= weight;
        tilted.backward[p] *= weight;
        tilted.forward_mean[p] *= weight;
        tilted.backward_mean[p] *= weight;
    }
    const struct tsu_i_turn turn = tsu_i_strand_turn(&tilted);
    const struct tsu_i_stream stream = tsu_i_two_stream(&turn, strand->eta, 1.0);
    struct tsu_i_fields fields = tsu_i_two_stream_fields(&stream, front, 1e3, exp(-front));
    tsu_i_two_stream_halves(&fields.same, &fields.other);
    return fields;
}

static struct tsu_i_dual_moments moments_of(double less, double none, double more, double step)
{
    struct tsu_i_dual_moments m = {0.0, VARIANCE_MOST};
    if (less > 1e-12 && none > 1e-12 && more > 1e-12) {
        m.mean = (log(more) - log(less)) / (2.0 * step);
        m.variance = (log(more) - 2.0 * log(none) + log(less)) / (step * step);
    }
    m.mean = fmin(fmax(m.mean, -SHIFT_MOST), SHIFT_MOST);
    m.variance = fmin(m.variance, VARIANCE_MOST);
    return m;
}

void tsu_i_dual_moments(const struct tsu_i_strand *strand, const struct tsu_i_event *event,
                        double front, struct tsu_i_dual_moments moments[2])
{
    const double step = 0.05;
    // Where next to nothing arrives the lobe of what arrived last stays.
    while (front > 0.1) {
        const struct tsu_i_fields left = generate(strand, event, front, 0.0);
        if (left.same > 1e-9 && left.other > 1e-9)
            break;
        front *= 0.8;
    }
    const struct tsu_i_fields less = generate(strand, event, front, -step);
    const struct tsu_i_fields none = generate(strand, event, front, 0.0);
    const struct tsu_i_fields more = generate(strand, event, front, step);
    moments[0] = moments_of(less.same, none.same, more.same, step);
    moments[1] = moments_of(less.other, none.other, more.other, step);
    // Two events at least: twice the narrowest lobe.
    const double least = 2.0 * strand->beta[TSU_I_TT] * strand->beta[TSU_I_TT];
    moments[0].variance = fmax(moments[0].variance, least);
    moments[1].variance = fmax(moments[1].variance, least);
}

void tsu_i_dual_zinke(const struct tsu_i_strand *strand, const struct tsu_i_event *event,
                      struct tsu_i_dual_zinke *out)
{
    const struct tsu_i_turn turn = tsu_i_strand_turn(event);
    const double f = fmin(turn.forward_mean, 1.0 - 1e-4), b = turn.backward_mean;
    double shift_f = 0.0, shift_b = 0.0, var_f = 0.0, var_b = 0.0;
    for (int p = 0; p < TSU_I_LOBES; p++) {
        const double beta2 = strand->beta[p] * strand->beta[p];
        shift_f += event->forward_mean[p] * strand->alpha[p] / fmax(turn.forward_mean, 1e-12);
        shift_b += event->backward_mean[p] * strand->alpha[p] / fmax(turn.backward_mean, 1e-12);
        var_f += event->forward_mean[p] * beta2 / fmax(turn.forward_mean, 1e-12);
        var_b += event->backward_mean[p] * beta2 / fmax(turn.backward_mean, 1e-12);
    }
    const double u = 1.0 - f * f;
    out->forward = turn.forward_mean;
    out->back = b;
    out->albedo = b * f * f / u + b * b * b * f * f / (u * u * u);
    // Eq. 16 and 17.
    out->shift = shift_b * (1.0 - 2.0 * b * b / (u * u)) +
                 shift_f * (2.0 * u * u + 4.0 * f * f * b * b) / (u * u * u);
    const double sigma =
        (1.0 + 0.7 * f * f) *
        (b * sqrt(2.0 * var_f + var_b) + b * b * b * sqrt(2.0 * var_f + 3.0 * var_b)) /
        (b + b * b * b * (2.0 * sqrt(var_f) + 3.0 * sqrt(var_b)));
    out->shift = fmin(fmax(out->shift, -SHIFT_MOST), SHIFT_MOST);
    out->variance = fmin(sigma * sigma, VARIANCE_MOST);
    out->step = var_f;
}

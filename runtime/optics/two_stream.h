// Light inside a volume of parallel fibres in closed form: two diffuse streams fed by one
// collimated event.
//
// The first event uses the aligned shares, every later one the averaged shares with the diffuse
// factor D = pi/2 of two dimensions. The light inside is forward peaked, so only kappa of the
// averaged backward share turns back: the one fitted number. m = 2/pi is none: the mean cosine
// between a way through the volume and the normal of its surface, so that a straight way past n
// fibres goes m n fibres deep.
//
//     b = kappa b_mean, f = f_mean + b_mean - b, a = D (1 - f), B = D b,
//     k = sqrt(a^2 - B^2), r = B / (a + k)
//
// Sources: the two-stream equations, Chandrasekhar 1960, "Radiative Transfer", section 2; the
// shares, Zinke et al. 2008, "Dual Scattering Approximation for Fast Multiple Scattering in Hair",
// eq. 6 and
// 12. kappa was fitted to adding-doubling solutions (fiber_layer.h).
#ifndef TSU_OPTICS_TWO_STREAM_H
#define TSU_OPTICS_TWO_STREAM_H

#include "optics/strand_event.h"

struct tsu_i_stream {
    double k, r;              // decay of the diffuse light in a fibre of depth; reflectance of a
                              // half space for diffuse light
    double forward, backward; // aligned shares of the first event, spread (below)
    double gamma;             // tsu_i_two_stream_gamma()
};

// What a fibre without absorption loses, so that no white slab gives more than it gets: the two
// azimuth distributions stand for N, which is narrower. Found on white slabs of eta 1.2 to 2.
#define TSU_I_TWO_STREAM_LOST 0.015
// Factor that takes the loss off the kept shares, whose sum is `kept`.
double tsu_i_two_stream_restore(double kept);

// Powers on the viewer's side and beyond come back with the azimuth distributions cos^4(phi/2) and
// sin^4(phi/2), each over 3 pi/4; of each the share 1/2 + 4/(3 pi) falls in its own half circle.
// This turns powers of the halves into weights of the distributions and back.
void tsu_i_two_stream_spread(double *same, double *other);
void tsu_i_two_stream_halves(double *same, double *other);

// A turn that sums to more than 1 is scaled to 1. gamma: see below.
struct tsu_i_stream tsu_i_two_stream(const struct tsu_i_turn *turn, double eta, double gamma);

// Of the light that leaves, direct^gamma times the first event's shares is single scattering, which
// is added by its own lobes elsewhere. gamma is below 1 because N is narrower than the two
// distributions, so that its light leaves along shorter ways: fixed where both lose the same one
// fibre deep, for white fibres at normal incidence.
double tsu_i_two_stream_gamma(double eta, double beta_az);

// Light that leaves after at least two events, out of a first event at a fibre with `front` fibres
// on the straight way to the light and `behind` fibres on the way's other end: weights of the two
// distributions, shares of the power that the fibre meets. >= 0.
//   direct  share of the direct light that arrives, exp(-front) for fibres at random
struct tsu_i_fields {
    double same, other;
};
struct tsu_i_fields tsu_i_two_stream_fields(const struct tsu_i_stream *stream, double front,
                                            double behind, double direct);

#endif

// What one meeting with a fibre does to light that travels through a volume of parallel fibres.
//
// Light is followed from the viewer's end: theta is the inclination of the fixed direction, the one
// whose inclination N and the shift use. By adjointness the share of a path that leaves through a
// face is the radiance seen when that face is lit by uniform unit radiance.
//
// Forward and backward are the half circles beyond and before the fibre. "Aligned" is light that
// arrives along the volume's normal; "averaged" is its mean over light from anywhere in the front
// half circle with the halves held fixed (Zinke et al. 2008, "Dual Scattering Approximation for
// Fast Multiple Scattering in Hair", eq. 6 and 12).
#ifndef TSU_OPTICS_STRAND_EVENT_H
#define TSU_OPTICS_STRAND_EVENT_H

#include "optics/fiber.h"

// Which longitudinal lobe, and at which inclination N is taken.
enum {
    TSU_I_STRAND_DEON,     // tsuya's own: d'Eon's lobe, N at the fixed direction; conserves energy
    TSU_I_STRAND_GAUSSIAN, // Gaussian over its normaliser, N at the fixed direction; conserves
    TSU_I_STRAND_DIFFERENCE, // Gaussian over its normaliser, N at theta_d = (theta_r - theta_i)/2
    TSU_I_STRAND_LITERAL     // Marschner's Gaussian as printed, N at theta_d
};

struct tsu_i_strand {
    double eta, sigma_a, beta_az;                 // refractive index; per radius; radians
    double alpha[TSU_I_LOBES], beta[TSU_I_LOBES]; // shift and deviation in theta_i + theta_r
    int kind;                                     // TSU_I_STRAND_*
    int lobes;                                    // 3: without the residual, 4: all
};

// Shares of the light that a fibre meets, and the same lobe by lobe (order R, TT, TRT, residual).
struct tsu_i_event {
    double forward[TSU_I_LOBES], backward[TSU_I_LOBES];           // aligned
    double forward_mean[TSU_I_LOBES], backward_mean[TSU_I_LOBES]; // averaged
};

// Sums over the lobes.
struct tsu_i_turn {
    double forward, backward, forward_mean, backward_mean;
};

// theta as above. Error: below 1e-5 of the whole for beta_az >= 4 degrees.
void tsu_i_strand_event(const struct tsu_i_strand *strand, double theta, struct tsu_i_event *event);
struct tsu_i_turn tsu_i_strand_turn(const struct tsu_i_event *event);

// Cosine coefficients of N over the azimuth, as tsu_i_fiber_cosines() but integrated over the free
// direction's inclination where N depends on it. Returns the number of orders, at most
// TSU_I_FIBER_ORDERS. theta is held 1e-4 off the poles.
int tsu_i_strand_cosines(const struct tsu_i_strand *strand, double theta, double c[][TSU_I_LOBES]);
// Shares out of them.
void tsu_i_strand_halves(int orders, double c[][TSU_I_LOBES], struct tsu_i_event *event);

// Density of lobe p over the free direction, per radian of theta_out, cosine included; its integral
// is 1 (LITERAL: about 1).
double tsu_i_strand_lobe(const struct tsu_i_strand *strand, int p, double theta, double theta_out);

#endif

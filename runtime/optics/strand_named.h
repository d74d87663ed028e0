// The fibres of published tables by name: columns of the functions about multiple scattering.
#ifndef TSU_OPTICS_STRAND_NAMED_H
#define TSU_OPTICS_STRAND_NAMED_H

#include "optics/strand_event.h"

struct tsu_i_strand_columns {
    double eta, alpha_R, beta_R, beta_az, scale_shifts; // radians
    int kind, lobes;                                    // of tsu_i_strand
};

// 0 is the fibre of the five columns eta, alpha_R, beta_R, beta_az, scale_shifts with tsuya's own
// lobes; the others stand for themselves, Gaussian lobes, and leave the columns alone:
//   1 conserve_all  all lobes, conserves energy; the one that has a twin in the shader
//   2 base          R, TT, TRT, N at theta_d, as all that follow
//   3 base_all      all lobes
//   4 wide          beta_az 20, alpha_R -10, beta_R 10 degrees
//   5 narrow        alpha_R -5, beta_R 5
//   6 half          alpha_R -15, beta_R 15: Marschner's (-7.5, 7.5) of theta_h
//   7 literal       base without the normaliser
struct tsu_i_strand_columns tsu_i_strand_named(const double columns[5], int name);

// The columns theta_i, sigma_a, tau, the fibre and its name. Words after the ; are known to the
// reference alone.
#define TSU_I_STRAND_NAMES "own|conserve_all;base|base_all|wide|narrow|half|literal"
#define TSU_I_STRAND_INPUTS                                                                        \
    TSU_I_FRAGMENT("theta_i", "rad", "inclination of the fixed direction, the view's",             \
                   TSU_I_DEGREES(-90), TSU_I_DEGREES(90), 0),                                      \
        TSU_I_MATERIAL("sigma_a", "1/radius", "absorption of one channel", 0, 1e6, 0.9061),        \
        TSU_I_FRAGMENT("tau", "1", "fibres met by a straight way through; inf allowed", 0,         \
                       TSU_VALUE_INFINITE, TSU_VALUE_INFINITE),                                    \
        TSU_I_MATERIAL("eta", "1", "refractive index", 1.2, 2, 1.55),                              \
        TSU_I_MATERIAL("alpha_R", "rad", "shift of R", TSU_I_DEGREES(-20), TSU_I_DEGREES(20),      \
                       TSU_I_DEGREES(-7.5)),                                                       \
        TSU_I_MATERIAL("beta_R", "rad", "deviation of R", TSU_I_DEGREES(2), TSU_I_DEGREES(30),     \
                       TSU_I_DEGREES(7.5)),                                                        \
        TSU_I_MATERIAL("beta_az", "rad", "azimuthal deviation", TSU_I_DEGREES(5),                  \
                       TSU_I_DEGREES(30), TSU_I_DEGREES(10)),                                      \
        TSU_I_MATERIAL("scale_shifts", "1", "shifts of real tilted scales", 0, 1, 0),              \
        TSU_I_MATERIAL("cfg", TSU_I_STRAND_NAMES, "fibre of a published table, over the columns",  \
                       0, 7, 0)
// And what they ask for.
#define TSU_I_STRAND_OUTPUTS                                                                       \
    TSU_I_OUTPUT("af", "1", "share of the light met that goes on"),                                \
        TSU_I_OUTPUT("ab", "1", "share that comes back"),                                          \
        TSU_I_OUTPUT("R", "1", "radiance of a slab, the viewer's side lit by unit radiance"),      \
        TSU_I_OUTPUT("T", "1", "the same, the side beyond lit; unscattered light included")

#endif

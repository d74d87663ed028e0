// Layers of a leaf from what it reflects and lets through, one channel at a time.
//
// A leaf is two layers (palisade above, spongy tissue below) of one index n and one
// Henyey-Greenstein g, smooth Fresnel walls, air outside. A layer has two depths along the normal:
//
//   scatter     mu_s (1 - g) d, reduced scattering; found in [1e-7, 50]
//   absorption  mu_a d; found in [1e-7, 60]
//
// What is known of a leaf are three numbers at normal incidence (mu0 = 1): R_top and R_bottom, lit
// from above and from below, the mirror reflection included, and T, lit from above, unscattered
// light included. Three numbers leave one of the four depths free; leaves' own spectra ask for a
// nearly clear layer full of pigment over a scattering one, so the upper scattering is held at 0.1
// (the lower one's where R_bottom < R_top) wherever that reaches the three numbers, and moves as
// little as it must where it does not: thin clear leaves, and numbers at the edge of what two
// layers can do.
//
// Newton steps, damped (Levenberg 1944, Marquardt 1963), in logarithms of the depths and, until
// they arrive, of the light above the surface's reflection, in which depths are nearly straight
// lines. The solver is slab.h itself: a fine solution for values, a coarse one for slopes.
//
// Where nothing reaches the three numbers, the nearest in the sense of least squares are given, and
// the layers that do them.
#ifndef TSU_OPTICS_LEAF_INVERSE_H
#define TSU_OPTICS_LEAF_INVERSE_H

#include <stddef.h>

struct tsu_i_leaf_layers {
    double scatter_top, absorption_top, scatter_bottom, absorption_bottom;
};

struct tsu_i_leaf_faces {
    double R_top, R_bottom, T;
};

// What is asked: n [1, 2], g [-0.9, 0.9], finite faces; those that no slab has are told so.
struct tsu_i_leaf_question {
    double n, g;
    struct tsu_i_leaf_faces faces;
};

enum tsu_i_leaf_answer {
    TSU_I_LEAF_REACHED, // within TSU_I_LEAF_ENOUGH
    TSU_I_LEAF_ENERGY,  // R_top + T or R_bottom + T is above 1
    TSU_I_LEAF_SURFACE, // R_top or R_bottom is below ((n-1)/(n+1))^2, or T below 0
    TSU_I_LEAF_REACH,   // no two layers are so different, or so clear, or so dark
};
#define TSU_I_LEAF_ENOUGH 1e-4

struct tsu_i_leaf_inverse {
    enum tsu_i_leaf_answer answer;
    struct tsu_i_leaf_layers layers;
    struct tsu_i_leaf_faces faces; // of these layers
    double residual;               // the largest of three differences, asked less done
    int solutions;                 // of the slab, all
};

// Mirror reflection of one wall at normal incidence: no leaf reflects less.
double tsu_i_leaf_surface(double n);

// Doubles of memory that the functions below need.
size_t tsu_i_leaf_inverse_doubles(void);

// Faces of given layers. Error: 1.5e-6.
void tsu_i_leaf_solve(double n, double g, const struct tsu_i_leaf_layers *layers,
                      struct tsu_i_leaf_faces *faces, double *memory);

// Layers of given faces. Time: some 60 coarse solutions for faces of leaves (4 to 10 ms), at most
// 900 and a few hundred milliseconds for odd ones.
void tsu_i_leaf_invert(const struct tsu_i_leaf_question *question, struct tsu_i_leaf_inverse *out,
                       double *memory);

// The same where R_bottom is a wish: R_top and T are kept, and R_bottom comes as near to the wish
// as that allows. The most unlike faces belong to a leaf all of whose pigment is in one layer.
void tsu_i_leaf_invert_near(const struct tsu_i_leaf_question *question,
                            struct tsu_i_leaf_inverse *out, double *memory);

#endif

// How far light spreads sideways in a thin slab: the transport equation, solved for one spatial
// frequency after the other of a pattern of light that comes along the normal.
//
// A pencil beam of power 1 falls on the first layer of a slab with smooth walls and air outside.
// What leaves at distance r of it per area is R(r) on the lit side and T(r) on the far side (the
// BSSRDF, a hemisphere of directions summed). R(k) = int R(r) J0(k r) 2 pi r dr is the answer to a
// pattern cos(k x): blurring is a product, R(0) and T(0) are the totals.
//
// For one k the unknowns are the moments of radiance over direction, up to degree L of spherical
// harmonics (even in the azimuth from x), on nodes of depth that are dense at the walls, parabolic
// between. Directions: Gauss nodes on both sides of the critical angle, in the outside cosine above
// it, and midpoints in the azimuth. Along a direction light is followed exactly through a cell and
// through all reflections at the walls; GMRES (Saad and Schultz 1986) closes the loop. What the
// phase function has beyond degree L goes on as if not scattered (delta-M, Wiscombe 1977): it
// counts as `straight`.
//
// Error (tests/optics/spread_test.c): totals of 40 leaves of two layers at random, against
// adding-doubling (slab.h): R 1.2e-3, T 6e-4 of the light that comes at the worst, at g near 0.8;
// 3e-4 for g to 0.6. A white slab's energy: 1e-9 thin, 2e-4 at a reduced depth of 8 (g 0.4), 1.5e-3
// (g 0.8); 1e-2 at 20. Transforms are within 5e-4 of their total to k d = 20, against more
// directions and nodes. Profiles against Monte Carlo: slab_blur.h.
//
// Cost: 1 to 5 ms a solution for g to 0.5, up to 25 ms for thick slabs of g 0.8.
#ifndef TSU_OPTICS_SLAB_SPREAD_H
#define TSU_OPTICS_SLAB_SPREAD_H

#include <stddef.h>

enum { TSU_I_SPREAD_LAYERS = 2 };

struct tsu_i_spread_layer {
    double scatter, absorption; // optical depths along the normal: sigma_s d, sigma_a d, >= 0
    double thickness;           // in any unit of length, > 0
};

struct tsu_i_spread_slab {
    double n; // refractive index of all layers, [1, 2]
    double g; // mean cosine of Henyey and Greenstein, [-0.9, 0.9]
    int layers;
    struct tsu_i_spread_layer layer[TSU_I_SPREAD_LAYERS];
};

// R without the wall's own reflection; T without `straight`, light that met nothing, which stays at
// r = 0.
struct tsu_i_spread {
    double reflected, through, straight;
};

// Bytes that a solution needs, aligned as double.
size_t tsu_i_spread_bytes(const struct tsu_i_spread_slab *slab);

// Solve for one spatial frequency k, radians per unit of length, >= 0. Returns 0 when the iteration
// did not converge to 1e-5 of the light that was scattered once; *out is the last step's then.
int tsu_i_spread_solve(const struct tsu_i_spread_slab *slab, double k, void *memory,
                       struct tsu_i_spread *out);

#endif

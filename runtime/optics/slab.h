// Light in a slab of plane scattering layers with smooth walls, solved: adding-doubling, azimuth
// mode by azimuth mode, in double precision.
//
// Any number of layers, each with its index, albedo, optical thickness and phase function; Fresnel
// reflection where the index changes and at both faces; thin clear plates on the faces; air (index
// 1) outside; light from either side; radiance at any depth inside.
//
// Directions inside are nodes of one invariant, k = n sin(theta), for all layers: between any two
// neighbouring indices there are `nodes` Gauss nodes, in a variable in which the cosines of both
// media are smooth, so that total reflection falls between intervals and costs no accuracy. A layer
// takes part with the nodes below its index. Cosines that the caller asks for are more nodes of
// weight 0: exact interpolation. The start of the doubling takes the source as constant over a thin
// layer: it conserves energy to rounding, has no singularity for any albedo, depth or cosine, and
// errs by the square of the thin layer's depth.
//
// A phase function with more moments than the nodes carry is cut there and what is cut goes on
// unscattered (delta-M); radiances get their single scattering back exactly, from the whole phase
// function, with all reflections of the beam and of the scattered ray at the walls.
//
// Errors, against many more nodes. Powers, 8 nodes, n from 1.05 to 2: 1e-7 (|g| to 0.5), 5e-6
// (0.75), 3e-5 (0.85); 16 nodes 2e-8; n between 1 and 1.01, 16 nodes: 1e-5; n 1: as 8 nodes with
// 16, relative to 1e-4 of what a slab thinner than 0.01 scatters. Radiances, relative: g 0.6, 12
// nodes 1e-8 (n 1.2 and above), 20 nodes 1e-6 (n 1); g 0.85 24 and 32; g 0.95 56 nodes, n 1 more
// than 100. What a white slab reflects and lets through adds up to 1 within 1e-12, whatever its
// thickness, phase function, index and number of nodes.
//
// Sources: van de Hulst 1980, "Multiple Light Scattering", chapters 4 and 5 (adding and doubling);
// Grant and Hunt 1969 (discrete space theory); Wiscombe 1977 (delta-M); Nakajima and Tanaka 1988
// (single scattering restored); Grassmann, Taksar and Heyman 1985 (elimination without subtraction,
// which keeps a conservative slab of any depth accurate).
#ifndef TSU_OPTICS_SLAB_H
#define TSU_OPTICS_SLAB_H

#include <stddef.h>
#include <stdint.h>

enum { TSU_I_SLAB_MOMENTS = 8 }; // of the phase function that are kept, for each node

struct tsu_i_slab_layer {
    double n;           // refractive index, [1, 4]
    double albedo;      // of single scattering, [0, 1]
    double depth;       // optical thickness, [0, infinity]
    double g;           // Henyey-Greenstein, (-1, 1); read where chi is NULL
    const double *chi;  // Legendre moments, chi[0] = 1, all of them [-1, 1]; those beyond are 0
    uint32_t chi_count; // [1, 4096]
};

// A cosine at which radiance comes or leaves, in a medium of index n: 1 for light outside, the
// layer's for directions inside it, which may be beyond total reflection.
struct tsu_i_slab_direction {
    double mu; // (0, 1]
    double n;  // [1, 4]
};

struct tsu_i_slab_desc {
    const struct tsu_i_slab_layer *layers; // from the top down
    uint32_t layer_count;           // [1, 64]; those below one of infinite depth get no light
    double slide_top, slide_bottom; // index of a thin clear plate on that face, [1, 4]; 1: none
    uint32_t nodes;                 // in each interval of indices, [4, 128]
    uint32_t modes; // azimuth modes at most, [1, 8 nodes]; 1 is enough for fluxes; fewer are solved
                    // where the rest is nothing
    const struct tsu_i_slab_direction *directions;
    uint32_t direction_count; // [0, 64]
    // Radiance inside: `level_depth` below the top of layer `level_layer`, inside_wanted != 0.
    uint32_t inside_wanted, level_layer;
    double level_depth; // [0, the layer's depth]
};

enum { TSU_I_SLAB_TOP, TSU_I_SLAB_BOTTOM }; // the side that is lit

// Results. Powers are shares of the power that comes; [side] is the side that is lit.
struct tsu_i_slab {
    // Light along directions[u] of the outside, arrays of direction_count: all that is reflected
    // (mirror reflection included), all that comes through (unscattered light included).
    const double *reflectance[2], *transmittance[2];
    // Of these, light that was never scattered.
    const double *specular[2], *direct[2];
    // Lambertian light from outside (uniform radiance).
    double diffuse_reflectance[2], diffuse_transmittance[2];
    // Power that crosses the level towards the bottom and towards the top, a unit of it coming
    // along directions[u], or Lambertian; unscattered light included. NULL and 0 without a level.
    const double *inside_down[2], *inside_up[2];
    double diffuse_inside_down[2], diffuse_inside_up[2];
    // Radiance at the level along directions[u], down and up, when all of the outside on that side
    // is of radiance 1; unscattered light included. NULL without a level.
    const double *sky_down[2], *sky_up[2];
    uint32_t modes; // solved

    const struct tsu_i_slab_desc *desc; // the caller's, which outlives this
    struct tsu_i_slab_work *work;       // in the caller's memory
};

// NULL, or the name of the first bad field ("layers.albedo") with its range.
const char *tsu_i_slab_check(const struct tsu_i_slab_desc *desc);
// Doubles that a checked description needs.
size_t tsu_i_slab_doubles(const struct tsu_i_slab_desc *desc);
// Solve a checked description. `memory` is aligned for double and lives as long as *slab is asked.
void tsu_i_slab_solve(struct tsu_i_slab *slab, const struct tsu_i_slab_desc *desc, double *memory);

// Scattered radiance that leaves towards directions[out], over the irradiance of light that comes
// along directions[in], azimuth phi between both directions of travel: BRDF of the lit side and
// BTDF, 1/sr; mirror reflection and unscattered light excluded. Both directions are outside ones.
// phi 0 is where a mirror would send the light, and straight on.
double tsu_i_slab_brdf(const struct tsu_i_slab *slab, int side, uint32_t in, uint32_t out,
                       double phi);
double tsu_i_slab_btdf(const struct tsu_i_slab *slab, int side, uint32_t in, uint32_t out,
                       double phi);
// The same inside, at the level: radiance in the layer (not over n^2) that travels along
// directions[out], up to the top or down, over the irradiance from outside.
double tsu_i_slab_inside(const struct tsu_i_slab *slab, int side, int up, uint32_t in, uint32_t out,
                         double phi);

#endif

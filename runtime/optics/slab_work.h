// Inside the slab solver: what its files share.
//
// Nodes: the caller's directions first (weight 0), then Gauss nodes by falling steepness, so that
// those which a layer has are the first ones. Matrices are kernels K(out, in) of basic radiance,
// row-major, `count` wide: out(i) = sum over j of K(i, j) weight(j) in(j), where weight is the
// node's share of d(k^2), the same in all media. A whole slab's kernel is pi times its BRDF or
// BTDF. Light that was never scattered is kept apart from them.
#ifndef TSU_OPTICS_SLAB_WORK_H
#define TSU_OPTICS_SLAB_WORK_H

#include "optics/slab.h"

// A layer, a boundary, or a stack of them. [0]: lit from the top, [1]: from below.
struct tsu_i_slab_element {
    double *back[2]; // kernels of what comes back; a layer's are the same matrix
    double *through; // kernel from the top; from below it is the transpose
    int reach;       // nodes that the kernels have; 0 for a boundary
    int same;        // looks the same from below
    // Light that was never scattered: share that comes back, goes through (the same from either
    // side), and all the rest.
    double *mirror[2], *straight, *lost[2];
    // Shares of power, kept in mode 0: absorbed; not sent back, so absorbed or let through.
    double *absorbed[2], *kept[2];
};

// A layer's scattering after delta-M.
struct tsu_i_slab_scattering {
    double albedo, absorption; // absorption: 1 - albedo
    double stretch;            // optical thickness over the one given
    double restored;           // albedo that goes with the whole phase function
    double *chi;               // moments, work->moments
    int moments;               // of them that are not 0
    double *extinction;        // of each node, 1 but for what balances the quadrature
};

// The slab as light that is scattered once meets it: a layer, or the part of one above or below the
// level, with the boundary on its top.
struct tsu_i_slab_part {
    uint32_t layer;
    double depth; // after delta-M
};

enum { TSU_I_SLAB_SCRATCH = 9, TSU_I_SLAB_MOST_LAYERS = 64, TSU_I_SLAB_MOST_NODES = 128 };

struct tsu_i_slab_work {
    int count, users, nodes, moments, fine; // nodes and fine nodes are of one interval
    double *normal2, *index; // of a node: (n cos(theta))^2 in the medium of this index
    double *weight;
    // Fine nodes of each interval, and what they add to the mean around each of its nodes.
    double *fine_normal2, *basis;
    struct tsu_i_slab_scattering *scattering; // one a layer
    struct tsu_i_slab_element above, below, layer, boundary;
    double *loop, *down[2], *up[2], *spare; // matrices
    double *down_straight[2], *up_straight[2];
    double *scratch[TSU_I_SLAB_SCRATCH]; // vectors
    // Legendre functions, `moments` a node, and of whom they are; two rows more.
    double *functions, functions_n;
    int functions_mode, functions_count;
    double *results;
    struct tsu_i_slab_part *parts;
    uint32_t part_count, level; // the level is on top of part `level`
    double *ladder;             // see slab_single.c
    double *multiple;           // [mode][side][kind][out][in]: scattered more than once
};

// Where scattered light is asked for.
enum { TSU_I_SLAB_BACK, TSU_I_SLAB_THROUGH, TSU_I_SLAB_UP, TSU_I_SLAB_DOWN, TSU_I_SLAB_KINDS };

// slab_nodes.c
// Distinct indices of air and layers, rising; how many: at most TSU_I_SLAB_MOST_LAYERS + 1.
int tsu_i_slab_indices(const struct tsu_i_slab_desc *desc, double *out);
void tsu_i_slab_nodes(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc);
// n cos(theta) of a node in a medium of index n; 0 when it has no such direction.
double tsu_i_slab_normal(const struct tsu_i_slab_work *work, int node, double n);
// Share of power that goes through the boundary on top of layer `below`; below = layer_count is the
// bottom face. *mirror: the rest.
double tsu_i_slab_boundary(const struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                           uint32_t below, int node, double *mirror);

// slab_add.c. `above` becomes itself over `below`, which may be the same layer. down[side] and
// up[side], with down_straight and up_straight, get what goes down and up between the two; up[1]
// only when `between` is set. Kernels are nonnegative in mode 0 but for the ripple of cut phase
// functions.
void tsu_i_slab_add(struct tsu_i_slab_work *work, struct tsu_i_slab_element *above,
                    const struct tsu_i_slab_element *below, int mode, int between);
// right = (gap - kernel weight)^-1 right for one or two right sides; destroys the kernel. With
// `balance` (destroyed) the diagonal is what conservation says it is: balance(j) = gap(j) - sum
// over i of weight(i) kernel(i, j), from losses. Then nothing is subtracted, and a slab that
// absorbs nothing keeps its accuracy at any depth.
void tsu_i_slab_eliminate(const struct tsu_i_slab_work *work, int reach, double *kernel,
                          const double *gap, double *balance, double *first, double *second);
// out(j) = sum over i of weight(i) v(i) kernel(i, j).
void tsu_i_slab_powers(const struct tsu_i_slab_work *work, int reach, const double *v,
                       const double *kernel, double *out);
// Sum over j of kernel(i, j) weight(j) v(j).
double tsu_i_slab_power(const struct tsu_i_slab_work *work, int reach, const double *v,
                        const double *kernel, int i);

// slab_layer.c
void tsu_i_slab_scattering(struct tsu_i_slab_work *work, const struct tsu_i_slab_layer *layer,
                           struct tsu_i_slab_scattering *out);
// work->layer becomes `depth` (after delta-M) of a layer.
void tsu_i_slab_layer(struct tsu_i_slab_work *work, double n,
                      const struct tsu_i_slab_scattering *scattering, double depth, int mode);

// slab_single.c
size_t tsu_i_slab_single_doubles(int users, uint32_t parts);
void tsu_i_slab_single_begin(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc);
// Of light along a direction that comes to one side: share that is never scattered and comes back;
// *straight: goes through. By the optical thickness that was given.
double tsu_i_slab_unscattered(const struct tsu_i_slab_work *work,
                              const struct tsu_i_slab_desc *desc, int side, int direction,
                              double *straight);
// Take light that was scattered once out of multiple[mode].
void tsu_i_slab_single_remove(struct tsu_i_slab_work *work, const struct tsu_i_slab_desc *desc,
                              uint32_t mode);

#endif

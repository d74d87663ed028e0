// A small tree out of numbers: skeleton, wood and leaves, the same for a seed everywhere.
#ifndef TSUYA_LEAF_TREE_H
#define TSUYA_LEAF_TREE_H

#include "leaf/generate.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <vector>

namespace tsuya::leaf {

struct TreeParams {
    std::uint64_t seed = 1;
    std::uint32_t leaves = 3600; // exactly as many, [200, 20000]
    std::uint32_t twigs = 1100;  // places that the tree grows towards, [40, 4000]
    double height = 2.3;         // metres, of the crown's top, [0.5, 30]
    double crown_width = 0.72;   // greatest diameter over the height, [0.2, 2]
    double crown_base = 0.24;    // where the crown begins, share of the height, [0, 0.8]
    double phototropism = 0.7;   // how far blades turn up and outwards, [0, 1]
    double droop = 0.35;         // how far leaves hang, [0, 1]
    double variation = 0.12;     // deviation of pigment from leaf to leaf, [0, 0.5]
    LeafParams leaf;             // rows, columns and texels are those of every leaf
};

// A tree with its leaf of `shape`: coarse blades, less relief, maps of 512 texels.
Expected<TreeParams> tree_preset(const std::string &shape);

// One leaf: a blade and stalk of `kind`, placed.
struct Placed {
    glm::mat4 place{1.0f};  // of the leaf at rest to the tree: rotation, translation and a
                            // uniform scale
    std::uint32_t kind = 0; // which of Plant::kinds
    std::uint32_t node = 0; // of the skeleton that it grows on; it is attached between this
                            // node and its parent
    float pigment = 1.0f;   // factor on the maps, > 0
    float thickness = 1.0f; // likewise
};

// A node of the skeleton; the first is the root, every other comes after its parent.
struct Node {
    glm::vec3 place{0.0f}; // metres
    std::uint32_t parent = 0;
    float radius = 0.0f; // metres; the square of a node's is the sum of its children's
};

// A blade and a stalk that leaves share. Their maps are Plant::maps.
struct Kind {
    Mesh blade, stalk;
};

// A single leaf or a tree, ready to be drawn. +y is up; a tree stands at the origin.
struct Plant {
    std::vector<Kind> kinds;
    Maps maps;
    std::vector<Placed> leaves;
    Mesh wood;               // closed tubes; no triangles for a single leaf
    std::vector<Node> nodes; // none for a single leaf
    glm::vec3 centre{0.0f};  // of the crown, for normals that follow it, metres
    glm::vec3 half{0.0f};    // its half axes; 0: there is none
};

// Grow a tree: by space colonisation (Runions, Lane and Prusinkiewicz 2007, "Modeling Trees with a
// Space Colonization Algorithm") towards points in an egg-shaped crown, with radii by da Vinci's
// rule, and leaves on the outer twigs at golden angles. The same bytes for the same parameters on
// every machine, as generate().
//
// Cost:    the default tree takes less than a second on one core.
// Errors:  a parameter out of range; those of generate().
// Threads: any.
Expected<Plant> grow(const TreeParams &params);

// A single leaf as a plant.
Plant single(Leaf leaf);
// The same for a mesh from a file, without maps.
Plant single(Mesh mesh);

} // namespace tsuya::leaf

#endif

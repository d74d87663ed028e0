// A leaf out of numbers: outline, blade, stalk and maps, the same for a seed everywhere.
#ifndef TSUYA_LEAF_GENERATE_H
#define TSUYA_LEAF_GENERATE_H

#include "leaf/maps.h"
#include "leaf/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::leaf {

// What to grow. preset() gives values that suit each other; every field can be changed from there
// within its range. Shares are of the blade's length along the midrib, 0 at its base, unless
// something else is said.
struct LeafParams {
    std::uint64_t seed = 1;    // any
    double length = 0.09;      // metres, of the blade along its midrib, [0.005, 1]
    double width = 0.6;        // greatest width over length, [0.05, 1.5]
    double widest = 0.42;      // where it is widest, [0.2, 0.8]
    double tip = 0.7;          // 0 round, 0.5 pointed, 1 drawn out into a drip tip
    double base = 0.6;         // 0 wedge, 0.5 pointed, 1 round
    double heart = 0.0;        // how far the base reaches back beside the stalk, [0, 0.25]
    std::uint32_t teeth = 0;   // along each margin, [0, 80]
    double tooth_depth = 0.03; // of half the width, [0, 0.2]
    std::uint32_t lobes = 0;   // along each margin, [0, 8]
    double lobe_depth = 0.35;  // of half the width, [0, 0.45]
    double roughness = 0.5;    // of the outline, and halves that differ, [0, 1]
    double petiole = 0.25;     // length of the stalk, [0, 1.5]

    std::uint32_t veins = 9; // secondary veins on each side, [2, 30]
    double sweep = 0.55;     // how far they run forward on their way to the margin, [0, 1]
    double curve = 0.5;      // 0: they run straight, 1: they bend forward near the margin
    double loops = 0.0;      // 0: they end at the margin, 1: each joins the next before it

    double fold = 0.35; // angle by which each half rises at the midrib, radians, [-1.2, 1.2]
    double curl = 0.9;  // share of it that is gone at the margin, above 1 it hangs, [0, 3]
    double bend = 0.6;  // angle by which the midrib turns down, radians, [-3, 3]
    double twist = 0.1; // about the midrib, radians, [-2, 2]
    double wave = 0.06; // of the margin, of half the width, [0, 0.5]

    double blotches = 0.16; // deviation of the pigment in clouds, [0, 1]
    double edge = 0.15;     // more pigment at the margin, [-0.6, 1]
    double halo = 0.2;      // less pigment beside the large veins, [0, 0.9]
    double relief = 1.0;    // height of veins and of the blade between them, [0, 3]

    std::uint32_t rows = 72;     // of quads from base to tip, [8, 512], at least 5 a tooth
    std::uint32_t columns = 14;  // of quads on each side, [2, 64]
    std::uint32_t texels = 1536; // of the maps along their longer side, [64, 8192]; 0: no maps
};

// Shapes like those of species: "beech", "linden", "willow", "oak", "ficus".
const std::vector<std::string> &shapes();
// Errors: no shape of this name; the message lists them.
Expected<LeafParams> preset(const std::string &shape);

// A leaf at rest: its stalk begins at the origin, the blade runs towards +y with its upper side to
// +z and its left half at -x.
struct Leaf {
    Mesh blade; // one sheet, a disk: Euler characteristic 1, one boundary
    Mesh stalk; // closed, with albedo; runs on under the midrib; no triangles where petiole is 0
    Maps maps;
    double flat_area = 0.0; // of the blade before it was bent, square metres
};

// Grow a leaf. The same bytes for the same parameters on every machine with plain IEEE 754 doubles:
// see groom/numeric.h.
//
// Cost:    the default leaf with its maps takes about a second on one core.
// Errors:  a parameter out of range (the message names it and the range); an outline that folds
//          over itself.
// Threads: any.
Expected<Leaf> generate(const LeafParams &params);

} // namespace tsuya::leaf

#endif

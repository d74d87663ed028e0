// Private to the generator: a tree's skeleton and its wood.
#ifndef TSUYA_LEAF_SKELETON_H
#define TSUYA_LEAF_SKELETON_H

#include "groom/numeric.h"

#include "leaf/tree.h"

#include <vector>

namespace tsuya::leaf {

struct Bone {
    groom::Vec place;
    std::uint32_t parent = 0;
    std::vector<std::uint32_t> children; // the thickest first, once radii are known
    double radius = 0.0;
    double reach = 0.0; // metres along the wood to its farthest tip
};

// Half axes and centre of the crown, and whether a place is in it. It is an egg: wider below.
class Crown
{
  public:
    explicit Crown(const TreeParams &params);
    bool holds(groom::Vec p) const;
    // Unit vector out of the crown at p.
    groom::Vec out(groom::Vec p) const;

    groom::Vec centre, half;
};

// Bones in an order in which parents come first; bone 0 is the root.
std::vector<Bone> skeleton(const TreeParams &params, const Crown &crown);

// Tapered closed tubes along the bones.
Mesh wood(const TreeParams &params, const std::vector<Bone> &bones);

} // namespace tsuya::leaf

#endif

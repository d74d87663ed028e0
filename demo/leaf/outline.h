// Private to the generator: the flat blade.
//
// A place on one half is (s, r): s in [0, 1] along the leaf, r from 0 on the midrib to 1 on the
// margin. Lines of equal s run forward as they leave the midrib.
#ifndef TSUYA_LEAF_OUTLINE_H
#define TSUYA_LEAF_OUTLINE_H

#include "groom/numeric.h"

#include "leaf/generate.h"

namespace tsuya::leaf {

// Metres; the midrib begins at (0, 0) and runs along +y.
struct Flat {
    double x = 0.0, y = 0.0;
};

// Smooth random function of one and of two numbers: mean about 0, in (-1, 1), features 1 apart.
double noise(std::uint64_t seed, double x);
double noise(std::uint64_t seed, double x, double y);

class Outline
{
  public:
    explicit Outline(const LeafParams &params);

    // The place (s, r) of the half `side`, -1 or 1; teeth and lobes included.
    Flat at(double s, double r, int side) const;
    // s along a secondary vein that ends on the margin at `end`.
    double vein(double end, double r) const;
    // Half the width at s without teeth, lobes and roughness, metres.
    double half_width(double s) const;
    // Sideways deviation of the midrib at y, metres.
    double sway(double y) const;

    const LeafParams &params() const
    {
        return params_;
    }

  private:
    double lobe(double s) const;
    double tooth(double s) const;

    LeafParams params_;
    double slant_ = 0.0, uneven_ = 0.0, sway_ = 0.0;
};

} // namespace tsuya::leaf

#endif

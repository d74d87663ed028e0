// Private to the generator: the flat blade bent in space, and its stalk.
#ifndef TSUYA_LEAF_BLADE_H
#define TSUYA_LEAF_BLADE_H

#include "leaf/outline.h"

#include <vector>

namespace tsuya::leaf {

class Blade
{
  public:
    explicit Blade(const Outline &outline);

    // The flat place (s, r) of a half, bent. Lengths along the midrib and across it are kept.
    groom::Vec at(double s, double r, int side) const;
    // On the midrib at y, metres; before its base, y < 0, straight on.
    groom::Vec middle(double y) const;
    // Unit vectors there: along, and up (the upper side).
    groom::Vec along(double y) const;
    groom::Vec up(double y) const;

    const Outline &outline() const
    {
        return outline_;
    }

  private:
    double heading(double q) const; // of the midrib against +y, turns

    const Outline &outline_;
    std::vector<groom::Vec> spine_; // of equal steps along the midrib
    double phase_[2] = {0.0, 0.0};
};

// The sheet, without maps: positions, uv over the flat box, normals, tangents.
//
//   lower, size   box of the flat blade that uv fill
//   flat_area     of the mesh before it was bent
// Returns: false where the outline folds over itself.
bool make_blade(const Blade &blade, const Flat &lower, const Flat &size, Mesh &mesh,
                double &flat_area);

// A tube below the midrib from the stalk's beginning to where the midrib is thin. `begin` is its
// beginning's place.
void make_stalk(const Blade &blade, Mesh &mesh, groom::Vec &begin);

// Box of the flat blade, a little larger.
void flat_box(const Outline &outline, Flat &lower, Flat &size);

} // namespace tsuya::leaf

#endif

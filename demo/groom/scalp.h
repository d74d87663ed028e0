// Private to the generator: the head, its scalp, and roots on it.
#ifndef TSUYA_GROOM_SCALP_H
#define TSUYA_GROOM_SCALP_H

#include "numeric.h"

#include "generate.h"

namespace tsuya::groom {

struct Ellipsoid {
    Vec centre;
    Vec axes; // half, metres

    // p in the coordinates where this is the unit sphere.
    Vec inside(Vec p) const
    {
        return (p - centre) / axes;
    }
};

struct Scalp {
    Mesh head;
    Mesh scalp;
    Ellipsoid body;
    bool neck = false; // the built-in neck is below: keep hair out of it too
};

// Half axes of the built-in neck's cross-section, an ellipse around the y axis,
// and the height up to which it reaches.
constexpr double neck_width = 0.050;
constexpr double neck_depth = 0.070;
constexpr double neck_top = -0.06;
// In front, below the chin, it is less deep; and the head's mesh ends at this height.
constexpr double throat_depth = 0.042;
constexpr double head_bottom = -0.21;

struct Root {
    Vec position;
    Vec normal;
    std::uint32_t face;
};

Scalp built_in_scalp();

// Errors: those of generate() about its mesh.
Expected<Scalp> load_scalp(const ScalpParams &params);

// `count` roots on `scalp`, uniform by area and in random order. One falls in
// each of `count` equal parts of the area, which is evener than chance.
std::vector<Root> sample_roots(const Scalp &scalp, std::uint32_t count, std::uint64_t seed);

} // namespace tsuya::groom

#endif

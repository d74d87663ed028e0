// What varies over a blade: pigment, thickness and relief as textures.
#ifndef TSUYA_LEAF_MAPS_H
#define TSUYA_LEAF_MAPS_H

#include <cstddef>
#include <vector>

namespace tsuya::leaf {

constexpr float pigment_least = 0.25f, pigment_most = 2.0f;
constexpr float thickness_least = 0.5f, thickness_most = 2.0f;

// Rows of texels, the first at v = 0 (the leaf's base), texel (0, 0) centred at half a texel of u
// and v. Texels off the blade go on with what is beside it, so that filtering meets no edge.
struct Maps {
    int width = 0, height = 0;
    double metres = 0.0; // of a texel's side, on the flat blade
    // Factor on the material's absorbers. Grown: [pigment_least, pigment_most], mean over the blade
    // 1 within 1 %, least on veins. From a file: [0, pigment_most].
    std::vector<float> pigment;
    // Factor on the blade's thickness, [thickness_least, thickness_most]. Grown: mean over the
    // blade 1 within 1 %, most on midrib and veins.
    std::vector<float> thickness;
    // Of the sheet's middle above the flat blade, metres, towards the upper side: veins are furrows
    // above and ridges below.
    std::vector<float> relief;
    // 1 where the texel's centre is on the blade, else 0.
    std::vector<unsigned char> inside;
    // From a file (scene/leaf_maps.h), where relief and inside are empty: what slopes() returns.
    std::vector<float> slope = {};
    bool repeat = false; // beyond uv in [0, 1], instead of going on with the edge

    bool empty() const
    {
        return pigment.empty();
    }
};

// Slopes of the relief along u and v, two numbers a texel: central differences over texels, metres
// over metres; those of a file as they are. A normal in the frame (tangent, bitangent, normal) is
// (-first, -second, 1).
std::vector<float> slopes(const Maps &maps);

} // namespace tsuya::leaf

#endif

// What a scene of a leaf or a tree is to the chooser (tsuya/choose.h), but for its material.
#ifndef TSUYA_SCENE_LEAF_TRAITS_H
#define TSUYA_SCENE_LEAF_TRAITS_H

#include "scene/plant.h"

namespace tsuya::scene {

struct LeafTraits {
    double footprint = 0.0;      // side of what a pixel covers at the middle of the picture, mm
    double curvature = 0.0;      // radius that nine tenths of the blades' area exceed, mm; 1e9 when
                                 // they are flat
    double covered_pixels = 0.0; // by blades, as they stand before one another
    bool backlit = false;        // there is a sky, or a light reaches more than a hundredth of the
                                 // area that faces the viewer from behind
    bool varies = false;         // pigment or thickness differ between places or leaves
    double sky_share = 0.0, light_cosine = 0.0; // as of hair (scene/traits.h)
    int directional_lights = 0, point_lights = 0, area_lights = 0, environments = 0;
};

// frame  frame() of the same scene and surface
LeafTraits traits(const Scene &scene, const Surface &surface, const draw::SurfaceFrame &frame);

} // namespace tsuya::scene

#endif

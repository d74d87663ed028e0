// Texture maps of a leaf's mesh, from the pictures that a scene names.
#ifndef TSUYA_SCENE_LEAF_MAPS_H
#define TSUYA_SCENE_LEAF_MAPS_H

#include "leaf/maps.h"
#include "leaf/read.h"
#include "scene/scene.h"

#include <array>
#include <string>

namespace tsuya::scene
{

// A key that names a map's file.
struct LeafMapKey {
    const char *name;
    std::string Scene::*path; // "none": no such map
    const char *help;
};

// Pigment, thickness, normal, height.
const std::array<LeafMapKey, 4> &leaf_map_keys();

// The first key of a map that `scene` gives; "" when it gives none.
std::string leaf_map_given(const Scene &scene);

// Read the maps of the leaf that was read from scene.mesh.
//
// Files:   .png of 1 to 16 bits or .exr, at most 8192 texels a side. A PNG's levels count as they
//          are, from 0 to 1, whatever curve it names. Pigment, thickness and height are grey: Y,
//          the only colour channel, or red, green and blue that are equal. Where alpha is 0 the map
//          is not painted: factor 1, no slope. Other alpha is left alone.
//   pigment    factor on the material's absorbers, [0, 2].  PNG: 2 value
//   thickness  factor on the blade's thickness, [0.5, 2].   PNG: 0.5 * 4^value
//   normal     of the upper side in the tangent frame: red along u, green along v (up in the
//              picture; down with mesh.normal_green=down), blue out of the surface. Length in
//              [0.5, 1.1], of which only the direction counts; at most a slope of 20, 87 degrees.
//              PNG: value = (component + 1) / 2, so that level 128 of 255 leans by 0.2 degrees
//   height     times mesh.height_mm, towards the upper side, [-1000, 1000]. PNG: value. 8 bits make
//              steps. Along u and v it is taken over the mesh's mean metres of each, so that a uv
//              that is stretched here and there has slopes that err by as much; at most a slope of
//              20
// Place:   the picture's lower left corner is at uv (0, 0), its upper right one at (1, 1). Where
// the
//          mesh's uv go beyond that, all maps repeat; else they end at their edges.
// Size:    maps of different sizes are brought to the greatest width and height among them,
//          bilinearly between texel centres, slopes after they were made.
// Errors:  as image::read_png() and read_exr(); a file of another size or other channels, or whose
//          alpha is 0 everywhere; a value
//          that is no number or out of range, the message naming key, file, texel and range; a mesh
//          that has no uv; both a normal and a height map.
Expected<leaf::Maps> leaf_maps(const Scene &scene, const leaf::Loaded &loaded);

} // namespace tsuya::scene

#endif

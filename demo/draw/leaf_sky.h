// How much of the sky is seen in a crown: leaves as a cloud.
#ifndef TSUYA_DRAW_LEAF_SKY_H
#define TSUYA_DRAW_LEAF_SKY_H

#include "leaf/tree.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace tsuya::draw {

// Radiance around places of a box of the plant's space, colour by colour as a + b . d for the
// world's direction d.
struct LeafSky {
    glm::ivec3 size{0}; // cells; 0: nothing stands in the way anywhere
    glm::vec3 corner{0.0f};
    glm::vec3 cell{0.0f};
    // Per colour, then z, y, x: a and b, four numbers.
    std::vector<float> texels;
};

// The environment's radiance (record of tsuya/light.h) dimmed by the leaves of a tree, from 64
// directions: they are spread evenly within a cell, turned at random (each hides half its area),
// and let pass a fifth of what they hide, for what they reflect and transmit. Wood hides nothing.
// Empty for a single leaf.
//
//   turn  plant's directions to the world's
LeafSky leaf_sky(const leaf::Plant &plant, const std::array<float, 36> &environment,
                 const glm::mat3 &turn);

} // namespace tsuya::draw

#endif

// Directional lights, and a sky made of them.
#ifndef TSUYA_DRAW_LIGHTS_H
#define TSUYA_DRAW_LIGHTS_H

#include <glm/vec3.hpp>

#include <vector>

namespace tsuya::draw {

constexpr int lights_most = 32; // in one frame
constexpr int sky_most = 32;

struct Light {
    glm::vec3 direction;  // towards the light, unit, world
    glm::vec3 irradiance; // on a plane that faces the light, linear
};

// A sky of uniform radiance as `count` lights of equal solid angle, 4 pi / count, spread over the
// whole sphere on a Fibonacci spiral. The same directions at every call.
std::vector<Light> sky(const glm::vec3 &radiance, int count);

} // namespace tsuya::draw

#endif

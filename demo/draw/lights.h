// Lights, and a sky made of directional ones.
#ifndef TSUYA_DRAW_LIGHTS_H
#define TSUYA_DRAW_LIGHTS_H

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace tsuya::draw {

constexpr int lights_most = 32; // in one frame
constexpr int sky_most = 32;
constexpr int areas_most = 8; // of the first lights, those that are more than a direction

struct Light {
    glm::vec3 direction;  // towards the light, unit, world
    glm::vec3 irradiance; // on a plane that faces the light, linear
    // tsu_light_pack() of a light with a place or a size, whose direction and irradiance above are
    // those at the origin: for the head and for the one look at the shadow. 0: there is no more.
    std::array<float, 16> record{};
};

// A sky of uniform radiance as `count` lights of equal solid angle, 4 pi / count, spread over the
// whole sphere on a Fibonacci spiral. The same directions at every call.
std::vector<Light> sky(const glm::vec3 &radiance, int count);
// The same with the radiance of an environment's record (tsuya/light.h).
std::vector<Light> sky(const std::array<float, 36> &environment, int count);

} // namespace tsuya::draw

#endif

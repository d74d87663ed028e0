// Lights, and a sky made of directional ones.
#ifndef TSUYA_DRAW_LIGHTS_H
#define TSUYA_DRAW_LIGHTS_H

#include <glm/mat4x4.hpp>
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
    // those in the middle of what is lit: for the grid's shadow. 0: there is no more.
    std::array<float, 16> record{};

    // Is it somewhere, record[0] to [2]?
    bool placed() const
    {
        return record[3] > 0.5f && record[3] < 3.5f;
    }
};

// Where from, in which light and how finely a picture is drawn. Lengths in metres, colours linear
// Rec. 709.
struct View {
    int width = 640, height = 640; // pixels
    int supersample = 1;           // samples along a pixel's side, [1, 8]
    glm::mat4 model{1.0f};         // to the world: rotation, translation, uniform scale
    glm::mat4 view{1.0f};          // world to eye
    glm::mat4 projection{1.0f};
    glm::vec3 eye{0.0f};       // in the world
    float distance = 1.0f;     // from the eye to what it looks at
    float near = 0.01f;        // what is nearer is left out
    std::vector<Light> lights; // evaluated in each pixel; at most lights_most
    glm::vec3 background{0.0f};
};

// A sky of uniform radiance as `count` lights of equal solid angle, 4 pi / count, spread over the
// whole sphere on a Fibonacci spiral. The same directions at every call.
std::vector<Light> sky(const glm::vec3 &radiance, int count);
// The same with the radiance of an environment's record (tsuya/light.h).
std::vector<Light> sky(const std::array<float, 36> &environment, int count);

} // namespace tsuya::draw

#endif

// Lights of a scene's own, and its surroundings.
#ifndef TSUYA_SCENE_LIGHT_H
#define TSUYA_SCENE_LIGHT_H

#include "draw/renderer.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace tsuya::scene {

// One lightN as the renderer takes it. `middle` of what it lights: where the direction and the
// irradiance of a light with a place are taken.
draw::Light own_light(const SceneLight &light, const glm::dvec3 &middle);

// The key environment=: harmonics and a dominant light, which may be none.
struct Surroundings {
    bool there = false;
    std::array<float, 36> record{};
    std::vector<draw::Light> dominant;
};

// Errors: a file that cannot be read, is no picture twice as wide as high, or holds values that are
//         no radiance.
Expected<Surroundings> surroundings(const Scene &scene);

} // namespace tsuya::scene

#endif

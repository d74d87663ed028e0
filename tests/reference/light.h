// Where light comes from: places, directions and surroundings, sampled without bias.
//
// Built from a scene's keys and the picture of its surroundings; nothing of the library's own
// lights (tsuya/light.h) is in it, because those are judged by it.
#ifndef TSUYA_TESTS_REFERENCE_LIGHT_H
#define TSUYA_TESTS_REFERENCE_LIGHT_H

#include "reference/random.h"
#include "scene/globe.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <limits>
#include <memory>
#include <vector>

namespace tsuya::reference
{

// One way to a light.
struct Way {
    glm::dvec3 direction{0.0, 1.0, 0.0}; // towards it, unit
    glm::dvec3 irradiance{0.0};          // on a plane that faces it, over the way's probability
    double length = std::numeric_limits<double>::infinity(); // metres; behind it nothing blocks
};

struct Light {
    enum class Kind { directional, point, rect, disk };

    glm::dvec3 direction{0.0, 1.0, 0.0}; // towards it, unit
    glm::dvec3 irradiance{0.0}; // on a plane that faces it; of a point its intensity, of an
                                // area its radiance
    Kind kind = Kind::directional;
    double angle = 0.0; // of a directional one, between centre and rim, radians
    glm::dvec3 position{0.0}, x{0.0}, y{0.0}; // half axes; it shines along x times y
    bool two_sided = false;

    // A way from `from`; its irradiance is 0 behind an area that shines to one side. Areas are
    // sampled evenly.
    Way way(const glm::dvec3 &from, Random &random) const;
};

// lightN of a scene, placed as the renderer places it.
Light light_of(const scene::SceneLight &light);

// Surroundings in two parts whose sum they are: what paths find that meet nothing more, bounded so
// that a narrow sun makes no noise, and the rest, which is sampled by its power like a light.
class Sky
{
  public:
    explicit Sky(scene::Globe globe);

    glm::dvec3 radiance(const glm::dvec3 &direction) const; // the bounded part
    Way way(Random &random) const;                          // to the rest

  private:
    glm::dvec3 part(std::size_t i, bool bounded) const;

    scene::Globe globe_;
    double bound_ = 0.0;        // of the first part's strongest channel
    std::vector<double> power_; // of the rest: sums over the picture's points
};

} // namespace tsuya::reference

#endif

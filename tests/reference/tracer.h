// Paths of light from the eye: any number of meetings, no light of any kind left out.
#ifndef TSUYA_TESTS_REFERENCE_TRACER_H
#define TSUYA_TESTS_REFERENCE_TRACER_H

#include "reference/fiber.h"
#include "reference/geometry.h"
#include "reference/light.h"

#include <glm/vec3.hpp>

#include <memory>
#include <vector>

namespace tsuya::reference {

// What light meets, and where it comes from. Linear Rec. 709, radiance.
struct World {
    std::shared_ptr<const Geometry> geometry;
    std::shared_ptr<const Fiber> fiber;
    std::vector<Light> lights;
    glm::dvec3 sky{0.0};        // from every direction
    std::shared_ptr<const Sky> around; // surroundings beyond that; may be null
    glm::dvec3 background{0.0}; // what the camera sees where nothing is; it lights nothing
    glm::dvec3 skin{0.0};       // albedo of the surface, diffuse
};

// A path that has come as far as `start` and goes on in `direction`.
struct Path {
    Start start;
    glm::dvec3 direction{0.0, 0.0, -1.0}; // away from the eye, unit
    double near = 0.0;                    // skipped, metres
    glm::dvec3 throughput{1.0};
    int meetings = 0;
};

enum class Fate {
    escaped,  // it met nothing more; direction and throughput are those it left with
    ended,    // absorbed, or given up by Russian roulette
    scattered // start, direction and throughput are new
};

// One camera sample.
struct Sample {
    glm::dvec3 radiance{0.0};
    double hair = 0.0; // 1 when the camera saw hair first
};

class Tracer
{
  public:
    explicit Tracer(const World &world) : world_(world)
    {
    }

    // Go on to the next meeting and scatter there.
    //   direct  gets radiance from the lights, through this one meeting, added; may be null
    //   hit     gets what was met; may be null
    // Threads: any, also at the same time; the same for sample().
    Fate advance(Path &path, Random &random, glm::dvec3 *direct, Hit *hit) const;

    // Radiance along a whole path. Unbiased; no bound on its length.
    Sample sample(const Path &start, Random &random) const;

    const World &world() const
    {
        return world_;
    }

  private:
    // Ways to all lights that nothing blocks.
    template <class Take> void light(const Start &start, Random &random, Take take) const;
    void scatter(const Hit &hit, Path &path, Random &random, glm::dvec3 *direct) const;
    void reflect(const Hit &hit, Path &path, Random &random, glm::dvec3 *direct) const;

    World world_;
};

} // namespace tsuya::reference

#endif

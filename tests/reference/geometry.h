// Fibres and a surface in Embree, as a far-field fibre wants them met.
//
// A fibre is met where a way comes closer to its axis than its radius. Seen from the way that is a
// ribbon that faces it, as broad as the fibre, like the renderer's. Light leaves again from the
// axis, so no part of the fibre it was at can be in its way twice: the stretch of the same strand
// that has not yet departed from the new way is left out. A strand that curls back is met again.
#ifndef TSUYA_TESTS_REFERENCE_GEOMETRY_H
#define TSUYA_TESTS_REFERENCE_GEOMETRY_H

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace tsuya::reference {

// Polylines with a radius at each point, one after the other.
struct Strands {
    std::vector<glm::vec3> points;
    std::vector<float> radius;        // one per point, >= 0
    std::vector<glm::vec3> tangent;   // one per point, from root to tip, any length above 0
    std::vector<std::uint32_t> first; // strand s is [first[s], first[s + 1]); one more than strands
    std::vector<double> chance;       // one per strand, [-1, 1]; see Fiber
};

// Triangles; normals are interpolated, on the side that the viewer is on.
struct Surface {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; // one per position
    std::vector<std::uint32_t> indices;
};

// Where a way begins.
struct Start {
    static constexpr std::uint32_t nowhere = 0xffffffffu;

    glm::dvec3 position{0.0};
    std::uint32_t point = nowhere;    // first point of the segment it is on the axis of
    std::uint32_t triangle = nowhere; // that it is on
};

struct Hit {
    double distance = 0.0;
    Start start;        // of a way that goes on from here; a fibre's is on its axis
    glm::dvec3 tangent; // of a fibre, unit
    glm::dvec3 normal;  // of a surface: interpolated and its facet's, unit, towards the viewer
    glm::dvec3 facet;
    double chance = 0.0; // of the strand

    bool fibre() const
    {
        return start.point != Start::nowhere;
    }
};

class Geometry
{
  public:
    // Threads of the building of the tree; 0: all cores. Throws std::runtime_error with Embree's
    // reason, memory above all.
    Geometry(Strands strands, Surface surface, unsigned threads = 0);
    ~Geometry();
    Geometry(const Geometry &) = delete;
    Geometry &operator=(const Geometry &) = delete;

    // What a way meets first. Returns: false when it meets nothing.
    //   direction  unit
    //   near       metres that are skipped, >= 0
    // Threads: any, also at the same time; the same for blocked().
    bool meets(const Start &start, const glm::dvec3 &direction, double near, Hit &hit) const;

    // Whether anything is in the way, no farther than `far` metres.
    bool blocked(const Start &start, const glm::dvec3 &direction,
                 double far = std::numeric_limits<double>::infinity()) const;

    std::size_t strands() const;

    // For geometry.cpp alone.
    struct Data;

  private:
    std::unique_ptr<Data> data_;
};

} // namespace tsuya::reference

#endif

// A groom: hair strands as polylines from root to tip, and what is wrong with them.
#ifndef TSUYA_GROOM_GROOM_H
#define TSUYA_GROOM_GROOM_H

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::groom {

// Strands, root first. Scene units are metres with +y up, +z out of the face
// and +x to the person's left; files say nothing about units or axes, so a
// reader gives whatever the file holds after ReadOptions::unit_scale and
// ReadOptions::up.
//
// Every groom that comes out of this folder keeps these promises, so a
// consumer may divide by a segment's length and square it in float:
//   - at least one strand, and at least two points in each;
//   - every coordinate is finite and within +-coordinate_limit;
//   - every segment is longer than shortest_segment.
struct Groom {
    std::vector<glm::vec3> points;    // all strands, one after the other, scene units
    std::vector<std::uint32_t> first; // strand s is [first[s], first[s + 1]); one more than strands
    std::vector<glm::vec2> uv;        // root's place on the scalp, one per strand; empty: unknown
    std::vector<float> seed;          // one per strand, uniform in [0, 1), the same at each load
    std::vector<float> radius;        // one per point, scene units, > 0; empty: constant_radius
    float constant_radius = 4e-5f;    // scene units, > 0; used while `radius` is empty

    std::size_t strands() const
    {
        return first.empty() ? 0 : first.size() - 1;
    }
};

constexpr float coordinate_limit = 1e15f;  // scene units; beyond it a point counts as non-finite
constexpr float shortest_segment = 1e-12f; // scene units; up to it a segment counts as degenerate

// What a groom holds, and what had to be left out to keep its promises.
// Kinks and an odd size are reported, never repaired.
struct Report {
    std::size_t strands = 0;
    std::size_t points = 0;
    glm::vec3 lower{0.0f}; // bounding box, scene units
    glm::vec3 upper{0.0f};
    double mean_length = 0.0; // of a strand along its polyline, scene units

    std::size_t kinks = 0;               // points where a strand turns by more than 90 degrees
    std::size_t kinked_strands = 0;      // strands with at least one of them
    std::size_t degenerate_segments = 0; // repeated points, merged into the one before
    std::size_t non_finite_points = 0;   // dropped: NaN, infinite or beyond coordinate_limit
    std::size_t dropped_strands = 0;     // fewer than 2 finite distinct points
    std::size_t replaced_values = 0;     // a width or uv that is no usable number: default, (0, 0)
    std::size_t unused_bytes = 0;        // of the file: colour, transparency, unknown sections

    // False when the largest extent is outside [0.05, 2] scene units. A head
    // is about 0.2 m, so the file is then probably not in metres.
    bool plausible_size = true;
};

// Measure `groom`: everything in a Report that can be seen in the groom
// itself. The counts of what a reader left out stay 0.
//
// Domain: any groom whose `first` is valid, also one that breaks the promises
//         above: degenerate segments and non-finite points are then counted.
Report inspect(const Groom &groom);

// `report` as English text, one fact a line, warnings last; ends with a newline.
std::string text(const Report &report);

// What had to be left out or replaced, a fact each, as text() says it; empty when the groom is as its
// file gave it.
std::vector<std::string> repairs(const Report &report);

// Seed of strand `strand`: 24 hashed bits, so the same index gives the same
// number everywhere. Returns: [0, 1).
float strand_seed(std::uint32_t strand);

} // namespace tsuya::groom

#endif

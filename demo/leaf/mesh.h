// A triangle mesh of a leaf or of wood, and what can be measured of it.
#ifndef TSUYA_LEAF_MESH_H
#define TSUYA_LEAF_MESH_H

#include "groom/expected.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::leaf {

using groom::Error;
using groom::Expected;

// Triangles, counter-clockwise seen from the upper side of a leaf (the one that faces the sun) or
// from outside of wood. Every mesh that comes out of this folder keeps these promises:
//   - at least one triangle, all indices in range, no triangle with two equal corners;
//   - every number is finite, positions within +-coordinate_limit;
//   - normals and tangents have length 1 within 1e-5 and stand at right angles.
struct Mesh {
    std::vector<glm::vec3> positions; // metres
    std::vector<glm::vec3> normals;   // one per position, of the upper side
    std::vector<glm::vec2> uvs;       // one per position, see leaf/maps.h
    // One per position: direction in which u grows, and the sign s of the bitangent
    // s * cross(normal, tangent), in which v grows. s is -1 where a file mirrors its uv.
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec3> albedo; // one per position, linear Rec. 709; only wood has it
    std::vector<std::uint32_t> indices;

    std::size_t triangles() const
    {
        return indices.size() / 3;
    }
};

constexpr float coordinate_limit = 1e6f; // metres

// What a mesh is, in numbers. Vertices at one place count as one, so that a seam of the uv is no
// boundary.
struct Report {
    std::size_t vertices = 0; // as stored
    std::size_t triangles = 0;
    std::size_t places = 0;         // different positions
    std::size_t edges = 0;          // between places
    std::size_t boundary_edges = 0; // of one triangle
    std::size_t tangled_edges = 0;  // of three and more triangles, or of two that are wound
                                    // against each other
    std::size_t boundary_loops = 0;
    std::size_t pieces = 0; // connected through edges
    long euler = 0;         // places - edges + triangles: 1 for a sheet, 2 for a closed surface
    double area = 0.0;      // square metres, one side
    double uv_area = 0.0;   // signed: negative where the uv is mirrored
    glm::vec3 lower{0.0f};  // box, metres
    glm::vec3 upper{0.0f};
    // Left at 0 by inspect(); what a reader had to do.
    std::size_t dropped_triangles = 0;  // without area
    std::size_t mirrored_triangles = 0; // uv runs clockwise
    bool computed_normals = false;
    bool planar_uv = false;
};

// Measure a mesh that keeps the promises.
Report inspect(const Mesh &mesh);

// `report` as English text, one fact a line.
std::string text(const Report &report);

// Normals from the triangles, weighed by area. A vertex whose triangles cancel gets +z.
void make_normals(Mesh &mesh);

// Tangents from uv and normals. Where triangles with mirrored uv meet others, their vertices are
// doubled, so that neither side has the other's sign; a vertex without any uv area gets a tangent
// at right angles to its normal.
// Returns: triangles with mirrored uv.
std::size_t make_tangents(Mesh &mesh);

} // namespace tsuya::leaf

#endif

// Numbers that tell one head of hair from another.
#ifndef TSUYA_TESTS_GROOM_MEASURE_H
#define TSUYA_TESTS_GROOM_MEASURE_H

#include "generate.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace groom_measure {

using namespace tsuya::groom;

// FNV-1a over the points.
inline std::uint64_t fingerprint(const Groom &groom)
{
    std::uint64_t h = 14695981039346656037u;
    for (const glm::vec3 &p : groom.points) {
        for (int k = 0; k < 3; ++k) {
            std::uint32_t bits;
            std::memcpy(&bits, &p[k], sizeof bits);
            h = (h ^ bits) * 1099511628211u;
        }
    }
    return h;
}

// Mean angle between neighbour segments per metre of strand, radians.
inline double mean_curvature(const Groom &groom)
{
    double turn = 0.0, length = 0.0;
    for (std::size_t s = 0; s < groom.strands(); ++s) {
        for (std::size_t i = groom.first[s] + 1; i + 1 < groom.first[s + 1]; ++i) {
            const glm::dvec3 a = glm::dvec3(groom.points[i]) - glm::dvec3(groom.points[i - 1]);
            const glm::dvec3 b = glm::dvec3(groom.points[i + 1]) - glm::dvec3(groom.points[i]);
            turn += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            length += glm::length(a);
        }
    }
    return turn / length;
}

// How far `p` is inside the ellipsoid, metres, along the ray from its centre.
inline double depth(const HairyHead &head, const glm::vec3 &p)
{
    const glm::dvec3 d = glm::dvec3(p) - glm::dvec3(head.centre);
    const double level = glm::length(d / glm::dvec3(head.semi_axes));
    return level < 1.0 ? glm::length(d) * (1.0 / level - 1.0) : 0.0;
}

inline double area(const Mesh &mesh, std::size_t face)
{
    const glm::dvec3 a = mesh.positions[mesh.indices[face * 3]];
    const glm::dvec3 b = mesh.positions[mesh.indices[face * 3 + 1]];
    const glm::dvec3 c = mesh.positions[mesh.indices[face * 3 + 2]];
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

// Chi-square of the roots over `bins` runs of faces, against their areas.
inline double chi_square(const HairyHead &head, std::size_t bins)
{
    const std::size_t faces = head.scalp.indices.size() / 3;
    std::vector<double> share(bins, 0.0), roots(bins, 0.0);
    double total = 0.0;
    for (std::size_t f = 0; f < faces; ++f) {
        share[f * bins / faces] += area(head.scalp, f);
        total += area(head.scalp, f);
    }
    for (const std::uint32_t face : head.root_face) {
        roots[face * bins / faces] += 1.0;
    }
    double sum = 0.0;
    for (std::size_t b = 0; b < bins; ++b) {
        const double expected = share[b] / total * double(head.root_face.size());
        sum += (roots[b] - expected) * (roots[b] - expected) / expected;
    }
    return sum;
}

} // namespace groom_measure

#endif

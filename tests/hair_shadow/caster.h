// Rays through strands, exactly: a fibre is a flat ribbon of its diameter that faces the light,
// which is what a cylinder hides from parallel light.
#ifndef TSUYA_TESTS_HAIR_SHADOW_CASTER_H
#define TSUYA_TESTS_HAIR_SHADOW_CASTER_H

#include "groom/groom.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

struct Counts {
    int front = 0, behind = 0;
};

// A point on a strand, and where on it.
struct Place {
    glm::vec3 position;
    std::uint32_t segment; // by its first point
};

class Caster
{
  public:
    // light  towards it, unit
    // scale  factor on every fibre's width
    Caster(const tsuya::groom::Groom &groom, const glm::vec3 &light, float scale) : light_(light)
    {
        const glm::vec3 other = std::abs(light.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        u = glm::normalize(glm::cross(light, other));
        v = glm::cross(light, u);
        glm::vec2 upper(-1e9f);
        for (const glm::vec3 &p : groom.points) {
            lower_ = glm::min(lower_, flat(p));
            upper = glm::max(upper, flat(p));
        }
        const glm::vec2 extent = upper - lower_;
        cells_.resize(std::size_t(side) * side);
        per_metre_ = float(side) / (1.01f * std::max(extent.x, extent.y));
        for (std::size_t s = 0; s < groom.strands(); s++) {
            for (std::uint32_t i = groom.first[s]; i + 1 < groom.first[s + 1]; i++) {
                add(groom.points[i], groom.points[i + 1], i,
                    scale * (groom.radius.empty() ? groom.constant_radius : groom.radius[i]));
            }
        }
    }

    // Fibres on the line through `p` along the light, but the few segments around its own.
    Counts count(const glm::vec3 &p, std::uint32_t own) const
    {
        Counts counts;
        const glm::vec2 q = flat(p);
        const float height = glm::dot(p, light_);
        const glm::ivec2 cell = cell_of(q);
        for (std::uint32_t k : cells_[index(cell.x, cell.y)]) {
            const Ribbon &r = ribbons_[k];
            const std::uint32_t apart = r.point > own ? r.point - own : own - r.point;
            const float t = glm::dot(q - r.a, r.way);
            if (apart <= 2 || t < 0.0f || t >= 1.0f ||
                glm::distance(q, r.a + t * (r.b - r.a)) >= r.radius) {
                continue;
            }
            (glm::mix(r.from, r.to, t) > height ? counts.front : counts.behind)++;
        }
        return counts;
    }

    glm::vec3 u, v; // across the light

  private:
    static constexpr int side = 1024;
    struct Ribbon {
        glm::vec2 a, b, way; // way: (b - a) / |b - a|^2
        float from, to, radius;
        std::uint32_t point;
    };

    glm::vec2 flat(const glm::vec3 &p) const
    {
        return {glm::dot(p, u), glm::dot(p, v)};
    }
    glm::ivec2 cell_of(const glm::vec2 &q) const
    {
        return glm::clamp(glm::ivec2((q - lower_) * per_metre_), 0, side - 1);
    }
    static std::size_t index(int x, int y)
    {
        return std::size_t(y) * side + std::size_t(x);
    }
    void add(const glm::vec3 &from, const glm::vec3 &to, std::uint32_t point, float radius)
    {
        const glm::vec2 a = flat(from), b = flat(to);
        const glm::vec2 d = b - a;
        const glm::ivec2 low = cell_of(glm::min(a, b) - radius);
        const glm::ivec2 high = cell_of(glm::max(a, b) + radius);
        ribbons_.push_back({a, b, d / std::max(glm::dot(d, d), 1e-20f), glm::dot(from, light_),
                            glm::dot(to, light_), radius, point});
        for (int y = low.y; y <= high.y; y++) {
            for (int x = low.x; x <= high.x; x++) {
                cells_[index(x, y)].push_back(std::uint32_t(ribbons_.size() - 1));
            }
        }
    }

    glm::vec3 light_;
    glm::vec2 lower_{1e9f};
    float per_metre_ = 1.0f;
    std::vector<Ribbon> ribbons_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

// Points uniform over strands and along them; the same for a seed.
inline std::vector<Place> places(const tsuya::groom::Groom &groom, int count)
{
    std::mt19937 random(7);
    // Not std::uniform_*_distribution: those differ from library to library.
    const auto chance = [&] { return double(random()) / 4294967296.0; };
    std::vector<Place> result;
    for (int i = 0; i < count; i++) {
        const std::size_t s = std::size_t(chance() * double(groom.strands()));
        const std::uint32_t first = groom.first[s], segments = groom.first[s + 1] - first - 1;
        const double along = chance() * segments;
        const std::uint32_t k = first + std::uint32_t(along);
        const float t = float(along - std::floor(along));
        result.push_back({glm::mix(groom.points[k], groom.points[k + 1], t), k});
    }
    return result;
}

// Light that arrives at a point by rays.
struct Traced {
    double through = 0.0;      // share of rays that meet no fibre
    double half = 0.0;         // mean of 2^-n: every fibre takes half
    double front = 0.0, behind = 0.0;
};

// The mean of rays^2 rays over a square of side `extent` around the point across the light; one ray
// through the point itself for rays = 1.
inline Traced trace(const Caster &caster, const Place &place, int rays, float extent)
{
    Traced sum;
    for (int i = 0; i < rays * rays; i++) {
        const float x = (float(i % rays) + 0.5f) / float(rays) - 0.5f;
        const float y = (float(i / rays) + 0.5f) / float(rays) - 0.5f;
        const glm::vec3 p = place.position + extent * (x * caster.u + y * caster.v);
        const Counts counts = caster.count(p, place.segment);
        sum.through += counts.front == 0 ? 1.0 : 0.0;
        sum.half += std::exp2(-double(counts.front));
        sum.front += counts.front;
        sum.behind += counts.behind;
    }
    const double share = 1.0 / (rays * rays);
    return {sum.through * share, sum.half * share, sum.front * share, sum.behind * share};
}

#endif

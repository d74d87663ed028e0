#include "draw/leaf_sky.h"

#include "draw/lights.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::draw {

namespace {

constexpr int cells = 28; // along each side of the box
constexpr int directions = 64;
constexpr float hidden = 0.5f * 0.8f; // of a leaf's area, see leaf_sky()

struct Cloud {
    glm::vec3 corner, cell;
    std::vector<float> density; // leaf area per volume, 1/m

    float at(const glm::ivec3 &i) const
    {
        if (i.x < 0 || i.y < 0 || i.z < 0 || i.x >= cells || i.y >= cells || i.z >= cells) {
            return 0.0f;
        }
        return density[std::size_t((i.z * cells + i.y) * cells + i.x)];
    }
};

Cloud cloud_of(const leaf::Plant &plant)
{
    struct Blob {
        glm::vec3 place;
        float area;
    };
    std::vector<Blob> blobs;
    std::vector<Blob> rest;
    glm::vec3 lower(1e9f), upper(-1e9f);
    for (const leaf::Placed &leaf : plant.leaves) {
        const leaf::Mesh &mesh = plant.kinds[leaf.kind].blade;
        glm::vec3 sum(0.0f);
        float area = 0.0f;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[t]];
            const glm::vec3 b = mesh.positions[mesh.indices[t + 1]];
            const glm::vec3 c = mesh.positions[mesh.indices[t + 2]];
            const float one = 0.5f * glm::length(glm::cross(b - a, c - a));
            area += one;
            sum += one / 3.0f * (a + b + c);
        }
        const float scale = glm::length(glm::vec3(leaf.place[0]));
        const glm::vec3 place = glm::vec3(leaf.place * glm::vec4(sum / area, 1.0f));
        blobs.push_back({place, area * scale * scale});
        lower = glm::min(lower, place);
        upper = glm::max(upper, place);
    }
    Cloud cloud;
    const glm::vec3 margin = 0.03f * (upper - lower) + 1e-3f;
    cloud.corner = lower - margin;
    cloud.cell = (upper - lower + 2.0f * margin) / float(cells);
    cloud.density.assign(std::size_t(cells * cells * cells), 0.0f);
    const float volume = cloud.cell.x * cloud.cell.y * cloud.cell.z;
    for (const Blob &blob : blobs) {
        // Shared among the eight nearest cells.
        const glm::vec3 at = (blob.place - cloud.corner) / cloud.cell - 0.5f;
        const glm::vec3 low = glm::floor(at), f = at - low;
        for (int k = 0; k < 8; k++) {
            const glm::ivec3 step(k & 1, k >> 1 & 1, k >> 2);
            const glm::ivec3 i = glm::min(glm::max(glm::ivec3(low) + step, 0), cells - 1);
            const float w = (step.x ? f.x : 1.0f - f.x) * (step.y ? f.y : 1.0f - f.y) *
                            (step.z ? f.z : 1.0f - f.z);
            cloud.density[std::size_t((i.z * cells + i.y) * cells + i.x)] += w * blob.area / volume;
        }
    }
    return cloud;
}

// Share of light that arrives from direction d.
float passed(const Cloud &cloud, const glm::ivec3 &from, const glm::vec3 &d)
{
    const glm::vec3 rate = glm::abs(d) / cloud.cell; // cells per metre
    const float step = 0.7f / std::max(rate.x, std::max(rate.y, rate.z));
    glm::vec3 at = glm::vec3(from) + 0.5f;
    const glm::vec3 move = step * d / cloud.cell;
    float depth = 0.0f;
    for (int i = 0; i < 3 * cells; i++) {
        const glm::ivec3 cell = glm::ivec3(glm::floor(at));
        if (glm::any(glm::lessThan(cell, glm::ivec3(0))) ||
            glm::any(glm::greaterThanEqual(cell, glm::ivec3(cells)))) {
            break;
        }
        // Half of the first cell: the leaf itself is in its middle.
        depth += hidden * cloud.at(cell) * step * (i == 0 ? 0.5f : 1.0f);
        at += move;
    }
    return std::exp(-depth);
}

} // namespace

LeafSky leaf_sky(const leaf::Plant &plant, const std::array<float, 36> &environment,
                 const glm::mat3 &turn)
{
    LeafSky result;
    if (plant.nodes.empty() || plant.leaves.empty()) {
        return result;
    }
    const Cloud cloud = cloud_of(plant);
    const std::vector<Light> lights = sky(environment, directions);
    result.size = glm::ivec3(cells);
    result.corner = cloud.corner;
    result.cell = cloud.cell;
    const std::size_t count = std::size_t(cells * cells * cells);
    result.texels.assign(count * 12, 0.0f);
    const float share =
        1.0f / 12.5663706f; // a light's irradiance is radiance times its solid angle
    for (int z = 0; z < cells; z++) {
        for (int y = 0; y < cells; y++) {
            for (int x = 0; x < cells; x++) {
                const std::size_t i = std::size_t((z * cells + y) * cells + x);
                for (const Light &light : lights) {
                    const float through = passed(cloud, {x, y, z}, light.direction * turn);
                    for (int c = 0; c < 3; c++) {
                        float *t = &result.texels[(std::size_t(c) * count + i) * 4];
                        const float l = through * light.irradiance[c] * share;
                        t[0] += l;
                        for (int k = 0; k < 3; k++) {
                            t[1 + k] += 3.0f * l * light.direction[k];
                        }
                    }
                }
            }
        }
    }
    return result;
}

} // namespace tsuya::draw

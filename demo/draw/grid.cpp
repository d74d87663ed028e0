#include "draw/grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tsuya::draw {

namespace {

constexpr float thick = 8.0f; // fibres in a cell of a hairy solid

} // namespace

void Grid::splat(const glm::vec3 &place, const glm::vec3 &tangent, float amount)
{
    const glm::vec3 p = (place - corner_) / cell_ - 0.5f;
    const glm::vec3 base = glm::floor(p);
    const glm::vec3 f = p - base;
    for (int c = 0; c < 8; c++) {
        const int x = c & 1, y = c >> 1 & 1, z = c >> 2;
        const float share = (x ? f.x : 1.0f - f.x) * (y ? f.y : 1.0f - f.y) *
                            (z ? f.z : 1.0f - f.z);
        const std::size_t cell = index(std::clamp(int(base.x) + x, 0, size_.x - 1),
                                       std::clamp(int(base.y) + y, 0, size_.y - 1),
                                       std::clamp(int(base.z) + z, 0, size_.z - 1));
        density_[cell] += share * amount;
        along_[cell] += glm::outerProduct(tangent, tangent) * (share * amount);
    }
}

void Grid::fill(const groom::Groom &groom, const Solid &solid, bool hairy, float width_scale,
                int resolution)
{
    glm::vec3 lower = groom.points.front(), upper = lower;
    for (const glm::vec3 &p : groom.points) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    const glm::vec3 extent = upper - lower;
    cell_ = std::max({extent.x, extent.y, extent.z, 1e-9f}) / float(resolution);
    corner_ = lower - 1.5f * cell_;
    size_ = glm::ivec3(glm::ceil(extent / cell_)) + 3;
    density_.assign(std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z), 0.0f);
    along_.assign(density_.size(), glm::mat3(0.0f));
    solid_.assign(density_.size(), 0);

    const float volume = cell_ * cell_ * cell_;
    for (std::size_t s = 0; s < groom.strands(); s++) {
        for (std::uint32_t i = groom.first[s]; i + 1 < groom.first[s + 1]; i++) {
            const glm::vec3 a = groom.points[i], b = groom.points[i + 1];
            const float length = glm::distance(a, b);
            const float radius = groom.radius.empty()
                                     ? groom.constant_radius
                                     : 0.5f * (groom.radius[i] + groom.radius[i + 1]);
            const int parts = 1 + int(std::min(length / (0.5f * cell_), 1000.0f));
            const float amount = 2.0f * radius * width_scale * length / (float(parts) * volume);
            const glm::vec3 tangent = length > 0.0f ? (b - a) / length : glm::vec3(0.0f);
            for (int k = 0; k < parts; k++) {
                splat(glm::mix(a, b, (float(k) + 0.5f) / float(parts)), tangent, amount);
            }
        }
    }
    if (solid.semi_axes == glm::vec3(0.0f)) {
        return;
    }
    for (int z = 0; z < size_.z; z++) {
        for (int y = 0; y < size_.y; y++) {
            for (int x = 0; x < size_.x; x++) {
                const glm::vec3 p = corner_ + cell_ * (glm::vec3(x, y, z) + 0.5f);
                // A cell inside the surface, or the hair that lies on it would be cut off as well.
                const glm::vec3 q =
                    (p - solid.centre) / glm::max(solid.semi_axes - cell_, glm::vec3(1e-6f));
                if (glm::dot(q, q) < 1.0f) {
                    if (hairy) {
                        density_[index(x, y, z)] += thick / cell_;
                    } else {
                        solid_[index(x, y, z)] = 1;
                    }
                }
            }
        }
    }
}

std::vector<float> Grid::sweep(const glm::vec3 &direction) const
{
    return add_up(direction, false);
}

std::vector<float> Grid::beyond(const glm::vec3 &direction) const
{
    return add_up(-direction, true);
}

std::vector<float> Grid::add_up(const glm::vec3 &direction, bool stop) const
{
    // Slices across the light's longest component, from the light's side on. A cell's way to the
    // light leaves its slice for the one before at a point between four centres.
    const glm::vec3 size = glm::abs(direction);
    const int w = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = (w + 1) % 3, v = (w + 2) % 3;
    const int step = direction[w] > 0.0f ? 1 : -1;
    const float du = direction[u] / size[w], dv = direction[v] / size[w];
    const float way = cell_ / size[w];
    const std::size_t stride[3] = {1, std::size_t(size_.x),
                                   std::size_t(size_.x) * std::size_t(size_.y)};

    std::vector<float> met(density_.size()); // fibres per metre of this way
    for (std::size_t c = 0; c < met.size(); c++) {
        const float whole = density_[c], along = glm::dot(direction, along_[c] * direction);
        met[c] = std::sqrt(std::max(whole * (whole - along), 0.0f));
    }
    std::vector<float> fibres(density_.size());
    const int last = step > 0 ? size_[w] - 1 : 0;
    for (int n = 0; n < size_[w]; n++) {
        const int k = last - step * n;
        for (int j = 0; j < size_[v]; j++) {
            for (int i = 0; i < size_[u]; i++) {
                const std::size_t here = std::size_t(k) * stride[w] + std::size_t(j) * stride[v] +
                                         std::size_t(i) * stride[u];
                // A fibre is not in its own shadow, so of the own cell nearly half is left out.
                float sum = 0.25f * met[here] * way;
                if (n > 0) {
                    const float x = std::clamp(float(i) + du, 0.0f, float(size_[u] - 1));
                    const float y = std::clamp(float(j) + dv, 0.0f, float(size_[v] - 1));
                    const int x0 = std::min(int(x), size_[u] - 2);
                    const int y0 = std::min(int(y), size_[v] - 2);
                    const float fx = x - float(x0), fy = y - float(y0);
                    const std::size_t at = std::size_t(k + step) * stride[w] +
                                           std::size_t(y0) * stride[v] +
                                           std::size_t(x0) * stride[u];
                    const auto value = [&](std::size_t c) {
                        return fibres[c] + 0.75f * met[c] * way;
                    };
                    sum += (1.0f - fy) * ((1.0f - fx) * value(at) + fx * value(at + stride[u])) +
                           fy * ((1.0f - fx) * value(at + stride[v]) +
                                 fx * value(at + stride[v] + stride[u]));
                }
                fibres[here] = stop && solid_[here] ? 0.0f : sum;
            }
        }
    }
    return fibres;
}

} // namespace tsuya::draw

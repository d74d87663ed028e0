#include "scene/leaf_traits.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tsuya::scene {

namespace {

constexpr double flat = 1e9; // mm

double luminance(const glm::dvec3 &c)
{
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

// Calls with every triangle of every blade, in the world.
template <class Call>
void each_triangle(const Surface &surface, const draw::SurfaceFrame &frame, const Call &call)
{
    for (const leaf::Placed &leaf : surface.plant.leaves) {
        const leaf::Mesh &mesh = surface.plant.kinds[leaf.kind].blade;
        const glm::dmat4 place = glm::dmat4(frame.model) * glm::dmat4(leaf.place);
        const auto at = [&](std::size_t corner) {
            const glm::dvec3 p(mesh.positions[mesh.indices[corner]]);
            return glm::dvec3(place * glm::dvec4(p, 1.0));
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            call(at(i), at(i + 1), at(i + 2));
        }
    }
}

// Of every blade that there is, weighed by area; a radius r turns a normal by 1 / r a length.
double curvature(const Surface &surface, const draw::SurfaceFrame &frame)
{
    std::vector<double> scale(surface.plant.kinds.size(), 0.0);
    for (const leaf::Placed &leaf : surface.plant.leaves) {
        scale[leaf.kind] = std::max(scale[leaf.kind], glm::length(glm::dvec3(leaf.place[0])));
    }
    std::vector<std::pair<double, double>> radii; // and areas
    double whole = 0.0;
    for (std::size_t k = 0; k < scale.size(); k++) {
        const leaf::Mesh &mesh = surface.plant.kinds[k].blade;
        const double unit = 1e3 * scale[k] * glm::length(glm::dvec3(frame.model[0]));
        for (std::size_t i = 0; i + 2 < mesh.indices.size() && scale[k] > 0.0; i += 3) {
            double bend = 0.0;
            for (std::size_t c = 0; c < 3; c++) {
                const std::uint32_t a = mesh.indices[i + c], b = mesh.indices[i + (c + 1) % 3];
                const glm::dvec3 edge(mesh.positions[b] - mesh.positions[a]);
                const glm::dvec3 turn(mesh.normals[b] - mesh.normals[a]);
                const double square = glm::dot(edge, edge);
                bend =
                    square > 0.0 ? std::max(bend, std::abs(glm::dot(turn, edge)) / square) : bend;
            }
            const glm::dvec3 corner(mesh.positions[mesh.indices[i]]);
            const glm::dvec3 u = glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - corner;
            const glm::dvec3 v = glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - corner;
            const double area = glm::length(glm::cross(u, v));
            radii.emplace_back(bend * flat > unit ? unit / bend : flat, area);
            whole += area;
        }
    }
    std::sort(radii.begin(), radii.end());
    double sum = 0.0;
    for (const auto &one : radii) {
        sum += one.second;
        if (sum >= 0.1 * whole) {
            return one.first;
        }
    }
    return flat;
}

// Cells whose middle a triangle covers, in a picture of at most 512 cells a side.
double covered(const Surface &surface, const draw::SurfaceFrame &frame)
{
    const double cell = std::max(1.0, std::max(frame.width, frame.height) / 512.0);
    const int width = int(std::ceil(frame.width / cell)),
              height = int(std::ceil(frame.height / cell));
    std::vector<char> met(std::size_t(width) * std::size_t(height), 0);
    const glm::dmat4 to_clip = glm::dmat4(frame.projection) * glm::dmat4(frame.view);
    const glm::dvec2 half(0.5 * frame.width / cell, 0.5 * frame.height / cell);
    each_triangle(
        surface, frame, [&](const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) {
            glm::dvec2 p[3];
            for (int k = 0; k < 3; k++) {
                const glm::dvec4 clip = to_clip * glm::dvec4(k == 0 ? a : k == 1 ? b : c, 1.0);
                if (clip.w <= double(frame.near)) {
                    return;
                }
                p[k] = half + half * glm::dvec2(clip) / clip.w;
            }
            const auto side = [](const glm::dvec2 &from, const glm::dvec2 &to,
                                 const glm::dvec2 &at) {
                return (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
            };
            const auto first = [](double x, int most) {
                return int(std::clamp(std::ceil(x - 0.5), 0.0, double(most)));
            };
            const auto range = [&](int axis, int most) {
                const double low = std::min({p[0][axis], p[1][axis], p[2][axis]});
                const double high = std::max({p[0][axis], p[1][axis], p[2][axis]});
                return std::pair<int, int>(first(low, most), first(high, most));
            };
            const auto columns = range(0, width), rows = range(1, height);
            for (int y = rows.first; y < rows.second; y++) {
                for (int x = columns.first; x < columns.second; x++) {
                    const glm::dvec2 at(x + 0.5, y + 0.5);
                    const double s0 = side(p[0], p[1], at), s1 = side(p[1], p[2], at),
                                 s2 = side(p[2], p[0], at);
                    if (std::min({s0, s1, s2}) >= 0.0 || std::max({s0, s1, s2}) <= 0.0) {
                        met[std::size_t(y) * std::size_t(width) + std::size_t(x)] = 1;
                    }
                }
            }
        });
    return double(std::count(met.begin(), met.end(), 1)) * cell * cell;
}

void of_lights(const Scene &scene, const Surface &surface, const draw::SurfaceFrame &frame,
               LeafTraits &traits)
{
    const glm::dvec3 centre(glm::inverse(glm::dmat4(frame.view)) *
                            glm::dvec4(0.0, 0.0, -double(frame.distance), 1.0));
    const glm::dvec3 view = glm::normalize(glm::dvec3(frame.eye) - centre);
    double direct = 0.0, along = 0.0, sky = 0.0;
    for (const draw::Light &light : frame.lights) {
        const double irradiance = luminance(glm::dvec3(light.irradiance));
        direct += irradiance;
        along += irradiance * glm::dot(glm::normalize(glm::dvec3(light.direction)), view);
    }
    // draw::sky() gives a dark record a little light.
    const bool there =
        scene.environment != "none" || scene.dome * luminance(scene.dome_color) > 0.0;
    for (const draw::Light &light : draw::sky(frame.sky, there ? 20 : 0)) {
        sky += 0.25 * luminance(glm::dvec3(light.irradiance)); // of 4 pi L, pi L reach a plane
    }
    for (const auto &own : scene.lights) {
        const SceneLight &light = own.second;
        const bool area = light.kind == "rect" || light.kind == "disk" || light.angle > 0.0;
        (area                    ? traits.area_lights
         : light.kind == "point" ? traits.point_lights
                                 : traits.directional_lights)++;
    }
    traits.directional_lights +=
        std::max(0, int(frame.lights.size()) -
                        (traits.directional_lights + traits.point_lights + traits.area_lights));
    traits.environments = sky > 0.0;
    traits.sky_share = sky + direct > 0.0 ? sky / (sky + direct) : 0.0;
    traits.light_cosine = direct > 0.0 ? along / direct : 0.0;

    // The part of each light's area in view that is lit on its far side.
    std::vector<double> behind(frame.lights.size(), 0.0);
    double whole = 0.0;
    each_triangle(
        surface, frame, [&](const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) {
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const double seen = glm::dot(normal, glm::normalize(glm::dvec3(frame.eye) - a));
            whole += std::abs(seen);
            for (std::size_t i = 0; i < behind.size(); i++) {
                if (glm::dot(normal, glm::dvec3(frame.lights[i].direction)) * seen < 0.0) {
                    behind[i] += std::abs(seen);
                }
            }
        });
    traits.backlit = sky > 0.0;
    for (std::size_t i = 0; i < behind.size(); i++) {
        traits.backlit =
            traits.backlit ||
            (luminance(glm::dvec3(frame.lights[i].irradiance)) > 0.0 && behind[i] > 0.01 * whole);
    }
}

} // namespace

LeafTraits traits(const Scene &scene, const Surface &surface, const draw::SurfaceFrame &frame)
{
    LeafTraits traits;
    traits.footprint =
        2e3 * double(frame.distance) / (double(frame.projection[1].y) * frame.height);
    traits.curvature = curvature(surface, frame);
    traits.covered_pixels = covered(surface, frame);
    traits.varies = !surface.plant.maps.empty();
    const std::vector<leaf::Placed> &leaves = surface.plant.leaves;
    for (const leaf::Placed &leaf : leaves) {
        traits.varies = traits.varies || leaf.pigment != leaves[0].pigment ||
                        leaf.thickness != leaves[0].thickness;
    }
    of_lights(scene, surface, frame, traits);
    return traits;
}

} // namespace tsuya::scene

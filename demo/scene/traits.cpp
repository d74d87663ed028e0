#include "scene/traits.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::scene
{

namespace
{

constexpr double pi = 3.14159265358979323846;

double luminance(const glm::dvec3 &c)
{
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

double radius_at(const groom::Groom &groom, std::size_t point)
{
    return double(groom.radius.empty() ? groom.constant_radius : groom.radius[point]);
}

// Share of a fibre's width that its taper leaves, on average.
double width_left(const Scene &scene)
{
    return 1.0 - 0.5 * std::clamp(scene.taper, 0.0, 1.0);
}

void of_lights(const Scene &scene, const draw::Frame &frame, Traits &traits)
{
    const glm::dvec3 centre = glm::dvec3(glm::inverse(glm::dmat4(frame.view)) *
                                         glm::dvec4(0.0, 0.0, -double(frame.distance), 1.0));
    const glm::dvec3 view = glm::normalize(glm::dvec3(frame.eye) - centre);
    double direct = 0.0, cosine = 0.0;
    for (const draw::Light &light : frame.lights) {
        const double irradiance = luminance(glm::dvec3(light.irradiance));
        direct += irradiance;
        const glm::dvec3 way = glm::normalize(glm::dvec3(light.direction));
        cosine += irradiance * glm::dot(way, view);
    }
    for (const auto &own : scene.lights) {
        const SceneLight &light = own.second;
        const bool area = light.kind == "rect" || light.kind == "disk" || light.angle > 0.0;
        (area                    ? traits.area_lights
         : light.kind == "point" ? traits.point_lights
                                 : traits.directional_lights)++;
    }
    traits.directional_lights +=
        int(frame.lights.size()) -
        (traits.directional_lights + traits.point_lights + traits.area_lights);
    double sky = 0.0;
    for (const draw::Light &light : frame.sky) {
        sky += 0.25 * luminance(glm::dvec3(light.irradiance)); // of 4 pi L, pi L reach a plane
    }
    traits.environments = sky > 0.0;
    traits.sky_share = sky + direct > 0.0 ? sky / (sky + direct) : 0.0;
    if (direct > 0.0) {
        traits.light_cosine = cosine / direct;
    }
}

// Whether the solid is between the eye and a point, both in the groom's space.
bool hidden(const draw::Solid &solid, const glm::dvec3 &eye, const glm::dvec3 &point)
{
    const glm::dvec3 axes(solid.semi_axes);
    const glm::dvec3 from = (eye - glm::dvec3(solid.centre)) / axes, way = (point - eye) / axes;
    const double a = glm::dot(way, way), b = glm::dot(from, way), c = glm::dot(from, from) - 1.0;
    const double root = b * b - a * c;
    const double at = root > 0.0 ? (-b - std::sqrt(root)) / a : 2.0;
    return at > 0.0 && at < 1.0;
}

// Fibres along the rays of view, in cells of a pixel or more.
class Depths
{
  public:
    Depths(const Scene &scene, const Hair &hair, const draw::Frame &frame)
        : scene_(scene), hair_(hair), frame_(frame)
    {
        const double pixels = std::max(1.0, std::max(frame.width, frame.height) / 96.0);
        cell_ = std::ceil(pixels);
        columns_ = int(std::ceil(frame.width / cell_));
        rows_ = int(std::ceil(frame.height / cell_));
        sums_.assign(std::size_t(columns_) * std::size_t(rows_), 0.0);
        to_clip_ = glm::dmat4(frame.projection) * glm::dmat4(frame.view) * glm::dmat4(frame.model);
        eye_ = glm::dvec3(glm::inverse(glm::dmat4(frame.model)) *
                          glm::dvec4(glm::dvec3(frame.eye), 1.0));
        scale_ = glm::length(glm::dvec3(frame.model[0])) * scene.width_scale * width_left(scene);
        solid_ = frame.head && hair.solid.semi_axes.x > 0.0f && hair.solid.semi_axes.y > 0.0f &&
                 hair.solid.semi_axes.z > 0.0f;
        const groom::Groom &groom = hair.groom;
        for (std::size_t s = 0; s < groom.strands(); s++) {
            for (std::size_t i = groom.first[s]; i + 1 < groom.first[s + 1]; i++) {
                segment(i);
            }
        }
    }
    void summary(Traits &traits) const
    {
        double depth = 0.0, covered = 0.0;
        int met = 0;
        for (const double sum : sums_) {
            const double share = 1.0 - std::exp(-sum);
            covered += share;
            if (share > 0.3) {
                depth += sum;
                met++;
            }
        }
        traits.covered_pixels = covered * cell_ * cell_;
        traits.depth = met ? depth / met : 0.0;
    }

  private:
    // In cells; z: cells that a metre at that place takes.
    glm::dvec3 place(const glm::vec3 &point) const
    {
        const glm::dvec4 clip = to_clip_ * glm::dvec4(glm::dvec3(point), 1.0);
        if (clip.w <= double(frame_.near)) {
            return glm::dvec3(-1.0, -1.0, 0.0);
        }
        const glm::dvec2 size(frame_.width / cell_, frame_.height / cell_);
        return {(0.5 + 0.5 * clip.x / clip.w) * size.x, (0.5 + 0.5 * clip.y / clip.w) * size.y,
                0.5 * size.y * double(frame_.projection[1].y) / clip.w};
    }
    void segment(std::size_t i)
    {
        const groom::Groom &groom = hair_.groom;
        const glm::dvec3 a = place(groom.points[i]), b = place(groom.points[i + 1]);
        if (a.z <= 0.0 || b.z <= 0.0) {
            return;
        }
        const glm::dvec3 middle =
            0.5 * (glm::dvec3(groom.points[i]) + glm::dvec3(groom.points[i + 1]));
        if (solid_ && hidden(hair_.solid, eye_, middle)) {
            return;
        }
        const double length = glm::length(glm::dvec2(b - a));
        const double width = 2.0 * radius_at(groom, i) * scale_ * 0.5 * (a.z + b.z);
        const int steps = std::max(1, int(std::ceil(2.0 * length)));
        for (int k = 0; k < steps; k++) {
            const glm::dvec3 at = glm::mix(a, b, (k + 0.5) / steps);
            const int x = int(std::floor(at.x)), y = int(std::floor(at.y));
            if (x >= 0 && y >= 0 && x < columns_ && y < rows_) {
                sums_[std::size_t(y * columns_ + x)] += length / steps * width;
            }
        }
    }

    const Scene &scene_;
    const Hair &hair_;
    const draw::Frame &frame_;
    double cell_ = 1.0, scale_ = 1.0;
    int columns_ = 1, rows_ = 1;
    bool solid_ = false;
    std::vector<double> sums_;
    glm::dmat4 to_clip_{1.0};
    glm::dvec3 eye_{0.0};
};

double curl(const Hair &hair)
{
    const groom::Groom &groom = hair.groom;
    const double window = 0.2 * std::max(hair.report.mean_length, 1e-12); // to each side
    const std::size_t step = std::max<std::size_t>(1, groom.strands() / 500);
    double sum = 0.0, met = 0.0;
    for (std::size_t s = 0; s < groom.strands(); s += step) {
        const std::size_t begin = groom.first[s], end = groom.first[s + 1];
        std::vector<double> way(1, 0.0);
        for (std::size_t i = begin + 1; i < end; i++) {
            way.push_back(way.back() + double(glm::distance(groom.points[i - 1], groom.points[i])));
        }
        const auto at = [&](double where) {
            const std::size_t after = std::size_t(std::clamp<std::ptrdiff_t>(
                std::upper_bound(way.begin(), way.end(), where) - way.begin(), 1,
                std::ptrdiff_t(way.size()) - 1));
            const double t = (where - way[after - 1]) / (way[after] - way[after - 1]);
            return glm::mix(glm::dvec3(groom.points[begin + after - 1]),
                            glm::dvec3(groom.points[begin + after]), t);
        };
        for (std::size_t i = 0; i + 1 < way.size(); i++) {
            const double middle = 0.5 * (way[i] + way[i + 1]);
            if (middle < window || middle > way.back() - window) {
                continue;
            }
            const glm::dvec3 chord = at(middle + window) - at(middle - window);
            const glm::dvec3 own =
                glm::dvec3(groom.points[begin + i + 1]) - glm::dvec3(groom.points[begin + i]);
            const double squares = glm::dot(chord, chord) * glm::dot(own, own);
            const double cosine2 = glm::dot(chord, own) * glm::dot(chord, own);
            const double weight = way[i + 1] - way[i];
            sum += squares > 0.0 ? weight * (1.0 - cosine2 / squares) : 0.0;
            met += weight;
        }
    }
    return met > 0.0 ? std::clamp(sum / met, 0.0, 1.0) : 0.0;
}

} // namespace

Traits traits(const Scene &scene, const Hair &hair, const Material &material,
              const draw::Frame &frame)
{
    Traits traits;
    traits.sigma_a = material.sigma_a;
    const auto given = scene.parameters.find("beta_R");
    traits.beta_R = (given == scene.parameters.end() ? 7.5 : given->second.x) * pi / 180.0;
    of_lights(scene, frame, traits);
    Depths(scene, hair, frame).summary(traits);
    traits.curl = curl(hair);
    const groom::Groom &groom = hair.groom;
    double radius = 0.0;
    for (std::size_t i = 0; i < groom.points.size(); i++) {
        radius += radius_at(groom, i) / double(groom.points.size());
    }
    const double pixel =
        2.0 * double(frame.distance) / (double(frame.projection[1].y) * frame.height);
    traits.strand_pixels = 2.0 * radius * scene.width_scale * width_left(scene) *
                           glm::length(glm::dvec3(frame.model[0])) / pixel;
    return traits;
}

} // namespace tsuya::scene

#include "reference/light.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::reference
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double least = 1e-3; // metres: from nearer a point is as bright as from here

// Two unit vectors at right angles to n and to each other.
void across(const glm::dvec3 &n, glm::dvec3 &u, glm::dvec3 &w)
{
    const glm::dvec3 other =
        std::abs(n.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    u = glm::normalize(glm::cross(n, other));
    w = glm::cross(n, u);
}

double strongest(const glm::dvec3 &v)
{
    return std::max(v.x, std::max(v.y, v.z));
}

} // namespace

Way Light::way(const glm::dvec3 &from, Random &random) const
{
    Way way;
    if (kind == Kind::directional) {
        way.direction = direction;
        way.irradiance = irradiance;
        if (angle > 0.0) {
            // Of even radiance; a plane that faces the middle gets its irradiance.
            glm::dvec3 u, w;
            across(direction, u, w);
            const double cosine = 1.0 - random.unit() * (1.0 - std::cos(angle));
            const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
            const double phi = 2.0 * pi * random.unit();
            way.direction = cosine * direction + sine * (std::cos(phi) * u + std::sin(phi) * w);
            const double s = std::sin(angle);
            way.irradiance = irradiance * (2.0 * (1.0 - std::cos(angle)) / (s * s));
        }
        return way;
    }
    glm::dvec3 to = position - from;
    if (kind != Kind::point) {
        double a = 2.0 * random.unit() - 1.0, b = 2.0 * random.unit() - 1.0;
        if (kind == Kind::disk) {
            const double radius = std::sqrt(0.5 * (a + 1.0)), phi = pi * b;
            a = radius * std::cos(phi);
            b = radius * std::sin(phi);
        }
        to += a * x + b * y;
    }
    const double distance = glm::length(to);
    if (distance <= 0.0) {
        return way;
    }
    way.direction = to / distance;
    way.length = distance;
    const double square = std::max(distance, least) * std::max(distance, least);
    if (kind == Kind::point) {
        way.irradiance = irradiance / square;
        return way;
    }
    const glm::dvec3 normal = glm::cross(x, y);
    const double size = glm::length(normal) * (kind == Kind::disk ? pi : 4.0);
    double facing = -glm::dot(glm::normalize(normal), way.direction);
    facing = two_sided ? std::abs(facing) : std::max(facing, 0.0);
    way.irradiance = irradiance * (size * facing / (distance * distance));
    return way;
}

Light light_of(const scene::SceneLight &light)
{
    Light result;
    result.irradiance = light.color * light.intensity;
    result.direction = glm::normalize(light.direction);
    result.position = light.position;
    result.angle = light.angle * pi / 180.0;
    result.two_sided = light.sides == 2.0;
    result.kind = light.kind == "point"  ? Light::Kind::point
                  : light.kind == "rect" ? Light::Kind::rect
                  : light.kind == "disk" ? Light::Kind::disk
                                         : Light::Kind::directional;
    if (result.kind == Light::Kind::rect || result.kind == Light::Kind::disk) {
        const glm::dvec3 inward =
            glm::length(light.position) > 1e-3 ? -light.position : glm::dvec3(0.0, -1.0, 0.0);
        const glm::dvec3 n =
            glm::normalize(glm::length(light.facing) > 0.0 ? light.facing : inward);
        glm::dvec3 side = glm::cross(glm::dvec3(0.0, 1.0, 0.0), n);
        side = glm::length(side) > 1e-6 ? glm::normalize(side) : glm::dvec3(1.0, 0.0, 0.0);
        result.x = 0.5 * light.width * side;
        const double height = result.kind == Light::Kind::disk ? light.width : light.height;
        result.y = 0.5 * height * glm::cross(n, side);
    }
    return result;
}

Sky::Sky(scene::Globe globe) : globe_(std::move(globe))
{
    double mean = 0.0;
    for (std::size_t i = 0; i < globe_.count(); i++) {
        mean += strongest(globe_.radiance(i)) * globe_.solid_angle(i) / (4.0 * pi);
    }
    bound_ = 4.0 * mean;
    double sum = 0.0;
    for (std::size_t i = 0; i < globe_.count(); i++) {
        sum += strongest(part(i, false)) * globe_.solid_angle(i);
        power_.push_back(sum);
    }
}

glm::dvec3 Sky::part(std::size_t i, bool bounded) const
{
    const glm::dvec3 whole = globe_.radiance(i);
    const double most = strongest(whole), share = most > bound_ ? bound_ / most : 1.0;
    return whole * (bounded ? share : 1.0 - share);
}

glm::dvec3 Sky::radiance(const glm::dvec3 &direction) const
{
    return part(globe_.find(direction), true);
}

Way Sky::way(Random &random) const
{
    Way way;
    if (power_.empty() || power_.back() <= 0.0) {
        return way;
    }
    const auto at = std::upper_bound(power_.begin(), power_.end(), random.unit() * power_.back());
    const std::size_t i = std::min(std::size_t(at - power_.begin()), power_.size() - 1);
    const double own = power_[i] - (i ? power_[i - 1] : 0.0);
    way.direction = globe_.within(i, random.unit(), random.unit());
    way.irradiance = part(i, false) * (globe_.solid_angle(i) * power_.back() / own);
    return way;
}

} // namespace tsuya::reference

#include "scene/globe.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::scene
{

namespace
{

constexpr double pi = 3.14159265358979323846;

// Radiance of a preset from direction d.
glm::dvec3 preset(const std::string &name, const glm::dvec3 &d)
{
    if (name == "window") {
        const glm::dvec3 at = d.x > 0.3 ? d / d.x : glm::dvec3(1.0, 9.0, 9.0);
        const bool inside = std::abs(at.y - 0.3) < 0.5 && std::abs(at.z - 0.2) < 0.35;
        return inside ? glm::dvec3(9.0, 9.5, 10.0) : glm::dvec3(0.32, 0.29, 0.26);
    }
    const double up = std::max(d.y, 0.0), ground = std::min(1.0, std::max(0.0, 0.5 - 4.0 * d.y));
    if (name == "gradient") {
        const glm::dvec3 sky = glm::mix(glm::dvec3(1.2, 1.25, 1.3), glm::dvec3(0.5, 0.7, 1.1), up);
        return glm::mix(sky, glm::dvec3(0.3, 0.26, 0.2), ground);
    }
    // sunset: a sun of 2 degrees in a warm horizon
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.9, 0.2, 0.35));
    const double along = glm::dot(d, sun);
    const glm::dvec3 sky = glm::mix(glm::dvec3(1.0, 0.62, 0.38), glm::dvec3(0.2, 0.3, 0.55), up) +
                           glm::dvec3(1.2, 0.6, 0.25) * std::exp(8.0 * (along - 1.0));
    const glm::dvec3 land = glm::mix(sky, glm::dvec3(0.16, 0.12, 0.1), ground);
    return along > std::cos(0.0349) ? glm::dvec3(520.0, 330.0, 170.0) : land;
}

glm::dvec3 way(double cosine, double turn)
{
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return {sine * std::sin(turn), cosine, -sine * std::cos(turn)};
}

} // namespace

Expected<Globe> Globe::of(const Scene &scene)
{
    Globe globe;
    globe.name_ = scene.environment;
    globe.factor_ = scene.environment_intensity;
    const std::string prefix = "file:";
    if (scene.environment.rfind(prefix, 0) == 0) {
        const std::string path = scene.environment.substr(prefix.size());
        std::string error;
        if (!image::read_exr(path, globe.picture_, error)) {
            return Error{error};
        }
        globe.width_ = globe.picture_.width;
        globe.height_ = globe.picture_.height;
        if (globe.width_ != 2 * globe.height_) {
            return Error{path + ": an environment is twice as wide as high, this is " +
                         std::to_string(globe.width_) + "x" + std::to_string(globe.height_)};
        }
        for (std::size_t i = 0; i < globe.count(); i++) {
            const glm::dvec3 radiance = globe.radiance(i);
            for (int k = 0; k < 3; k++) {
                if (!(radiance[k] >= 0.0 && std::isfinite(radiance[k]))) {
                    return Error{path + ": radiance is finite and not below 0, but that of pixel " +
                                 std::to_string(i % std::size_t(globe.width_)) + "," +
                                 std::to_string(i / std::size_t(globe.width_)) + " is " +
                                 std::to_string(radiance[k])};
                }
            }
        }
    }
    return Expected<Globe>(std::move(globe));
}

glm::dvec3 Globe::radiance(std::size_t i) const
{
    if (picture_.channels == 0) {
        return factor_ * preset(name_, direction(i));
    }
    const std::size_t channels = std::size_t(picture_.channels);
    glm::dvec3 result;
    for (int k = 0; k < 3; k++) {
        result[k] = factor_ * double(picture_.pixels[i * channels + (channels < 3 ? 0 : k)]);
    }
    return result;
}

double Globe::solid_angle(std::size_t i) const
{
    const double row = double(i / std::size_t(width_));
    return (std::cos(pi * row / height_) - std::cos(pi * (row + 1.0) / height_)) * 2.0 * pi /
           width_;
}

glm::dvec3 Globe::direction(std::size_t i) const
{
    const double row = double(i / std::size_t(width_)), column = double(i % std::size_t(width_));
    return way(std::cos(pi * (row + 0.5) / height_), 2.0 * pi * ((column + 0.5) / width_ - 0.5));
}

glm::dvec3 Globe::within(std::size_t i, double u, double v) const
{
    const double row = double(i / std::size_t(width_)), column = double(i % std::size_t(width_));
    const double top = std::cos(pi * row / height_), bottom = std::cos(pi * (row + 1.0) / height_);
    return way(top + v * (bottom - top), 2.0 * pi * ((column + u) / width_ - 0.5));
}

std::size_t Globe::find(const glm::dvec3 &direction) const
{
    const glm::dvec3 d = glm::normalize(direction);
    const double row = std::acos(std::clamp(d.y, -1.0, 1.0)) / pi * height_;
    const double column = (std::atan2(d.x, -d.z) / (2.0 * pi) + 0.5) * width_;
    const int y = std::clamp(int(row), 0, height_ - 1), x = std::clamp(int(column), 0, width_ - 1);
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
}

} // namespace tsuya::scene

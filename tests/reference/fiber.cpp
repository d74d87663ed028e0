#include "reference/fiber.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::reference {

namespace {

// Unit vector across t on the side of v, and the sine of v's inclination.
glm::dvec3 across(const glm::dvec3 &t, const glm::dvec3 &v, double &sin_theta)
{
    sin_theta = std::clamp(glm::dot(t, v), -1.0, 1.0);
    const glm::dvec3 side = v - t * sin_theta;
    const double size = glm::length(side);
    if (size > 1e-9) {
        return side / size;
    }
    const glm::dvec3 other =
        std::abs(t.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(glm::cross(t, other));
}

} // namespace

Fiber::Fiber(const FiberParams &params)
    : azimuthal_({params.eta, params.beta_az, params.sigma_a, params.variation})
{
    // As stated in tsuya/models/marschner.h.
    constexpr double textbook[lobes] = {1.0, -0.5, -1.5, -2.5};
    constexpr double scales[lobes] = {1.0, -0.92, -3.2, -1.2};
    constexpr double widths[lobes] = {1.0, 0.5, 2.0, 2.0};
    for (int p = 0; p < lobes; p++) {
        const double shift = textbook[p] + params.scale_shifts * (scales[p] - textbook[p]);
        longitudinal_.emplace_back(params.longitudinal, params.alpha_R * shift,
                                   params.beta_R * widths[p]);
    }
}

glm::dvec3 Fiber::value(const glm::dvec3 &t, const glm::dvec3 &l, const glm::dvec3 &v,
                        double u) const
{
    double sin_i = 0.0, sin_r = 0.0;
    const glm::dvec3 side_i = across(t, l, sin_i), side_r = across(t, v, sin_r);
    // From the chord: the arc cosine would blur phi near 0 and pi.
    const double phi = 2.0 * std::atan2(glm::length(side_i - side_r), glm::length(side_i + side_r));
    const double theta_i = std::asin(sin_i), theta_r = std::asin(sin_r);
    glm::dvec3 n[lobes], sum(0.0);
    azimuthal_.density(std::cos(theta_r), phi, u, n);
    for (int p = 0; p < lobes; p++) {
        sum += longitudinal_[std::size_t(p)].density(theta_i, theta_r) * n[p];
    }
    return sum;
}

glm::dvec3 Fiber::sample(const glm::dvec3 &t, const glm::dvec3 &v, double u, glm::dvec3 &throughput,
                         Random &random) const
{
    double sin_r = 0.0, phi = 0.0;
    const glm::dvec3 side = across(t, v, sin_r), up = glm::cross(t, side);
    const double theta_r = std::asin(sin_r);
    const int p = azimuthal_.sample(std::cos(theta_r), u, throughput, &phi, random);
    const double theta_i = longitudinal_[std::size_t(p)].sample(theta_r, random);
    return glm::normalize(t * std::sin(theta_i) +
                          std::cos(theta_i) * (side * std::cos(phi) + up * std::sin(phi)));
}

} // namespace tsuya::reference

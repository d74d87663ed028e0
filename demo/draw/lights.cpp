#include "draw/lights.h"

#include <glm/common.hpp>

#include <cmath>

namespace tsuya::draw {

std::vector<Light> sky(const glm::vec3 &radiance, int count)
{
    const double pi = 3.14159265358979323846;
    const double turn = pi * (3.0 - std::sqrt(5.0));
    std::vector<Light> lights;
    for (int i = 0; i < count; i++) {
        const double y = 1.0 - (2.0 * i + 1.0) / count;
        const double r = std::sqrt(1.0 - y * y);
        lights.push_back({glm::vec3(r * std::cos(turn * i), y, r * std::sin(turn * i)),
                          radiance * float(4.0 * pi / count)});
    }
    return lights;
}

std::vector<Light> sky(const std::array<float, 36> &environment, int count)
{
    std::vector<Light> lights = sky(glm::vec3(1.0f), count);
    for (Light &light : lights) {
        const glm::vec3 d = light.direction;
        const float p[9] = {1.0f,      d.x,       d.y,
                            d.z,       d.x * d.y, d.y * d.z,
                            d.z * d.x, d.x * d.x - d.y * d.y, 3.0f * d.z * d.z - 1.0f};
        glm::vec3 radiance(0.0f);
        for (int j = 0; j < 9; j++) {
            const float *r = &environment[std::size_t(4 * j)];
            radiance += p[j] * glm::vec3(r[0], r[1], r[2]);
        }
        // Not 0, which would be no light at all, without a shadow to look up.
        light.irradiance *= glm::max(radiance, 1e-6f);
    }
    return lights;
}

} // namespace tsuya::draw

#include "draw/lights.h"

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

} // namespace tsuya::draw

#include "scene/light.h"

#include "scene/globe.h"

#include <tsuya/light.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace tsuya::scene {

namespace {

constexpr double pi = 3.14159265358979323846;

struct Library {
    Library()
    {
        tsu_context_desc desc;
        tsu_context_desc_init(&desc);
        desc.log_user = this;
        desc.log = [](void *user, int32_t, int32_t, const char *text) {
            static_cast<Library *>(user)->message = text;
        };
        tsu_context_create(&desc, &context);
    }
    ~Library()
    {
        tsu_context_destroy(context);
    }
    tsu_context *context = nullptr;
    std::string message;
};

void put(float out[3], const glm::dvec3 &v)
{
    for (int k = 0; k < 3; k++) {
        out[k] = float(v[k]);
    }
}

glm::dvec3 across(const glm::dvec3 &n)
{
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const glm::dvec3 side = glm::cross(up, n);
    return glm::length(side) > 1e-6 ? glm::normalize(side) : glm::dvec3(1.0, 0.0, 0.0);
}

// A globe as the library asks for it.
void sample(void *user, uint32_t index, float d[3], float l[3], float *angle)
{
    const Globe &globe = *static_cast<const Globe *>(user);
    put(d, globe.direction(index));
    put(l, globe.radiance(index));
    *angle = float(globe.solid_angle(index));
}

} // namespace

draw::Light own_light(const SceneLight &light, const glm::dvec3 &middle)
{
    tsu_light_desc desc;
    tsu_light_desc_init(&desc);
    const glm::dvec3 color = light.color * light.intensity;
    put(desc.color, color);
    put(desc.direction, glm::normalize(light.direction));
    put(desc.position, light.position);
    desc.angle = float(light.angle * pi / 180.0);
    desc.flags = light.sides == 2 ? TSU_LIGHT_TWO_SIDED : 0;
    desc.kind = light.kind == "rect"    ? TSU_LIGHT_RECT
                : light.kind == "disk"  ? TSU_LIGHT_DISK
                : light.kind == "point" ? TSU_LIGHT_POINT
                                        : TSU_LIGHT_DIRECTIONAL;
    draw::Light result{glm::vec3(glm::normalize(light.direction)), glm::vec3(color)};
    if (desc.kind != TSU_LIGHT_DIRECTIONAL) {
        const glm::dvec3 to = light.position - middle;
        const double far = std::max(glm::length(to), 1e-3);
        const glm::dvec3 way = glm::length(to) > 1e-3 ? to / far : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 home = glm::length(light.position) > 1e-3
                                    ? -glm::normalize(light.position)
                                    : glm::dvec3(0.0, -1.0, 0.0);
        const glm::dvec3 n =
            glm::length(light.facing) > 0.0 ? glm::normalize(light.facing) : home;
        const glm::dvec3 x = across(n) * 0.5 * light.width;
        const bool disk = desc.kind == TSU_LIGHT_DISK;
        const glm::dvec3 y = glm::normalize(glm::cross(n, x)) * 0.5 *
                             (disk ? light.width : light.height);
        put(desc.x, x);
        put(desc.y, y);
        const double facing = glm::dot(n, -way);
        const double area = (disk ? pi : 4.0) * glm::length(x) * glm::length(y) *
                            (light.sides == 2 ? std::abs(facing) : std::max(facing, 0.0));
        result.direction = glm::vec3(way);
        // Right in front of a disk's middle; elsewhere, and of a rectangle, not more than it gives.
        result.irradiance =
            glm::vec3(desc.kind == TSU_LIGHT_POINT ? color / (far * far)
                                                   : color * area / (far * far + area / pi));
    }
    Library library;
    float record[16];
    // The keys' ranges are within the library's.
    if (tsu_light_pack(library.context, &desc, record) == TSU_OK && record[3] > 0.0f) {
        std::copy(record, record + 16, result.record.begin());
    }
    return result;
}

Expected<Surroundings> surroundings(const Scene &scene)
{
    Surroundings result;
    if (scene.environment == "none") {
        return Expected<Surroundings>(result);
    }
    Expected<Globe> globe = Globe::of(scene);
    if (!globe) {
        return Error{globe.error()};
    }
    Library library;
    tsu_environment_desc desc;
    tsu_environment_desc_init(&desc);
    desc.radiance = sample;
    desc.user = &*globe;
    desc.count = uint32_t(globe->count());
    tsu_environment environment;
    tsu_environment_init(&environment);
    if (tsu_environment_make(library.context, &desc, &environment) != TSU_OK) {
        return Error{"environment: " + library.message};
    }
    result.there = true;
    std::copy(environment.record, environment.record + 36, result.record.begin());
    const float *irradiance = environment.light_irradiance;
    if (irradiance[0] + irradiance[1] + irradiance[2] > 0.0f) {
        SceneLight light;
        light.intensity = 1.0;
        light.angle = double(environment.light_angle) * 180.0 / pi;
        for (int k = 0; k < 3; k++) {
            light.direction[k] = double(environment.light_direction[k]);
            light.color[k] = double(irradiance[k]);
        }
        result.dominant.push_back(own_light(light, glm::dvec3(0.0)));
    }
    return Expected<Surroundings>(std::move(result));
}

} // namespace tsuya::scene

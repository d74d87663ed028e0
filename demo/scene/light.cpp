#include "scene/light.h"

#include "image/image.h"

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

// A latitude-longitude picture: +y on top, -z in the middle, +x to its right.
struct Globe {
    int width = 0, height = 0;
    double factor = 1.0;
    std::string name;     // of a preset
    image::Image picture; // of a file

    static void sample(void *user, uint32_t index, float d[3], float l[3], float *angle)
    {
        const Globe &globe = *static_cast<const Globe *>(user);
        const int row = int(index) / globe.width, column = int(index) % globe.width;
        const double top = pi * row / globe.height, bottom = pi * (row + 1) / globe.height;
        const double polar = 0.5 * (top + bottom);
        const double turn = 2.0 * pi * ((column + 0.5) / globe.width - 0.5);
        const glm::dvec3 way(std::sin(polar) * std::sin(turn), std::cos(polar),
                             -std::sin(polar) * std::cos(turn));
        put(d, way);
        *angle = float((std::cos(top) - std::cos(bottom)) * 2.0 * pi / globe.width);
        if (globe.picture.channels == 0) {
            put(l, globe.factor * preset(globe.name, way));
            return;
        }
        const int channels = globe.picture.channels;
        const float *pixel = &globe.picture.pixels[std::size_t(index) * std::size_t(channels)];
        for (int k = 0; k < 3; k++) {
            l[k] = float(globe.factor) * pixel[channels < 3 ? 0 : k];
        }
    }
};

} // namespace

draw::Light own_light(const SceneLight &light)
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
        // From the origin, for the grid, the maps and the head.
        const double far = std::max(glm::length(light.position), 1e-3);
        const glm::dvec3 way = glm::length(light.position) > 1e-3 ? light.position / far
                                                                  : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 n = glm::length(light.facing) > 0.0 ? glm::normalize(light.facing) : -way;
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
        result.irradiance =
            glm::vec3(color * (desc.kind == TSU_LIGHT_POINT ? 1.0 : area) / (far * far));
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
    Globe globe;
    globe.width = 512;
    globe.height = 256;
    globe.name = scene.environment;
    globe.factor = scene.environment_intensity;
    const std::string prefix = "file:";
    if (scene.environment.rfind(prefix, 0) == 0) {
        const std::string path = scene.environment.substr(prefix.size());
        std::string error;
        if (!image::read_exr(path, globe.picture, error)) {
            return Error{error};
        }
        globe.width = globe.picture.width;
        globe.height = globe.picture.height;
        if (globe.width != 2 * globe.height) {
            return Error{path + ": an environment is twice as wide as high, this is " +
                         std::to_string(globe.width) + "x" + std::to_string(globe.height)};
        }
    }
    Library library;
    tsu_environment_desc desc;
    tsu_environment_desc_init(&desc);
    desc.radiance = Globe::sample;
    desc.user = &globe;
    desc.count = uint32_t(globe.width) * uint32_t(globe.height);
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
        result.dominant.push_back(own_light(light));
    }
    return Expected<Surroundings>(std::move(result));
}

} // namespace tsuya::scene

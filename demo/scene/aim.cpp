#include "scene/build.h"
#include "scene/light.h"
#include "scene/plant.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::scene {

namespace {

constexpr double degree = 0.01745329251994329577;

glm::dvec3 toward(double azimuth, double elevation)
{
    const double a = azimuth * degree, e = elevation * degree;
    return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

constexpr int sky_directions = 20; // of the sky's shadow

struct RigLight {
    const char *rig;
    double azimuth, elevation, irradiance;
};

const RigLight rigs[] = {
    {"key", 47.0, 36.0, 0.6},  {"key", 202.0, 26.0, 1.0},  {"front", 10.0, 20.0, 2.0},
    {"side", 95.0, 20.0, 3.0}, {"back", 195.0, 20.0, 3.0},
};

struct Box {
    glm::dvec3 lower, upper;
};

// Of what there is to see; the first of these is not empty.
using Points = std::vector<const std::vector<glm::vec3> *>;

Box bounds(const Points &shown)
{
    Box box = {glm::dvec3(shown[0]->front()), glm::dvec3(shown[0]->front())};
    for (const std::vector<glm::vec3> *points : shown) {
        for (const glm::vec3 &p : *points) {
            box.lower = glm::min(box.lower, glm::dvec3(p));
            box.upper = glm::max(box.upper, glm::dvec3(p));
        }
    }
    return box;
}

// Distance from `target` along `back` at which every point is inside the picture.
double distance(const Points &shown, const glm::dvec3 &target, const glm::dmat4 &model,
                const glm::dvec3 &back, double tan_x, double tan_y)
{
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), back));
    const glm::dvec3 up = glm::cross(back, right);
    double far = 0.0;
    for (const std::vector<glm::vec3> *points : shown) {
        for (const glm::vec3 &point : *points) {
            const glm::dvec3 p = glm::dvec3(model * glm::dvec4(point, 1.0)) - target;
            const double side = std::max(std::abs(glm::dot(p, right)) / tan_x,
                                         std::abs(glm::dot(p, up)) / tan_y);
            far = std::max(far, side + glm::dot(p, back));
        }
    }
    return far;
}

void aim_at(const Scene &scene, const Points &shown, bool turntable, draw::View &frame)
{
    const Box box = bounds(shown);
    const glm::dvec3 middle = 0.5 * (box.lower + box.upper);
    const glm::dvec3 target = scene.camera_aims ? scene.camera_target : middle;
    const double aspect = double(scene.width) / double(scene.height);
    const double tan_y = std::tan(0.5 * scene.camera_fov * degree), tan_x = tan_y * aspect;
    const glm::dvec3 back = toward(scene.camera_azimuth, scene.camera_elevation);

    const auto turned = [&](double degrees) {
        return glm::translate(glm::dmat4(1.0), middle) *
               glm::rotate(glm::dmat4(1.0), degrees * degree, glm::dvec3(0.0, 1.0, 0.0)) *
               glm::translate(glm::dmat4(1.0), -middle);
    };
    double far = scene.camera_distance;
    if (far <= 0.0) {
        constexpr double margin = 1.04;
        for (int i = 0; i < (turntable ? 12 : 1); i++) {
            far = std::max(far, margin * distance(shown, target, turned(scene.turn + 30.0 * i),
                                                  back, tan_x, tan_y));
        }
    }
    far = std::max(far / scene.camera_zoom, 1e-6);
    const glm::dvec3 eye = target + far * back;
    const double size = glm::length(box.upper - box.lower) + glm::distance(target, middle);
    const double near = std::max(far - size, 0.01 * far);
    frame.model = glm::mat4(turned(scene.turn));
    frame.view = glm::mat4(glm::lookAt(eye, target, glm::dvec3(0.0, 1.0, 0.0)));
    frame.projection = glm::mat4(
        glm::perspective(scene.camera_fov * degree, aspect, near, far + 2.0 * size));
    frame.eye = glm::vec3(eye);
    frame.distance = float(far);
    frame.near = float(near);
}

} // namespace

std::vector<draw::Light> lights(const Scene &scene, const glm::dvec3 &middle)
{
    std::vector<draw::Light> result;
    for (const RigLight &light : rigs) {
        if (scene.light == light.rig) {
            result.push_back({glm::vec3(toward(light.azimuth, light.elevation)),
                              glm::vec3(float(light.irradiance))});
        }
    }
    for (const auto &own : scene.lights) {
        result.push_back(own_light(own.second, middle));
    }
    return result;
}

glm::dvec3 middle(const std::vector<glm::vec3> &points)
{
    const Box box = bounds({&points});
    return 0.5 * (box.lower + box.upper);
}

std::vector<draw::Light> sky(const Scene &scene)
{
    if (scene.dome <= 0.0) {
        return {};
    }
    return draw::sky(glm::vec3(scene.dome_color * scene.dome), sky_directions);
}

void aim(const Scene &scene, const Hair &hair, bool turntable, draw::View &frame)
{
    Points shown = {&hair.groom.points};
    if (scene.head == "auto") {
        shown.push_back(&hair.head.positions);
    }
    aim_at(scene, shown, turntable, frame);
}

void aim(const Scene &scene, const Surface &surface, bool turntable, draw::View &frame)
{
    aim_at(scene, {&surface.points}, turntable, frame);
}

} // namespace tsuya::scene

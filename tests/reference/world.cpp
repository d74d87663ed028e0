#include "reference/world.h"

#include <tsuya/model.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cstring>

namespace tsuya::reference {

namespace {

// A material's parameter by the model's name for it; none: NULL.
const float *parameter(const scene::Material &material, const char *name)
{
    tsu_parameter_info info;
    tsu_parameter_info_init(&info);
    for (uint32_t i = 0; tsu_model_parameter(material.model, i, &info) == TSU_OK; i++) {
        if (!std::strcmp(info.name, name)) {
            return reinterpret_cast<const float *>(
                reinterpret_cast<const char *>(material.params.data()) + info.offset);
        }
    }
    return nullptr;
}

} // namespace

Expected<FiberParams> fiber_params(const scene::Scene &scene, const scene::Material &material)
{
    FiberParams params;
    double *const fields[] = {&params.eta, &params.alpha_R, &params.beta_R, &params.beta_az,
                              &params.scale_shifts};
    const char *const names[] = {"eta", "alpha_R", "beta_R", "beta_az", "scale_shifts"};
    // What multiply scattering models add is what the paths do anyway.
    for (std::size_t i = 0; i < 5; i++) {
        const float *const from = parameter(material, names[i]);
        if (!from) {
            return Error{"model is " + scene.model + ", which has no " + names[i] +
                         " for the reference to trace; say model=marschner"};
        }
        *fields[i] = double(*from);
    }
    params.sigma_a = material.sigma_a;
    params.variation = scene.variation;
    return Expected<FiberParams>(params);
}

Strands strands(const groom::Groom &groom, const draw::Frame &frame)
{
    Strands result;
    result.first = groom.first;
    const float scale = glm::length(glm::vec3(frame.model[0])) * frame.width_scale;
    for (const glm::vec3 &point : groom.points) {
        result.points.push_back(glm::vec3(frame.model * glm::vec4(point, 1.0f)));
    }
    for (std::size_t s = 0; s < groom.strands(); s++) {
        const std::size_t begin = groom.first[s], end = groom.first[s + 1];
        std::vector<double> way(1, 0.0);
        for (std::size_t i = begin + 1; i < end; i++) {
            way.push_back(way.back() +
                          double(glm::distance(result.points[i - 1], result.points[i])));
        }
        for (std::size_t i = begin; i < end; i++) {
            const double share = 1.0 - way[i - begin] / way.back();
            const double taper =
                frame.taper > 0.0f ? std::clamp(share / double(frame.taper), 0.0, 1.0) : 1.0;
            const float radius = groom.radius.empty() ? groom.constant_radius : groom.radius[i];
            result.radius.push_back(radius * scale * float(taper));
            const std::size_t before = std::max(i, begin + 1) - 1, after = std::min(i + 1, end - 1);
            result.tangent.push_back(result.points[after] - result.points[before]);
        }
        result.chance.push_back(2.0 * double(groom.seed[s]) - 1.0);
    }
    return result;
}

Surface surface(const groom::Mesh &head, const draw::Frame &frame)
{
    // Hair that lies on the head stays in sight: demo/draw/head.vert.glsl.
    constexpr float inset = 0.0015f;
    Surface result;
    if (!frame.head) {
        return result;
    }
    result.indices = head.indices;
    for (std::size_t i = 0; i < head.positions.size(); i++) {
        const glm::vec3 position = head.positions[i] - inset * head.normals[i];
        result.positions.push_back(glm::vec3(frame.model * glm::vec4(position, 1.0f)));
        result.normals.push_back(glm::mat3(frame.model) * head.normals[i]);
    }
    return result;
}

Expected<World> world(const scene::Scene &scene, const scene::Hair &hair,
                      const scene::Material &material, const draw::Frame &frame, unsigned threads)
{
    const Expected<FiberParams> params = fiber_params(scene, material);
    if (!params) {
        return Error{params.error()};
    }
    World world;
    world.fiber = std::make_shared<Fiber>(*params);
    world.geometry =
        std::make_shared<Geometry>(strands(hair.groom, frame), surface(hair.head, frame), threads);
    // The rig's; own ones, which come after them, may have a place and a size.
    const std::size_t rig = frame.lights.size() - scene.lights.size();
    for (std::size_t i = 0; i < rig; i++) {
        Light light;
        light.direction = glm::normalize(glm::dvec3(frame.lights[i].direction));
        light.irradiance = glm::dvec3(frame.lights[i].irradiance);
        world.lights.push_back(light);
    }
    for (const auto &own : scene.lights) {
        world.lights.push_back(light_of(own.second));
    }
    if (scene.environment != "none") {
        Expected<scene::Globe> globe = scene::Globe::of(scene);
        if (!globe) {
            return Error{globe.error()};
        }
        world.around = std::make_shared<Sky>(std::move(*globe));
    }
    world.sky = scene.dome_color * scene.dome;
    world.background = scene.background;
    world.skin = glm::dvec3(frame.skin);
    return Expected<World>(world);
}

Camera camera(const draw::Frame &frame)
{
    Camera camera;
    camera.eye = glm::dvec3(frame.eye);
    // A rotation: its inverse is its transpose.
    camera.world = glm::transpose(glm::dmat3(glm::mat3(frame.view)));
    camera.tan_x = 1.0 / double(frame.projection[0].x);
    camera.tan_y = 1.0 / double(frame.projection[1].y);
    camera.near = double(frame.near);
    return camera;
}

} // namespace tsuya::reference

// A studio for leaves, flat ones to draw in it, and the reference's answer; brings cmocka along.
#ifndef TSUYA_TESTS_LEAF_RIG_H
#define TSUYA_TESTS_LEAF_RIG_H

#include "leaf_checks.h"

#include "scene/build.h"
#include "scene/picture.h"
#include "scene/plant.h"

#include <tsuya/models/leaf.h>
#include <tsuya/models/leaf_body.h>
#include <tsuya/models/leaf_coarse.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace leaf_rig {

using namespace leaf_checks;
using namespace tsuya;

inline std::unique_ptr<scene::Studio> studio;
inline draw::SurfaceRenderer *renderer = nullptr;
inline tsu_context *library = nullptr;

constexpr double pi = 3.14159265358979323846;

// One row of the function "leaf" or "leaf-body": a leaf given by its faces, and directions.
struct Row {
    double R_top = 0.129, R_bottom = 0.18, T = 0.126, n = 1.45;
    double mu0 = 1.0, mu = 1.0, phi = 0.0;
    bool through = false, from_below = false;
    double absorption = 1.0, thickness = 1.0, roughness = 0.35;

    std::vector<double> values(const tsu_model *model) const
    {
        tsu_function_info function;
        tsu_info_init_sized(&function, sizeof function);
        assert_int_equal(tsu_model_function(model, 0, &function), TSU_OK);
        std::vector<double> row;
        for (uint32_t i = 0; i < function.input_count; i++) {
            tsu_value_info value;
            tsu_value_info_init(&value);
            assert_int_equal(tsu_function_input(model, 0, i, &value), TSU_OK);
            const std::string name = value.name;
            row.push_back(name == "R_top"        ? R_top
                          : name == "R_bottom"   ? R_bottom
                          : name == "T"          ? T
                          : name == "n"          ? n
                          : name == "mu0"        ? mu0
                          : name == "mu"         ? mu
                          : name == "phi"        ? phi
                          : name == "kind"       ? double(through)
                          : name == "side"       ? double(from_below)
                          : name == "absorption" ? absorption
                          : name == "thickness"  ? thickness
                          : name == "roughness"  ? roughness
                                                 : value.default_value);
        }
        return row;
    }

    // BRDF or BTDF of all lobes.
    double reference(const tsu_model *model) const
    {
        double out[8] = {0.0};
        assert_int_equal(tsu_function_reference(library, model, 0, values(model).data(), out),
                         TSU_OK);
        return out[0] + out[1] + out[2];
    }

    std::vector<std::max_align_t> params(const tsu_model *model) const
    {
        tsu_model_info info;
        tsu_model_info_init(&info);
        tsu_model_describe(model, &info);
        std::vector<std::max_align_t> params(info.params_size / sizeof(std::max_align_t) + 1);
        tsu_model_params_init(model, params.data(), info.params_size);
        assert_int_equal(
            tsu_function_params(library, model, 0, values(model).data(), params.data()), TSU_OK);
        return params;
    }
};

// A flat leaf of side 2 around the origin that faces +z.
inline Mesh quad()
{
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    make_normals(mesh);
    make_tangents(mesh);
    return mesh;
}

// Seen from `toward`, orthographic, so that every pixel has the same view.
inline draw::SurfaceFrame frame(const glm::dvec3 &toward, float half = 2.0f)
{
    draw::SurfaceFrame frame;
    frame.width = frame.height = 64;
    const glm::vec3 eye = 1000.0f * glm::vec3(glm::normalize(toward));
    frame.eye = eye;
    frame.view = glm::lookAt(eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
    frame.projection = glm::ortho(-half, half, -half, half, 990.0f, 1010.0f);
    return frame;
}

inline draw::Light sun(const glm::dvec3 &toward, double irradiance)
{
    return {glm::vec3(glm::normalize(toward)), glm::vec3(float(irradiance))};
}

inline draw::Picture drawn(const draw::SurfaceFrame &frame)
{
    const auto good = renderer->draw(frame);
    if (!good) {
        fail_msg("%s", good.error().c_str());
    }
    draw::Picture picture = renderer->picture();
    for (const float value : picture.pixels) {
        assert_true(std::isfinite(value) && value >= 0.0f);
    }
    return picture;
}

// Mean over pixels that leaves cover whole, of the channel; -1: the whole picture's coverage.
inline double mean(const draw::Picture &picture, int channel, bool (*chosen)(int, int) = nullptr)
{
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < picture.height; y++) {
        for (int x = 0; x < picture.width; x++) {
            const float *p = &picture.pixels[std::size_t(4 * (y * picture.width + x))];
            if (channel < 0) {
                sum += double(p[3]);
                weight += 1.0;
            } else if (p[3] == 1.0f && (!chosen || chosen(x, y))) {
                sum += double(p[channel]);
                weight += 1.0;
            }
        }
    }
    assert_true(weight > 0.0);
    return sum / weight;
}

inline void take(const Plant &plant, const tsu_model *model, const Row &row)
{
    renderer->load(plant);
    const auto taken = renderer->material(model, row.params(model).data());
    if (!taken) {
        fail_msg("%s", taken.error().c_str());
    }
}

// Run tests in a studio.
template <std::size_t count> int run(const char *name, const CMUnitTest (&tests)[count])
{
    auto made = scene::Studio::create();
    if (!made) {
        std::fprintf(stderr, "%s: %s\n", name, made.error().c_str());
        return 1;
    }
    studio = std::move(*made);
    const auto surfaces = studio->surfaces();
    if (!surfaces) {
        std::fprintf(stderr, "%s: %s\n", name, surfaces.error().c_str());
        return 1;
    }
    renderer = *surfaces;
    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    tsu_context_create(&desc, &library);
    const int failed = cmocka_run_group_tests_name(name, tests, nullptr, nullptr);
    tsu_context_destroy(library);
    studio.reset();
    return failed;
}

} // namespace leaf_rig

#endif

// Heads of hair, their maps in memory, and the errors of maps against rays.
#ifndef TSUYA_TESTS_HAIR_SHADOW_HEADS_H
#define TSUYA_TESTS_HAIR_SHADOW_HEADS_H

#include "caster.h"
#include "draw/grid.h"
#include "groom/generate.h"

#include <tsuya/tsuya.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

extern "C" {
#include <cmocka.h>
}

using namespace tsuya;

// 10,000 strands that stand for the 100,000 of a head.
constexpr std::uint32_t strand_count = 10000;
constexpr float width_scale = 10.0f;
constexpr int columns = 128, rows = 64, point_count = columns * rows;

inline const glm::vec3 lights[3] = {{0.4f, 0.6f, 0.7f}, {0.0f, 1.0f, 0.0f}, {-0.9f, 0.1f, -0.4f}};

struct Head {
    groom::Groom groom;
    std::vector<float> points; // x, y, z, diameter
    std::vector<Place> places;
    glm::vec3 centre{0.0f};
    float radius = 0.0f, length = 0.0f;
};

inline Head grow(groom::Style style)
{
    groom::HairParams params = groom::preset(style);
    params.strands = strand_count;
    groom::Expected<groom::HairyHead> grown = groom::generate(params);
    assert_true(bool(grown));
    Head head;
    head.groom = std::move(grown->groom);
    const groom::Groom &g = head.groom;
    glm::vec3 lower(1e9f), upper(-1e9f);
    for (const glm::vec3 &p : g.points) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
        head.points.insert(head.points.end(),
                           {p.x, p.y, p.z, 2.0f * width_scale * g.constant_radius});
    }
    assert_true(g.radius.empty());
    head.centre = 0.5f * (lower + upper);
    for (std::size_t i = 0; i < g.points.size(); i++) {
        head.radius = std::max(head.radius, glm::distance(g.points[i], head.centre));
    }
    for (std::size_t s = 0; s < g.strands(); s++) {
        for (std::uint32_t i = g.first[s]; i + 1 < g.first[s + 1]; i++) {
            head.length += glm::distance(g.points[i], g.points[i + 1]);
        }
    }
    head.places = places(g, point_count);
    return head;
}

inline tsu_context *context = nullptr;

inline tsu_hair_shadow_plan make(const Head &head, const glm::vec3 &light,
                                 const tsu_model *technique, uint32_t size, float opacity,
                                 float layers = 8.0f, bool placed = false)
{
    tsu_hair_shadow_desc desc;
    tsu_hair_shadow_desc_init(&desc);
    tsu_deep_opacity_params params;
    tsu_model_params_init(technique, &params, sizeof params);
    params.opacity = opacity;
    params.layers = layers;
    desc.model = technique;
    desc.params = &params;
    for (int k = 0; k < 3; k++) {
        desc.centre[k] = head.centre[k];
        desc.light[k] = light[k];
    }
    desc.radius = head.radius;
    desc.length = head.length;
    desc.width = 2.0f * width_scale * head.groom.constant_radius;
    desc.size = size;
    desc.most_size = 1024;
    desc.flags |= placed ? uint32_t(TSU_HAIR_SHADOW_POINT) : 0u;
    tsu_hair_shadow_plan plan;
    tsu_hair_shadow_plan_init(&plan);
    assert_int_equal(tsu_hair_shadow_make(context, &desc, &plan), TSU_OK);
    return plan;
}

struct Truth {
    std::vector<Traced> bundle, ray;
};

inline Truth truth(const Head &head, const Caster &caster, float spacing)
{
    Truth result;
    for (const Place &place : head.places) {
        result.bundle.push_back(trace(caster, place, 4, spacing));
        result.ray.push_back(trace(caster, place, 1, 0.0f));
    }
    return result;
}

// Four floats a point: front, behind, direct, transmittance at opacity 0.5.
using Answers = std::vector<float>;

inline Answers in_memory(const Head &head, const tsu_hair_shadow_plan &plan)
{
    std::vector<float> map(tsu_hair_shadow_floats(&plan));
    assert_int_equal(tsu_hair_shadow_write(&plan, head.points.data(), head.groom.first.data(),
                                           uint32_t(head.groom.strands()), map.data()),
                     TSU_OK);
    Answers answers(4 * head.places.size());
    for (std::size_t i = 0; i < head.places.size(); i++) {
        assert_int_equal(tsu_hair_shadow_read(&plan, map.data(), &head.places[i].position.x,
                                              &answers[4 * i]),
                         TSU_OK);
    }
    return answers;
}

struct Errors {
    double direct = 0.0, half = 0.0, ray = 0.0, front = 0.0, behind = 0.0;
};

inline Errors errors(const Answers &answers, const Truth &truth)
{
    Errors e;
    const double n = double(truth.bundle.size());
    for (std::size_t i = 0; i < truth.bundle.size(); i++) {
        const float *a = &answers[4 * i];
        for (int k = 0; k < 4; k++) {
            assert_true(std::isfinite(a[k]) && a[k] >= 0.0f);
        }
        assert_true(a[2] <= 1.0001f && a[3] <= 1.0001f);
        e.direct += std::abs(double(a[2]) - truth.bundle[i].through) / n;
        e.half += std::abs(double(a[3]) - truth.bundle[i].half) / n;
        e.ray += std::abs(double(a[2]) - truth.ray[i].through) / n;
        e.front += (double(a[0]) - truth.bundle[i].front) / n;
        e.behind += (double(a[1]) - truth.bundle[i].behind) / n;
    }
    return e;
}

inline void say(const char *groom, int light, const char *what, const tsu_hair_shadow_plan &plan,
         const Errors &e)
{
    print_message("%-8s light %d  %-22s %4u^2 x %u  opaque fibres %.4f  half opaque %.4f  "
                  "one ray %.4f  front %+.2f  behind %+.2f\n",
                  groom, light, what, plan.size, plan.layers, e.direct, e.half, e.ray, e.front,
                  e.behind);
}

// The grid of the demo, for comparison.
inline Answers by_grid(const Head &head, const draw::Grid &grid, const glm::vec3 &light)
{
    const std::vector<float> fibres = grid.sweep(light), behind = grid.beyond(light);
    Answers answers;
    const auto at = [&](const std::vector<float> &values, const glm::vec3 &p) {
        const glm::vec3 q = glm::clamp((p - grid.corner()) / grid.cell() - 0.5f, glm::vec3(0.0f),
                                       glm::vec3(grid.size()) - 1.001f);
        const glm::ivec3 c(q);
        const glm::vec3 f = q - glm::vec3(c);
        double sum = 0.0;
        for (int i = 0; i < 8; i++) {
            const glm::ivec3 k = c + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
            const std::size_t cell = (std::size_t(k.z) * std::size_t(grid.size().y) +
                                      std::size_t(k.y)) * std::size_t(grid.size().x) +
                                     std::size_t(k.x);
            sum += double((i & 1 ? f.x : 1.0f - f.x) * (i >> 1 & 1 ? f.y : 1.0f - f.y) *
                          (i >> 2 ? f.z : 1.0f - f.z) * values[cell]);
        }
        return float(sum);
    };
    for (const Place &place : head.places) {
        const float n = at(fibres, place.position);
        answers.insert(answers.end(), {n, at(behind, place.position), std::exp(-n),
                                       std::exp(-0.5f * n)});
    }
    return answers;
}

#endif

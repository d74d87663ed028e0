// Each fibre is met once, none is lost, and what one fibre sends to the eye is the model's value.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "reference/render.h"

#include <tsuya/models/marschner.h>
#include <tsuya/tsuya.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

extern "C" {
#include <cmocka.h>
}

namespace {

using namespace tsuya::reference;

constexpr double pi = 3.14159265358979323846;
constexpr float thin = 6e-5f; // radius of a fibre, metres

void add(Strands &strands, const std::vector<glm::vec3> &points, float radius)
{
    if (strands.first.empty()) {
        strands.first.push_back(0);
    }
    for (std::size_t i = 0; i < points.size(); i++) {
        const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, points.size() - 1);
        strands.points.push_back(points[i]);
        strands.radius.push_back(radius);
        strands.tangent.push_back(points[after] - points[before]);
    }
    strands.first.push_back(std::uint32_t(strands.points.size()));
    strands.chance.push_back(0.0);
}

World world(Strands strands, const FiberParams &params = {})
{
    World world;
    world.geometry = std::make_shared<Geometry>(std::move(strands), Surface());
    world.fiber = std::make_shared<Fiber>(params);
    return world;
}

// Mean number of meetings of paths that come from all sides to points of the strand.
double meetings(const World &world, const std::vector<glm::vec3> &points, int paths)
{
    const Tracer tracer(world);
    double sum = 0.0;
    for (int i = 0; i < paths; i++) {
        Random random(5, 0, std::uint64_t(i));
        const std::size_t at = std::size_t(random.unit() * double(points.size() - 1));
        const glm::dvec3 goal =
            glm::mix(glm::dvec3(points[at]), glm::dvec3(points[at + 1]), random.unit());
        Path path;
        path.direction =
            glm::normalize(glm::dvec3(random.normal(), random.normal(), random.normal()));
        path.start.position = goal - 0.01 * path.direction;
        while (tracer.advance(path, random, nullptr, nullptr) == Fate::scattered) {
        }
        assert_true(path.meetings > 0);
        sum += path.meetings;
    }
    return sum / paths;
}

void fibre_is_met_once(void **)
{
    std::vector<glm::vec3> straight, arc;
    for (int i = 0; i <= 30; i++) {
        straight.push_back(glm::vec3(0.1f, 0.2f + 0.009f * float(i), -0.05f));
        const double angle = 0.05 * i;
        arc.push_back(glm::vec3(0.02 * std::cos(angle), 0.02 * std::sin(angle), 0.1));
    }
    Strands one, other;
    add(one, straight, thin);
    add(other, arc, thin);
    assert_true(meetings(world(one), straight, 100000) == 1.0);
    // An arc is really met again, by what leaves along its plane on the inside.
    const double again = meetings(world(other), arc, 100000) - 1.0;
    std::printf("arc: met again by %.4f %%\n", 100.0 * again);
    assert_true(again < 0.01);
}

void none_is_lost(void **)
{
    // Axes from a twentieth of a radius to 3 radii apart, where Embree alone would see nothing.
    for (int i = 1; i <= 60; i++) {
        const float away = 0.05f * float(i) * thin;
        Strands two;
        add(two, {glm::vec3(-1.0f, 0.0f, 0.0f), glm::vec3(1.0f, 0.0f, 0.0f)}, thin);
        add(two, {glm::vec3(-1.0f, away, 0.0f), glm::vec3(1.0f, away, 0.0f)}, thin);
        const Geometry geometry(std::move(two), Surface());
        Start start;
        start.point = 0;
        const glm::dvec3 up = glm::normalize(glm::dvec3(0.5, 1.0, 0.0));
        Hit hit;
        assert_true(geometry.meets(start, up, 0.0, hit));
        assert_true(hit.start.point == 2);
        assert_true(std::abs(hit.distance * up.y - double(away)) < 1e-6);
        assert_true(geometry.blocked(start, up));
        assert_false(geometry.meets(start, -up, 0.0, hit));
        assert_false(geometry.blocked(start, -up));
    }
}

void curl_is_met_again(void **)
{
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 64; i++) {
        const double angle = 2.0 * pi * i / 32.0;
        points.push_back(glm::vec3(0.005 * std::cos(angle), 1e-5 * i, 0.005 * std::sin(angle)));
    }
    Strands one;
    add(one, points, thin);
    const Geometry geometry(std::move(one), Surface());
    Start start;
    start.point = 0;
    start.position = glm::dvec3(points[0]);
    Hit hit;
    assert_true(
        geometry.meets(start, glm::normalize(glm::dvec3(points[16]) - start.position), 0.0, hit));
    assert_true(std::abs(hit.distance - 0.01) < 1e-4);
}

// A picture that one fibre fills, under one light, and one that it crosses.
void one_fibre_is_the_models_value(void **)
{
    FiberParams params;
    params.sigma_a = {0.05, 0.3, 1.0};
    Strands one;
    const glm::dvec3 t = glm::normalize(glm::dvec3(0.3, 1.0, -0.2));
    add(one, {glm::vec3(-2.0 * t), glm::vec3(2.0 * t)}, 0.01f);
    World scene = world(std::move(one), params);
    const glm::dvec3 l = glm::normalize(glm::dvec3(0.4, 0.3, -0.5)), v(0.0, 0.0, 1.0);
    scene.lights.push_back({l, glm::dvec3(2.0, 3.0, 4.0)});
    const Tracer tracer(scene);
    Camera camera;
    camera.eye = {0.0, 0.0, 100.0};
    camera.tan_x = camera.tan_y = 1e-5;
    Film film(4, 4);
    assert_true(render(tracer, camera, {16, 1, 2}, film));

    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    tsu_context *context = nullptr;
    assert_int_equal(tsu_context_create(&desc, &context), TSU_OK);
    const double theta_i = std::asin(glm::dot(l, t)), theta_r = std::asin(glm::dot(v, t));
    const glm::dvec3 side_i = glm::normalize(l - t * glm::dot(l, t));
    const glm::dvec3 side_r = glm::normalize(v - t * glm::dot(v, t));
    const double phi = std::acos(glm::dot(side_i, side_r));
    for (int c = 0; c < 3; c++) {
        const double in[9] = {theta_i,       theta_r,           phi,
                              params.eta,    params.sigma_a[c], params.alpha_R,
                              params.beta_R, params.beta_az,    0.0};
        double out[5] = {};
        assert_int_equal(tsu_function_reference(context, tsu_marschner(), 0, in, out), TSU_OK);
        const double expected = out[4] * scene.lights[0].irradiance[c];
        const double got = film.at(2, 1).mean(c);
        std::printf("one fibre: %.6f, model %.6f\n", got, expected);
        assert_true(std::abs(got / expected - 1.0) < 0.003);
        assert_true(film.at(2, 1).hair == 16.0);
    }
    tsu_context_destroy(context);

    camera.tan_x = camera.tan_y = 1e-3; // a square of 0.2 m
    Film wide(8, 8);
    assert_true(render(tracer, camera, {4096, 1, 2}, wide));
    // Slanted on the picture: longer by the same factor as it looks thinner across.
    const double covered = 0.02 / 0.2 / (t.y / std::hypot(t.x, t.y));
    std::printf("coverage %.5f, true %.5f\n", wide.summary().coverage, covered);
    assert_true(std::abs(wide.summary().coverage - covered) < 4.0 * std::sqrt(covered / 262144.0));
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(fibre_is_met_once),
        cmocka_unit_test(none_is_lost),
        cmocka_unit_test(curl_is_met_again),
        cmocka_unit_test(one_fibre_is_the_models_value),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}

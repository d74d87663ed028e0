// Lights and surroundings of the reference against closed forms and plain sums.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "image/image.h"
#include "reference/world.h"
#include "scene/light.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

extern "C" {
#include <cmocka.h>
}

namespace
{

using namespace tsuya;
using namespace tsuya::reference;

constexpr double pi = 3.14159265358979323846;

// Mean irradiance of ways to a light on a plane with normal n.
double irradiance(const Light &light, const glm::dvec3 &from, const glm::dvec3 &n, int ways)
{
    double sum = 0.0;
    for (int i = 0; i < ways; i++) {
        Random random(11, 0, std::uint64_t(i));
        const Way way = light.way(from, random);
        assert_true(std::abs(glm::length(way.direction) - 1.0) < 1e-9);
        sum += way.irradiance.x * std::max(glm::dot(way.direction, n), 0.0);
    }
    return sum / ways;
}

scene::SceneLight light(const char *kind, const glm::dvec3 &position)
{
    scene::SceneLight light;
    light.kind = kind;
    light.position = position;
    light.intensity = 2.0;
    light.width = 1.2;
    light.height = 0.7;
    return light;
}

// Irradiance through a rectangle seen from below one of its corners, over radiance. Source: any
// book of radiative heat transfer, element parallel to a rectangle.
double corner(double a, double b)
{
    const double p = std::sqrt(1.0 + a * a), q = std::sqrt(1.0 + b * b);
    return 0.5 * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
}

void near(const char *what, double value, double truth, double bound)
{
    std::printf("%-40s %.5f, exactly %.5f\n", what, value, truth);
    assert_true(std::abs(value - truth) <= bound * std::abs(truth));
}

void areas_give_their_closed_forms(void **)
{
    const glm::dvec3 up(0.0, 1.0, 0.0), middle(0.0);
    const Light rect = light_of(light("rect", {0.0, 0.8, 0.0}));
    near("rectangle overhead", irradiance(rect, middle, up, 200000),
         2.0 * 4.0 * corner(0.6 / 0.8, 0.35 / 0.8), 0.003);
    // From below a corner.
    near("from below its corner",
         irradiance(rect, {rect.x.x + rect.y.x, 0.0, rect.x.z + rect.y.z}, up, 200000),
         2.0 * corner(1.2 / 0.8, 0.7 / 0.8), 0.003);
    const Light disk = light_of(light("disk", {0.0, 0.8, 0.0}));
    near("disk", irradiance(disk, middle, up, 200000), 2.0 * pi * 0.36 / (0.36 + 0.64), 0.003);
    // Behind it, unless it shines to both sides.
    assert_true(irradiance(disk, {0.0, 1.6, 0.0}, -up, 100) == 0.0);
    scene::SceneLight both = light("disk", {0.0, 0.8, 0.0});
    both.sides = 2.0;
    near("its other side", irradiance(light_of(both), {0.0, 1.6, 0.0}, -up, 200000),
         2.0 * pi * 0.36 / (0.36 + 0.64), 0.003);
    const Light point = light_of(light("point", {0.3, 0.4, 0.0}));
    near("point", irradiance(point, middle, glm::normalize(point.position), 1), 2.0 / 0.25, 1e-12);
    assert_true(std::isfinite(
        irradiance(point, point.position + glm::dvec3(1e-9, 0.0, 0.0), {-1.0, 0.0, 0.0}, 1)));
    scene::SceneLight sun = light("directional", {});
    sun.direction = {0.0, 3.0, 4.0};
    sun.angle = 20.0;
    near("sun of 20 degrees", irradiance(light_of(sun), middle, {0.0, 0.6, 0.8}, 200000), 2.0,
         0.001);
}

// Both sides read the same keys: a light's place, orientation and size.
void lights_lie_where_the_renderer_has_them(void **)
{
    for (const char *kind : {"point", "rect", "disk"}) {
        scene::SceneLight own = light(kind, {0.7, 0.9, -1.4});
        for (int turned = 0; turned < 2; turned++) {
            own.facing = turned ? glm::dvec3(-1.0, -0.2, 0.6) : glm::dvec3(0.0);
            own.width = 0.03;
            own.height = 0.02;
            const draw::Light drawn = scene::own_light(own, glm::dvec3(0.0));
            const glm::dvec3 n(drawn.direction);
            const double value = irradiance(light_of(own), glm::dvec3(0.0), n, 2000);
            near(kind, value, double(drawn.irradiance.x), 0.002);
        }
    }
}

void surroundings_are_the_sum_of_their_parts(void **)
{
    for (const char *name : {"gradient", "window", "sunset"}) {
        scene::Scene scene;
        scene.environment = name;
        const Expected<scene::Globe> globe = scene::Globe::of(scene);
        assert_true(bool(globe));
        glm::dvec3 whole(0.0), bounded(0.0), rest(0.0);
        double sphere = 0.0, brightest = 0.0;
        const Sky sky(*globe);
        for (std::size_t i = 0; i < globe->count(); i++) {
            const glm::dvec3 d = globe->direction(i);
            assert_true(globe->find(3.0 * d) == i);
            assert_true(globe->find(globe->within(i, 0.01, 0.99)) == i);
            whole += globe->radiance(i) * globe->solid_angle(i);
            bounded += sky.radiance(d) * globe->solid_angle(i);
            brightest = std::max(brightest, sky.radiance(d).x);
            sphere += globe->solid_angle(i);
        }
        const int ways = 40000;
        for (int i = 0; i < ways; i++) {
            Random random(3, 0, std::uint64_t(i));
            const Way way = sky.way(random);
            rest += way.irradiance / double(ways);
            // It points to where there is more than the bounded part.
            assert_true(way.irradiance == glm::dvec3(0.0) ||
                        globe->radiance(globe->find(way.direction)).x >
                            sky.radiance(way.direction).x);
        }
        near("sphere", sphere, 4.0 * pi, 1e-9);
        for (int c = 0; c < 3; c++) {
            near(name, bounded[c] + rest[c], whole[c], 0.005);
        }
        assert_true(brightest < 6.0 * whole.x / (4.0 * pi) + 1e-9);
    }
}

// A picture with what is no radiance is refused, by the pixel.
void bad_surroundings_are_refused(void **)
{
    const std::string path =
        (std::filesystem::temp_directory_path() / "tsuya_bad_surroundings.exr").string();
    for (const float bad : {-0.5f, std::nanf("")}) {
        image::Image image = {4, 2, 3, std::vector<float>(4 * 2 * 3, 1.0f)};
        image.pixels[3 * 6 + 1] = bad;
        std::string error;
        assert_true(image::write_exr(path, image, error));
        scene::Scene scene;
        scene.environment = "file:" + path;
        const Expected<scene::Globe> globe = scene::Globe::of(scene);
        assert_false(bool(globe));
        assert_non_null(std::strstr(globe.error().c_str(), "pixel 2,1"));
    }
    std::filesystem::remove(path);
}

// What is behind a light does not take its light away.
void fibres_beyond_a_light_do_not_block_it(void **)
{
    Strands strands;
    strands.first = {0, 2};
    strands.points = {{-1.0f, 1.0f, 0.0f}, {1.0f, 1.0f, 0.0f}};
    strands.radius = {0.01f, 0.01f};
    strands.tangent = {{2.0f, 0.0f, 0.0f}, {2.0f, 0.0f, 0.0f}};
    strands.chance = {0.0};
    const Geometry geometry(strands, Surface(), 1);
    const glm::dvec3 up(0.0, 1.0, 0.0);
    assert_true(geometry.blocked(Start(), up));
    assert_true(geometry.blocked(Start(), up, 1.1));
    assert_false(geometry.blocked(Start(), up, 0.9));
}

// White hair in surroundings of radiance 1 cannot be seen, whichever part carries the light.
void white_furnace_by_surroundings(void **)
{
    const std::string path =
        (std::filesystem::temp_directory_path() / "tsuya_furnace_surroundings.exr").string();
    image::Image image = {64, 32, 3, std::vector<float>(64 * 32 * 3, 1.0f)};
    std::string error;
    assert_true(image::write_exr(path, image, error));
    const Expected<scene::Scene> scene = scene::override(
        scene::Scene(),
        {"groom=wavy", "strands=6000", "width_scale=4", "sigma_a=0,0,0", "light=none", "dome=0",
         "environment=file:" + path, "head=none", "background=1,1,1", "size=16x16"});
    if (!scene) {
        fail_msg("%s", scene.error().c_str());
    }
    const Expected<scene::Hair> hair = scene::hair(*scene);
    const Expected<scene::Material> material = scene::material(*scene);
    const draw::Frame frame = scene::frame(*scene, *hair, *material);
    const Expected<World> world = reference::world(*scene, *hair, *material, frame);
    assert_true(bool(world));
    Film film(16, 16);
    assert_true(render(Tracer(*world), camera(frame),
                       {64, 1, std::max(1u, std::thread::hardware_concurrency())}, film));
    const Summary summary = film.summary();
    near("furnace by surroundings", summary.mean, 1.0, 0.001);
    assert_true(summary.coverage > 0.2);
    std::filesystem::remove(path);
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(areas_give_their_closed_forms),
        cmocka_unit_test(lights_lie_where_the_renderer_has_them),
        cmocka_unit_test(surroundings_are_the_sum_of_their_parts),
        cmocka_unit_test(bad_surroundings_are_refused),
        cmocka_unit_test(fibres_beyond_a_light_do_not_block_it),
        cmocka_unit_test(white_furnace_by_surroundings),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}

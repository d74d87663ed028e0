// Lights of scenes: their keys, and pictures in which one kind of light must look like another.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "image/image.h"
#include "scene/build.h"
#include "scene/picture.h"
#include "scene/scene.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

extern "C" {
#include <cmocka.h>
}

namespace {

using namespace tsuya;

std::unique_ptr<scene::Studio> studio;

scene::Scene scene_of(const std::vector<std::string> &words)
{
    std::vector<std::string> all = {"size=96x96", "strands=1500", "width_scale=18", "light=none"};
    all.insert(all.end(), words.begin(), words.end());
    const groom::Expected<scene::Scene> scene = scene::override({}, all);
    if (!scene) {
        fail_msg("%s", scene.error().c_str());
    }
    return *scene;
}

// Luminance of the hair, or what is wrong.
groom::Expected<double> draw(const std::vector<std::string> &words)
{
    const scene::Scene scene = scene_of(words);
    const groom::Expected<scene::Hair> hair = scene::hair(scene);
    const groom::Expected<scene::Material> material = scene::material(scene);
    const groom::Expected<scene::Surroundings> around = scene::surroundings(scene);
    assert_true(bool(hair) && bool(material));
    if (!around) {
        return groom::Error{around.error()};
    }
    groom::Expected<bool> good = studio->take(*hair, *material);
    const draw::Frame frame = scene::frame(scene, *hair, *material, 0.0, false, *around);
    good = good ? studio->renderer().draw(frame) : good;
    if (!good) {
        return groom::Error{good.error()};
    }
    const draw::Picture picture = studio->renderer().picture();
    for (float value : picture.pixels) {
        assert_true(std::isfinite(value) && value >= 0.0f);
    }
    return scene::numbers(picture).hair;
}

double drawn(std::vector<std::string> words, const char *model)
{
    words.push_back(std::string("model=") + model);
    const groom::Expected<double> hair = draw(words);
    if (!hair) {
        fail_msg("%s", hair.error().c_str());
    }
    return *hair;
}

void refuse(const char *word, const char *key, const char *range)
{
    const groom::Expected<scene::Scene> scene = scene::override({}, {word});
    assert_false(bool(scene));
    if (scene.error().find(key) == std::string::npos ||
        scene.error().find(range) == std::string::npos) {
        fail_msg("\"%s\" does not name %s and %s", scene.error().c_str(), key, range);
    }
}

void keys(void **)
{
    refuse("light0.kind=sphere", "light0.kind", "disk");
    refuse("light0.width=0", "light0.width", "[1e-05, 1000000]");
    refuse("light0.angle_deg=40", "light0.angle_deg", "[0, 34]");
    refuse("light0.position=1,2", "light0.position", "three numbers");
    refuse("light0.sides=3", "light0.sides", "[1, 2]");
    refuse("environment=moon", "environment", "sunset");
    const scene::Scene scene =
        scene_of({"light2.kind=rect", "light2.position=1,2,3", "light2.width=0.25",
                  "light2.height=2", "light2.facing=0,-1,0", "light2.sides=2",
                  "light3.angle_deg=5", "environment=sunset", "environment.intensity=2"});
    const std::string written = scene::write(scene);
    const groom::Expected<scene::Scene> again = scene::parse(written, "again");
    assert_true(bool(again) && *again == scene);
    assert_string_equal(written.c_str(), scene::write(*again).c_str());
}

// Far lights with a place are directions; a far sun with a small angle is one, too.
void far_lights_are_directions(void **)
{
    const std::vector<std::string> dark = {"dome=0", "light0.direction=300,200,400"};
    for (const char *model : {"marschner", "kajiya_kay", "dual_scattering"}) {
        const double truth = drawn(dark, model);
        const double square = 300.0 * 300.0 + 200.0 * 200.0 + 400.0 * 400.0;
        // Scale is at the most 1e4: a disk of 60 metres, whose radiance makes irradiance 3.
        const std::string radiance = std::to_string(3.0 * square / (3.14159265 * 30.0 * 30.0));
        const double disk =
            drawn({"dome=0", "light0.kind=disk", "light0.position=300,200,400", "light0.width=60",
                   "light0.intensity=" + radiance}, model);
        const double sun = drawn({"dome=0", "light0.direction=300,200,400",
                                  "light0.angle_deg=0.5"}, model);
        print_message("%s: direction %.5f, disk %.5f, sun %.5f\n", model, truth, disk, sun);
        assert_true(truth > 0.0);
        assert_true(std::fabs(disk / truth - 1.0) < 0.05);
        assert_true(std::fabs(sun / truth - 1.0) < 0.02);
    }
}

void uniform_surroundings_are_the_dome(void **)
{
    image::Image even;
    even.width = 64;
    even.height = 32;
    even.channels = 3;
    even.pixels.assign(64 * 32 * 3, 0.8f);
    std::string error;
    assert_true(image::write_exr("light_even.exr", even, error));
    for (const char *model : {"marschner", "kajiya_kay", "dual_scattering"}) {
        const double dome = drawn({"dome=0.8", "dome.samples=128"}, model);
        const double around = drawn({"dome=0", "environment=file:light_even.exr"}, model);
        const double both = drawn({"dome=0.4", "environment=file:light_even.exr",
                                   "environment.intensity=0.5"}, model);
        print_message("%s: dome %.5f, surroundings %.5f\n", model, dome, around);
        assert_true(std::fabs(around / dome - 1.0) < 0.06);
        assert_true(std::fabs(both / around - 1.0) < 1e-3);
    }
    std::remove("light_even.exr");
}

void presets_and_refusals(void **)
{
    for (const char *name : {"gradient", "sunset", "window"}) {
        const double hair = drawn({"dome=0", std::string("environment=") + name}, "marschner");
        assert_true(hair > 0.01 && hair < 2.0);
    }
    const groom::Expected<double> absent = draw({"environment=file:no-such.exr"});
    assert_false(bool(absent));
    std::vector<std::string> many;
    for (int i = 0; i < 9; i++) {
        many.push_back("light" + std::to_string(i) + ".intensity=1");
    }
    many.push_back("light8.kind=point");
    const groom::Expected<double> late = draw(many);
    assert_false(bool(late));
    assert_true(late.error().find("first 8") != std::string::npos);
}

} // namespace

int main()
{
    groom::Expected<std::unique_ptr<scene::Studio>> opened = scene::Studio::create();
    if (!opened) {
        std::fprintf(stderr, "%s\n", opened.error().c_str());
        return 1;
    }
    studio = std::move(*opened);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys),
        cmocka_unit_test(far_lights_are_directions),
        cmocka_unit_test(uniform_surroundings_are_the_dome),
        cmocka_unit_test(presets_and_refusals),
    };
    const int failed = cmocka_run_group_tests_name("scenes", tests, nullptr, nullptr);
    studio.reset();
    return failed;
}

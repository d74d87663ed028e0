// Scene files, and the numbers that pictures have to keep.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "draw/grid.h"
#include "scene/build.h"
#include "scene/gallery.h"
#include "scene/picture.h"
#include "scene/tiers.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

extern "C" {
#include <cmocka.h>
}

namespace {

using namespace tsuya;

std::unique_ptr<scene::Studio> studio;

// One Rec. 709 luminance off by this share fails.
constexpr double one_percent = 0.01;

void refuse(const std::string &text, const std::vector<std::string> &words)
{
    const groom::Expected<scene::Scene> scene = scene::parse(text, "test.scene");
    if (scene) {
        fail_msg("accepted: %s", text.c_str());
    }
    for (const std::string &word : words) {
        if (scene.error().find(word) == std::string::npos) {
            fail_msg("\"%s\" does not name %s", scene.error().c_str(), word.c_str());
        }
    }
}

void refuses_bad_scenes(void **)
{
    refuse("hair", {"test.scene", "line 1", "key=value"});
    refuse("\n# fine\nhat=1", {"line 3", "hat"});
    refuse("=1", {"line 1"});
    refuse("dome=1\ndome=1", {"line 2", "dome", "twice"});
    refuse("light1.sides=1.5", {"line 1", "light1.sides", "whole"});
    refuse("dome=nan", {"dome", "not finite", "[0, 10000]"});
    refuse("dome=inf", {"dome", "not finite"});
    refuse("dome=1e999", {"dome"});
    refuse("dome=-1", {"dome", "-1", "[0, 10000]"});
    refuse("dome=1,5", {"dome", "not a number"});
    refuse("dome=", {"dome", "not a number"});
    refuse("dome=0x10", {"dome", "not a number"});
    refuse("supersample=1.5", {"supersample", "1.5", "whole"});
    refuse("supersample=9", {"supersample", "[1, 8]"});
    refuse("strands=99", {"strands", "[100, 100000]"});
    refuse("strands=1000000", {"strands", "[100, 100000]"});
    refuse("points=8.5", {"points", "whole"});
    refuse("length=-0.1", {"length", "[0.02, 1]"});
    refuse("size=640", {"size", "WxH"});
    refuse("size=0x640", {"size", "[1, 8192]"});
    refuse("size=640x9000", {"size", "[1, 8192]"});
    refuse("size=640x640x2", {"size"});
    refuse("model=phong", {"model", "phong", "marschner"});
    refuse("color=teal", {"color", "teal", "brown"});
    refuse("sigma_a=1,2", {"sigma_a", "three numbers"});
    refuse("sigma_a=1,2,3,4", {"sigma_a"});
    refuse("sigma_a=1,2,-3", {"sigma_a", "-3"});
    refuse("albedo=0.5,0.5,1.5", {"albedo", "1.5", "[0, 1]"});
    refuse("head_albedo=0.5,-0.1,0.5", {"head_albedo", "-0.1", "[0, 1]"});
    refuse("head_albedo=0.5", {"head_albedo", "three numbers"});
    refuse("head_albedo=0.5,0.5,0.5\nalbedo=0.5,0.5,0.5", {"line 2", "head_albedo", "albedo"});
    refuse("color=brown\nsigma_a=1,1,1", {"line 2", "color", "sigma_a"});
    refuse("eumelanin=1\nalbedo=0.5,0.5,0.5", {"eumelanin", "albedo"});
    refuse("eta=3", {"eta", "[1.2, 2]"});
    refuse("beta_R_deg=1", {"beta_R_deg", "[2, 30]"});
    refuse("beta_R=0.1", {"beta_R", "no key"});
    refuse("light=sun", {"light", "sun", "back"});
    refuse("light0.direction=0,0,0", {"light0.direction", "not all 0"});
    refuse("light32.intensity=1", {"light32.intensity", "no key"});
    refuse("light01.intensity=1", {"light01.intensity", "no key"});
    refuse("camera.fov_deg=0", {"camera.fov_deg", "[1, 120]"});
    refuse("camera.elevation_deg=90", {"camera.elevation_deg", "[-89, 89]"});
    refuse("groom=file:", {"groom", "file:PATH"});
    refuse("groom=bald", {"groom", "bald"});
    refuse("width_scale=0", {"width_scale"});
    refuse("background=1,2,nan", {"background", "not finite"});
    refuse("shadow=soft", {"shadow", "grid"});
    refuse("tier=fast", {"line 1", "tier", "fast", "plane_parallel", "leaf_body_uniform"});
    refuse("tier=", {"tier", "exact"});
    refuse("tier=zinke\nmodel=marschner", {"line 2", "tier=zinke", "model=dual_scattering"});
    refuse("model=dual_scattering\n\ntier=exact", {"line 3", "model and tier", "keep one"});
    refuse("variant=plain\ntier=exact", {"line 2", "variant and tier"});
    refuse("tier=unshadowed\nshadow=grid", {"line 2", "shadow and tier", "shadow=none"});
    refuse("tier=exact\ntier=zinke", {"line 2", "tier", "twice"});
    refuse("tier=leaf", {"tier=leaf", "kind is hair", "unshadowed"});
    refuse("tier=zinke\nkind=tree", {"tier=zinke", "kind is tree", "leaf_body_uniform"});
    refuse("kind=leaf\nleaf.texels=64\ntier=leaf_uniform", {"leaf.texels and tier"});
    assert_false(bool(scene::override({}, {"dome=1", "dome=2"})));
    assert_false(bool(scene::read("/no/such/file.scene")));
    assert_false(bool(scene::find("no-such-scene")));
}

void reads_what_it_writes(void **)
{
    const std::string text = "\xef\xbb\xbf# a scene\r\n groom = curly # style\r\nseed=4294967295\n"
                             "length=0.123456789012345\nmodel=kajiya_kay\nbeta_az_deg=7.3\n"
                             "alpha_R_deg=-3.1\neumelanin=0\npheomelanin=0.3\nlight=none\n"
                             "light3.direction=1,-2,3e-3\nlight31.intensity=0.1\nsize=17x900\n"
                             "camera.target=0,0,0\nturn_deg=-12.5\ntitle=a b = c";
    const groom::Expected<scene::Scene> first = scene::parse(text, "a");
    if (!first) {
        fail_msg("%s", first.error().c_str());
    }
    assert_int_equal(first->lights.size(), 2);
    assert_true(first->camera_aims);
    assert_int_equal(first->height, 900);
    const std::string written = scene::write(*first);
    const groom::Expected<scene::Scene> second = scene::parse(written, "b");
    assert_true(bool(second));
    assert_true(*first == *second);
    assert_true(first->parameters == second->parameters && first->hair == second->hair);
    assert_string_equal(written.c_str(), scene::write(*second).c_str());
    assert_string_equal(scene::write({}).c_str(), "");
    assert_true(scene::material(*first)->sigma_a.x > 0.0);

    const groom::Expected<scene::Scene> dyed = scene::override(*first, {"color=red"});
    assert_true(bool(dyed) && dyed->color_by == scene::ColorBy::preset);
    assert_false(bool(scene::material(*scene::override({}, {"albedo=0.01,0.5,0.5"}))));
}

// A tier is the keys that it stands for, in any order, over any other.
void tiers_are_keys(void **)
{
    const std::map<std::string, std::string> keys = {
        {"unshadowed", "model=kajiya_kay shadow=none"},
        {"kajiya_kay", "model=kajiya_kay shadow=deep_opacity"},
        {"marschner", "shadow=deep_opacity"},
        {"zinke", "model=dual_scattering variant=zinke shadow=deep_opacity"},
        {"exact", "model=dual_scattering shadow=deep_opacity"},
        {"plane_parallel", "model=plane_parallel_hair shadow=deep_opacity"},
        {"leaf_coarse", "kind=leaf model=leaf_coarse"},
        {"leaf_body", "kind=leaf model=leaf_body"},
        {"leaf", "kind=leaf model=leaf"},
        {"leaf_body_uniform", "kind=leaf leaf.texels=0 tree.variation=0 model=leaf_body"},
        {"leaf_uniform", "kind=leaf leaf.texels=0 tree.variation=0 model=leaf"},
    };
    assert_int_equal(keys.size(), scene::tiers().size());
    for (const scene::Tier &tier : scene::tiers()) {
        const std::string kind = tier.leaf ? "kind=leaf" : "kind=hair";
        const auto first = scene::parse("tier=" + tier.name + "\n" + kind, "a");
        const auto before = scene::override(
            {}, {"model=marschner", "variant=zinke", "shadow=opacity_shadow", kind});
        assert_true(bool(first) && bool(before));
        std::string written = scene::write(*first);
        std::replace(written.begin(), written.end(), '\n', ' ');
        assert_string_equal(written.c_str(), (keys.at(tier.name) + " ").c_str());
        assert_true(*scene::parse(scene::write(*first), "b") == *first);
        scene::Scene over = *scene::override(*before, {"tier=" + tier.name});
        over.shadow = tier.leaf ? first->shadow : over.shadow; // leaves do not read it
        assert_true(over == *first);
        assert_true(scene::grammar().find(tier.name) != std::string::npos);
        assert_true(tier.leaf || bool(scene::material(*first)));
    }
}

void gallery_scenes_parse(void **)
{
    const groom::Expected<std::vector<scene::Named>> all = scene::gallery();
    assert_true(bool(all) && all->size() >= 8);
    for (const scene::Named &named : *all) {
        assert_false(named.scene.title.empty());
        assert_true(bool(scene::material(named.scene)));
    }
}

struct Drawn {
    scene::Numbers numbers;
    double reached = 0.0; // share of the strands
};

Drawn drawn(const std::vector<std::string> &words, bool count = false)
{
    std::vector<std::string> all = {"size=128x128", "strands=2000", "width_scale=15"};
    all.insert(all.end(), words.begin(), words.end());
    const groom::Expected<scene::Scene> scene = scene::override({}, all);
    assert_true(bool(scene));
    const groom::Expected<scene::Hair> hair = scene::hair(*scene);
    const groom::Expected<scene::Material> material = scene::material(*scene);
    assert_true(bool(hair) && bool(material));
    groom::Expected<bool> good = studio->take(*hair, *material);
    const draw::Frame frame = scene::frame(*scene, *hair, *material);
    good = good ? studio->renderer().draw(frame) : good;
    if (!good) {
        fail_msg("%s", good.error().c_str());
    }
    Drawn result;
    const draw::Picture picture = studio->renderer().picture();
    for (float value : picture.pixels) {
        assert_true(std::isfinite(value) && value >= 0.0f);
    }
    result.numbers = scene::numbers(picture);
    if (count) {
        result.reached = double(studio->renderer().reached(frame)) / double(hair->groom.strands());
    }
    return result;
}

void keeps_energy_when_supersampled(void **)
{
    double worst = 0.0;
    for (const char *style : {"groom=straight", "groom=curly"}) {
        // From locks to fibres far below a pixel: 0.7, 0.2 and 0.05 pixels.
        for (const char *width : {"fiber_width=8e-5", "fiber_width=2.1e-5", "fiber_width=5e-6"}) {
            const auto mean = [&](const char *samples) {
                return drawn({style, width, samples, "head=none", "background=0,0,0"}).numbers.mean;
            };
            const double off = mean("supersample=1") / mean("supersample=4") - 1.0;
            std::printf("%s %s: 1x against 4x4 %+.3f %%\n", style, width, 100.0 * off);
            worst = std::max(worst, std::abs(off));
        }
    }
    assert_true(worst <= 2.0 * one_percent);
}

void keeps_energy_when_models_change(void **)
{
    double worst = 0.0;
    for (const char *style : {"groom=straight", "groom=wavy", "groom=curly"}) {
        for (const char *color : {"color=black", "color=brown", "color=blond"}) {
            const scene::Numbers a = drawn({style, color}).numbers;
            const scene::Numbers b = drawn({style, color, "model=kajiya_kay"}).numbers;
            std::printf("%s %s: kajiya_kay against marschner, hair %+.2f %%, frame %+.2f %%\n",
                        style, color, 100.0 * (b.hair / a.hair - 1.0),
                        100.0 * (b.mean / a.mean - 1.0));
            worst = std::max(worst, std::abs(b.hair / a.hair - 1.0));
            worst = std::max(worst, std::abs(b.mean / a.mean - 1.0));
        }
    }
    assert_true(worst <= 5.0 * one_percent);
}

void strands_reach_the_picture(void **)
{
    const Drawn result = drawn({"head=none"}, true);
    std::printf("strands that reach the picture: %.2f %%\n", 100.0 * result.reached);
    assert_true(result.reached >= 0.95);
}

// One straight strand in an orthographic picture; its coverage must add up to width times length.
void strand_has_its_area(void **)
{
    constexpr int size = 96;
    constexpr double length = 60.0;
    const groom::Expected<scene::Material> material = scene::material({});
    double worst = 0.0;
    for (double width : {0.02, 0.3, 0.9, 1.0, 1.7, 5.0}) {
        for (double angle : {0.0, 3.0, 22.5, 45.0, 71.0, 90.0, 200.0}) {
            for (double shift : {0.0, 0.25, 0.5, 0.83}) {
                const double a = angle * 3.14159265358979 / 180.0;
                const glm::dvec3 along(std::cos(a), std::sin(a), 0.0);
                const glm::dvec3 middle(shift, 0.37 * shift, 0.0);
                scene::Hair hair;
                for (int i = 0; i < 9; i++) {
                    hair.groom.points.push_back(
                        glm::vec3(middle + along * (length * (double(i) / 8.0 - 0.5))));
                }
                hair.groom.first = {0, 9};
                hair.groom.seed = {0.5f};
                hair.groom.constant_radius = float(width / 2.0);
                assert_true(bool(studio->take(hair, *material)));
                draw::Frame frame;
                frame.width = frame.height = size;
                frame.taper = 0.0f;
                frame.shadow = draw::Shadow::none;
                // One world unit is one pixel.
                frame.projection = glm::ortho(-48.0f, 48.0f, -48.0f, 48.0f, 0.1f, 100.0f);
                frame.view = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -50.0f));
                frame.eye = glm::vec3(0.0f, 0.0f, 50.0f);
                assert_true(bool(studio->renderer().draw(frame)));
                const double area = scene::numbers(studio->renderer().picture()).coverage * size *
                                    size;
                const double off = area / (width * length) - 1.0;
                worst = std::max(worst, std::abs(off));
                if (std::abs(off) > 2.0 * one_percent) {
                    fail_msg("width %g, angle %g, shift %g: area off by %+.2f %%", width, angle,
                             shift, 100.0 * off);
                }
            }
        }
    }
    std::printf("a strand's area: off by at most %.3f %%\n", 100.0 * worst);
}

// Sheets of strands on both sides of a ball: the light's way ends in it.
void grid_ends_at_the_head(void **)
{
    constexpr int sheets = 10, across = 1000;
    groom::Groom hair;
    hair.first = {0};
    hair.constant_radius = 0.0001f;
    for (int sheet = -sheets; sheet <= sheets; sheet++) {
        const float z = 0.01f * (float(sheet) + (sheet > 0 ? 9.5f : -9.5f));
        for (int i = 0; i < across && sheet != 0; i++) {
            const float x = 0.4f * ((float(i) + 0.5f) / across - 0.5f);
            hair.points.insert(hair.points.end(), {{x, -0.2f, z}, {x, 0.2f, z}});
            hair.first.push_back(std::uint32_t(hair.points.size()));
        }
    }
    draw::Grid grid;
    grid.fill(hair, {glm::vec3(0.0f), glm::vec3(0.08f)}, false, 1.0f);
    const glm::vec3 light(0.0f, 0.0f, 1.0f);
    const std::vector<float> front = grid.sweep(light), behind = grid.beyond(light);
    const auto at = [&](const std::vector<float> &values, float x, float z) {
        const glm::ivec3 c((glm::vec3(x, 0.0f, z) - grid.corner()) / grid.cell());
        return double(values[(std::size_t(c.z) * std::size_t(grid.size().y) + std::size_t(c.y)) *
                                 std::size_t(grid.size().x) +
                             std::size_t(c.x)]);
    };
    // A sheet is 0.0002 / 0.0004 fibres.
    const double each = 0.5;
    for (float z : {0.0995f, 0.1501f, 0.1999f}) {
        const double here = std::round((z - 0.1f) / 0.01f) + 0.0;
        std::printf("grid: at %.3f behind %.2f before the ball, %.2f beside it, front %.2f\n",
                    double(z), at(behind, 0.0f, z), at(behind, 0.15f, z), at(front, 0.0f, z));
        assert_true(std::abs(at(behind, 0.0f, z) - each * here) < 0.7 * each);
        assert_true(std::abs(at(behind, 0.15f, z) - each * (here + sheets)) < 0.7 * each);
        assert_true(std::abs(at(front, 0.0f, z) - each * (sheets - here)) < 0.7 * each);
    }
    grid.fill(hair, {glm::vec3(0.0f), glm::vec3(0.08f)}, true, 1.0f);
    assert_true(at(grid.beyond(light), 0.0f, 0.1501f) > 100.0);
}

// Light that reaches the head is lost to white hair, whether hair is counted in the grid or in
// maps.
void head_takes_light(void **)
{
    const std::vector<std::string> words = {"groom=straight", "color=white", "dome=0",
                                            "background=0,0,0", "model=plane_parallel_hair"};
    const auto hair = [&](const char *shadow, const char *variant) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {shadow, variant});
        return drawn(all).numbers.hair;
    };
    const double grid = hair("shadow=grid", "variant=finite");
    const double maps = hair("shadow=deep_opacity", "variant=finite");
    const double thick = hair("shadow=grid", "variant=plain");
    std::printf("white hair on a head: grid %.4f, maps %.4f; on thick hair %.4f\n", grid, maps,
                thick);
    assert_true(std::abs(maps / grid - 1.0) < 0.08);
    assert_true(grid < 0.9 * thick);
}

} // namespace

int main()
{
    groom::Expected<std::unique_ptr<scene::Studio>> made = scene::Studio::create();
    if (!made) {
        std::fprintf(stderr, "draw_test: %s\n", made.error().c_str());
        return 1;
    }
    studio = std::move(*made);
    const CMUnitTest tests[] = {
        cmocka_unit_test(refuses_bad_scenes),
        cmocka_unit_test(reads_what_it_writes),
        cmocka_unit_test(tiers_are_keys),
        cmocka_unit_test(gallery_scenes_parse),
        cmocka_unit_test(strand_has_its_area),
        cmocka_unit_test(strands_reach_the_picture),
        cmocka_unit_test(keeps_energy_when_supersampled),
        cmocka_unit_test(keeps_energy_when_models_change),
        cmocka_unit_test(grid_ends_at_the_head),
        cmocka_unit_test(head_takes_light),
    };
    const int failed = cmocka_run_group_tests_name("draw", tests, nullptr, nullptr);
    studio.reset();
    return failed;
}

// Maps of a leaf's mesh from files: what is drawn under them against the reference and against
// leaves that are bent in truth; where and how they lie; what is refused.
#include "leaf_files.h"
#include "leaf_rig.h"

#include "image/image.h"
#include "scene/leaf_maps.h"

#include <functional>

using namespace leaf_rig;

namespace
{

using Words = std::vector<std::string>;
using Texel = std::function<glm::dvec3(int x, int y)>;

std::filesystem::path folder;

std::string file(const std::string &name)
{
    return (folder / name).string();
}

// A picture of `channels` channels. In a PNG, value 0 to 1 becomes levels 0 to 65535 or 255.
std::string picture(const std::string &name, int width, int height, int channels,
                    const Texel &texel, image::Depth depth = image::Depth::sixteen,
                    float alpha = 1.0f)
{
    image::Image out{width, height, channels, {}};
    const bool png = name.back() == 'g';
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const glm::dvec3 value = texel(x, y);
            for (int c = 0; c < channels; c++) {
                const bool is_alpha = channels % 2 == 0 && c == channels - 1;
                const float v = is_alpha ? alpha : float(value[c % 3]);
                out.pixels.push_back(png && !is_alpha ? image::srgb_decode(v) : v);
            }
        }
    }
    std::string error;
    const std::string path = file(name);
    if (!(png ? image::write_png(path, out, error, depth) : image::write_exr(path, out, error))) {
        fail_msg("%s", error.c_str());
    }
    return path;
}

std::string even(const std::string &name, double value)
{
    return picture(name, 4, 4, 1, [=](int, int) { return glm::dvec3(value); });
}

std::string even(const std::string &name, const glm::dvec3 &value)
{
    return picture(name, 4, 4, 3, [=](int, int) { return value; });
}

std::string mesh_file(const Mesh &mesh, bool uvs = true)
{
    const std::string path = file("leaf.obj");
    std::ofstream(path, std::ios::binary) << leaf_files::make_obj(mesh, uvs);
    return path;
}

Words words(Words more)
{
    more.insert(more.begin(), {"kind=leaf", "model=leaf_body", "mesh=" + file("leaf.obj")});
    return more;
}

scene::Surface surface(const Words &more)
{
    const auto scene = scene::override({}, words(more));
    if (!scene) {
        fail_msg("%s", scene.error().c_str());
    }
    auto surface = scene::surface(*scene);
    if (!surface) {
        fail_msg("%s", surface.error().c_str());
    }
    return std::move(*surface);
}

Maps maps(const Words &more)
{
    return surface(more).plant.maps;
}

// The quad, turned about y and then x by radians.
Mesh tilted(double about_y, double about_x)
{
    Mesh mesh = quad();
    glm::mat4 turn = glm::rotate(glm::mat4(1.0f), float(about_x), glm::vec3(1.0f, 0.0f, 0.0f));
    turn = glm::rotate(turn, float(about_y), glm::vec3(0.0f, 1.0f, 0.0f));
    for (std::size_t i = 0; i < 4; i++) {
        mesh.positions[i] = glm::mat3(turn) * mesh.positions[i];
        mesh.normals[i] = glm::mat3(turn) * mesh.normals[i];
    }
    make_tangents(mesh);
    return mesh;
}

double seen(const Plant &plant, const glm::dvec3 &view, const glm::dvec3 &light)
{
    take(plant, tsu_leaf(), {});
    draw::SurfaceFrame f = frame(view);
    f.shadow_size = 0;
    f.lights = {sun(light, 1.0)};
    return mean(drawn(f), 1);
}

// The same factor by way of every kind of file, against the reference with that factor.
void even_factors_scale_the_leaf(void **)
{
    mesh_file(quad());
    double worst = 0.0, apart = 0.0;
    for (const double pigment : {0.0, 0.5, 1.0, 1.8}) {
        for (const double thickness : {0.6, 1.0, 1.7}) {
            const double level = std::log(2.0 * thickness) / std::log(4.0);
            const Words ways[] = {
                {"mesh.pigment_map=" + even("p.exr", pigment),
                 "mesh.thickness_map=" + even("t.exr", thickness)},
                {"mesh.pigment_map=" + even("p.png", 0.5 * pigment),
                 "mesh.thickness_map=" + even("t.png", level)},
                {"mesh.pigment_map=" + even("c.png", glm::dvec3(0.5 * pigment)),
                 "mesh.thickness_map=" + even("t.png", level)},
            };
            double first = 0.0;
            for (const Words &way : ways) {
                Row row;
                take(surface(way).plant, tsu_leaf_body(), row);
                draw::SurfaceFrame f = frame({0.0, 0.0, -1.0});
                f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
                const double through = mean(drawn(f), 1);
                row.through = true;
                row.absorption = pigment;
                row.thickness = thickness;
                const double off = through / row.reference(tsu_leaf_body()) - 1.0;
                worst = std::max(worst, std::fabs(off));
                first = first == 0.0 ? through : first;
                apart = std::max(apart, std::fabs(through / first - 1.0));
            }
        }
    }
    std::printf("even maps against the reference: %.2f %%; PNG against EXR: %.3f %%\n",
                100.0 * worst, 100.0 * apart);
    assert_true(worst < 0.03 && apart < 1e-3);
    // Levels of 8 bits count as they are: 51 of 255 is 0.2.
    const auto eight = [](int, int) { return glm::dvec3(0.2); };
    const std::string path = picture("e.png", 2, 2, 1, eight, image::Depth::eight);
    assert_true(std::fabs(maps({"mesh.pigment_map=" + path}).pigment[0] - 0.4f) < 1e-6f);
    const Maps thick = maps({"mesh.thickness_map=" + path});
    assert_true(std::fabs(thick.thickness[3] - float(0.5 * std::pow(4.0, 0.2))) < 1e-6f);
    assert_true(thick.pigment[3] == 1.0f && thick.slope[7] == 0.0f);
}

// A normal map that leans everywhere alike against the quad that leans as much, from both sides.
void tilted_normals_shade_as_a_tilted_leaf(void **)
{
    mesh_file(quad());
    double worst = 0.0;
    for (const double a : {-0.5, 0.3}) {
        for (const double b : {-0.2, 0.4}) {
            const Mesh leaning = tilted(a, b);
            const glm::dvec3 n = glm::normalize(glm::dvec3(leaning.normals[0]));
            const glm::dvec3 down(n.x, -n.y, n.z);
            const Words ways[] = {
                {"mesh.normal_map=" + even("n.exr", n)},
                {"mesh.normal_map=" + even("n.png", 0.5 * n + 0.5)},
                {"mesh.normal_map=" + even("d.png", 0.5 * down + 0.5), "mesh.normal_green=down"},
                // Not of length 1, as after filtering.
                {"mesh.normal_map=" + even("s.exr", 0.8 * n)},
            };
            for (const double side : {1.0, -1.0}) {
                const glm::dvec3 view(0.1, -0.2, side), light(-0.4, 0.3, 1.0);
                const double truth = seen(single(leaning), view, light);
                const double flat = seen(single(quad()), view, light);
                assert_true(std::fabs(flat / truth - 1.0) > 0.02);
                for (const Words &way : ways) {
                    const double off = seen(surface(way).plant, view, light) / truth - 1.0;
                    worst = std::max(worst, std::fabs(off));
                }
            }
        }
    }
    std::printf("a leaf leant by its normal map against one that leans: %.3f %%\n", 100.0 * worst);
    assert_true(worst < 2e-3);
}

// The same map on a leaf whose uv run otherwise leans the other way: mirrored and turned frames.
void frames_follow_the_uv(void **)
{
    const double a = 0.4;
    const std::string path = even("n.exr", glm::dvec3(std::sin(a), 0.0, std::cos(a)));
    const glm::dvec3 view(0.0, 0.0, 1.0), light(-0.5, 0.3, 1.0);
    const auto drawn_with = [&](const std::function<glm::vec2(glm::vec2)> &to) {
        Mesh mesh = quad();
        for (glm::vec2 &uv : mesh.uvs) {
            uv = to(uv);
        }
        mesh_file(mesh);
        return seen(surface({"mesh.normal_map=" + path}).plant, view, light);
    };
    const auto near = [](double x, double y) { return std::fabs(x / y - 1.0) < 2e-3; };
    const double right = seen(single(tilted(a, 0.0)), view, light);
    const double left = seen(single(tilted(-a, 0.0)), view, light);
    const double up = seen(single(tilted(0.0, -a)), view, light);
    assert_false(near(right, left) || near(left, up) || near(right, up));
    assert_true(near(drawn_with([](glm::vec2 uv) { return uv; }), right));
    assert_true(near(drawn_with([](glm::vec2 uv) { return glm::vec2(1.0f - uv.x, uv.y); }), left));
    assert_true(near(drawn_with([](glm::vec2 uv) { return glm::vec2(uv.x, 1.0f - uv.y); }), right));
    assert_true(near(drawn_with([](glm::vec2 uv) { return glm::vec2(uv.y, 1.0f - uv.x); }), up));
    // A uv without area, and one that goes back on itself: something finite, which drawn() checks.
    assert_true(drawn_with([](glm::vec2) { return glm::vec2(0.3f); }) > 0.0);
    assert_true(drawn_with([](glm::vec2 uv) { return glm::vec2(uv.x, 0.0f); }) > 0.0);
    assert_true(drawn_with([](glm::vec2 uv) { return 1e-30f * uv; }) > 0.0);
    // Tangents that are gone, as between vertices whose tangents cancel: the mesh's own normal.
    mesh_file(quad());
    Plant plant = surface({"mesh.normal_map=" + path}).plant;
    for (glm::vec4 &t : plant.kinds[0].blade.tangents) {
        t = glm::vec4(0.0f, 0.0f, 1.0f, 1.0f);
    }
    assert_true(near(seen(plant, view, light), seen(single(quad()), view, light)));
}

// A ramp of known rise over a quad of known size; and over one whose u is stretched.
void heights_lean_by_their_slope(void **)
{
    // 2 cm wide; 5 mm over it is a slope of 1 in 4. uv (0, 0) to (0.5, 1) see half the ramp.
    const Words common = {"unit_scale=0.01", "mesh.height_mm=5"};
    for (const double part : {1.0, 0.5}) {
        Mesh mesh = quad();
        for (glm::vec2 &uv : mesh.uvs) {
            uv.x *= float(part);
        }
        mesh_file(mesh);
        const auto ramp = [](int x, int) { return glm::dvec3((x + 0.5) / 64.0); };
        const auto rise = [](int, int y) { return glm::dvec3(1.0 - (y + 0.5) / 32.0); };
        for (const char *name : {"h.png", "h.exr"}) {
            Words more = common;
            more.push_back("mesh.height_map=" + picture(name, 64, 1, 1, ramp));
            Maps got = maps(more);
            for (std::size_t i = 0; i < 64; i++) {
                assert_true(std::fabs(got.slope[2 * i] - float(0.25 * part)) < 1e-3f);
                assert_true(got.slope[2 * i + 1] == 0.0f);
            }
            more = common;
            more.push_back("mesh.height_map=" + picture(name, 1, 32, 1, rise));
            got = maps(more);
            assert_true(got.width == 1 && got.height == 32);
            for (std::size_t i = 0; i < 32; i++) {
                assert_true(got.slope[2 * i] == 0.0f);
                assert_true(std::fabs(got.slope[2 * i + 1] - 0.25f) < 1e-3f);
            }
        }
    }
    mesh_file(quad());
    const auto ramp = [](int x, int) { return glm::dvec3(x / 64.0); };
    Words more = common;
    more.push_back("mesh.height_map=" + picture("h.exr", 64, 2, 1, ramp));
    Plant plant = surface(more).plant;
    for (glm::vec3 &p : plant.kinds[0].blade.positions) {
        p *= 100.0f;
    }
    // Higher on the right: the normal leans to the left.
    const glm::dvec3 view(0.0, 0.0, 1.0), light(-0.6, 0.2, 1.0);
    const double truth = seen(single(tilted(-std::atan(0.25), 0.0)), view, light);
    assert_true(std::fabs(seen(plant, view, light) / truth - 1.0) < 2e-3);
}

void maps_lie_where_the_uv_say(void **)
{
    // Little pigment in the picture's upper left corner.
    const auto corner = [](int x, int y) { return glm::dvec3(x == 0 && y == 0 ? 0.2 : 1.8); };
    const std::string path = picture("c.exr", 2, 2, 1, corner);
    mesh_file(quad());
    const scene::Surface once = surface({"mesh.pigment_map=" + path});
    const Maps &got = once.plant.maps;
    assert_true(got.width == 2 && got.height == 2 && !got.repeat);
    assert_true(got.pigment == std::vector<float>({1.8f, 1.8f, 0.2f, 1.8f}));
    draw::SurfaceFrame f = frame({0.0, 0.0, 1.0}, 1.0f);
    f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
    const auto bright = [](const draw::Picture &picture, int x, int y) {
        return picture.pixels[std::size_t(4 * (y * picture.width + x) + 1)];
    };
    take(once.plant, tsu_leaf_body(), {});
    draw::Picture picture = drawn(f);
    const float dark = bright(picture, 55, 55);
    assert_true(bright(picture, 8, 8) > 1.5f * dark);
    assert_true(bright(picture, 55, 8) == dark && bright(picture, 8, 55) == dark);

    // Beyond 1 the picture repeats, four times here.
    Mesh mesh = quad();
    for (glm::vec2 &uv : mesh.uvs) {
        uv = 2.0f * uv - glm::vec2(1.0f);
    }
    mesh_file(mesh);
    const scene::Surface twice = surface({"mesh.pigment_map=" + path});
    assert_true(twice.plant.maps.repeat);
    take(twice.plant, tsu_leaf_body(), {});
    picture = drawn(f);
    for (const int x : {8, 40}) {
        for (const int y : {8, 40}) {
            assert_true(bright(picture, x, y) > 1.5f * bright(picture, x + 16, y));
            assert_true(std::fabs(bright(picture, x, y) / bright(picture, 8, 8) - 1.0f) < 1e-3f);
        }
    }
}

// 2 x 3, 4 x 1 and 4 x 4 texels meet at 4 x 4.
void sizes_meet(void **)
{
    mesh_file(quad());
    const Maps got =
        maps({"mesh.pigment_map=" +
                  picture("p.exr", 2, 3, 1, [](int x, int y) { return glm::dvec3(x + 0.1 * y); }),
              "mesh.thickness_map=" +
                  picture("t.exr", 4, 1, 1, [](int x, int) { return glm::dvec3(1.0 + 0.1 * x); }),
              "mesh.normal_map=" + even("n.exr", glm::dvec3(-0.6, 0.0, 0.8))});
    assert_true(got.width == 4 && got.height == 4);
    // Between texel centres: u 0.125, 0.375, .. of two texels at 0.25 and 0.75, rows from below.
    const double across[] = {0.0, 0.25, 0.75, 1.0};
    const double rows[] = {0.2, 0.1375, 0.0625, 0.0};
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 4; x++) {
            const std::size_t i = std::size_t(4 * y + x);
            assert_true(std::fabs(double(got.pigment[i]) - across[x] - rows[y]) < 1e-6);
            assert_true(std::fabs(double(got.thickness[i]) - 1.0 - 0.1 * x) < 1e-6);
            assert_true(std::fabs(got.slope[2 * i] - 0.75f) < 1e-6f);
        }
    }
}

// Where alpha is 0 nothing is painted, whatever is below it.
void alpha_leaves_out(void **)
{
    mesh_file(quad());
    image::Image image{2, 1, 4, {}};
    image.pixels = {0.0f, 0.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.5f, 0.3f};
    std::string error;
    assert_true(image::write_exr(file("a.exr"), image, error));
    for (const char *key : {"mesh.pigment_map=", "mesh.thickness_map="}) {
        const Maps got = maps({key + file("a.exr")});
        const bool pigment = std::string(key) == "mesh.pigment_map=";
        const std::vector<float> &values = pigment ? got.pigment : got.thickness;
        assert_true(values == std::vector<float>({1.0f, 0.5f}));
    }
    // No cliff at the border of what is painted.
    assert_true(maps({"mesh.height_map=" + file("a.exr")}).slope == std::vector<float>(4, 0.0f));
    image.pixels = {0.0f, 0.0f, 0.0f, 0.0f, 0.6f, 0.0f, 0.8f, 1.0f};
    assert_true(image::write_exr(file("a.exr"), image, error));
    const std::vector<float> slope = maps({"mesh.normal_map=" + file("a.exr")}).slope;
    assert_true(slope[0] == 0.0f && std::fabs(slope[2] + 0.75f) < 1e-6f);
}

void paths_follow_the_scene(void **)
{
    mesh_file(quad());
    even("p.exr", 0.7);
    even("n.exr", glm::dvec3(0.0, 0.6, 0.8));
    std::ofstream(file("mine.scene")) << "kind=leaf\nmodel=leaf\nmesh=leaf.obj\n"
                                      << "mesh.pigment_map=p.exr\nmesh.normal_map=n.exr\n"
                                      << "mesh.normal_green=down\nmesh.height_mm=0.25\n";
    const auto scene = scene::read(file("mine.scene"));
    assert_true(bool(scene));
    assert_string_equal(scene->pigment_map.c_str(), file("p.exr").c_str());
    assert_string_equal(scene->thickness_map.c_str(), "none");
    const auto again = scene::parse(scene::write(*scene), "again");
    assert_true(bool(again));
    assert_true(*again == *scene && again->normal_map == file("n.exr"));
    assert_true(again->normal_green == "down" && again->height_mm == 0.25);
    const auto surface = scene::surface(*again);
    assert_true(bool(surface));
    assert_true(surface->plant.maps.pigment[0] == 0.7f);
    assert_true(std::fabs(surface->plant.maps.slope[1] - 0.75f) < 1e-6f);
    expect_error(surface->report, {"maps", "4x4"});
    // The same without the maps.
    const auto bare = scene::override(*scene, {"mesh.pigment_map=none", "mesh.normal_map=none"});
    assert_true(bool(bare));
    assert_true(scene::surface(*bare)->plant.maps.empty());
}

void refuse(const Words &more, const std::vector<std::string> &parts)
{
    const auto scene = scene::override({}, more);
    if (!scene) {
        expect_error(scene.error(), parts);
        return;
    }
    const auto surface = scene::surface(*scene);
    if (surface) {
        fail_msg("not refused: %s", parts[0].c_str());
    }
    expect_error(surface.error(), parts);
}

void what_is_no_map_is_refused(void **)
{
    mesh_file(quad());
    const auto one = [](const std::string &name, double bad, int channels = 1) {
        return picture(name, 5, 3, channels, [=](int x, int y) {
            return x == 3 && y == 1 ? glm::dvec3(bad) : glm::dvec3(1.0);
        });
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const std::string where = "texel (3, 1)";
    const auto pigment = [&](const std::string &path, std::vector<std::string> parts) {
        parts.push_back("mesh.pigment_map");
        refuse(words({"mesh.pigment_map=" + path}), parts);
    };
    pigment(one("a.exr", 2.5), {"a.exr", where, "2.5", "[0, 2]"});
    pigment(one("a.exr", -0.1), {where, "-0.1", "[0, 2]"});
    pigment(one("a.exr", nan), {where, "not finite", "[0, 2]"});
    pigment(one("a.exr", inf), {where, "not finite", "[0, 2]"});
    const auto coloured = [](int x, int y) { return glm::dvec3(1.0, x == 3 && y == 1, 1.0); };
    pigment(picture("a.png", 5, 2, 3, [=](int x, int y) { return 1.0 - coloured(x, y); }),
            {"texel (0, 0)", "(0, 1, 0)", "grey"});
    pigment(
        picture(
            "a.exr", 1, 1, 2, [](int, int) { return glm::dvec3(1.0); }, image::Depth::eight, 0.0f),
        {"a.exr", "alpha is 0"});
    image::Image odd{1, 1, 2, {1.0f, 1.0f}, {"U", "V"}};
    std::string error;
    assert_true(image::write_exr(file("odd.exr"), odd, error));
    pigment(file("odd.exr"), {"odd.exr", "no channels R, G and B", "grey"});
    pigment(file("missing.png"), {"missing.png", "cannot read"});
    std::ofstream(file("text.exr")) << "no picture";
    pigment(file("text.exr"), {"text.exr", "not an EXR"});
    pigment("leaf.jpg", {"leaf.jpg", ".png"});
    pigment("", {".png"});
    pigment(picture("wide.png", 8193, 1, 1, [](int, int) { return glm::dvec3(0.5); }),
            {"8193x1", "8192"});

    refuse(words({"mesh.thickness_map=" + one("a.exr", 0.4)}),
           {"mesh.thickness_map", "a.exr", where, "0.4", "[0.5, 2]"});
    refuse(words({"mesh.thickness_map=" + one("a.exr", 2.1)}), {where, "2.1", "[0.5, 2]"});

    const auto normal = [&](const std::string &name, const glm::dvec3 &n,
                            std::vector<std::string> parts) {
        parts.push_back("mesh.normal_map");
        refuse(words({"mesh.normal_map=" + even(name, n)}), parts);
    };
    normal("n.exr", {0.5, 0.5, 1.0}, {"texel (0, 0)", "length 1.22", "[0.5, 1.1]", "EXR"});
    normal("n.png", {0.0, 0.0, 0.0}, {"length 1.73", "[0.5, 1.1]"});
    normal("n.exr", {0.0, 0.0, 0.2}, {"length 0.2", "[0.5, 1.1]"});
    normal("n.exr", {0.0, nan, 1.0}, {"texel (0, 0)", "nan", "[0.5, 1.1]"});
    normal("n.exr", {0.0, 0.0, -1.0}, {"texel (0, 0)", "slope", "[0, 20]"});
    normal("n.exr", {1.0, 0.0, 0.04}, {"slope", "[0, 20]"});
    refuse(words({"mesh.normal_map=" + even("g.exr", 1.0)}), {"g.exr", "no channels R, G and B"});

    refuse(words({"mesh.height_map=" + one("a.exr", nan)}), {"mesh.height_map", where, "finite"});
    refuse(words({"mesh.height_map=" + one("a.exr", 1001.0)}), {where, "1001", "[-1000, 1000]"});
    refuse(words({"mesh.height_map=" + one("a.exr", 50.0), "mesh.height_mm=1000"}),
           {"slope", "[-20, 20]", "mesh.height_mm"});
    refuse(words({"mesh.height_mm=-1"}), {"mesh.height_mm", "[0, 1000]"});
    refuse(words({"mesh.normal_green=left"}), {"mesh.normal_green", "up, down"});
    const std::string flat = even("f.exr", glm::dvec3(0.0, 0.0, 1.0));
    refuse(words({"mesh.normal_map=" + flat, "mesh.height_map=" + even("h.exr", 0.0)}),
           {"mesh.normal_map", "mesh.height_map", "keep one"});
    refuse({"kind=leaf", "mesh.normal_map=" + flat}, {"mesh.normal_map", "with a mesh"});
    refuse({"kind=tree", "mesh.normal_map=" + flat}, {"mesh.normal_map", "kind=leaf"});
    mesh_file(quad(), false);
    refuse(words({"mesh.normal_map=" + flat}), {"mesh.normal_map", "leaf.obj", "no uv"});
}

} // namespace

int main()
{
    std::string name = (std::filesystem::temp_directory_path() / "leaf_maps_test_XXXXXX").string();
    if (!mkdtemp(name.data())) {
        std::perror(name.c_str());
        return 1;
    }
    folder = name;
    const CMUnitTest tests[] = {
        cmocka_unit_test(even_factors_scale_the_leaf),
        cmocka_unit_test(tilted_normals_shade_as_a_tilted_leaf),
        cmocka_unit_test(frames_follow_the_uv),
        cmocka_unit_test(heights_lean_by_their_slope),
        cmocka_unit_test(maps_lie_where_the_uv_say),
        cmocka_unit_test(sizes_meet),
        cmocka_unit_test(alpha_leaves_out),
        cmocka_unit_test(paths_follow_the_scene),
        cmocka_unit_test(what_is_no_map_is_refused),
    };
    const int failed = run("leaf_maps", tests);
    std::filesystem::remove_all(folder);
    return failed;
}

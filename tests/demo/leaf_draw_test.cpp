// Leaves as they are drawn: radiances against the model's double-precision reference, sides,
// shadows, the sky in a crown.
#include "leaf_checks.h"

#include "draw/leaf_sky.h"
#include "scene/build.h"
#include "scene/gallery.h"
#include "scene/picture.h"
#include "scene/plant.h"

#include <tsuya/models/leaf.h>
#include <tsuya/models/leaf_body.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdio>

using namespace leaf_checks;
using namespace tsuya;

namespace {

std::unique_ptr<scene::Studio> studio;
draw::SurfaceRenderer *renderer = nullptr;
tsu_context *library = nullptr;

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
Mesh quad()
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
draw::SurfaceFrame frame(const glm::dvec3 &toward, float half = 2.0f)
{
    draw::SurfaceFrame frame;
    frame.width = frame.height = 64;
    const glm::vec3 eye = 1000.0f * glm::vec3(glm::normalize(toward));
    frame.eye = eye;
    frame.view = glm::lookAt(eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
    frame.projection = glm::ortho(-half, half, -half, half, 990.0f, 1010.0f);
    return frame;
}

draw::Light sun(const glm::dvec3 &toward, double irradiance)
{
    return {glm::vec3(glm::normalize(toward)), glm::vec3(float(irradiance))};
}

draw::Picture drawn(const draw::SurfaceFrame &frame)
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
double mean(const draw::Picture &picture, int channel, bool (*chosen)(int, int) = nullptr)
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

void take(const Plant &plant, const tsu_model *model, const Row &row)
{
    renderer->load(plant);
    const auto taken = renderer->material(model, row.params(model).data());
    if (!taken) {
        fail_msg("%s", taken.error().c_str());
    }
}

// The real number: a flat leaf, one far light, radiance = BRDF or BTDF times E times cosine.
void flat_leaf_has_the_models_radiance(void **)
{
    const double E = 2.5;
    double worst_through = 0.0, worst_back = 0.0;
    for (const tsu_model *model : {tsu_leaf(), tsu_leaf_body()}) {
        for (const double T : {0.126, 0.03}) {
            Row row;
            row.T = T;
            take(single(quad()), model, row);
            for (const double mu0 : {1.0, 0.8, 0.4}) {
                for (const double mu : {1.0, 0.6}) {
                    for (const bool below : {false, true}) {
                        for (const bool through : {false, true}) {
                            row.mu0 = mu0;
                            row.mu = mu;
                            row.from_below = below;
                            row.through = through;
                            // Light comes from -x, the view leaves sideways.
                            row.phi = 0.5 * pi;
                            const double light = below ? -1.0 : 1.0;
                            const double view = through ? -light : light;
                            const glm::dvec3 l(-std::sqrt(1.0 - mu0 * mu0), 0.0, light * mu0);
                            const glm::dvec3 v(0.0, std::sqrt(1.0 - mu * mu), view * mu);
                            draw::SurfaceFrame f = frame(v);
                            f.lights = {sun(l, E)};
                            const double seen = mean(drawn(f), 1);
                            const double truth = row.reference(model) * E * mu0;
                            const double off = seen / truth - 1.0;
                            double &worst = through ? worst_through : worst_back;
                            worst = std::max(worst, std::fabs(off));
                            const bool normal = mu0 == 1.0 && mu == 1.0;
                            if (normal && through && std::fabs(off) > 0.02) {
                                fail_msg("T %g: radiance %g, BTDF times E %g", T, seen, truth);
                            }
                        }
                    }
                }
            }
        }
    }
    std::printf("flat leaf against the reference: through %.2f %%, back %.2f %% at worst\n",
                100.0 * worst_through, 100.0 * worst_back);
    assert_true(worst_through < 0.05 && worst_back < 0.05);
}

void both_sides_cover_the_same(void **)
{
    take(single(quad()), tsu_leaf_body(), {});
    for (const double z : {1.0, -1.0}) {
        draw::SurfaceFrame f = frame({0.0, 0.0, z});
        f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
        // Half of the picture's side is the leaf's.
        assert_true(std::fabs(mean(drawn(f), -1) - 0.25) < 1e-6);
    }
}

// Light of equal radiance from everywhere: what a leaf without absorption gives back. Without its
// gloss it lacks what the wall reflects.
void white_leaf_vanishes_in_a_white_sky(void **)
{
    for (const tsu_model *model : {tsu_leaf(), tsu_leaf_body()}) {
        const double gloss = model == tsu_leaf() ? 0.0 : 0.45 * 0.45 / (2.45 * 2.45);
        Row row;
        row.absorption = 0.0;
        renderer->load(single(quad()));
        std::vector<std::max_align_t> params = row.params(model);
        for (uint32_t i = 0;; i++) {
            tsu_parameter_info p;
            tsu_parameter_info_init(&p);
            if (tsu_model_parameter(model, i, &p) != TSU_OK) {
                break;
            }
            if (std::string(p.name).rfind("absorption", 0) == 0) {
                std::memset(reinterpret_cast<char *>(params.data()) + p.offset, 0,
                            p.count * sizeof(float));
            }
        }
        assert_true(bool(renderer->material(model, params.data())));
        for (const double angle : {0.0, 40.0, 65.0}) {
            const double a = angle * pi / 180.0;
            draw::SurfaceFrame f = frame({0.0, std::sin(a), std::cos(a)});
            f.sky[0] = f.sky[1] = f.sky[2] = 0.7f;
            const double back = mean(drawn(f), 1) / 0.7;
            std::printf("white leaf in a white sky at %g degrees: %.4f\n", angle, back);
            assert_true(back < 1.03 && back > (angle < 50.0 ? 0.97 : 0.85) - gloss);
            assert_true(model != tsu_leaf() || std::fabs(back - 1.0) < 0.03);
        }
        // Lit from one side alone, both sides together: the same power, by way of two pictures.
        double sum = 0.0;
        for (const double z : {1.0, -1.0}) {
            draw::SurfaceFrame f = frame({0.0, 0.0, z});
            f.sky[0] = f.sky[1] = f.sky[2] = 0.5f;
            f.sky[12] = f.sky[13] = f.sky[14] = 0.5f; // radiance 0.5 + 0.5 z
            sum += mean(drawn(f), 1);
        }
        assert_true(std::fabs(sum + gloss - 1.0) < 0.03);
    }
}

void sides_differ(void **)
{
    Row row;
    row.R_top = 0.05;
    row.R_bottom = 0.16;
    take(single(quad()), tsu_leaf_body(), row);
    double side[2];
    for (int i = 0; i < 2; i++) {
        const glm::dvec3 z(0.0, 0.0, i == 0 ? 1.0 : -1.0);
        draw::SurfaceFrame f = frame(z);
        f.lights = {sun(z, 1.0)};
        side[i] = mean(drawn(f), 1);
    }
    assert_true(side[1] > 2.0 * side[0]);
}

// The maps' factors reach the model.
void factors_reach_the_model(void **)
{
    Row row;
    Plant plant = single(quad());
    for (const double pigment : {0.5, 1.8}) {
        for (const double thickness : {0.6, 1.7}) {
            plant.leaves[0].pigment = float(pigment);
            plant.leaves[0].thickness = 1.0f;
            plant.maps = {2,
                          2,
                          1.0,
                          std::vector<float>(4, 1.0f),
                          std::vector<float>(4, float(thickness)),
                          std::vector<float>(4, 0.0f),
                          std::vector<unsigned char>(4, 1)};
            take(plant, tsu_leaf_body(), row);
            draw::SurfaceFrame f = frame({0.0, 0.0, -1.0});
            f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
            Row changed = row;
            changed.through = true;
            changed.absorption = pigment;
            changed.thickness = thickness;
            const double truth = changed.reference(tsu_leaf_body());
            assert_true(std::fabs(mean(drawn(f), 1) / truth - 1.0) < 0.04);
        }
    }
}

bool in_the_middle(int x, int y)
{
    return x >= 28 && x < 36 && y >= 28 && y < 36;
}
bool at_the_edge(int x, int y)
{
    return x >= 18 && x < 22 && y >= 18 && y < 46;
}

// One leaf in the way lets its transmittance pass, two and wood let nothing.
void leaves_shade_each_other(void **)
{
    Row row;
    Plant plant = single(quad());
    const auto add = [&](float z) {
        Placed leaf;
        leaf.place = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, z)) *
                     glm::scale(glm::mat4(1.0f), glm::vec3(0.4f));
        plant.leaves.push_back(leaf);
    };
    const auto share = [&] {
        take(plant, tsu_leaf_body(), row);
        draw::SurfaceFrame f = frame({0.0, 0.0, -1.0});
        f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
        const draw::Picture picture = drawn(f);
        return mean(picture, 1, in_the_middle) / mean(picture, 1, at_the_edge);
    };
    assert_true(std::fabs(share() - 1.0) < 1e-3);
    add(0.5f);
    // All that passes a leaf lit at 45 degrees: by Gauss's rule over the other side.
    double passed = 0.0;
    const double nodes[] = {0.046910077, 0.23076534, 0.5, 0.76923466, 0.95308992};
    const double weights[] = {0.11846344, 0.23931434, 0.28444444, 0.23931434, 0.11846344};
    for (int i = 0; i < 5; i++) {
        for (int k = 0; k < 8; k++) {
            Row at = row;
            at.through = true;
            at.mu0 = std::sqrt(0.5);
            at.mu = nodes[i];
            at.phi = (k + 0.5) * pi / 8.0;
            passed += weights[i] * nodes[i] * 2.0 * pi / 8.0 * at.reference(tsu_leaf_body());
        }
    }
    const double one = share();
    std::printf("light behind one leaf: %.4f of what arrives, transmittance %.4f\n", one, passed);
    assert_true(std::fabs(one / passed - 1.0) < 0.03);
    add(0.8f);
    assert_true(share() < 1e-6);
    plant.leaves.resize(1);
    plant.wood = quad();
    for (glm::vec3 &p : plant.wood.positions) {
        p = 0.4f * p + glm::vec3(0.0f, 0.0f, 0.5f);
    }
    plant.wood.albedo.assign(4, glm::vec3(0.2f));
    assert_true(share() < 1e-6);
}

// Normals that follow a crown: the shading normal turns, the lit side stays the leaf's own.
void rounded_normals_keep_their_side(void **)
{
    Row row;
    Plant plant = single(quad());
    plant.half = glm::vec3(1.0f);
    for (const double tilt : {30.0, 60.0}) {
        // The crown's middle is far off, so that its normal is the same everywhere.
        const double a = tilt * pi / 180.0;
        for (const double behind : {1.0, -1.0}) {
            const glm::dvec3 crown(std::sin(a), 0.0, behind * std::cos(a));
            plant.centre = glm::vec3(-1e5 * crown);
            take(plant, tsu_leaf_body(), row);
            draw::SurfaceFrame f = frame({0.0, 0.0, 1.0});
            f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
            f.roundness = 1.0f;
            // Lit and seen from the top at the angle of the crown's normal, reflected.
            Row truth = row;
            truth.mu0 = truth.mu = std::cos(a);
            truth.phi = pi;
            const double seen = mean(drawn(f), 1);
            assert_true(std::fabs(seen / (truth.reference(tsu_leaf_body()) * std::cos(a)) - 1.0) <
                        0.05);
            f = frame({0.0, 0.0, -1.0});
            f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
            f.roundness = 1.0f;
            truth.through = true;
            truth.phi = 0.0;
            assert_true(
                std::fabs(mean(drawn(f), 1) / (truth.reference(tsu_leaf_body()) * std::cos(a)) -
                          1.0) < 0.05);
        }
    }
}

void lights_with_a_place_are_points_and_areas(void **)
{
    // A small quad, so that the light's direction is the same all over.
    Mesh mesh = quad();
    for (glm::vec3 &p : mesh.positions) {
        p *= 0.01f;
    }
    take(single(mesh), tsu_leaf_body(), {});
    const auto lit = [&](const scene::SceneLight &light) {
        draw::SurfaceFrame f = frame({0.0, 0.0, 1.0}, 0.02f);
        f.lights = {scene::own_light(light)};
        return mean(drawn(f), 1);
    };
    draw::SurfaceFrame f = frame({0.0, 0.0, 1.0}, 0.02f);
    f.lights = {sun({0.0, 0.0, 1.0}, 1.0)};
    const double far = mean(drawn(f), 1);
    scene::SceneLight light;
    light.kind = "point";
    light.position = {0.0, 0.0, 2.0};
    light.intensity = 4.0;
    assert_true(std::fabs(lit(light) / far - 1.0) < 1e-3);
    light.kind = "rect";
    light.width = 0.1;
    light.height = 0.2;
    light.intensity = 4.0 / (0.1 * 0.2);
    assert_true(std::fabs(lit(light) / far - 1.0) < 0.01);
    light.kind = "disk";
    light.intensity = 4.0 / (pi * 0.05 * 0.05);
    assert_true(std::fabs(lit(light) / far - 1.0) < 0.01);
    // Its back gives nothing, unless it shines to both sides.
    light.facing = {0.0, 0.0, 1.0};
    assert_true(lit(light) < 1e-6);
    light.sides = 2;
    assert_true(std::fabs(lit(light) / far - 1.0) < 0.01);
}

// A cloud of leaves spread evenly in a cube: the sky in its middle against the closed form.
void crown_dims_the_sky(void **)
{
    Plant plant;
    Mesh mesh = quad();
    plant.kinds.push_back({mesh, {}});
    plant.nodes.resize(2);
    std::uint32_t state = 7u;
    const auto unit = [&] {
        state = state * 1664525u + 1013904223u;
        return float(state >> 8) / 16777216.0f;
    };
    const int count = 40000;
    const float area = 4.0f * 0.01f * 0.01f;
    for (int i = 0; i < count; i++) {
        Placed leaf;
        const glm::vec3 at(unit() - 0.5f, unit() - 0.5f, unit() - 0.5f);
        leaf.place =
            glm::translate(glm::mat4(1.0f), at) * glm::scale(glm::mat4(1.0f), glm::vec3(0.01f));
        plant.leaves.push_back(leaf);
    }
    std::array<float, 36> white{};
    white[0] = white[1] = white[2] = 1.0f;
    const draw::LeafSky sky = draw::leaf_sky(plant, white, glm::mat3(1.0f));
    const auto at = [&](int x, int y, int z) {
        return &sky.texels[std::size_t((z * sky.size.y + y) * sky.size.x + x) * 4];
    };
    // exp(-0.4 density way), way to the cube's surface from its middle, over all directions.
    double truth = 0.0;
    const int steps = 200000;
    for (int i = 0; i < steps; i++) {
        const double z = 1.0 - (2.0 * i + 1.0) / steps, r = std::sqrt(1.0 - z * z);
        const double phi = 2.399963229728653 * i;
        const double most =
            std::max({std::fabs(r * std::cos(phi)), std::fabs(r * std::sin(phi)), std::fabs(z)});
        truth += std::exp(-0.4 * double(count) * double(area) * 0.5 / most) / steps;
    }
    const int half = sky.size.x / 2;
    const float *middle = at(half, half, half);
    std::printf("sky in the middle of a cloud: %.4f, by hand %.4f\n", double(middle[0]), truth);
    assert_true(std::fabs(double(middle[0]) / truth - 1.0) < 0.06);
    for (int k = 1; k < 4; k++) {
        assert_true(std::fabs(middle[k]) < 0.02f);
    }
    // On top the light comes from above.
    const float *top = at(half, sky.size.y - 1, half);
    assert_true(top[0] > 1.5f * middle[0] && top[2] > 0.3f);
    assert_true(std::fabs(top[1]) < 0.05f && std::fabs(top[3]) < 0.05f);
    assert_true(draw::leaf_sky(single(mesh), white, glm::mat3(1.0f)).texels.empty());
}

// Green of all light, median over pixels that leaves cover whole.
double greenness(const draw::Picture &picture)
{
    std::vector<double> shares;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        const float *p = &picture.pixels[i];
        if (p[3] == 1.0f) {
            shares.push_back(double(p[1]) / (double(p[0]) + double(p[1]) + double(p[2])));
        }
    }
    assert_true(!shares.empty());
    std::sort(shares.begin(), shares.end());
    return shares[shares.size() / 2];
}

// What the gallery draws, coarsely: green light through a leaf, gloss on it, a tree with a shadow.
void gallery_leaves_look_like_leaves(void **)
{
    const auto gallery = scene::gallery();
    assert_true(bool(gallery));
    int seen = 0;
    double green[2] = {0.0, 0.0};
    for (const scene::Named &named : *gallery) {
        if (named.scene.kind == "hair") {
            continue;
        }
        seen++;
        const auto small =
            scene::override(named.scene, {"size=96x96", "supersample=1", "leaf.texels=256"});
        const auto surface = scene::surface(*small);
        const auto material = scene::material(*small);
        const auto around = scene::surroundings(*small);
        assert_true(bool(surface) && bool(material) && bool(around));
        renderer->load(surface->plant);
        assert_true(bool(renderer->material(material->model, material->params.data())));
        const draw::Picture picture = drawn(scene::frame(*small, *surface, 0.0, false, *around));
        const double coverage = mean(picture, -1);
        assert_true(coverage > 0.12 && coverage < 0.6);
        const double share = greenness(picture);
        std::printf("%s: green %.3f of a pixel's light, leaves cover %.3f\n", named.name.c_str(),
                    share, coverage);
        assert_true(coverage > 0.12 && coverage < 0.6);
        assert_true(share > 0.45);
        if (named.scene.kind == "leaf") {
            green[named.scene.light == "back"] = share;
        }
    }
    assert_int_equal(seen, 4);
    // Light that came through is purer than light that a glossy leaf sends back.
    assert_true(green[1] > green[0]);
}

void refuses_what_it_cannot_draw(void **)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    std::vector<std::max_align_t> params(64);
    tsu_model_params_init(tsu_model_find("marschner"), params.data(), 256);
    const auto fibre = renderer->material(tsu_model_find("marschner"), params.data());
    assert_false(bool(fibre));
    expect_error(fibre.error(), {"marschner", "leaf"});
    take(single(quad()), tsu_leaf_body(), {});
    draw::SurfaceFrame f = frame({0.0, 0.0, 1.0});
    f.lights.assign(33, sun({0.0, 0.0, 1.0}, 1.0));
    expect_error(renderer->draw(f).error(), {"at most 32"});
    const auto refuse = [](const std::vector<std::string> &words,
                           const std::vector<std::string> &parts) {
        const auto scene = scene::override({}, words);
        if (!scene) {
            expect_error(scene.error(), parts);
            return;
        }
        const auto surface = scene::surface(*scene);
        assert_false(bool(surface));
        expect_error(surface.error(), parts);
    };
    refuse({"kind=stone"}, {"kind", "hair, leaf, tree"});
    refuse({"leaf.width=3"}, {"leaf.width", "[0.05, 1.5]"});
    refuse({"leaf.shape=fern"}, {"leaf.shape", "beech"});
    refuse({"leaves=100"}, {"leaves", "[200, 20000]"});
    refuse({"leaves=300.5"}, {"leaves", "whole"});
    refuse({"kind=leaf", "mesh=missing.obj"}, {"missing.obj", "cannot be read"});
    refuse({"kind=tree", "mesh=a.obj"}, {"mesh", "kind=leaf"});
    refuse({"kind=leaf", "leaf.teeth=60"}, {"rows", "300"});
}

} // namespace

int main()
{
    auto made = scene::Studio::create();
    if (!made) {
        std::fprintf(stderr, "leaf_draw_test: %s\n", made.error().c_str());
        return 1;
    }
    studio = std::move(*made);
    const auto surfaces = studio->surfaces();
    if (!surfaces) {
        std::fprintf(stderr, "leaf_draw_test: %s\n", surfaces.error().c_str());
        return 1;
    }
    renderer = *surfaces;
    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    tsu_context_create(&desc, &library);
    const CMUnitTest tests[] = {
        cmocka_unit_test(flat_leaf_has_the_models_radiance),
        cmocka_unit_test(both_sides_cover_the_same),
        cmocka_unit_test(white_leaf_vanishes_in_a_white_sky),
        cmocka_unit_test(sides_differ),
        cmocka_unit_test(factors_reach_the_model),
        cmocka_unit_test(leaves_shade_each_other),
        cmocka_unit_test(rounded_normals_keep_their_side),
        cmocka_unit_test(lights_with_a_place_are_points_and_areas),
        cmocka_unit_test(crown_dims_the_sky),
        cmocka_unit_test(gallery_leaves_look_like_leaves),
        cmocka_unit_test(refuses_what_it_cannot_draw),
    };
    const int failed = cmocka_run_group_tests_name("leaf_draw", tests, nullptr, nullptr);
    tsu_context_destroy(library);
    studio.reset();
    return failed;
}

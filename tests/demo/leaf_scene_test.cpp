// Leaves in scenes: shadows, crowns, lights with a place, the sky among leaves, the gallery.
#include "leaf_rig.h"

#include "draw/leaf_sky.h"
#include "scene/gallery.h"

using namespace leaf_rig;

namespace {

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
        f.lights = {scene::own_light(light, glm::dvec3(0.0))};
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
    const CMUnitTest tests[] = {
        cmocka_unit_test(leaves_shade_each_other),
        cmocka_unit_test(rounded_normals_keep_their_side),
        cmocka_unit_test(lights_with_a_place_are_points_and_areas),
        cmocka_unit_test(crown_dims_the_sky),
        cmocka_unit_test(gallery_leaves_look_like_leaves),
        cmocka_unit_test(refuses_what_it_cannot_draw),
    };
    return run("leaf_scene", tests);
}

#include "scene/plant.h"

#include "leaf/read.h"
#include "scene/build.h"
#include "scene/leaf_maps.h"

#include <algorithm>
#include <cstdio>
#include <cstdint>
#include <utility>

namespace tsuya::scene {

namespace {

constexpr double degree = 0.01745329251994329577;

std::uint64_t seed(const Scene &scene)
{
    const auto given = scene.hair.find("seed");
    return given == scene.hair.end() ? 1 : std::uint64_t(given->second);
}

template <class T>
void take(const std::map<std::string, double> &given, const char *name, T &field, double unit = 1.0)
{
    const auto found = given.find(name);
    if (found != given.end()) {
        field = T(found->second * unit);
    }
}

void change(const std::map<std::string, double> &given, leaf::LeafParams &p)
{
    take(given, "length", p.length);
    take(given, "width", p.width);
    take(given, "widest", p.widest);
    take(given, "tip", p.tip);
    take(given, "base", p.base);
    take(given, "heart", p.heart);
    take(given, "teeth", p.teeth);
    take(given, "tooth_depth", p.tooth_depth);
    take(given, "lobes", p.lobes);
    take(given, "lobe_depth", p.lobe_depth);
    take(given, "roughness", p.roughness);
    take(given, "petiole", p.petiole);
    take(given, "veins", p.veins);
    take(given, "sweep", p.sweep);
    take(given, "curve", p.curve);
    take(given, "loops", p.loops);
    take(given, "fold_deg", p.fold, degree);
    take(given, "curl", p.curl);
    take(given, "bend_deg", p.bend, degree);
    take(given, "twist_deg", p.twist, degree);
    take(given, "wave", p.wave);
    take(given, "blotches", p.blotches);
    take(given, "edge", p.edge);
    take(given, "halo", p.halo);
    take(given, "relief", p.relief);
    take(given, "rows", p.rows);
    take(given, "columns", p.columns);
    take(given, "texels", p.texels);
}

Expected<leaf::Plant> one_leaf(const Scene &scene, std::string &report)
{
    if (scene.mesh != "none") {
        leaf::ReadOptions options;
        options.unit_scale = scene.unit_scale;
        options.up = scene.up == "z" ? groom::Up::z : groom::Up::y;
        Expected<leaf::Loaded> loaded = leaf::read(scene.mesh, options);
        if (!loaded) {
            return Error{loaded.error()};
        }
        Expected<leaf::Maps> maps = leaf_maps(scene, *loaded);
        if (!maps) {
            return Error{maps.error()};
        }
        report = leaf::text(loaded->report);
        if (!maps->empty()) {
            report += "maps             " + std::to_string(maps->width) + "x" +
                      std::to_string(maps->height) + (maps->repeat ? ", repeated\n" : "\n");
        }
        leaf::Plant plant = leaf::single(std::move(loaded->mesh));
        plant.maps = std::move(*maps);
        return Expected<leaf::Plant>(std::move(plant));
    }
    Expected<leaf::LeafParams> params = leaf::preset(scene.shape);
    if (!params) {
        return Error{params.error()};
    }
    params->seed = seed(scene);
    change(scene.leaf, *params);
    Expected<leaf::Leaf> grown = leaf::generate(*params);
    if (!grown) {
        return Error{grown.error()};
    }
    report = leaf::text(leaf::inspect(grown->blade));
    return leaf::single(std::move(*grown));
}

Expected<leaf::Plant> tree(const Scene &scene, std::string &report)
{
    if (scene.mesh != "none") {
        return Error{"mesh is for kind=leaf; a tree grows its own leaves"};
    }
    Expected<leaf::TreeParams> params = leaf::tree_preset(scene.shape);
    if (!params) {
        return Error{params.error()};
    }
    params->seed = params->leaf.seed = seed(scene);
    change(scene.leaf, params->leaf);
    take(scene.tree, "leaves", params->leaves);
    take(scene.tree, "twigs", params->twigs);
    take(scene.tree, "height", params->height);
    take(scene.tree, "crown_width", params->crown_width);
    take(scene.tree, "crown_base", params->crown_base);
    take(scene.tree, "phototropism", params->phototropism);
    take(scene.tree, "droop", params->droop);
    take(scene.tree, "variation", params->variation);
    Expected<leaf::Plant> grown = leaf::grow(*params);
    if (grown) {
        char line[160];
        std::snprintf(line, sizeof line,
                      "leaves           %zu, of %zu triangles each\n"
                      "wood             %zu triangles, trunk %.3g mm thick\n",
                      grown->leaves.size(), grown->kinds[0].blade.triangles(),
                      grown->wood.triangles(), 2e3 * double(grown->nodes[0].radius));
        report = line;
    }
    return grown;
}

} // namespace

Expected<Surface> surface(const Scene &scene)
{
    Surface result;
    const std::string map = leaf_map_given(scene);
    if (!map.empty() && (scene.kind == "tree" || scene.mesh == "none")) {
        return Error{map + " is for kind=leaf with a mesh; leaves that grow have their own maps"};
    }
    Expected<leaf::Plant> plant =
        scene.kind == "tree" ? tree(scene, result.report) : one_leaf(scene, result.report);
    if (!plant) {
        return Error{plant.error()};
    }
    result.plant = std::move(*plant);
    const auto add = [&](const leaf::Mesh &mesh, const glm::mat4 &place) {
        for (const glm::vec3 &p : mesh.positions) {
            result.points.push_back(glm::vec3(place * glm::vec4(p, 1.0f)));
        }
    };
    for (const leaf::Placed &leaf : result.plant.leaves) {
        add(result.plant.kinds[leaf.kind].blade, leaf.place);
        add(result.plant.kinds[leaf.kind].stalk, leaf.place);
    }
    add(result.plant.wood, glm::mat4(1.0f));
    return Expected<Surface>(std::move(result));
}

draw::SurfaceFrame frame(const Scene &scene, const Surface &surface, double turn, bool turntable,
                         const Surroundings &around)
{
    draw::SurfaceFrame frame;
    frame.width = scene.width;
    frame.height = scene.height;
    frame.supersample = scene.supersample;
    frame.lights = lights(scene, middle(surface.points));
    if (around.there) {
        frame.lights.insert(frame.lights.begin(), around.dominant.begin(), around.dominant.end());
        frame.sky = around.record;
    }
    for (int k = 0; k < 3; k++) {
        frame.sky[std::size_t(k)] += float(scene.dome * scene.dome_color[k]);
    }
    frame.background = glm::vec3(scene.background);
    frame.ground = scene.ground == "auto";
    frame.roundness = float(scene.roundness);
    if (scene.shadow == "none") {
        frame.shadow_size = 0;
    } else if (scene.shadow_size > 0) {
        frame.shadow_size = std::min(scene.shadow_size, 4096);
    }
    Scene turned = scene;
    turned.turn += turn;
    aim(turned, surface, turntable, frame);
    return frame;
}

} // namespace tsuya::scene

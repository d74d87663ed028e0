// Keys of leaves and trees.
#include "scene/keys.h"

#include "leaf/generate.h"
#include "scene/leaf_maps.h"

#include <algorithm>

namespace tsuya::scene {

namespace {

const char *const leaf_group = "leaf that is grown";
const char *const tree_group = "tree that is grown";

Key mesh_key()
{
    return {"mesh",
            leaf_group,
            "none or PATH",
            "a leaf from an .obj or .ply file, with kind=leaf; "
            "unit_scale and up are those of the file",
            [](Scene &scene, const std::string &text) -> std::string {
                if (text.empty()) {
                    return "is \"\"";
                }
                scene.mesh = text;
                return "";
            },
            [](const Scene &scene) { return scene.mesh; }};
}

Key leaf_map_key(const LeafMapKey &from)
{
    std::string Scene::*const path = from.path;
    return {from.name,
            leaf_group,
            "none or PATH.png or PATH.exr",
            from.help,
            [=](Scene &scene, const std::string &text) -> std::string {
                const std::size_t dot = text.rfind('.');
                std::string ending = dot == std::string::npos ? "" : text.substr(dot);
                std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
                    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
                });
                if (text != "none" && ending != ".png" && ending != ".exr") {
                    return "is \"" + text + "\"";
                }
                scene.*path = text;
                return "";
            },
            [=](const Scene &scene) { return scene.*path; }};
}

// The material in words: a name, contents, or faces; faces replace the rest, and these them.
void forget_others(LeafWords &words, LeafBy by)
{
    if (by == LeafBy::faces) {
        words.name.clear();
    }
    for (auto value = words.values.begin(); value != words.values.end();) {
        value = leaf_by(value->first) == by ? std::next(value) : words.values.erase(value);
    }
}

Key name_key()
{
    std::vector<std::string> names = leaf_names();
    std::string range;
    for (const std::string &name : names) {
        range += (range.empty() ? "" : ", ") + name;
    }
    return {"leaf",
            "material",
            range,
            "a leaf by name, for models of leaves",
            [=](Scene &scene, const std::string &text) -> std::string {
                if (std::find(names.begin(), names.end(), text) == names.end()) {
                    return "is \"" + text + "\"";
                }
                forget_others(scene.contents, LeafBy::contents);
                scene.contents.name = text;
                return "";
            },
            [](const Scene &scene) { return scene.contents.name; }};
}

Key content_key(const LeafKey &key)
{
    const std::string name = key.name;
    const double low = key.low, high = key.high;
    const bool triple = key.face;
    return {name,
            "material",
            (triple ? "a,b,c each in " : "") + range_text(low, high),
            key.help,
            [=](Scene &scene, const std::string &text) {
                glm::dvec3 value{0.0};
                const std::string wrong = triple ? read_triple(text, low, high, value)
                                                 : read_number(text, low, high, value.x);
                if (wrong.empty()) {
                    forget_others(scene.contents, leaf_by(name));
                    scene.contents.values[name] = value;
                }
                return wrong;
            },
            [=](const Scene &scene) -> std::string {
                const auto found = scene.contents.values.find(name);
                if (found == scene.contents.values.end()) {
                    return "";
                }
                return triple ? triple_text(found->second) : number_text(found->second.x);
            }};
}

} // namespace

void add_leaf_material_keys(std::vector<Key> &keys)
{
    keys.push_back(name_key());
    for (const LeafKey &key : leaf_keys()) {
        keys.push_back(content_key(key));
    }
}

void add_leaf_keys(std::vector<Key> &keys)
{
    const auto leaf = [&](const char *name, double low, double high, bool whole, const char *help) {
        keys.push_back(
            map_key(leaf_group, std::string("leaf.") + name, &Scene::leaf, low, high, whole, help));
    };
    const auto tree = [&](const char *name, double low, double high, bool whole, const char *help) {
        keys.push_back(map_key(tree_group, name, &Scene::tree, low, high, whole, help));
    };
    keys.push_back(mesh_key());
    for (const LeafMapKey &key : leaf_map_keys()) {
        keys.push_back(leaf_map_key(key));
    }
    keys.push_back(word_key(leaf_group, "mesh.normal_green", &Scene::normal_green, {"up", "down"},
                            "of mesh.normal_map: along v (OpenGL), or against it (DirectX)"));
    keys.push_back(number_key(leaf_group, "mesh.height_mm", &Scene::height_mm, 0.0, 1000.0,
                              "millimetres that a value of 1 in mesh.height_map stands for"));
    keys.push_back(word_key(leaf_group, "leaf.shape", &Scene::shape, leaf::shapes(),
                            "like that of; gives the defaults of the rest"));
    leaf("length", 0.005, 1.0, false, "metres, of the blade along its midrib");
    leaf("width", 0.05, 1.5, false, "greatest, over the length");
    leaf("widest", 0.2, 0.8, false, "where that is, from base to tip");
    leaf("tip", 0.0, 1.0, false, "0 round, 0.5 pointed, 1 drawn out");
    leaf("base", 0.0, 1.0, false, "0 wedge, 0.5 pointed, 1 round");
    leaf("heart", 0.0, 0.25, false, "how far the base reaches back beside the stalk");
    leaf("teeth", 0, 80, true, "along each margin");
    leaf("tooth_depth", 0.0, 0.2, false, "of half the width");
    leaf("lobes", 0, 8, true, "along each margin");
    leaf("lobe_depth", 0.0, 0.45, false, "of half the width");
    leaf("roughness", 0.0, 1.0, false, "of the outline, and halves that differ");
    leaf("petiole", 0.0, 1.5, false, "length of the stalk, of the blade's");
    leaf("veins", 2, 30, true, "secondary veins on each side");
    leaf("sweep", 0.0, 1.0, false, "how far they run forward");
    leaf("curve", 0.0, 1.0, false, "how late");
    leaf("loops", 0.0, 1.0, false, "1: each joins the next before the margin");
    leaf("fold_deg", -68.0, 68.0, false, "each half rises at the midrib");
    leaf("curl", 0.0, 3.0, false, "share of it that is gone at the margin");
    leaf("bend_deg", -171.0, 171.0, false, "the midrib turns down");
    leaf("twist_deg", -114.0, 114.0, false, "about the midrib");
    leaf("wave", 0.0, 0.5, false, "of the margin, of half the width");
    leaf("blotches", 0.0, 1.0, false, "deviation of pigment in clouds");
    leaf("edge", -0.6, 1.0, false, "more pigment at the margin");
    leaf("halo", 0.0, 0.9, false, "less pigment beside the large veins");
    leaf("relief", 0.0, 3.0, false, "height of the veins, of the usual");
    leaf("rows", 8, 512, true, "of quads from base to tip, at least 5 a tooth");
    leaf("columns", 2, 64, true, "of quads on each side");
    leaf("texels", 0, 8192, true, "of the maps' longer side, 64 or more; 0: no maps");
    tree("leaves", 200, 20000, true, "exactly as many; default 3600");
    tree("tree.twigs", 40, 4000, true, "places that the tree grows towards");
    tree("tree.height", 0.5, 30.0, false, "metres");
    tree("tree.crown_width", 0.2, 2.0, false, "greatest diameter, of the height");
    tree("tree.crown_base", 0.0, 0.8, false, "where the crown begins, of the height");
    tree("tree.phototropism", 0.0, 1.0, false, "how far blades turn up and outwards");
    tree("tree.droop", 0.0, 1.0, false, "how far leaves hang");
    tree("tree.variation", 0.0, 0.5, false, "deviation of pigment from leaf to leaf");
    keys.push_back(word_key(tree_group, "ground", &Scene::ground, {"auto", "none"},
                            "draw the ground under a tree"));
    keys.push_back(number_key(tree_group, "tree.roundness", &Scene::roundness, 0.0, 1.0,
                              "how far shading normals follow a rounded crown; the side that is "
                              "lit stays the leaf's own"));
}

} // namespace tsuya::scene

#include "scene/keys.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace tsuya::scene {

namespace {

Key hair_key(const char *name, double low, double high, bool whole, const char *help)
{
    return map_key("hair that is grown", name, &Scene::hair, low, high, whole, help);
}

Key groom_key()
{
    return {"groom", "groom", "straight, wavy, curly or file:PATH",
            "hair to grow on the built-in head, or a .tfx, .hair or .data file",
            [](Scene &scene, const std::string &text) -> std::string {
                const bool file = text.rfind("file:", 0) == 0 && text.size() > 5;
                if (!file && text != "straight" && text != "wavy" && text != "curly") {
                    return "is \"" + text + "\"";
                }
                scene.groom = text;
                return "";
            },
            [](const Scene &scene) { return scene.groom; }};
}

Key size_key()
{
    return {"size", "picture", "WxH, each whole in [1, 8192]", "pixels",
            [](Scene &scene, const std::string &text) -> std::string {
                const std::size_t x = text.find('x');
                double size[2] = {0.0, 0.0};
                if (x == std::string::npos || !number_value(text.substr(0, x), size[0]) ||
                    !number_value(text.substr(x + 1), size[1])) {
                    return "is \"" + text + "\", which is not WxH";
                }
                for (double side : size) {
                    if (!(side >= 1.0 && side <= 8192.0) || side != std::floor(side)) {
                        return "is " + text;
                    }
                }
                scene.width = int(size[0]);
                scene.height = int(size[1]);
                return "";
            },
            [](const Scene &scene) {
                return std::to_string(scene.width) + "x" + std::to_string(scene.height);
            }};
}

Key target_key()
{
    Key key = triple_key("camera", "camera.target", &Scene::camera_target, -1e6, 1e6,
                         "point that the camera looks at, metres; default: the groom's middle");
    const auto set = key.set;
    const auto get = key.get;
    key.set = [=](Scene &scene, const std::string &text) {
        std::string wrong = set(scene, text);
        scene.camera_aims = scene.camera_aims || wrong.empty();
        return wrong;
    };
    key.get = [=](const Scene &scene) { return scene.camera_aims ? get(scene) : ""; };
    return key;
}

Key title_key()
{
    return {"title", "groom", "text", "what the list of scenes prints",
            [](Scene &scene, const std::string &text) -> std::string {
                scene.title = text;
                return "";
            },
            [](const Scene &scene) { return scene.title; }};
}

std::vector<Key> make_keys()
{
    std::vector<Key> keys = {
        title_key(),
        word_key("groom", "kind", &Scene::kind, {"hair", "leaf", "tree"}, "what is drawn"),
        groom_key(),
        number_key("groom", "unit_scale", &Scene::unit_scale, 1e-9, 1e9,
                   "metres of one unit of the groom file"),
        word_key("groom", "up", &Scene::up, {"y", "z"}, "axis that points up in the groom file"),
        number_key("groom", "fiber_width", &Scene::fiber_width, 1e-7, 1e-2,
                   "diameter of a fibre, metres, where the groom says nothing"),
        number_key("groom", "width_scale", &Scene::width_scale, 1e-3, 1e3,
                   "factor on every fibre's width; 4 lets 25,000 strands stand for 100,000"),
        number_key("groom", "taper", &Scene::taper, 0.0, 1.0,
                   "share of a strand's length over which the tip narrows to a point"),
        number_key("groom", "variation", &Scene::variation, 0.0, 1.0,
                   "deviation of ln(sigma_a) from strand to strand"),
        word_key("groom", "head", &Scene::head, {"auto", "none"},
                 "draw the head that hair was grown on; none: hair fills its place"),
        hair_key("seed", 0, 4294967295.0, true,
                 "another seed, another head of hair, leaf or tree"),
        hair_key("strands", 100, 100000, true, "number of strands"),
        hair_key("points", 8, 256, true, "points of a strand"),
        hair_key("length", 0.02, 1.0, false, "mean length, metres"),
        hair_key("length_variation", 0.0, 0.5, false, "relative half range of length"),
        hair_key("curl_radius", 0.0, 0.03, false, "metres"),
        hair_key("curl_frequency", 0.0, 200.0, false, "turns per metre"),
        hair_key("clumping", 0.0, 1.0, false, "how far tips move to their lock"),
        hair_key("frizz", 0.0, 1.0, false, "how far strands leave their lock"),
        hair_key("volume", 0.0, 0.05, false, "thickness of the hair over the scalp, metres"),
    };
    add_leaf_keys(keys);
    add_material_keys(keys);
    const std::vector<Key> rest = {
        word_key("light", "light", &Scene::light, {"key", "front", "side", "back", "none"},
                 "rig of lights; lightN.* adds to it"),
        number_key("light", "dome", &Scene::dome, 0.0, 1e4, "radiance of a uniform sky"),
        triple_key("light", "dome.color", &Scene::dome_color, 0.0, 1e4, "factor on dome"),
        environment_key(),
        number_key("light", "environment.intensity", &Scene::environment_intensity, 0.0, 1e4,
                   "factor on its radiance"),
        integer_key("light", "dome.samples", &Scene::dome_samples, 1, 256,
                    "light directions for the sky, in each point of a strand"),
        word_key("light", "shadow", &Scene::shadow,
                 {"grid", "deep_opacity", "opacity_shadow", "none"},
                 "dim lights by the hair in their way: counted in a grid, or in maps of the first "
                 "8 lights (the sky keeps the grid)"),
        integer_key("light", "shadow.layers", &Scene::shadow_layers, 1, 8, "of a map"),
        integer_key("light", "shadow.size", &Scene::shadow_size, 0, 8192,
                    "texels along a map's side, 8 or more; 0: two strand spacings a texel"),
        number_key("camera", "camera.azimuth_deg", &Scene::camera_azimuth, -360.0, 360.0,
                   "0 in front of the face, 90 at the person's left"),
        number_key("camera", "camera.elevation_deg", &Scene::camera_elevation, -89.0, 89.0,
                   "above the horizon"),
        number_key("camera", "camera.distance", &Scene::camera_distance, 0.0, 1e6,
                   "metres to the target; 0: as near as shows the whole groom"),
        number_key("camera", "camera.zoom", &Scene::camera_zoom, 0.01, 1000.0,
                   "divides the distance"),
        number_key("camera", "camera.fov_deg", &Scene::camera_fov, 1.0, 120.0,
                   "vertical angle of view"),
        target_key(),
        number_key("camera", "turn_deg", &Scene::turn, -360.0, 360.0,
                   "turns the groom about the vertical under the same lights"),
        size_key(),
        integer_key("picture", "supersample", &Scene::supersample, 1, 8,
                    "samples along a pixel's side"),
        triple_key("picture", "background", &Scene::background, 0.0, 1e4, "radiance"),
        number_key("picture", "exposure", &Scene::exposure, -20.0, 20.0,
                   "stops, for PNG; EXR stays linear"),
        word_key("picture", "tone", &Scene::tone, {"film", "none"},
                 "for PNG: film curve, or a cut at 1"),
    };
    keys.insert(keys.end(), rest.begin(), rest.end());
    return keys;
}

} // namespace

const std::vector<Key> &keys()
{
    static const std::vector<Key> all = make_keys();
    return all;
}

bool find_key(const std::string &name, Key &key)
{
    for (const Key &candidate : keys()) {
        if (candidate.name == name) {
            key = candidate;
            return true;
        }
    }
    for (int i = 0; i < lights_most; i++) {
        if (name.rfind("light" + std::to_string(i) + ".", 0) == 0) {
            for (const Key &candidate : light_keys(i)) {
                if (candidate.name == name) {
                    key = candidate;
                    return true;
                }
            }
        }
    }
    return false;
}

} // namespace tsuya::scene

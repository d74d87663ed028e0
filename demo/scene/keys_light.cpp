// Keys of single lights and of the surroundings.
#include "scene/keys.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace tsuya::scene {

namespace {

constexpr double far = 1e6;

bool has(const Scene &scene, int index)
{
    return scene.lights.count(index) > 0;
}

Key number(int index, const char *name, double SceneLight::*member, double low, double high,
           const char *help, bool whole = false)
{
    return {"light" + std::to_string(index) + "." + name, "light",
            (whole ? "whole, " : "") + range_text(low, high), help,
            [=](Scene &scene, const std::string &text) {
                double value = 0.0;
                std::string wrong = read_number(text, low, high, value);
                if (wrong.empty() && whole && value != std::floor(value)) {
                    wrong = "is " + number_text(value);
                }
                if (wrong.empty()) {
                    scene.lights[index].*member = value;
                }
                return wrong;
            },
            [=](const Scene &s) {
                const double usual = SceneLight().*member;
                const double value = has(s, index) ? s.lights.at(index).*member : usual;
                return value != usual ? number_text(value) : "";
            }};
}

Key triple(int index, const char *name, glm::dvec3 SceneLight::*member, double low, double high,
           bool zero, bool always, const char *help)
{
    const std::string range = "x,y,z each in " + range_text(low, high);
    return {"light" + std::to_string(index) + "." + name, "light",
            range + (zero ? "" : ", not all 0"), help,
            [=](Scene &scene, const std::string &text) -> std::string {
                glm::dvec3 value{0.0};
                std::string wrong = read_triple(text, low, high, value);
                if (wrong.empty() && !zero && glm::length(value) < 1e-6) {
                    wrong = "is 0,0,0";
                }
                if (wrong.empty()) {
                    scene.lights[index].*member = value;
                }
                return wrong;
            },
            [=](const Scene &s) -> std::string {
                if (!has(s, index)) {
                    return "";
                }
                const glm::dvec3 value = s.lights.at(index).*member;
                return always || value != SceneLight().*member ? triple_text(value) : "";
            }};
}

Key kind(int index)
{
    return {"light" + std::to_string(index) + ".kind", "light", "directional, point, rect, disk",
            "default directional; the others are among the first 8 lights, rig included",
            [=](Scene &scene, const std::string &text) -> std::string {
                if (text != "directional" && text != "point" && text != "rect" && text != "disk") {
                    return "is \"" + text + "\"";
                }
                scene.lights[index].kind = text;
                return "";
            },
            [=](const Scene &s) -> std::string {
                return has(s, index) && s.lights.at(index).kind != "directional"
                           ? s.lights.at(index).kind
                           : "";
            }};
}

} // namespace

std::vector<Key> light_keys(int index)
{
    Key color = triple(index, "color", &SceneLight::color, 0.0, 1e4, true, true,
                       "linear, default 1,1,1");
    color.range = "r,g,b each in [0, 10000]";
    Key intensity = number(index, "intensity", &SceneLight::intensity, 0.0, 1e4,
                           "directional: irradiance on a plane that faces the light; point: "
                           "irradiance at 1 metre; rect, disk: radiance; default 3");
    intensity.get = [=](const Scene &s) {
        return has(s, index) ? number_text(s.lights.at(index).intensity) : "";
    };
    return {
        triple(index, "direction", &SceneLight::direction, -far, far, false, true,
               "towards the light"),
        color,
        intensity,
        kind(index),
        number(index, "angle_deg", &SceneLight::angle, 0.0, 34.0,
               "directional: from the centre of a far disk to its rim, default 0"),
        triple(index, "position", &SceneLight::position, -far, far, true, false,
               "point, rect, disk: centre, metres, default 0,1,1"),
        triple(index, "facing", &SceneLight::facing, -far, far, true, false,
               "rect, disk: where it shines; default 0,0,0: towards the origin"),
        number(index, "width", &SceneLight::width, 1e-5, far,
               "rect: metres along the horizon; disk: diameter; default 0.5"),
        number(index, "height", &SceneLight::height, 1e-5, far, "rect: metres, default 0.5"),
        number(index, "sides", &SceneLight::sides, 1.0, 2.0, "2: shines to both; default 1",
               true),
    };
}

Key environment_key()
{
    return {"environment", "light", "none, gradient, sunset, window or file:PATH",
            "surroundings as harmonics of order 2 and a dominant light; a file is an EXR twice as "
            "wide as high, +y on top, -z in the middle, +x to the right. dome is added",
            [](Scene &scene, const std::string &text) -> std::string {
                const bool file = text.rfind("file:", 0) == 0 && text.size() > 5;
                if (!file && text != "none" && text != "gradient" && text != "sunset" &&
                    text != "window") {
                    return "is \"" + text + "\"";
                }
                scene.environment = text;
                return "";
            },
            [](const Scene &scene) { return scene.environment; }};
}

} // namespace tsuya::scene

// Scenes: what `tsuya render` draws, as text.
//
// A scene file is UTF-8 text, one key=value a line, spaces around both allowed, everything after a
// # a comment. Each key at most once, and tier= without the keys that it sets (tiers.h). What is
// absent takes its default; grammar() prints all keys with range, default and meaning. The
// renderer, the reference and the chooser read the same files.
//
// Angles in files are degrees and carry _deg; lengths are metres; colours linear Rec. 709; the
// world is +y up, +z out of the face, +x to the person's left.
#ifndef TSUYA_SCENE_SCENE_H
#define TSUYA_SCENE_SCENE_H

#include "groom/expected.h"
#include "scene/leaf_material.h"

#include <glm/vec3.hpp>

#include <map>
#include <string>
#include <vector>

namespace tsuya::scene {

using groom::Error;
using groom::Expected;

constexpr int lights_most = 32; // light0 .. light31

// One light of its own.
struct SceneLight {
    glm::dvec3 direction{0.0, 0.0, 1.0}; // towards the light, any length above 0
    glm::dvec3 color{1.0};
    double intensity = 3.0; // irradiance, intensity or radiance: see the keys
    std::string kind = "directional"; // point, rect, disk
    double angle = 0.0;               // degrees
    glm::dvec3 position{0.0, 1.0, 1.0};
    glm::dvec3 facing{0.0}; // 0: towards the origin
    double width = 0.5, height = 0.5;
    double sides = 1.0;

    bool operator==(const SceneLight &other) const;
};

// Which key gave the hair's colour.
enum class ColorBy { preset, sigma_a, melanin, albedo, head_albedo };

// A scene as its keys say it; each field is the key of its name (camera_fov: camera.fov_deg).
struct Scene {
    std::string title;
    std::string kind = "hair"; // leaf, tree
    std::string groom = "straight"; // straight, wavy, curly or file:PATH
    std::map<std::string, double> hair; // keys of grown hair that were given: strands, length, ...
    double unit_scale = 1.0;
    std::string up = "y";
    double fiber_width = 8e-5;
    double width_scale = 1.0;
    double taper = 0.1;
    double variation = 0.1;
    std::string head = "auto";

    std::string mesh = "none"; // or the path of an .obj or .ply file, for a leaf
    std::string pigment_map = "none"; // or the path of a .png or .exr file: see leaf_maps.h
    std::string thickness_map = "none";
    std::string normal_map = "none";
    std::string height_map = "none";
    std::string normal_green = "up";
    double height_mm = 1.0;
    std::string shape = "beech";
    std::map<std::string, double> leaf; // keys of a grown leaf that were given; angles in degrees
    std::map<std::string, double> tree; // keys of a grown tree that were given
    double roundness = 0.0;
    std::string ground = "auto";

    std::string model = "marschner";
    std::string variant = "auto"; // of the model's entry point
    std::string match = "none";   // tier whose mean luminance the hair gets
    // Parameters that were given, under the model's name for them; angles in degrees. Those of
    // other models are kept, so that model= can be switched.
    std::map<std::string, glm::dvec3> parameters;
    ColorBy color_by = ColorBy::preset;
    std::string color = "brown";
    glm::dvec3 sigma_a{0.0};
    glm::dvec3 albedo{0.5};
    glm::dvec3 head_albedo{0.3, 0.2, 0.1};
    LeafWords contents; // what a leaf's material is made of
    double eumelanin = 0.0;
    double pheomelanin = 0.0;

    std::string light = "key"; // rig
    std::map<int, SceneLight> lights;
    double dome = 1.5;
    glm::dvec3 dome_color{1.0};
    std::string environment = "none"; // gradient, sunset, window, file:PATH
    double environment_intensity = 1.0;
    int dome_samples = 24;
    std::string shadow = "grid";
    int shadow_layers = 8;
    int shadow_size = 0;

    double camera_azimuth = 25.0; // degrees, like all angles of the camera
    double camera_elevation = 5.0;
    double camera_distance = 0.0; // 0: as far as the whole groom needs
    double camera_zoom = 1.0;
    double camera_fov = 25.0;
    bool camera_aims = false; // camera_target was given
    glm::dvec3 camera_target{0.0};
    double turn = 0.0;

    int width = 640;
    int height = 640;
    int supersample = 1;
    glm::dvec3 background{0.1, 0.1, 0.105};
    double exposure = 0.0;
    std::string tone = "film";

    bool operator==(const Scene &other) const;
};

// Read a scene file's text over `base`.
//
// name  of the file, for messages
// Errors: no "=", an unknown key, a key twice, two keys that both give the colour, a tier and a key
//         that it sets, a tier of another kind, a value that is no number, not finite or out of
//         range; each names file, line, key and range.
Expected<Scene> parse(const std::string &text, const std::string &name, const Scene &base = {});

// Set keys from words of the form key=value over `base`, as on a command line. A colour replaces
// whatever gave the colour before. Errors: as parse(), with "argument N" for the line.
Expected<Scene> override(const Scene &base, const std::vector<std::string> &words);

// Read the file `path`. A relative file:, mesh or map in it is taken from the file's folder.
// Errors: it cannot be read; and as parse().
Expected<Scene> read(const std::string &path, const Scene &base = {});

// `scene` as a scene file that parse() reads to the same Scene. Keys at their default are left out.
std::string write(const Scene &scene);

// All keys with form, range, default and meaning: what `tsuya scenes --help` prints.
std::string grammar();

} // namespace tsuya::scene

#endif

#include "scene/gallery.h"

#include "scene/build.h"
#include "scene/keys.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace tsuya::scene {

namespace fs = std::filesystem;

Expected<std::vector<Named>> gallery()
{
    std::vector<Named> all;
    const auto add = [&](const std::string &file, Expected<Scene> scene) {
        if (scene) {
            const std::string name = fs::path(file).stem().string();
            all.erase(std::remove_if(all.begin(), all.end(),
                                     [&](const Named &n) { return n.name == name; }),
                      all.end());
            all.push_back({name, std::move(*scene)});
        }
        return scene;
    };
    for (const Source *s = embedded_scenes; s->name; s++) {
        const Expected<Scene> scene = add(s->name, parse(s->text, s->name));
        if (!scene) {
            return Error{scene.error()};
        }
    }
    const char *const folder = std::getenv("TSUYA_SCENES");
    std::error_code failed;
    if (folder) {
        for (const fs::directory_entry &entry : fs::directory_iterator(folder, failed)) {
            if (entry.path().extension() == ".scene") {
                const Expected<Scene> scene = add(entry.path().string(),
                                                  read(entry.path().string()));
                if (!scene) {
                    return Error{scene.error()};
                }
            }
        }
    }
    std::sort(all.begin(), all.end(),
              [](const Named &a, const Named &b) { return a.name < b.name; });
    return Expected<std::vector<Named>>(std::move(all));
}

namespace {

std::string extension_of(const std::string &word)
{
    std::string extension = fs::path(word).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return extension;
}

} // namespace

bool is_groom(const std::string &word)
{
    const std::string extension = extension_of(word);
    return extension == ".tfx" || extension == ".hair" || extension == ".data";
}

bool is_mesh(const std::string &word)
{
    const std::string extension = extension_of(word);
    return extension == ".obj" || extension == ".ply";
}

Expected<Scene> find(const std::string &word)
{
    if (is_groom(word)) {
        Scene scene;
        scene.title = fs::path(word).filename().string();
        scene.groom = "file:" + word;
        return Expected<Scene>(std::move(scene));
    }
    if (is_mesh(word)) {
        Scene scene;
        scene.title = fs::path(word).filename().string();
        scene.kind = "leaf";
        scene.model = "leaf";
        scene.mesh = word;
        return Expected<Scene>(std::move(scene));
    }
    std::error_code failed;
    if (fs::path(word).extension() == ".scene" || fs::is_regular_file(word, failed)) {
        return read(word);
    }
    Expected<std::vector<Named>> all = gallery();
    if (!all) {
        return Error{all.error()};
    }
    std::string names;
    for (const Named &named : *all) {
        if (named.name == word) {
            return named.scene;
        }
        names += (names.empty() ? "" : ", ") + named.name;
    }
    return Error{word + " is no file and no scene; the scenes are " + names};
}

Expected<std::string> suit(Scene &scene, const std::vector<std::string> &given)
{
    const auto has = [&](const char *key) {
        return std::any_of(given.begin(), given.end(), [&](const std::string &word) {
            return word.rfind(std::string(key) + "=", 0) == 0;
        });
    };
    if (scene.groom.rfind("file:", 0) != 0) {
        return std::string();
    }
    Expected<Hair> hair = scene::hair(scene);
    if (!hair) {
        return Error{hair.error()};
    }
    std::string said;
    const groom::Report &report = hair->report;
    const glm::dvec3 extent = glm::dvec3(report.upper) - glm::dvec3(report.lower);
    const double largest = std::max({extent.x, extent.y, extent.z});
    double unit = 1.0;
    if (!report.plausible_size && !has("unit_scale")) {
        unit = 0.3 / largest;
        scene.unit_scale *= unit;
        said += "the groom measures " + number_text(std::round(largest * 1000.0) / 1000.0) +
                " m, which is no head; drawn with unit_scale=" + number_text(scene.unit_scale) +
                "\n";
    }
    if (extent.z > extent.x && !has("camera.azimuth_deg")) {
        scene.camera_azimuth = 100.0;
    }
    if (!has("width_scale")) {
        const double face = std::max({extent.x * extent.y, extent.y * extent.z,
                                      extent.z * extent.x}) * unit * unit;
        const double width = 2.0 * (hair->groom.radius.empty()
                                        ? scene.fiber_width / 2.0
                                        : double(hair->groom.radius[0]) * unit);
        const double area = double(report.strands) * report.mean_length * unit * width;
        // A strand or two have no face that could be covered.
        const bool thin = face < 4.0 * width * width || report.strands < 3;
        const double scale = thin ? 1.0 : std::clamp(1.5 * face / area, 0.05, 50.0);
        scene.width_scale = std::round(scale * 100.0) / 100.0;
        said += "drawn with width_scale=" + number_text(scene.width_scale) + "\n";
    }
    return said;
}

} // namespace tsuya::scene

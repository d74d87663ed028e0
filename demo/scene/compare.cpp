// `tsuya compare`: tiers of the renderer against a traced picture.
#include "scene/compare.h"

#include "command/arguments.h"
#include "command/commands.h"
#include "command/json.h"
#include "image/figures.h"
#include "scene/gallery.h"
#include "scene/keys.h"
#include "scene/match.h"
#include "scene/picture.h"
#include "scene/sheet.h"
#include "scene/tiers.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace tsuya::scene {

namespace {

// Whether the tracer reads a key.
bool traced_key(const Key &key)
{
    static const std::vector<std::string> renderer = {
        "title",        "shadow",      "shadow.layers", "shadow.size",
        "dome.samples", "supersample", "exposure",      "tone"};
    static const std::vector<std::string> fibre = {
        "color", "sigma_a",     "eumelanin",  "pheomelanin", "albedo",      "head_albedo",
        "eta",   "alpha_R_deg", "beta_R_deg", "beta_az_deg", "scale_shifts"};
    const auto among = [&](const std::vector<std::string> &names) {
        return std::find(names.begin(), names.end(), key.name) != names.end();
    };
    return key.group == "material" ? among(fibre) : !among(renderer);
}

std::string plain(const std::string &value)
{
    return value.rfind("file:", 0) == 0
               ? "file:" + std::filesystem::path(value.substr(5)).filename().string()
               : value;
}

} // namespace

std::string difference(const Scene &scene, const image::Image &picture)
{
    if (picture.width != scene.width || picture.height != scene.height) {
        return "is " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
               " but the scene's size is " + std::to_string(scene.width) + "x" +
               std::to_string(scene.height);
    }
    const auto text = picture.texts.find("tsuya.scene");
    if (text == picture.texts.end()) {
        return "";
    }
    const Expected<Scene> there = parse(text->second, "its scene");
    if (!there) {
        return "holds a scene that cannot be read: " + there.error();
    }
    for (const Key &key : keys()) {
        const std::string here = plain(key.get(scene)), was = plain(key.get(*there));
        if (traced_key(key) && here != was) {
            const auto said = [](const std::string &value) {
                return value.empty() ? std::string("not given") : value;
            };
            return "is of another scene: " + key.name + " is " + said(was) + " there and " +
                   said(here) + " here";
        }
    }
    return scene.lights == there->lights ? "" : "is of another scene: its lightN.* differ";
}

namespace {

const command::Manual &manual()
{
    static const command::Manual text = {
        "compare",
        "SCENE|FILE [key=value ...] tier=NAME [tier=NAME ...] | --all --reference FILE.exr",
        "Draw a scene of hair by tiers and print their errors against FILE.exr, which\n"
        "tsuya reference wrote of the same scene; SCENE and words are those of tsuya render.\n"
        "Model, variant and shadow of the scene do not matter: each tier sets its own.\n\n"
        "rel MSE    squared difference over squared brightness, mean over the pixels that hair\n"
        "           covers by more than 0.3 and over R, G, B; brightness is the traced one's mean\n"
        "           over 5x5 pixels, and at least a tenth of the hair's\n"
        "rms        its square root\n"
        "luminance  error of the hair's mean luminance, signed\n\n"
        "Behind +- stand standard errors from the noise of the traced picture, which itself is\n"
        "taken out of rel MSE. A map shows (Y - Y traced) / brightness of each pixel: white 0, "
        "red\n"
        "too bright, blue too dark, deepest at 1 and beyond, grey no hair; a strip below shows "
        "the\n"
        "scale from -1 to 1. Nothing is traced here, so this needs no Embree.",
        {{"--reference", "FILE", "traced picture, .exr"},
         {"--all", "", "every tier of hair"},
         {"--size", "WxH", "short for size=WxH"},
         {"--map", "FILE", "map of the errors to write, .png; of several tiers FILE_TIER.png"},
         {"--sheet", "FILE", "contact sheet to write, .png: traced, tiers, maps of their errors"},
         {"--json", "", "print JSON"}},
        "  tsuya reference straight-brown --size 256x256 -o brown.exr\n"
        "  tsuya compare straight-brown --size 256x256 --all --reference brown.exr\n"
        "  tsuya compare straight-brown --size 256x256 tier=zinke tier=exact \\\n"
        "      --reference brown.exr --map errors.png\n"};
    return text;
}

// What is asked.
struct Task {
    Scene scene;
    std::string said; // about a groom from a file
    std::vector<Tier> tiers;
    std::string reference, map, sheet;
    bool json = false;
};

Expected<Task> task_of(const command::Arguments &arguments)
{
    Task task;
    task.reference = arguments.get("--reference");
    task.map = arguments.get("--map");
    task.sheet = arguments.get("--sheet");
    task.json = arguments.has("--json");
    const std::vector<std::string> &words = arguments.positional();
    if (words.empty()) {
        return Error{"no scene is given; tsuya scenes lists them"};
    }
    std::vector<std::string> changes;
    for (std::size_t i = 1; i < words.size(); i++) {
        if (words[i].rfind("tier=", 0) != 0) {
            changes.push_back(words[i]);
            continue;
        }
        const std::string name = words[i].substr(5);
        const Tier *const tier = find_tier(name);
        if (!tier || tier->leaf) {
            return Error{(tier ? "tier=" + name + " shades leaves, which have no reference"
                               : "there is no tier " + (name.empty() ? "\"\"" : name)) +
                         "; the tiers of hair are " + tier_names(false)};
        }
        for (const Tier &other : task.tiers) {
            if (other.name == name) {
                return Error{"tier=" + name + " is given twice"};
            }
        }
        task.tiers.push_back(*tier);
    }
    if (arguments.has("--all")) {
        if (!task.tiers.empty()) {
            return Error{"tier=" + task.tiers[0].name + " and --all are both given; keep one"};
        }
        std::copy_if(tiers().begin(), tiers().end(), std::back_inserter(task.tiers),
                     [](const Tier &tier) { return !tier.leaf; });
    }
    if (arguments.has("--size")) {
        changes.push_back("size=" + arguments.get("--size"));
    }
    Expected<Scene> found = find(words[0]);
    found = found ? override(*found, changes) : std::move(found);
    if (!found) {
        return Error{found.error()};
    }
    task.scene = std::move(*found);
    if (task.scene.kind != "hair") {
        return Error{"the path tracer knows hair alone; this scene is a " + task.scene.kind};
    }
    if (task.tiers.empty()) {
        return Error{"no tier=NAME is given, nor --all; the tiers of hair are " +
                     tier_names(false)};
    }
    if (task.reference.empty()) {
        return Error{"--reference FILE.exr is missing; tsuya reference writes it"};
    }
    if (arguments.has("--map") && std::filesystem::path(task.map).extension() != ".png") {
        return Error{"--map " + task.map + " must end in .png"};
    }
    if (arguments.has("--sheet") && std::filesystem::path(task.sheet).extension() != ".png") {
        return Error{"--sheet " + task.sheet + " must end in .png"};
    }
    if (is_groom(words[0])) {
        const Expected<std::string> suited = suit(task.scene, changes);
        if (!suited) {
            return Error{suited.error()};
        }
        task.said = *suited;
    }
    return Expected<Task>(std::move(task));
}

// The scene by every tier.
Expected<std::vector<draw::Picture>> drawn(const Task &task, Studio &studio, const Hair &hair,
                                           const Surroundings &around)
{
    std::vector<draw::Picture> result;
    Expected<bool> good = studio.renderer().load(hair.groom, hair.head, hair.solid);
    for (const Tier &tier : task.tiers) {
        const Expected<Scene> scene = override(task.scene, {"tier=" + tier.name});
        if (!scene) {
            return Error{scene.error()};
        }
        const Expected<Material> material = scene::material(*scene);
        if (!material) {
            return Error{material.error()};
        }
        draw::Renderer &renderer = studio.renderer();
        good = good ? renderer.material(material->model, material->params.data(), material->variant)
                    : std::move(good);
        const Expected<float> gain =
            good ? match(renderer, *scene, hair, around) : Expected<float>(Error{good.error()});
        if (!gain) {
            return Error{gain.error()};
        }
        draw::Frame frame = scene::frame(*scene, hair, *material, 0.0, false, around);
        frame.gain = *gain;
        good = renderer.draw(frame);
        if (!good) {
            return Error{good.error()};
        }
        if (!material->note.empty()) {
            std::fprintf(stderr, "tsuya compare: %s.\n", material->note.c_str());
        }
        if (!renderer.note().empty()) {
            std::fprintf(stderr, "tsuya compare: %s.\n", renderer.note().c_str());
        }
        result.push_back(renderer.picture());
    }
    return Expected<std::vector<draw::Picture>>(std::move(result));
}

std::string plain_report(const Task &task, const std::vector<image::Figures> &figures,
                         std::size_t pixels)
{
    char line[256];
    std::snprintf(line, sizeof line,
                  "hair pixels      %zu\n"
                  "hair luminance   %.6g +- %.2g traced, weighed by coverage\n\n"
                  "%-16s %-22s %-20s %s\n",
                  pixels, figures[0].mean.value, figures[0].mean.error, "tier", "rel MSE", "rms",
                  "luminance");
    std::string text = task.said + line;
    for (std::size_t k = 0; k < figures.size(); k++) {
        const image::Figures &f = figures[k];
        const image::Figure rms = image::rms(f.rel_mse);
        char mse[64], root[64];
        std::snprintf(mse, sizeof mse, "%.4f +- %.4f", f.rel_mse.value, f.rel_mse.error);
        std::snprintf(root, sizeof root, "%.4f +- %.4f", rms.value, rms.error);
        std::snprintf(line, sizeof line, "%-16s %-22s %-20s %+.2f +- %.2f %%\n",
                      task.tiers[k].name.c_str(), mse, root, 100.0 * f.mean_error.value,
                      100.0 * f.mean_error.error);
        text += line;
    }
    return text;
}

void put(command::Json &json, const std::string &name, const image::Figure &figure)
{
    json.field(name, figure.value).field(name + "_se", figure.error);
}

std::string json_report(const Task &task, const std::vector<image::Figures> &figures,
                        std::size_t pixels, const image::Image &reference)
{
    command::Json json;
    json.open('{').field("reference", std::string_view(task.reference));
    const auto samples = reference.texts.find("tsuya.samples");
    double count = 0.0;
    json.key("samples");
    if (samples != reference.texts.end() && number_value(samples->second, count)) {
        json.value(count);
    } else {
        json.value(static_cast<const char *>(nullptr));
    }
    json.field("width", std::uint64_t(reference.width))
        .field("height", std::uint64_t(reference.height))
        .field("hair_pixels", std::uint64_t(pixels));
    put(json, "hair_luminance", figures[0].mean);
    json.key("tiers").open('[');
    for (std::size_t k = 0; k < figures.size(); k++) {
        json.open('{').field("tier", std::string_view(task.tiers[k].name));
        put(json, "rel_mse", figures[k].rel_mse);
        put(json, "rms", image::rms(figures[k].rel_mse));
        put(json, "luminance", figures[k].mean_error);
        json.close();
    }
    return json.close().close().text();
}

std::string map_path(const Task &task, const std::string &tier)
{
    return task.tiers.size() == 1 ? task.map
                                  : task.map.substr(0, task.map.size() - 4) + "_" + tier + ".png";
}

int complain(const std::string &text, int code = command::exit_bad_input)
{
    const bool dot = !text.empty() && (text.back() == '.' || text.back() == '\n');
    return command::complain("compare", text + (dot ? "" : "."), code);
}

int compare(const Task &task)
{
    image::Image reference;
    image::Traced traced;
    std::string error;
    if (!image::read_exr(task.reference, reference, error)) {
        return complain(error);
    }
    if (!image::traced(reference, traced, error)) {
        return complain(task.reference + " is no traced picture: " + error);
    }
    error = difference(task.scene, reference);
    if (!error.empty()) {
        return complain(task.reference + " " + error);
    }
    const Expected<Surroundings> around = surroundings(task.scene);
    const Expected<Hair> hair = scene::hair(task.scene);
    if (!around || !hair) {
        return complain(around ? hair.error() : around.error());
    }
    if (!hair->note.empty()) {
        std::fprintf(stderr, "tsuya compare: %s.\n", hair->note.c_str());
    }
    const Expected<std::unique_ptr<Studio>> studio = Studio::create();
    if (!studio) {
        return complain(studio.error(), command::exit_failure);
    }
    const Expected<std::vector<draw::Picture>> pictures = drawn(task, **studio, *hair, *around);
    if (!pictures) {
        return complain(pictures.error());
    }
    std::vector<image::Pixels> pixels;
    for (const draw::Picture &picture : *pictures) {
        pixels.push_back(picture.pixels.data());
    }
    const std::size_t count = image::hair_pixels(traced, pixels[0]);
    if (count == 0) {
        return complain("hair covers no pixel of this scene by more than 0.3");
    }
    const std::vector<image::Figures> figures = image::figures(traced, pixels);
    if (!(figures[0].mean.value > 0.0)) {
        return complain("the hair in " + task.reference +
                        " is black; errors are shares of its light");
    }
    if (!task.sheet.empty() &&
        !image::write_png(task.sheet, sheet(task.scene, traced, *pictures), error)) {
        return complain(error, command::exit_failure);
    }
    for (std::size_t k = 0; k < pixels.size() && !task.map.empty(); k++) {
        if (!image::write_png(map_path(task, task.tiers[k].name),
                              image::error_map(traced, pixels[k]), error)) {
            return complain(error, command::exit_failure);
        }
    }
    if (!reference.texts.count("tsuya.scene")) {
        std::fprintf(stderr, "tsuya compare: %s does not say of what scene it is.\n",
                     task.reference.c_str());
    }
    return command::print("compare", task.json ? json_report(task, figures, count, reference)
                                               : plain_report(task, figures, count));
}

} // namespace

} // namespace tsuya::scene

int command_compare(int argc, char **argv)
{
    using namespace tsuya;
    command::Arguments arguments;
    std::string error;
    if (!arguments.parse(scene::manual(), argc, argv, error)) {
        return scene::complain(error);
    }
    if (arguments.help()) {
        return command::print("compare", command::help_text(scene::manual()));
    }
    const scene::Expected<scene::Task> task = scene::task_of(arguments);
    return task ? scene::compare(*task) : scene::complain(task.error());
}

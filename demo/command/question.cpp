#include "question.h"

#include "commands.h"

#include "scene/gallery.h"
#include "scene/keys.h"
#include "scene/leaf_traits.h"
#include "scene/tiers.h"
#include "scene/traits.h"

#include <tsuya/leaf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tsuya::command {

using groom::Error;
using groom::Expected;

namespace {

const std::vector<std::pair<std::string, tsu_choose_gpu>> gpus = {{"navi21", TSU_CHOOSE_NAVI21},
                                                                  {"navi10", TSU_CHOOSE_NAVI10},
                                                                  {"vega10", TSU_CHOOSE_VEGA10},
                                                                  {"gfx1100", TSU_CHOOSE_GFX1100}};

// Words that are not keys of a scene: the wish, the host, the frame before.
struct Wish {
    const char *name;
    double low, high;
    bool whole;
    void (*set)(tsu_choose_desc &desc, double value);
};
const Wish wishes[] = {
    {"bound", 1e-6, 1e6, false, [](tsu_choose_desc &d, double v) { d.error_bound = float(v); }},
    {"luminance_bound", 1e-6, 1e6, false,
     [](tsu_choose_desc &d, double v) { d.luminance_bound = float(v); }},
    {"budget", 1e-3, 1e12, false, [](tsu_choose_desc &d, double v) { d.cost_budget = float(v); }},
    {"samplers", 0.0, 4294967295.0, true,
     [](tsu_choose_desc &d, double v) { d.samplers = std::uint32_t(v); }},
    {"memory", 0.0, 4294967295.0, true,
     [](tsu_choose_desc &d, double v) { d.memory = std::uint32_t(v); }},
    {"hysteresis", 0.0, 1.0, false, [](tsu_choose_desc &d, double v) { d.hysteresis = float(v); }},
};

template <class From> void light(const From &from, tsu_choose_desc &desc)
{
    desc.covered_pixels = float(from.covered_pixels);
    desc.sky_share = float(from.sky_share);
    desc.light_cosine = float(from.light_cosine);
    desc.directional_lights = std::uint32_t(from.directional_lights);
    desc.point_lights = std::uint32_t(from.point_lights);
    desc.area_lights = std::uint32_t(from.area_lights);
    desc.environments = std::uint32_t(from.environments);
}

void put_light(Question &question)
{
    const tsu_choose_desc &d = question.desc;
    const Traits light = {{"covered_pixels", {double(d.covered_pixels)}},
                          {"directional_lights", {double(d.directional_lights)}},
                          {"point_lights", {double(d.point_lights)}},
                          {"area_lights", {double(d.area_lights)}},
                          {"environments", {double(d.environments)}},
                          {"sky_share", {double(d.sky_share)}},
                          {"light_cosine", {double(d.light_cosine)}}};
    question.traits.insert(question.traits.end(), light.begin(), light.end());
}

std::string ask_hair(const scene::Scene &asked, Question &question)
{
    tsu_choose_desc &desc = question.desc;
    desc.shadow = TSU_CHOOSE_SHADOW_MAPS;
    if (asked.shadow == "none" || asked.shadow == "grid") {
        desc.shadow = asked.shadow == "none" ? TSU_CHOOSE_SHADOW_NONE : TSU_CHOOSE_SHADOW_COUNT;
    }
    // The fibre is the same whatever the model.
    scene::Scene scene = asked;
    scene.model = "marschner";
    scene.variant = "auto";
    const Expected<scene::Material> material = scene::material(scene);
    if (!material) {
        return material.error();
    }
    const Expected<scene::Surroundings> around = scene::surroundings(scene);
    if (!around) {
        return around.error();
    }
    const Expected<scene::Hair> hair = scene::hair(scene);
    if (!hair) {
        return hair.error();
    }
    if (!hair->note.empty()) {
        complain("choose", hair->note + ".", exit_ok);
    }
    const draw::Frame frame = scene::frame(scene, *hair, *material, 0.0, false, *around);
    const scene::Traits traits = scene::traits(scene, *hair, *material, frame);
    desc.kind = TSU_CHOOSE_HAIR;
    std::copy_n(&traits.sigma_a.x, 3, desc.sigma_a);
    desc.beta_R = float(traits.beta_R);
    desc.strand_pixels = float(traits.strand_pixels);
    desc.depth = float(traits.depth);
    desc.curl = float(traits.curl);
    light(traits, desc);
    question.traits = {{"sigma_a", {traits.sigma_a.x, traits.sigma_a.y, traits.sigma_a.z}},
                       {"beta_R", {traits.beta_R}},
                       {"strand_pixels", {traits.strand_pixels}},
                       {"depth", {traits.depth}},
                       {"curl", {traits.curl}},
                       {"shadow", {double(desc.shadow)}}};
    put_light(question);
    return "";
}

std::string ask_leaf(const Host &host, const scene::Scene &scene, Question &question)
{
    const Expected<scene::Material> material = scene::material(scene);
    if (!material) {
        return material.error();
    }
    if (!scene::has_leaf(material->model)) {
        return "model is " + scene.model + ", which is no leaf; say model=leaf";
    }
    tsu_leaf_report report;
    tsu_leaf_report_init(&report);
    const tsu_status status =
        tsu_leaf_measure(host.context(), material->model, material->params.data(), &report);
    if (status != TSU_OK) {
        return host.why(status);
    }
    const Expected<scene::Surroundings> around = scene::surroundings(scene);
    if (!around) {
        return around.error();
    }
    const Expected<scene::Surface> surface = scene::surface(scene);
    if (!surface) {
        return surface.error();
    }
    const scene::LeafTraits traits =
        scene::traits(scene, *surface, scene::frame(scene, *surface, 0.0, false, *around));
    tsu_choose_desc &desc = question.desc;
    desc.kind = TSU_CHOOSE_LEAF;
    const auto colour = [&](const char *name, const double *from, float *to) {
        std::copy_n(from, 3, to);
        question.traits.push_back({name, {from[0], from[1], from[2]}});
    };
    colour("R_top", report.R_top, desc.R_top);
    colour("R_bottom", report.R_bottom, desc.R_bottom);
    colour("T", report.T, desc.T);
    desc.footprint = float(traits.footprint);
    desc.curvature = float(traits.curvature);
    const bool coat = scene.model == "leaf";
    desc.flags |= traits.backlit ? std::uint32_t(TSU_CHOOSE_BACKLIT) : 0;
    desc.flags |= traits.varies ? std::uint32_t(TSU_CHOOSE_PIGMENT_MAP) : 0;
    desc.flags |= coat ? std::uint32_t(TSU_CHOOSE_COAT) : 0;
    light(traits, desc);
    const Traits own = {{"footprint", {traits.footprint}},
                        {"curvature", {traits.curvature}},
                        {"backlit", {double(traits.backlit)}},
                        {"pigment_map", {double(traits.varies)}},
                        {"coat", {double(coat)}}};
    question.traits.insert(question.traits.end(), own.begin(), own.end());
    put_light(question);
    return "";
}

// Take a word of the command's own. Returns: false when it is none.
bool take(const std::string &word, tsu_choose_desc &desc, std::string &previous, std::string &error)
{
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const std::string text = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (name == "previous") {
        previous = text;
        desc.previous = tsu_tier_find(text.c_str());
        error = desc.previous == TSU_TIER_NONE
                    ? "previous is \"" + text + "\" but must be one of " +
                          scene::tier_names(false) + "; of leaves: " + scene::tier_names(true)
                    : "";
        return true;
    }
    for (const Wish &wish : wishes) {
        if (name == wish.name) {
            double value = 0.0;
            error = scene::read_number(text, wish.low, wish.high, value);
            error = error.empty() && wish.whole && value != std::floor(value)
                        ? "is " + scene::number_text(value)
                        : error;
            error = error.empty()
                        ? ""
                        : name + " " + error + " but must be " + (wish.whole ? "whole, " : "") +
                              "in " + scene::range_text(wish.low, wish.high);
            wish.set(desc, value);
            return true;
        }
    }
    return false;
}

} // namespace

Expected<Question> question_of(const Host &host, const Arguments &arguments)
{
    Question question;
    tsu_choose_desc_init(&question.desc);
    const std::vector<std::string> &words = arguments.positional();
    if (words.empty()) {
        return Error{"no scene is given; tsuya scenes lists them"};
    }
    std::vector<std::string> changes, own;
    std::string previous;
    for (std::size_t i = 1; i < words.size(); i++) {
        std::string error;
        const std::string name = words[i].substr(0, words[i].find('='));
        if (!take(words[i], question.desc, previous, error)) {
            changes.push_back(words[i]);
            continue;
        }
        if (std::find(own.begin(), own.end(), name) != own.end()) {
            error = name + " is given twice";
        }
        own.push_back(name);
        if (!error.empty()) {
            return Error{error};
        }
    }
    if (arguments.has("--size")) {
        changes.push_back("size=" + arguments.get("--size"));
    }
    if (arguments.has("--target")) {
        question.gpu = arguments.get("--target");
        question.desc.gpu = 0;
        std::vector<std::string> names;
        for (const auto &gpu : gpus) {
            names.push_back(gpu.first);
            question.desc.gpu = gpu.first == question.gpu ? gpu.second : question.desc.gpu;
        }
        if (question.desc.gpu == 0) {
            return Error{"--target is \"" + question.gpu + "\" but must be one of " +
                         joined(names)};
        }
    }
    Expected<scene::Scene> scene = scene::find(words[0]);
    scene = scene ? scene::override(*scene, changes) : std::move(scene);
    if (!scene) {
        return Error{scene.error()};
    }
    const bool leaf = scene->kind != "hair";
    if (!previous.empty() && scene::find_tier(previous)->leaf != leaf) {
        return Error{"previous is " + previous + " but the scene's kind is " + scene->kind};
    }
    if (scene::is_groom(words[0])) {
        const Expected<std::string> suited = scene::suit(*scene, changes);
        if (!suited) {
            return Error{suited.error()};
        }
        question.said = *suited;
    }
    const std::string wrong = leaf ? ask_leaf(host, *scene, question) : ask_hair(*scene, question);
    return wrong.empty() ? Expected<Question>(std::move(question)) : Error{wrong};
}

} // namespace tsuya::command

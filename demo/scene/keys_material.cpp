#include "scene/keys.h"
#include "scene/tiers.h"

#include <tsuya/hair_color.h>
#include <tsuya/model.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tsuya::scene {

namespace {

constexpr double degree = 0.01745329251994329577;

// A colour key: it also notes that the colour comes from here.
Key colored(Key key, ColorBy by)
{
    const auto set = key.set;
    const auto get = key.get;
    key.set = [=](Scene &scene, const std::string &text) {
        std::string wrong = set(scene, text);
        if (wrong.empty()) {
            scene.color_by = by;
        }
        return wrong;
    };
    key.get = [=](const Scene &scene) { return scene.color_by == by ? get(scene) : ""; };
    return key;
}

std::vector<std::string> preset_names()
{
    std::vector<std::string> names;
    for (uint32_t i = 0; i < tsu_hair_preset_count(); i++) {
        tsu_hair_preset_info info;
        tsu_hair_preset_info_init(&info);
        if (tsu_hair_preset(i, &info) == TSU_OK) {
            names.push_back(info.name);
        }
    }
    return names;
}

std::vector<std::string> model_names()
{
    std::vector<std::string> names;
    for (uint32_t i = 0; i < tsu_model_count(); i++) {
        tsu_model_info info;
        tsu_model_info_init(&info);
        tsu_model_describe(tsu_model_at(i), &info);
        names.push_back(info.name);
    }
    return names;
}

std::vector<std::string> variant_names()
{
    std::vector<std::string> names = {"auto", "plain"};
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        tsu_variant_info variant;
        tsu_variant_info_init(&variant);
        for (uint32_t i = 0; tsu_model_variant(tsu_model_at(m), i, &variant) == TSU_OK; i++) {
            if (std::find(names.begin(), names.end(), variant.name) == names.end()) {
                names.push_back(variant.name);
            }
        }
    }
    return names;
}

std::vector<std::string> match_names()
{
    std::vector<std::string> names = {"none"};
    for (const Tier &tier : tiers()) {
        if (!tier.leaf) {
            names.push_back(tier.name);
        }
    }
    return names;
}

// A shorthand for others: it has no value of its own.
Key tier_key()
{
    return {"tier", "material", tier_names(false) + "; of leaves: " + tier_names(true),
            "how much to spend: sets model, variant and shadow (deep_opacity; none when unshadowed), "
            "or a leaf's\n      model, variant and, for one pigment and thickness, leaf.texels=0 "
            "and tree.variation=0",
            [](Scene &scene, const std::string &text) -> std::string {
                const Tier *const tier = find_tier(text);
                if (!tier) {
                    return "is \"" + text + "\"";
                }
                for (const std::string &word : tier->words) {
                    const std::size_t equals = word.find('=');
                    Key key;
                    const std::string wrong = find_key(word.substr(0, equals), key)
                                                  ? key.set(scene, word.substr(equals + 1))
                                                  : "sets " + word;
                    if (!wrong.empty()) {
                        return wrong;
                    }
                }
                return "";
            },
            [](const Scene &) { return ""; }};
}

// One key for each parameter of any model, but colour, which has keys of its own.
void add_parameters(std::vector<Key> &keys)
{
    const std::size_t before = keys.size();
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        tsu_model_info info;
        tsu_model_info_init(&info);
        tsu_model_describe(tsu_model_at(m), &info);
        for (uint32_t i = 0; i < info.parameter_count; i++) {
            tsu_parameter_info p;
            tsu_parameter_info_init(&p);
            tsu_model_parameter(tsu_model_at(m), i, &p);
            const bool angle = !std::strcmp(p.unit, "rad");
            const std::string field = p.name, name = field + (angle ? "_deg" : "");
            bool known = field == "sigma_a";
            for (std::size_t k = before; k < keys.size(); k++) {
                known = known || keys[k].name == name;
            }
            if (known) {
                continue;
            }
            const double unit = angle ? degree : 1.0;
            // Degrees of a table limit in radians come out a few 1e-15 off.
            const double low = std::round(p.minimum / unit * 1e9) / 1e9;
            const double high = std::round(p.maximum / unit * 1e9) / 1e9;
            const bool triple = p.count == 3;
            keys.push_back(
                {name, "material", (triple ? "a,b,c each in " : "") + range_text(low, high),
                 std::string(p.help) + "; default " +
                     number_text(std::round(p.default_value / unit * 1e6) / 1e6),
                 [=](Scene &scene, const std::string &text) {
                     glm::dvec3 value{0.0};
                     std::string wrong = triple ? read_triple(text, low, high, value)
                                                : read_number(text, low, high, value.x);
                     if (wrong.empty()) {
                         scene.parameters[field] = value;
                     }
                     return wrong;
                 },
                 [=](const Scene &scene) -> std::string {
                     const auto found = scene.parameters.find(field);
                     if (found == scene.parameters.end()) {
                         return "";
                     }
                     return triple ? triple_text(found->second) : number_text(found->second.x);
                 }});
        }
    }
}

} // namespace

void add_material_keys(std::vector<Key> &keys)
{
    const std::vector<Key> fixed = {
        tier_key(),
        word_key("material", "model", &Scene::model, model_names(), "shading model"),
        word_key("material", "variant", &Scene::variant, variant_names(),
                 "entry point of the model; auto: finite where there is one, else plain"),
        word_key("material", "match", &Scene::match, match_names(),
                 "draw hair as bright as this tier would: its light times a factor that is "
                 "measured in small pictures of both"),
        colored(word_key("material", "color", &Scene::color, preset_names(), "a natural colour"),
                ColorBy::preset),
        colored(triple_key("material", "sigma_a", &Scene::sigma_a, 0.0, 1e6,
                           "absorption per fibre radius; in place of color"),
                ColorBy::sigma_a),
        colored(number_key("material", "eumelanin", &Scene::eumelanin, 0.0, 100.0,
                           "dark pigment; with pheomelanin in place of color"),
                ColorBy::melanin),
        colored(number_key("material", "pheomelanin", &Scene::pheomelanin, 0.0, 100.0,
                           "red pigment"),
                ColorBy::melanin),
        colored(triple_key("material", "albedo", &Scene::albedo, 0.0, 1.0,
                           "of one fibre, above its surface reflection (0.099 at eta 1.55); in "
                           "place of color"),
                ColorBy::albedo),
        colored(triple_key("material", "head_albedo", &Scene::head_albedo, 0.0, 1.0,
                           "of thick hair: the colour that is seen, above what surfaces reflect "
                           "(0.013 with default fibres); in place of color"),
                ColorBy::head_albedo),
    };
    keys.insert(keys.end(), fixed.begin(), fixed.end());
    add_leaf_material_keys(keys);
    add_parameters(keys);
}

} // namespace tsuya::scene

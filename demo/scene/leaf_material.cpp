#include "scene/leaf_material.h"

#include <algorithm>
#include <cstring>

namespace tsuya::scene {

namespace {

// A number of the library's descriptors by the name of its key.
template <typename Numbers> struct Field {
    const char *name;
    double Numbers::*number;
};

constexpr Field<tsu_leaf_pigments> contents[] = {{"N", &tsu_leaf_pigments::N},
                                                 {"chlorophyll", &tsu_leaf_pigments::chlorophyll},
                                                 {"carotenoids", &tsu_leaf_pigments::carotenoids},
                                                 {"anthocyanins", &tsu_leaf_pigments::anthocyanins},
                                                 {"brown", &tsu_leaf_pigments::brown},
                                                 {"water", &tsu_leaf_pigments::water},
                                                 {"dry_matter", &tsu_leaf_pigments::dry_matter},
                                                 {"bottom", &tsu_leaf_pigments::bottom}};

const tsu_parameter_info *parameter(const tsu_model *model, const char *name,
                                    tsu_parameter_info &info)
{
    tsu_parameter_info_init(&info);
    for (std::uint32_t i = 0; tsu_model_parameter(model, i, &info) == TSU_OK; i++) {
        if (!std::strcmp(info.name, name)) {
            return &info;
        }
    }
    return nullptr;
}

// The index that the material already has.
double index_of(const tsu_model *model, const void *params)
{
    tsu_parameter_info info;
    float n = 1.45f;
    if (parameter(model, "n", info)) {
        std::memcpy(&n, static_cast<const char *>(params) + info.offset, sizeof n);
    }
    return double(n);
}

void copy(const glm::dvec3 &from, double to[3])
{
    for (int k = 0; k < 3; k++) {
        to[k] = from[k];
    }
}

} // namespace

const std::vector<LeafKey> &leaf_keys()
{
    static const std::vector<LeafKey> keys = {
        {"N", false, 1.0, 10.0,
         "structure of the leaf, 1 to 3.5; over the name's, as all contents"},
        {"chlorophyll", false, 0.0, 1e6, "ug/cm2, 0 to 100"},
        {"carotenoids", false, 0.0, 1e6, "ug/cm2, 0 to 25"},
        {"anthocyanins", false, 0.0, 1e6, "ug/cm2, 0 to 40"},
        {"brown", false, 0.0, 1e6, "brown pigments, 0 to 1.5"},
        {"water", false, 0.0, 1e6, "cm, 0.001 to 0.05"},
        {"dry_matter", false, 0.0, 1e6, "g/cm2, 0.001 to 0.03"},
        {"bottom", false, 0.25, 4.0, "R_bottom over R_top, as far as two layers can do it"},
        {"R_top", true, 0.0, 1.0,
         "reflectance of the top at normal incidence, gloss included; with T in place of leaf"},
        {"R_bottom", true, 0.0, 1.0, "reflectance of the underside; 1.4 R_top by default"},
        {"T", true, 0.0, 1.0, "transmittance at normal incidence"}};
    return keys;
}

LeafBy leaf_by(const std::string &key)
{
    if (key == "leaf") {
        return LeafBy::contents;
    }
    for (const LeafKey &known : leaf_keys()) {
        if (key == known.name) {
            return known.face ? LeafBy::faces : LeafBy::contents;
        }
    }
    return LeafBy::nothing;
}

std::vector<std::string> leaf_names()
{
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < tsu_leaf_preset_count(); i++) {
        names.push_back(tsu_leaf_preset_name(i));
    }
    return names;
}

bool LeafWords::operator==(const LeafWords &other) const
{
    return name == other.name && values == other.values;
}

bool has_leaf(const tsu_model *model)
{
    tsu_parameter_info info;
    return parameter(model, "scatter_top", info) != nullptr;
}

std::string set_leaf(tsu_context *context, const tsu_model *model, const LeafWords &leaf,
                     void *params, tsu_status &status)
{
    status = TSU_OK;
    const auto &values = leaf.values;
    bool faces = false, inside = !leaf.name.empty();
    for (const LeafKey &key : leaf_keys()) {
        (key.face ? faces : inside) |= values.count(key.name) != 0;
    }
    if (faces && inside) {
        return "R_top, R_bottom and T take the place of a leaf's name and contents; give either";
    }
    if (faces) {
        if (!values.count("R_top") || !values.count("T")) {
            return std::string(values.count("R_top") ? "T" : "R_top") +
                   " is missing: R_top and T go together";
        }
        tsu_leaf_reflectance reflectance;
        tsu_leaf_reflectance_init(&reflectance);
        const glm::dvec3 top = values.at("R_top");
        const auto bottom = values.find("R_bottom");
        reflectance.n = index_of(model, params);
        copy(top, reflectance.R_top);
        copy(bottom == values.end() ? 1.4 * top : bottom->second, reflectance.R_bottom);
        copy(values.at("T"), reflectance.T);
        status = tsu_leaf_from_reflectance(context, model, &reflectance, params, nullptr);
        return "";
    }
    if (!inside) {
        return "";
    }
    tsu_leaf_pigments pigments;
    tsu_leaf_pigments_init(&pigments);
    const std::vector<std::string> names = leaf_names();
    const auto named = std::find(names.begin(), names.end(), leaf.name);
    if (!leaf.name.empty() && named == names.end()) {
        return "there is no leaf \"" + leaf.name + "\"";
    }
    if (named != names.end()) {
        tsu_leaf_preset(std::uint32_t(named - names.begin()), &pigments);
    }
    for (const auto &field : contents) {
        const auto given = values.find(field.name);
        if (given != values.end()) {
            pigments.*field.number = given->second.x;
        }
    }
    pigments.n = index_of(model, params);
    status = tsu_leaf_from_pigments(context, model, &pigments, params, nullptr);
    return "";
}

} // namespace tsuya::scene

#include "material.h"

#include "arguments.h"
#include "function.h"
#include "number.h"

#include "../draw/params.h"
#include "../scene/head.h"

#include <tsuya/hair_color.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace tsuya::command {

namespace {

bool is_angle(const tsu_parameter_info &parameter)
{
    return std::strcmp(parameter.unit, "rad") == 0;
}

bool is_pigment(const std::string &key)
{
    return key == "eumelanin" || key == "pheomelanin";
}

const scene::LeafKey *leaf_key(const std::string &key)
{
    for (const scene::LeafKey &known : scene::leaf_keys()) {
        if (key == known.name) {
            return &known;
        }
    }
    return nullptr;
}

bool is_leaf(const std::string &key)
{
    return scene::leaf_by(key) != scene::LeafBy::nothing;
}

// What the words of a leaf set.
bool is_layer(const std::string &key)
{
    return key.rfind("scatter_", 0) == 0 || key.rfind("absorption_", 0) == 0;
}

} // namespace

bool parse_numbers(const std::string &text, std::vector<double> &values, std::string &error)
{
    values.clear();
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        double value;
        if (!parse_number(std::string_view(text).substr(from, end - from), value)) {
            error = "\"" + text.substr(from, end - from) + "\" is not a number";
            return false;
        }
        values.push_back(value);
        from = end + 1;
    }
    return true;
}

std::vector<std::string> preset_names()
{
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < tsu_hair_preset_count(); i++) {
        tsu_hair_preset_info info;
        tsu_hair_preset_info_init(&info);
        tsu_hair_preset(i, &info);
        names.push_back(info.name);
    }
    return names;
}

Material::Material(Host &host, const tsu_model *model) : host_(host), model_(model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    storage_.resize((info.params_size + sizeof(double) - 1) / sizeof(double));
    const tsu_status status = tsu_model_params_init(model, storage_.data(), info.params_size);
    if (status != TSU_OK) {
        throw std::runtime_error(host.why(status));
    }
    for (std::uint32_t i = 0; i < info.parameter_count; i++) {
        tsu_parameter_info parameter;
        tsu_parameter_info_init(&parameter);
        tsu_model_parameter(model, i, &parameter);
        parameters_.push_back(parameter);
    }
}

bool Material::vary(const std::string &variant, std::string &error)
{
    std::vector<std::string> names;
    tsu_variant_info info;
    tsu_variant_info_init(&info);
    for (std::uint32_t i = 0; tsu_model_variant(model_, i, &info) == TSU_OK; i++) {
        if (variant == info.name) {
            draw::add_flags(storage_.data(), info.params_flags);
            return true;
        }
        names.push_back(info.name);
    }
    error = "there is no variant \"" + variant + "\"" + suggestion(variant, names) + "; " +
            (names.empty() ? "the model has none." : "the model has " + joined(names) + ".");
    return false;
}

void *Material::params()
{
    return storage_.data();
}

const tsu_parameter_info *Material::find(const std::string &name) const
{
    for (const tsu_parameter_info &parameter : parameters_) {
        if (name == parameter.name) {
            return &parameter;
        }
    }
    return nullptr;
}

std::vector<std::string> Material::keys() const
{
    std::vector<std::string> keys;
    for (const tsu_parameter_info &parameter : parameters_) {
        keys.push_back(parameter.name);
        if (is_angle(parameter)) {
            keys.push_back(std::string(parameter.name) + "_deg");
        }
    }
    if (find("sigma_a")) {
        keys.insert(keys.end(), {"eumelanin", "pheomelanin", "color", "albedo", "head_albedo"});
    }
    if (scene::has_leaf(model_)) {
        keys.push_back("leaf");
        for (const scene::LeafKey &key : scene::leaf_keys()) {
            keys.push_back(key.name);
        }
    }
    return keys;
}

void Material::store(const tsu_parameter_info &parameter, const std::vector<double> &values)
{
    unsigned char *const at = reinterpret_cast<unsigned char *>(storage_.data()) + parameter.offset;
    for (std::size_t i = 0; i < parameter.count; i++) {
        const float value = float(values.size() == 1 ? values[0] : values[i]);
        std::memcpy(at + i * sizeof value, &value, sizeof value);
    }
}

bool Material::set_parameter(const tsu_parameter_info &parameter, const std::string &key,
                             const std::string &text, double scale, std::string &error)
{
    std::vector<double> values;
    if (!parse_numbers(text, values, error)) {
        error = key + ": " + error + ".";
        return false;
    }
    if (values.size() != 1 && values.size() != parameter.count) {
        error = key + " takes " + (parameter.count == 1 ? "one number" : "one or three numbers") +
                ", not " + std::to_string(values.size()) + ".";
        return false;
    }
    for (double &value : values) {
        const double api = value * scale, slack = 1e-9;
        const double low = parameter.minimum, high = parameter.maximum;
        if (!(api >= low - slack * std::fabs(low) && api <= high + slack * std::fabs(high))) {
            error = key + ": " + number_text(value, 15) + " is outside [" +
                    number_text(low / scale, 10) + ", " + number_text(high / scale, 10) + "].";
            return false;
        }
        value = std::clamp(api, low, high);
    }
    store(parameter, values);
    return true;
}

bool Material::set_color(const std::string &key, const std::string &text, std::string &error)
{
    if (key == "color") {
        preset_ = text;
        return true;
    }
    std::vector<double> values;
    if (!parse_numbers(text, values, error)) {
        error = key + ": " + error + ".";
        return false;
    }
    const bool pigment = is_pigment(key);
    if (values.size() != 1 && (pigment || values.size() != 3)) {
        error = key + " takes " + (pigment ? "one number" : "one or three numbers") + ", not " +
                std::to_string(values.size()) + ".";
        return false;
    }
    if (pigment) {
        (key == "eumelanin" ? eumelanin_ : pheomelanin_) = values[0];
    } else {
        values.resize(3, values[0]);
        albedo_ = values;
    }
    return true;
}

bool Material::set_leaf(const std::string &key, const std::string &text, std::string &error)
{
    const scene::LeafKey *const known = leaf_key(key);
    if (!known) {
        const std::vector<std::string> names = scene::leaf_names();
        if (std::find(names.begin(), names.end(), text) == names.end()) {
            error = "leaf: there is no leaf \"" + text + "\"" + suggestion(text, names) +
                    "; the leaves are " + joined(names) + ".";
            return false;
        }
        leaf_.name = text;
        return true;
    }
    std::vector<double> values;
    if (!parse_numbers(text, values, error)) {
        error = key + ": " + error + ".";
        return false;
    }
    if (values.size() != 1 && !(known->face && values.size() == 3)) {
        error = key + " takes " + (known->face ? "one or three numbers" : "one number") + ", not " +
                std::to_string(values.size()) + ".";
        return false;
    }
    for (const double value : values) {
        if (!(value >= known->low && value <= known->high)) {
            error = key + ": " + number_text(value, 15) + " is outside [" +
                    number_text(known->low, 10) + ", " + number_text(known->high, 10) + "].";
            return false;
        }
    }
    values.resize(3, values[0]);
    leaf_.values[key] = {values[0], values[1], values[2]};
    return true;
}

bool Material::set(const std::string &word, std::string &error)
{
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
        error = "\"" + word + "\" is not key=value; the keys of " + model_name(model_) + " are " +
                joined(keys()) + ".";
        return false;
    }
    const std::string key = word.substr(0, equals), text = word.substr(equals + 1);
    const std::vector<std::string> known = keys();
    if (std::find(known.begin(), known.end(), key) == known.end()) {
        error = "there is no key \"" + key + "\"" + suggestion(key, known) + "; the keys are " +
                joined(known) + ".";
        return false;
    }
    const bool degrees = key.size() > 4 && key.compare(key.size() - 4, 4, "_deg") == 0;
    const std::string name = degrees ? key.substr(0, key.size() - 4) : key;
    const tsu_parameter_info *const parameter = find(name);
    const bool absorption = (!parameter && !is_leaf(name)) || name == "sigma_a";
    for (const std::string &other : given_) {
        const bool both_absorption =
            absorption && ((!find(other) && !is_leaf(other)) || other == "sigma_a");
        if (other == name || (both_absorption && !(is_pigment(other) && is_pigment(name)))) {
            error = other == name ? name + " is given twice."
                                  : name + " and " + other + " both set the absorption; give one.";
            return false;
        }
        if ((is_leaf(name) && is_layer(other)) || (is_layer(name) && is_leaf(other))) {
            error = name + " and " + other + " both set the layers of the leaf; give one.";
            return false;
        }
    }
    given_.insert(name);
    if (parameter) {
        return set_parameter(*parameter, key, text, degrees ? degree : 1.0, error);
    }
    return is_leaf(name) ? set_leaf(name, text, error) : set_color(key, text, error);
}

bool Material::finish(std::string &error)
{
    double sigma_a[3] = {0, 0, 0};
    tsu_status status = TSU_OK;
    bool color = true;
    if (given_.count("eumelanin") || given_.count("pheomelanin")) {
        status = tsu_hair_melanin(host_.context(), eumelanin_, pheomelanin_, sigma_a);
    } else if (given_.count("color")) {
        const std::vector<std::string> names = preset_names();
        const auto found = std::find(names.begin(), names.end(), preset_);
        if (found == names.end()) {
            error = "color: there is no preset \"" + preset_ + "\"" + suggestion(preset_, names) +
                    "; the presets are " + joined(names) + ".";
            return false;
        }
        tsu_hair_preset_info info;
        tsu_hair_preset_info_init(&info);
        tsu_hair_preset(std::uint32_t(found - names.begin()), &info);
        std::copy(info.sigma_a, info.sigma_a + 3, sigma_a);
    } else if (given_.count("head_albedo")) {
        status = scene::head_sigma_a(host_.context(), scene::head_fibre(model_, storage_.data()),
                                     albedo_.data(), sigma_a);
    } else if (!albedo_.empty()) {
        const tsu_parameter_info *const eta = find("eta");
        float index = 1.55f;
        if (eta) {
            std::memcpy(&index, reinterpret_cast<unsigned char *>(storage_.data()) + eta->offset,
                        sizeof index);
        }
        status = tsu_hair_sigma_a(host_.context(), index, albedo_.data(), sigma_a);
    } else {
        color = false;
    }
    if (status == TSU_OK && color) {
        store(*find("sigma_a"), {sigma_a[0], sigma_a[1], sigma_a[2]});
    }
    if (status == TSU_OK && !leaf_.empty()) {
        error = scene::set_leaf(host_.context(), model_, leaf_, storage_.data(), status);
        if (!error.empty()) {
            error += ".";
            return false;
        }
    }
    if (status == TSU_OK) {
        status = tsu_model_params_check(host_.context(), model_, storage_.data());
    }
    if (status != TSU_OK) {
        error = host_.why(status) + ".";
    }
    return status == TSU_OK;
}

} // namespace tsuya::command

#include "function.h"

#include "arguments.h"
#include "number.h"

#include <algorithm>
#include <cmath>

namespace tsuya::command {

namespace {

Value value_of(const tsu_value_info &info)
{
    Value value;
    const bool angle = std::string(info.unit) == "rad";
    value.name = info.name;
    value.unit = info.unit;
    value.help = info.help;
    value.column = value.name + (angle ? "_deg" : "");
    value.scale = angle ? degree : 1.0;
    value.material = (info.flags & TSU_VALUE_MATERIAL) != 0;
    value.minimum = info.minimum;
    value.maximum = info.maximum;
    value.default_value = info.default_value;
    // A unit of words: "a|b;c".
    const std::string unit = info.unit;
    for (std::size_t begin = 0; unit.find('|') != std::string::npos && begin < unit.size();) {
        const std::size_t end = std::min(unit.find_first_of("|;", begin), unit.size());
        value.words.push_back(unit.substr(begin, end - begin));
        value.words_on_tables += unit.rfind(';', begin) == std::string::npos || begin == 0;
        begin = end + 1;
    }
    return value;
}

Function function_of(const tsu_model *model, std::uint32_t index)
{
    Function function;
    function.model = model;
    function.index = index;
    tsu_function_info info;
    tsu_function_info_init(&info);
    tsu_model_function(model, index, &info);
    function.name = info.name;
    function.reference_only = (info.flags & TSU_FUNCTION_REFERENCE_ONLY) != 0;
    for (std::uint32_t i = 0; i < info.input_count; i++) {
        tsu_value_info value;
        tsu_value_info_init(&value);
        tsu_function_input(model, index, i, &value);
        function.inputs.push_back(value_of(value));
    }
    for (std::uint32_t i = 0; i < info.output_count; i++) {
        tsu_value_info value;
        tsu_value_info_init(&value);
        tsu_function_output(model, index, i, &value);
        function.outputs.push_back(value_of(value));
    }
    return function;
}

std::vector<Function> functions_of(const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    std::vector<Function> functions;
    for (std::uint32_t i = 0; i < info.function_count; i++) {
        functions.push_back(function_of(model, i));
    }
    return functions;
}

// Functions of one model, or of all when `model` is NULL.
std::vector<Function> all_functions(const tsu_model *model)
{
    if (model) {
        return functions_of(model);
    }
    std::vector<Function> functions;
    for (std::uint32_t i = 0; i < tsu_model_count(); i++) {
        for (const Function &function : functions_of(tsu_model_at(i))) {
            functions.push_back(function);
        }
    }
    return functions;
}

void add_once(std::vector<std::string> &names, const std::string &name)
{
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
    }
}

// Variants answer the same question: `a` and `b` have the same columns.
bool same_inputs(const Function &a, const Function &b)
{
    return std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(),
                      [](const Value &x, const Value &y) { return x.column == y.column; });
}

} // namespace

std::string model_name(const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    return info.name;
}

std::vector<std::string> model_names()
{
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < tsu_model_count(); i++) {
        names.push_back(model_name(tsu_model_at(i)));
    }
    return names;
}

std::vector<std::string> technique_names()
{
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < tsu_hair_shadow_count(); i++) {
        names.push_back(model_name(tsu_hair_shadow_at(i)));
    }
    return names;
}

const tsu_model *find_model(const std::string &name, std::string &error)
{
    const tsu_model *const model = tsu_model_find(name.c_str());
    if (!model) {
        std::vector<std::string> names = model_names();
        for (const std::string &technique : technique_names()) {
            names.push_back(technique);
        }
        error = "there is no model \"" + name + "\"" + suggestion(name, names) +
                "; the models are " + joined(names) + ".";
    }
    return model;
}

std::vector<std::string> function_names()
{
    std::vector<std::string> names;
    for (const Function &function : all_functions(nullptr)) {
        add_once(names, function.name);
    }
    return names;
}

bool find_function(const std::string &name, const std::string &model, const std::string &variant,
                   Function &out, std::string &error)
{
    const tsu_model *only = nullptr;
    if (!model.empty() && !(only = find_model(model, error))) {
        return false;
    }
    std::vector<std::string> names, variants;
    const std::vector<Function> functions = all_functions(only);
    const Function *base = nullptr;
    for (const Function &function : functions) {
        base = !base && function.name == name ? &function : base;
        add_once(names, function.name);
    }
    for (const Function &function : functions) {
        const std::size_t size = name.size() + 1;
        if (!base || function.name.compare(0, size, name + "-") != 0 ||
            !same_inputs(function, *base)) {
            continue;
        }
        add_once(variants, function.name.substr(size));
        if (!variant.empty() && function.name.substr(size) == variant) {
            out = function;
            return true;
        }
    }
    if (base && variant.empty()) {
        out = *base;
        return true;
    }
    const std::string whose = only ? "model " + model : "any model";
    if (base) {
        error = "function " + name + " has no variant \"" + variant + "\"" +
                suggestion(variant, variants) + "; " +
                (variants.empty() ? "it has none" : "its variants are " + joined(variants)) + ".";
    } else {
        error = "there is no function \"" + name + "\" in " + whose + suggestion(name, names) +
                "; the functions are " + joined(names) + ".";
    }
    return false;
}

bool word_to_api(const Value &value, const std::string &word, double &out, std::string &error)
{
    const auto found = std::find(value.words.begin(), value.words.end(), word);
    if (found == value.words.end()) {
        error = "\"" + word + "\" is none of " + joined(value.words);
        return false;
    }
    out = double(found - value.words.begin());
    return true;
}

std::string columns_text(const Function &function)
{
    const auto padded = [](std::string text, std::size_t width) {
        text.resize(std::max(text.size() + 2, width), ' ');
        return text;
    };
    const auto limit = [](const Value &value, double number) {
        return number == TSU_VALUE_INFINITE ? "inf" : number_text(number / value.scale, 6);
    };
    std::string text = "Columns that " + function.name + " reads:\n";
    for (const Value &value : function.inputs) {
        const std::string range =
            value.words.empty()
                ? limit(value, value.minimum) + " .. " + limit(value, value.maximum)
                : joined(value.words);
        const std::string usual =
            value.words.empty()
                ? limit(value, value.default_value)
                : value.words[std::min(std::size_t(value.default_value), value.words.size() - 1)];
        text += "  " + padded(value.column, 18) + padded(range, 16) +
                padded("default " + usual, 16) + value.help + "\n";
    }
    text += "Columns that it adds:\n";
    for (const Value &value : function.outputs) {
        text += "  " + padded(value.column, 18) + value.help + "\n";
    }
    return text;
}

bool to_api(const Value &value, double number, double &out, std::string &error)
{
    const double low = value.minimum, high = value.maximum;
    if (std::isinf(number) && number > 0 && high == TSU_VALUE_INFINITE) {
        out = high;
        return true;
    }
    out = number * value.scale;
    const double slack = 1e-9;
    // Written so that NaN is outside.
    if (!(out >= low - slack * std::fabs(low) && out <= high + slack * std::fabs(high)) ||
        !std::isfinite(out)) {
        error = number_text(number, 15) + " is outside [" + number_text(low / value.scale, 10) +
                ", " + number_text(high / value.scale, 10) + "]";
        return false;
    }
    out = std::clamp(out, low, high);
    // A whole turn means nothing, but 32 bits lose the rest of an angle of many: turned back here, in
    // degrees, where 360 is exact.
    if (value.scale != 1 && std::fabs(number) > 360) {
        out = std::remainder(number, 360) * value.scale;
    }
    return true;
}

} // namespace tsuya::command

// `tsuya models`: what the registry says, as a table or as JSON.
#include "arguments.h"
#include "commands.h"
#include "function.h"
#include "json.h"
#include "number.h"

#include <tsuya/hair_shadow.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace {

using namespace tsuya::command;

Manual manual()
{
    return {"models",
            "[--json] [MODEL]",
            "Lists the models, or one of them: parameters with unit, range and default, tables,\n"
            "measured errors, inputs of the GLSL entry point and functions for tsuya eval.\n"
            "Angles are radians in the API; the list gives degrees too.\n",
            {{"--json", "",
              "print {\"models\": [...]} for programs; angles in radians under the\n"
              "names of the API and in degrees under ..._deg"}},
            "  tsuya models\n"
            "  tsuya models marschner\n"
            "  tsuya models --json | python3 -m json.tool\n"};
}

bool angle(const char *unit)
{
    return std::strcmp(unit, "rad") == 0;
}

// Twelve digits, so that a limit stated in degrees reads as it was stated.
double in_degrees(double radians)
{
    double rounded = 0;
    parse_number(number_text(radians / degree, 12), rounded);
    return rounded;
}

// minimum, maximum and default of a parameter or value, with degrees where it is an angle.
template <class Info> void range_json(Json &json, const Info &info)
{
    json.field("minimum", info.minimum).field("maximum", info.maximum);
    json.field("default", info.default_value);
    if (angle(info.unit)) {
        json.field("minimum_deg", in_degrees(info.minimum));
        json.field("maximum_deg", in_degrees(info.maximum));
        json.field("default_deg", in_degrees(info.default_value));
    }
}

void parameters_json(Json &json, const tsu_model *model, const tsu_model_info &info)
{
    json.key("parameters").open('[');
    for (std::uint32_t i = 0; i < info.parameter_count; i++) {
        tsu_parameter_info p;
        tsu_parameter_info_init(&p);
        tsu_model_parameter(model, i, &p);
        json.open('{').field("name", p.name).field("unit", p.unit);
        json.field("count", std::uint64_t(p.count));
        range_json(json, p);
        json.field("rebakes", p.rebakes != 0).field("help", p.help).close();
    }
    json.close();
}

// The variant that a table is for; "": all.
std::string variant_of(const tsu_model *model, const tsu_table_info &table)
{
    tsu_variant_info info;
    tsu_variant_info_init(&info);
    for (std::uint32_t i = 0; tsu_model_variant(model, i, &info) == TSU_OK; i++) {
        if (table.params_flags & info.params_flags) {
            return info.name;
        }
    }
    return "";
}

void tables_json(Json &json, const tsu_model *model, const tsu_model_info &info)
{
    json.key("tables").open('[');
    for (std::uint32_t i = 0; i < info.table_count; i++) {
        tsu_table_info t;
        tsu_table_info_init(&t);
        tsu_model_table(model, i, &t);
        json.open('{').field("name", t.name).field("format", "RGBA16F");
        json.field("width", std::uint64_t(t.width)).field("height", std::uint64_t(t.height));
        json.field("bytes", std::uint64_t(t.bytes)).field("variant", variant_of(model, t));
        json.field("axes", t.axes).field("channels", t.channels).close();
    }
    json.close();
}

void errors_json(Json &json, const tsu_model *model, const tsu_model_info &info)
{
    json.key("error").open('{');
    for (std::uint32_t i = 0; i < info.error_count; i++) {
        tsu_error_info e;
        tsu_error_info_init(&e);
        tsu_model_error(model, i, &e);
        json.key(e.name).open('{').field("value", e.value);
        json.field("measure", e.measure).field("range", e.range).close();
    }
    json.close();
}

void inputs_json(Json &json, const tsu_model *model, const tsu_model_info &info)
{
    json.key("inputs").open('[');
    for (std::uint32_t i = 0; i < info.input_count; i++) {
        tsu_input_info input;
        tsu_input_info_init(&input);
        tsu_model_input(model, i, &input);
        json.open('{').field("name", input.name).field("type", input.type);
        json.field("extra", (input.flags & TSU_INPUT_EXTRA) != 0).field("help", input.help).close();
    }
    json.close();
}

void functions_json(Json &json, const tsu_model *model, const tsu_model_info &info)
{
    json.key("functions").open('[');
    for (std::uint32_t i = 0; i < info.function_count; i++) {
        tsu_function_info f;
        tsu_function_info_init(&f);
        tsu_model_function(model, i, &f);
        json.open('{').field("name", f.name).field("help", f.help);
        const bool only = (f.flags & TSU_FUNCTION_REFERENCE_ONLY) != 0;
        json.key("on").open('[').value("reference");
        if (!only) {
            json.value("cpu").value("gpu");
        }
        json.close();
        json.key("inputs").open('[');
        for (std::uint32_t k = 0; k < f.input_count; k++) {
            tsu_value_info value;
            tsu_value_info_init(&value);
            tsu_function_input(model, i, k, &value);
            json.open('{').field("name", value.name).field("unit", value.unit);
            json.field("column", value.name + std::string(angle(value.unit) ? "_deg" : ""));
            json.field("material", (value.flags & TSU_VALUE_MATERIAL) != 0);
            range_json(json, value);
            json.field("help", value.help).close();
        }
        json.close().key("outputs").open('[');
        for (std::uint32_t k = 0; k < f.output_count; k++) {
            tsu_value_info value;
            tsu_value_info_init(&value);
            tsu_function_output(model, i, k, &value);
            json.open('{').field("name", value.name).field("unit", value.unit);
            json.field("help", value.help).close();
        }
        json.close().close();
    }
    json.close();
}

void model_json(Json &json, const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    json.open('{').field("name", info.name).field("title", info.title);
    json.field("source", info.source);
    json.field("kind", info.flags & TSU_MODEL_SHADOW    ? "shadow"
                       : info.flags & TSU_MODEL_SURFACE ? "surface"
                                                        : "fibre");
    parameters_json(json, model, info);
    tables_json(json, model, info);
    errors_json(json, model, info);
    inputs_json(json, model, info);
    functions_json(json, model, info);
    json.close();
}

// A word, and as many spaces as bring it to `width`, at least two.
std::string cell(std::string text, std::size_t width)
{
    text.resize(std::max(text.size() + 2, width), ' ');
    return text;
}

template <class Info> std::string range_text(const Info &info)
{
    const double scale = angle(info.unit) ? degree : 1.0;
    return cell(number_text(info.minimum / scale, 6) + " .. " +
                    number_text(info.maximum / scale, 6),
                16) +
           cell("default " + number_text(info.default_value / scale, 6), 16) +
           cell(angle(info.unit) ? "deg" : info.unit, 10);
}

std::string model_text(const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    std::string text = std::string(info.name) + ": " + info.title + "\n  " + info.source + "\n";
    text += info.parameter_count ? "\n  parameters\n" : "";
    for (std::uint32_t i = 0; i < info.parameter_count; i++) {
        tsu_parameter_info p;
        tsu_parameter_info_init(&p);
        tsu_model_parameter(model, i, &p);
        text += "    " + cell(p.name, 12) + range_text(p) + p.help +
                (p.count == 3 ? " (r,g,b)" : "") + (p.rebakes ? "; bakes anew" : "") + "\n";
    }
    text += info.table_count ? "\n  tables\n" : "";
    for (std::uint32_t i = 0; i < info.table_count; i++) {
        tsu_table_info t;
        tsu_table_info_init(&t);
        tsu_model_table(model, i, &t);
        text += "    " + cell(t.name, 12) + std::to_string(t.width) + " x " +
                std::to_string(t.height) + " RGBA16F, " + std::to_string(t.bytes) + " bytes" +
                (t.params_flags ? ", variant " + variant_of(model, t) + " alone\n" : "\n") +
                cell("    axes", 16) + t.axes + "\n" + cell("    channels", 16) + t.channels + "\n";
    }
    text += info.error_count ? "\n  errors\n" : "";
    for (std::uint32_t i = 0; i < info.error_count; i++) {
        tsu_error_info e;
        tsu_error_info_init(&e);
        tsu_model_error(model, i, &e);
        text += "    " + cell(e.name, 28) + cell(number_text(e.value, 3), 12) + e.measure + "; " +
                e.range + "\n";
    }
    text += info.function_count ? "\n  functions (tsuya eval)\n" : "";
    for (std::uint32_t i = 0; i < info.function_count; i++) {
        tsu_function_info f;
        tsu_function_info_init(&f);
        tsu_model_function(model, i, &f);
        text += "    " + cell(f.name, 24) + f.help + "\n";
    }
    return text;
}

} // namespace

int command_models(int argc, char **argv)
{
    Arguments arguments;
    std::string error;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain("models", error, exit_bad_input);
    }
    if (arguments.help()) {
        return print("models", help_text(manual()));
    }
    if (arguments.positional().size() > 1) {
        return complain("models", "at most one model can be named; without a name all are listed.",
                        exit_bad_input);
    }
    const bool one = !arguments.positional().empty();
    const tsu_model *const only = one ? find_model(arguments.positional()[0], error) : nullptr;
    if (one && !only) {
        return complain("models", error, exit_bad_input);
    }
    Json json;
    json.open('{').key("models").open('[');
    std::string text;
    for (std::uint32_t i = 0; i < tsu_model_count() + tsu_hair_shadow_count(); i++) {
        const tsu_model *const model = i < tsu_model_count()
                                           ? tsu_model_at(i)
                                           : tsu_hair_shadow_at(i - tsu_model_count());
        if (only && model != only) {
            continue;
        }
        model_json(json, model);
        text += (text.empty() ? "" : "\n") + model_text(model);
    }
    json.close().close();
    return print("models", arguments.has("--json") ? json.text() : text);
}

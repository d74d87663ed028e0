// `tsuya glsl`: the text that an engine pastes.
#include "arguments.h"
#include "commands.h"
#include "function.h"
#include "host.h"
#include "number.h"

#include <tsuya/shader.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

using namespace tsuya::command;

const std::vector<std::string> targets = {"330", "410", "450", "300es", "310es", "vulkan"};

Manual manual()
{
    return {
        "glsl",
        "MODEL[,MODEL...] --target TARGET [--drop LOBE,...] [--only NAME,...]\n"
        "             [--variant fine] [--harness] [--array N]",
        "Prints the GLSL of one or more models: functions, structs and macros that begin with\n"
        "tsu_ or TSU_, one sampler tsu_tables and one block tsu_materials for all of them.\n"
        "Without --harness the text has no #version, no main, no in and no out: paste it after\n"
        "your own header. For each model M it defines\n"
        "  tsu_M_lobes tsu_M_eval(int material, vec3 t, vec3 l, vec3 v, vec3 sigma_a, ...);\n"
        "  vec3 tsu_M_sum(tsu_M_lobes lobes);\n"
        "Models: " +
            joined(model_names()) +
            ".\n"
            "Techniques of self-shadow, alone or among models, without --harness: " +
            joined(technique_names()) + ".\n",
        {{"--target", "TARGET", "language: " + joined(targets)},
         {"--drop", "LOBE,...",
          "leave these out: trt, residual (of marschner's fibre in any model), back\n"
          "(light that comes back in dual_scattering and plane_parallel_hair),\n"
          "transmitted (through leaves); what each is worth stands in tsuya/shader.h"},
         {"--harness", "",
          "one complete fragment shader: varyings t, l, v, sigma_a, flat material\n"
          "and the models' extra inputs; o = vec4(sum of all lobes, 1)"},
         {"--only", "NAME,...",
          "the text of these functions and what they need: eval, a variant (finite,\n"
          "zinke, bent), what else follows tsu_M_ (uniform, ambient, reflected); a\n"
          "harness calls the variant that is named"},
         {"--variant", "NAME",
          "fine: spend more where a model can use it; `tsuya eval F --variant\n"
          "fine` answers with the same text"},
         {"--array", "N",
          "records as `uniform vec4 tsu_records[]` for N materials, 1 to 127,\n"
          "in place of the block; not for vulkan"}},
        "  tsuya glsl marschner --target 330\n"
        "  tsuya glsl kajiya_kay,marschner --target vulkan --harness > both.frag\n"};
}

// Words of a list with commas; "" gives none.
std::vector<std::string> split(const std::string &list)
{
    std::vector<std::string> words;
    for (std::size_t from = 0; from <= list.size() && !list.empty();) {
        const std::size_t end = std::min(list.find(',', from), list.size());
        words.push_back(list.substr(from, end - from));
        from = end + 1;
    }
    return words;
}

bool find_models(const std::string &list, std::vector<const tsu_model *> &models,
                 std::string &error)
{
    for (const std::string &name : list.empty() ? std::vector<std::string>{""} : split(list)) {
        const tsu_model *const model = find_model(name, error);
        if (!model) {
            return false;
        }
        models.push_back(model);
    }
    return true;
}

bool drop_lobes(const std::string &list, std::uint32_t &flags, std::string &error)
{
    const std::vector<std::string> names = {"trt", "residual", "back", "transmitted"};
    const std::uint32_t bits[] = {TSU_SHADER_DROP_TRT, TSU_SHADER_DROP_RESIDUAL,
                                  TSU_SHADER_DROP_BACK, TSU_SHADER_DROP_TRANSMITTED};
    for (const std::string &word : split(list)) {
        const auto found = std::find(names.begin(), names.end(), word);
        if (found == names.end()) {
            error = "--drop: there is no lobe \"" + word + "\"" + suggestion(word, names) +
                    "; the lobes are " + joined(names) + ".";
            return false;
        }
        flags |= bits[found - names.begin()];
    }
    return true;
}

bool describe(const Arguments &arguments, const std::vector<const tsu_model *> &models,
              const std::string &only, tsu_shader_desc &desc, std::string &error)
{
    tsu_shader_desc_init(&desc);
    const std::string target = arguments.get("--target");
    desc.target = tsu_target_find(target.c_str());
    if (!desc.target) {
        error = (target.empty()
                     ? "--target is missing"
                     : "there is no target \"" + target + "\"" + suggestion(target, targets)) +
                "; the targets are " + joined(targets) + ".";
        return false;
    }
    desc.model_count = std::uint32_t(models.size());
    desc.models = models.data();
    desc.only = only.c_str();
    desc.flags = arguments.has("--harness") ? TSU_SHADER_HARNESS : 0;
    if (arguments.has("--variant")) {
        if (arguments.get("--variant") != "fine") {
            error = "--variant: there is no variant \"" + arguments.get("--variant") +
                    "\" of the text; there is fine.";
            return false;
        }
        desc.flags |= TSU_SHADER_FINE;
    }
    if (!drop_lobes(arguments.get("--drop"), desc.flags, error)) {
        return false;
    }
    if (arguments.has("--array")) {
        double count = 0;
        const std::string text = arguments.get("--array");
        if (!parse_number(text, count) || !(count >= 1 && count <= TSU_PAGE_MATERIALS) ||
            count != double(int(count))) {
            error = "--array: " + text + " is not a whole number in [1, " +
                    std::to_string(TSU_PAGE_MATERIALS) + "].";
            return false;
        }
        desc.flags |= TSU_SHADER_ARRAY;
        desc.array_materials = std::uint32_t(count);
    }
    return true;
}

} // namespace

int command_glsl(int argc, char **argv)
{
    Arguments arguments;
    std::string error;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain("glsl", error, exit_bad_input);
    }
    if (arguments.help()) {
        return print("glsl", help_text(manual()));
    }
    if (arguments.positional().size() != 1) {
        return complain("glsl",
                        arguments.positional().empty()
                            ? "no model is given; the models are " + joined(model_names()) +
                                  ", the shadows " + joined(technique_names()) + "."
                            : "join several models with commas: " + arguments.positional()[0] +
                                  "," + arguments.positional()[1] + ".",
                        exit_bad_input);
    }
    std::vector<const tsu_model *> models;
    tsu_shader_desc desc;
    const std::string only = arguments.get("--only");
    if (!find_models(arguments.positional()[0], models, error) ||
        !describe(arguments, models, only, desc, error)) {
        return complain("glsl", error, exit_bad_input);
    }
    Host host;
    tsu_shader *shader = nullptr;
    const tsu_status status = tsu_shader_create(host.context(), &desc, &shader);
    if (status != TSU_OK) {
        const bool input = status == TSU_E_PARAMETER || status == TSU_E_LIMIT;
        return complain("glsl", host.why(status) + ".", input ? exit_bad_input : exit_failure);
    }
    std::size_t size = 0;
    const char *const text = tsu_shader_text(shader, &size);
    const int code = print("glsl", std::string(text, size));
    tsu_shader_destroy(shader);
    return code;
}

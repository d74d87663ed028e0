// `tsuya`: one door to the models, their GLSL, their tables and their numbers.
#include "arguments.h"
#include "commands.h"

#include <tsuya/base.h>

#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace tsuya::command;

struct Command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *summary;
};

const Command commands[] = {
    {"models", command_models, "list the models: parameters, tables, errors, functions"},
    {"glsl", command_glsl, "print the GLSL text of one or more models"},
    {"bake", command_bake, "write a material's tables and uniform block to files"},
    {"eval", command_eval, "evaluate a model on rows of CSV: reference, tables in C, or GPU"},
    {"bench", command_bench, "measure what each tier costs on this machine"},
    {"render", command_render, "render hair to a PNG or EXR file"},
    {"reference", command_reference, "render hair by path tracing, with its standard error"},
    {"choose", command_choose, "print the tier that a scene requires, its error and cost"},
    {"compare", command_compare, "print the errors of tiers against a path-traced picture"},
    {"scenes", command_scenes, "list the scenes that render knows"},
};

std::string version()
{
    const std::uint32_t v = tsu_version();
    return std::to_string(v >> 22) + "." + std::to_string((v >> 12) & 0x3ff) + "." +
           std::to_string(v & 0xfff);
}

std::string help()
{
    std::string text = "usage: tsuya COMMAND [argument ...]\n\n"
                       "Shading of hair for real-time renderers: models, GLSL, tables, numbers,\n"
                       "pictures.\n\ncommands:\n";
    for (const Command &command : commands) {
        std::string name = std::string("  ") + command.name;
        name.resize(12, ' ');
        text += name + command.summary + "\n";
    }
    return text +
           "\noptions:\n"
           "  --help      print this text; tsuya COMMAND --help tells about a command\n"
           "  --version   print the version\n"
           "\nexit codes: 0 success, 1 the machine failed (no GL, disk full), 2 bad input\n"
           "\nexamples:\n"
           "  tsuya models\n"
           "  tsuya glsl marschner --target 450 > hair.glsl\n"
           "  tsuya bake marschner color=brown beta_az_deg=10 -o hair.exr --block hair.block\n"
           "  tsuya eval hair --on gpu rows.csv > values.csv\n";
}

int run(int argc, char **argv)
{
    const std::string word = argc > 1 ? argv[1] : "";
    if (word.empty()) {
        return complain("", "no command is given; tsuya --help lists them.", exit_bad_input);
    }
    if (word == "--help" || word == "-h" || (word == "help" && argc == 2)) {
        return print("", help());
    }
    if (word == "--version") {
        return print("", "tsuya " + version() + "\n");
    }
    std::vector<std::string> names = {"--help", "--version"};
    for (const Command &command : commands) {
        if (word == command.name) {
            return command.run(argc - 1, argv + 1);
        }
        names.push_back(command.name);
    }
    const char *const kind = word[0] == '-' ? "unknown option " : "unknown command ";
    return complain("", kind + word + suggestion(word, names) + "; tsuya --help lists them.",
                    exit_bad_input);
}

} // namespace

int main(int argc, char **argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception &failure) {
        return complain("", std::string("the machine failed: ") + failure.what() + ".",
                        exit_failure);
    }
}

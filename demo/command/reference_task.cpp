#include "reference_task.h"

#include "scene/gallery.h"
#include "scene/keys.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>
#include <vector>

namespace tsuya::command {

using groom::Error;
using groom::Expected;

namespace {

constexpr double samples_most = 1e7, samples_usual = 256.0, samples_for_error = 65536.0;

// Number of an option, or what stands in the way. `value` keeps its default when it is absent.
std::string number(const Arguments &arguments, const std::string &option, double low, double high,
                   bool whole, double &value)
{
    if (!arguments.has(option)) {
        return "";
    }
    std::string wrong = scene::read_number(arguments.get(option), low, high, value);
    if (wrong.empty() && whole && value != std::floor(value)) {
        wrong = "is " + scene::number_text(value);
    }
    return wrong.empty() ? ""
                         : option + " " + wrong + " but must be " + (whole ? "whole, " : "") +
                               "in " + scene::range_text(low, high);
}

} // namespace

const Manual &reference_manual()
{
    static const Manual text = {
        "reference",
        "SCENE|FILE [key=value ...] -o FILE.exr",
        "Draw what tsuya render draws by path tracing: every way of light through hair and off\n"
        "the head, any number of times, with marschner's fibre in double precision, the\n"
        "dome as a uniform sky, lights with their size and surroundings as their picture. Keys\n"
        "and words are those of tsuya render.\n\n"
        "FILE.exr holds linear light R, G, B; hair, the share of each pixel that hair covers; se.R,\n"
        "se.G, se.B, se.Y, the standard error of each pixel and of its luminance; and the scene as\n"
        "text. tsuya compare holds the tiers against it. The same seed and samples give the same\n"
        "picture whatever the number of threads.\n\n"
        "All sums stand in FILE.exr.state, written from time to time and when the command is\n"
        "interrupted. With --resume it goes on from there and ends where it would have ended; a\n"
        "greater --samples adds to a finished picture.",
        {{"-o", "FILE", "picture to write: .exr"},
         {"--size", "WxH", "short for size=WxH"},
         {"--samples", "N",
          "paths a pixel, whole, in [1, 10000000]; default 256, with --error "
          "65536"},
         {"--error", "E",
          "stop when the pixels' standard error is this share of the hair's "
          "luminance, in [0.0001, 1]"},
         {"--seed", "S", "of the paths, whole, in [0, 4294967295]; default 1"},
         {"--threads", "T", "whole, in [1, 1024]; default: all cores"},
         {"--resume", "", "go on from FILE.exr.state where there is one"}},
        "  tsuya reference straight-brown --size 256x256 -o brown.exr\n"
        "  tsuya reference wavy-blond dome=0 --error 0.02 --resume -o blond.exr\n"};
    return text;
}

Expected<Task> reference_task(const Arguments &arguments)
{
    Task task;
    task.path = arguments.get("-o");
    task.resume = arguments.has("--resume");
    const std::vector<std::string> &words = arguments.positional();
    if (words.empty()) {
        return Error{"no scene is given; tsuya scenes lists them"};
    }
    if (std::filesystem::path(task.path).extension() != ".exr") {
        return Error{task.path.empty() ? "-o FILE.exr is missing"
                                       : "-o " + task.path + " must end in .exr"};
    }
    double seed = 1.0, threads = std::max(1u, std::thread::hardware_concurrency());
    double samples = arguments.has("--error") ? samples_for_error : samples_usual;
    for (const std::string &wrong :
         {number(arguments, "--samples", 1.0, samples_most, true, samples),
          number(arguments, "--error", 1e-4, 1.0, false, task.error),
          number(arguments, "--seed", 0.0, 4294967295.0, true, seed),
          number(arguments, "--threads", 1.0, 1024.0, true, threads)}) {
        if (!wrong.empty()) {
            return Error{wrong};
        }
    }
    task.work = {std::uint64_t(samples), std::uint64_t(seed), unsigned(threads)};

    std::vector<std::string> changes(words.begin() + 1, words.end());
    if (arguments.has("--size")) {
        changes.push_back("size=" + arguments.get("--size"));
    }
    Expected<scene::Scene> found = scene::find(words[0]);
    if (found) {
        found = scene::override(*found, changes);
    }
    if (!found) {
        return Error{found.error()};
    }
    task.scene = *found;
    if (scene::is_groom(words[0])) {
        const Expected<std::string> suited = scene::suit(task.scene, changes);
        if (!suited) {
            return Error{suited.error()};
        }
        task.said = *suited;
    }
    return Expected<Task>(task);
}

} // namespace tsuya::command

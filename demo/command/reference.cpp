// `tsuya reference`: a scene by path tracing, with its standard error.
#include "arguments.h"
#include "commands.h"

#include "reference/world.h"
#include "scene/gallery.h"
#include "scene/keys.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace tsuya;
using groom::Error;
using groom::Expected;

constexpr double samples_most = 1e7, samples_usual = 256.0, samples_for_error = 65536.0;
constexpr std::uint64_t samples_a_pass = 4;
constexpr double seconds_between_states = 30.0;

const command::Manual &manual()
{
    static const command::Manual text = {
        "reference",
        "SCENE|FILE [key=value ...] -o FILE.exr",
        "Draw what tsuya render draws by path tracing: every way of light through hair and off\n"
        "the head, any number of times, with marschner's fibre in double precision and the dome\n"
        "as a uniform sky. Keys and words are those of tsuya render.\n\n"
        "FILE.exr holds linear light R, G, B; hair, the share of each pixel that hair covers; and\n"
        "se.R, se.G, se.B, the standard error of each pixel. The same seed and samples give the\n"
        "same picture whatever the number of threads.\n\n"
        "All sums stand in FILE.exr.state, written from time to time and when the command is\n"
        "interrupted. With --resume it goes on from there and ends where it would have ended; a\n"
        "greater --samples adds to a finished picture.",
        {{"-o", "FILE", "picture to write: .exr"},
         {"--size", "WxH", "short for size=WxH"},
         {"--samples", "N", "paths a pixel, whole, in [1, 10000000]; default 256, with --error "
                            "65536"},
         {"--error", "E", "stop when the pixels' standard error is this share of the hair's "
                          "luminance, in [0.0001, 1]"},
         {"--seed", "S", "of the paths, whole, in [0, 4294967295]; default 1"},
         {"--threads", "T", "whole, in [1, 1024]; default: all cores"},
         {"--resume", "", "go on from FILE.exr.state where there is one"}},
        "  tsuya reference straight-brown --size 256x256 -o brown.exr\n"
        "  tsuya reference wavy-blond dome=0 --error 0.02 --resume -o blond.exr\n"};
    return text;
}

int complain(const std::string &text, int code = command::exit_bad_input)
{
    const bool dot = !text.empty() && (text.back() == '.' || text.back() == '\n');
    return command::complain("reference", text + (dot ? "" : "."), code);
}

struct Task {
    scene::Scene scene;
    std::string said, path;
    reference::Work work;
    double error = 0.0; // 0: until all samples are taken
    bool resume = false;

    std::string state() const
    {
        return path + ".state";
    }
};

// Number of an option, or what stands in the way. `value` keeps its default when it is absent.
std::string number(const command::Arguments &arguments, const std::string &option, double low,
                   double high, bool whole, double &value)
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

Expected<Task> asked(const command::Arguments &arguments)
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

// Of all that a sample depends on.
std::uint64_t key_of(const Task &task, const groom::Groom &groom)
{
    scene::Scene scene = task.scene;
    scene.title.clear();
    scene.exposure = 0.0;
    scene.tone = "film";
    const std::string text = scene::write(scene);
    std::uint64_t key = reference::key_of(text.data(), text.size());
    key = reference::key_of(&task.work.seed, sizeof task.work.seed, key);
    key = reference::key_of(groom.points.data(), groom.points.size() * sizeof groom.points[0], key);
    key = reference::key_of(groom.radius.data(), groom.radius.size() * sizeof groom.radius[0], key);
    return reference::key_of(groom.first.data(), groom.first.size() * sizeof groom.first[0], key);
}

volatile std::sig_atomic_t interrupted = 0;

extern "C" void interrupt(int)
{
    interrupted = 1;
}

// On a terminal a bar that overwrites itself; elsewhere a line at each quarter.
class Progress
{
  public:
    void show(double done, const reference::Summary &so_far)
    {
        if (isatty(STDERR_FILENO)) {
            char bar[33] = "................................";
            std::fill_n(bar, std::size_t(32.0 * std::min(done, 1.0)), '#');
            std::fprintf(stderr, "\r\033[K[%s] %3.0f %%  %s", bar, 100.0 * done,
                         text(so_far).c_str());
            std::fflush(stderr);
        } else if (int(4.0 * done) > quarter_) {
            quarter_ = int(4.0 * done);
            std::fprintf(stderr, "%3d %%  %s\n", 25 * quarter_, text(so_far).c_str());
        }
    }
    ~Progress()
    {
        if (isatty(STDERR_FILENO)) {
            std::fprintf(stderr, "\r\033[K");
        }
    }

  private:
    static std::string text(const reference::Summary &so_far)
    {
        const double error = so_far.hair > 0.0 ? 100.0 * so_far.hair_error / so_far.hair : 0.0;
        char text[64];
        std::snprintf(text, sizeof text, "%llu samples, error %.2f %%",
                      static_cast<unsigned long long>(so_far.samples), error);
        return text;
    }
    int quarter_ = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Passes over the whole picture, so that the error is asked at the same samples whatever happened
// before. Returns: false when it was interrupted.
Expected<bool> trace(const Task &task, const reference::World &world,
                     const reference::Camera &camera, std::uint64_t key, reference::Film &film)
{
    Progress progress;
    const reference::Tracer tracer(world);
    auto saved = std::chrono::steady_clock::now();
    for (;;) {
        const reference::Summary summary = film.summary();
        const bool enough = task.error > 0.0 && summary.samples % samples_a_pass == 0 &&
                            summary.samples >= 4 * samples_a_pass &&
                            summary.hair_error <= task.error * summary.hair;
        if (summary.samples >= task.work.samples || enough) {
            return true;
        }
        reference::Work pass = task.work;
        pass.samples = std::min(task.work.samples,
                                (summary.samples / samples_a_pass + 1) * samples_a_pass);
        const bool whole = reference::render(tracer, camera, pass, film, [&](double done) {
            const double at = double(summary.samples) +
                              done * double(pass.samples - summary.samples);
            progress.show(at / double(task.work.samples), summary);
            return !interrupted;
        });
        if (!whole || seconds_since(saved) > seconds_between_states) {
            const Expected<bool> written = film.write(task.state(), key);
            if (!written) {
                return Error{written.error()};
            }
            saved = std::chrono::steady_clock::now();
        }
        if (!whole) {
            return false;
        }
    }
}

std::string report(const Task &task, std::size_t strands, const reference::Summary &summary,
                   double seconds)
{
    char text[512];
    std::snprintf(text, sizeof text,
                  "strands          %zu\n"
                  "samples          %llu a pixel\n"
                  "mean luminance   %.6g +- %.2g\n"
                  "hair luminance   %.6g, weighed by coverage\n"
                  "hair coverage    %.4g\n"
                  "standard error   %.3g of the hair's luminance, root mean square over pixels\n"
                  "time             %.2f s, %u threads\n",
                  strands, static_cast<unsigned long long>(summary.samples), summary.mean,
                  summary.mean_error, summary.hair, summary.coverage,
                  summary.hair > 0.0 ? summary.hair_error / summary.hair : 0.0, seconds,
                  task.work.threads);
    return task.said + text;
}

int run(const Task &task)
{
    const auto begin = std::chrono::steady_clock::now();
    const Expected<scene::Material> material = scene::material(task.scene);
    if (!material) {
        return complain(material.error());
    }
    const Expected<reference::FiberParams> params = reference::fiber_params(task.scene, *material);
    if (!params) {
        return complain(params.error());
    }
    const Expected<scene::Hair> hair = scene::hair(task.scene);
    if (!hair) {
        return complain(hair.error());
    }
    const std::uint64_t key = key_of(task, hair->groom);
    reference::Film film(task.scene.width, task.scene.height);
    if (task.resume && std::filesystem::exists(task.state())) {
        Expected<reference::Film> before =
            reference::Film::read(task.state(), key, film.width(), film.height());
        if (!before) {
            return complain(before.error());
        }
        film = std::move(*before);
    }
    const draw::Frame frame = scene::frame(task.scene, *hair, *material);
    const Expected<reference::World> world =
        reference::world(task.scene, *hair, *material, frame, task.work.threads);
    if (!world) {
        return complain(world.error());
    }
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    const Expected<bool> traced = trace(task, *world, reference::camera(frame), key, film);
    if (!traced) {
        return complain(traced.error(), command::exit_failure);
    }
    if (!*traced) {
        return complain("interrupted; --resume goes on from " + task.state(),
                        command::exit_failure);
    }
    std::string error;
    const Expected<bool> written = film.write(task.state(), key);
    if (!written || !image::write_exr(task.path, film.image(), error)) {
        return complain(written ? error : written.error(), command::exit_failure);
    }
    return command::print("reference", report(task, hair->report.strands, film.summary(),
                                              seconds_since(begin)));
}

} // namespace

int command_reference(int argc, char **argv)
{
    command::Arguments arguments;
    std::string error;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain(error);
    }
    if (arguments.help()) {
        return command::print("reference", command::help_text(manual()));
    }
    const Expected<Task> task = asked(arguments);
    return task ? run(*task) : complain(task.error());
}

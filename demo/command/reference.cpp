// `tsuya reference`: a scene by path tracing, with its standard error.
#include "commands.h"
#include "reference_task.h"

#include "reference/world.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace tsuya;
using command::Task;
using groom::Error;
using groom::Expected;

constexpr std::uint64_t samples_a_pass = 4;
constexpr double seconds_between_states = 30.0;

int complain(const std::string &text, int code = command::exit_bad_input)
{
    const bool dot = !text.empty() && (text.back() == '.' || text.back() == '\n');
    return command::complain("reference", text + (dot ? "" : "."), code);
}

// Of all that a sample depends on.
std::uint64_t key_of(const Task &task, const groom::Groom &groom)
{
    scene::Scene scene = task.scene;
    scene.title.clear();
    scene.exposure = 0.0;
    scene.tone = "film";
    scene.match = "none";
    const std::string text = scene::write(scene);
    std::uint64_t key = reference::key_of(text.data(), text.size());
    key = reference::key_of(&task.work.seed, sizeof task.work.seed, key);
    key = reference::key_of(groom.points.data(), groom.points.size() * sizeof groom.points[0], key);
    // What cannot be read is complained of when the world is made.
    const Expected<scene::Globe> globe =
        scene.environment == "none" ? Error{"none"} : scene::Globe::of(scene);
    for (std::size_t i = 0; globe && i < globe->count(); i++) {
        const glm::dvec3 radiance = globe->radiance(i);
        key = reference::key_of(&radiance.x, sizeof radiance, key);
    }
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
        const bool enough = task.error > 0.0 && summary.samples == summary.samples_most &&
                            summary.samples >= 4 * samples_a_pass &&
                            summary.hair_error <= task.error * summary.hair;
        if (summary.samples >= task.work.samples || enough) {
            return true;
        }
        reference::Work pass = task.work;
        pass.samples =
            std::min(task.work.samples, (summary.samples / samples_a_pass + 1) * samples_a_pass);
        const bool whole = reference::render(tracer, camera, pass, film, [&](double done) {
            const double at =
                double(summary.samples) + done * double(pass.samples - summary.samples);
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
    if (task.scene.kind != "hair") {
        return complain("the path tracer knows hair alone; this scene is a " + task.scene.kind);
    }
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
    if (!hair->note.empty()) {
        command::complain("reference", hair->note + ".", command::exit_ok);
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
    // A place that cannot be written is better found before the work than after it.
    const Expected<bool> writable = film.write(task.state(), key);
    if (!writable) {
        return complain(writable.error(), command::exit_failure);
    }
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
    image::Image picture = film.image();
    picture.texts = {{"tsuya.scene", "# traced\n" + scene::write(task.scene)},
                     {"tsuya.samples", std::to_string(film.summary().samples)},
                     {"tsuya.seed", std::to_string(task.work.seed)}};
    if (!written || !image::write_exr(task.path, picture, error)) {
        return complain(written ? error : written.error(), command::exit_failure);
    }
    return command::print("reference",
                          report(task, hair->report.strands, film.summary(), seconds_since(begin)));
}

} // namespace

int command_reference(int argc, char **argv)
{
    command::Arguments arguments;
    std::string error;
    if (!arguments.parse(command::reference_manual(), argc, argv, error)) {
        return complain(error);
    }
    if (arguments.help()) {
        return command::print("reference", command::help_text(command::reference_manual()));
    }
    const Expected<Task> task = command::reference_task(arguments);
    return task ? run(*task) : complain(task.error());
}

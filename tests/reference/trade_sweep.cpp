// Errors of every tier on scenes drawn at random, against the path tracer, as CSV: what the
// predictor in the trade table is fitted on, and what the chooser is tried on.
//
//   trade_sweep FILE.csv --from SEED --count N [--samples MOST] [--threads T]
//               [--paths SEED] [--films FOLDER] [--tier TIER]
//   trade_sweep --print SEED     that scene, as a scene file
//
// Adds a scene's rows to FILE.csv at once when it is done; scenes that stand there are left alone,
// so that the program goes on where it was stopped. A row is one colour channel of one tier: the
// traits that the chooser goes by (scene/traits.h), rel MSE and error of the mean of that channel
// and, the same in the three rows, of the picture (figures.h). Scenes: random_scene.h. The head is
// there and lights the hair in the reference, as `tsuya reference` has it. --films keeps what was
// traced (some 10 MB a scene): with it a change to a tier asks for new pictures only, and with
// --tier for those of that tier.
#include "reference/cells.h"
#include "reference/random_scene.h"
#include "reference/world.h"
#include "scene/traits.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace
{

using namespace tsuya;
using namespace tsuya::reference;

const char *const head =
    "scene,tier,channel,sigma_a,sky_share,light_cosine,strand_pixels,"
    "depth,curl,beta_R,covered,"
    "rel_mse,rel_mse_se,mean_ratio,mean_ratio_se,samples,picture_rel_mse,picture_rel_mse_se,"
    "luminance_error,luminance_error_se\n";

const std::vector<Tier> tiers_on_offer = {
    {"unshadowed", {"model=kajiya_kay", "shadow=none"}},
    {"kajiya_kay", {"model=kajiya_kay", "shadow=deep_opacity"}},
    {"marschner", {"model=marschner", "shadow=deep_opacity"}},
    {"exact", {"model=dual_scattering", "shadow=deep_opacity"}},
    {"plane_parallel", {"model=plane_parallel_hair", "shadow=deep_opacity"}},
};

constexpr std::uint64_t least_samples = 48;

struct Options {
    std::string path, films, tier;
    std::uint64_t from = 1, count = 0, samples = 128;
    std::uint64_t paths = 0; // other numbers, other paths through the same scenes
    unsigned threads = std::max(1u, std::thread::hardware_concurrency());
};

// All on offer, or the one of that name.
std::vector<Tier> tiers_asked(const Options &options)
{
    std::vector<Tier> result;
    for (const Tier &tier : tiers_on_offer) {
        if (options.tier.empty() || options.tier == tier.name) {
            result.push_back(tier);
        }
    }
    return result;
}

bool parse(int argc, char **argv, Options &options)
{
    for (int i = 1; i < argc; i++) {
        const std::string word = argv[i];
        if (word.rfind("--", 0) != 0 && options.path.empty()) {
            options.path = word;
            continue;
        }
        const char *const value = i + 1 < argc ? argv[++i] : nullptr;
        if (!value) {
            return false;
        } else if (word == "--from") {
            options.from = std::strtoull(value, nullptr, 10);
        } else if (word == "--count") {
            options.count = std::strtoull(value, nullptr, 10);
        } else if (word == "--paths") {
            options.paths = std::strtoull(value, nullptr, 10);
        } else if (word == "--films") {
            options.films = value;
        } else if (word == "--tier") {
            options.tier = value;
        } else if (word == "--samples") {
            options.samples =
                std::strtoull(value, nullptr, 10) / Batches::count * std::uint64_t(Batches::count);
        } else if (word == "--threads") {
            options.threads = unsigned(std::atoi(value));
        } else {
            return false;
        }
    }
    return !options.path.empty() && options.count > 0 && options.samples >= Batches::count &&
           !tiers_asked(options).empty();
}

std::set<std::uint64_t> scenes_in(const std::string &path)
{
    std::set<std::uint64_t> result;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (!line.empty() && line[0] >= '0' && line[0] <= '9') {
            result.insert(std::strtoull(line.c_str(), nullptr, 10));
        }
    }
    return result;
}

struct Drawn {
    scene::Traits traits;
    std::vector<draw::Picture> pictures;
    std::vector<Figures> figures;
    std::uint64_t samples = 0;
};

Expected<Drawn> take(scene::Studio &studio, std::uint64_t seed, const Options &options)
{
    Drawn drawn;
    const std::vector<std::string> words = random_scene(seed);
    const Expected<scene::Scene> plain = scene::override(scene::Scene(), words);
    if (!plain) {
        return Error{plain.error()};
    }
    const Expected<scene::Hair> hair = scene::hair(*plain);
    const Expected<scene::Material> fiber = scene::material(*plain);
    if (!hair || !fiber) {
        return Error{hair ? fiber.error() : hair.error()};
    }
    const draw::Frame frame = scene::frame(*plain, *hair, *fiber);
    drawn.traits = scene::traits(*plain, *hair, *fiber, frame);
    draw::Renderer &renderer = studio.renderer();
    Expected<bool> good = renderer.load(hair->groom, hair->head, hair->solid);
    for (const Tier &tier : tiers_asked(options)) {
        const Expected<scene::Scene> scene = scene::override(*plain, tier.words);
        const Expected<scene::Material> material =
            scene ? scene::material(*scene) : Error{scene.error()};
        if (!good || !material) {
            return Error{good ? material.error() : good.error()};
        }
        good = renderer.material(material->model, material->params.data(), material->variant);
        good = good ? renderer.draw(scene::frame(*scene, *hair, *material)) : std::move(good);
        drawn.pictures.push_back(renderer.picture());
    }
    const Expected<World> world =
        good ? reference::world(*plain, *hair, *fiber, frame, options.threads)
             : Expected<World>(Error{good.error()});
    if (!world) {
        return Error{world.error()};
    }
    const Tracer tracer(*world);
    Batches batches(plain->width, plain->height);
    const std::string kept =
        options.films.empty() ? "" : options.films + "/" + std::to_string(seed) + ".";
    std::string text;
    for (const std::string &word : words) {
        text += word + "\n";
    }
    const std::uint64_t key = key_of(text.data(), text.size(), options.paths);
    drawn.samples = kept.empty() ? 0 : batches.read(kept, key);
    drawn.samples =
        std::max(drawn.samples, std::min<std::uint64_t>(least_samples, options.samples));
    // Until every error is five times its standard error, or the most.
    for (;; drawn.samples = std::min(2 * drawn.samples, options.samples)) {
        batches.bring(tracer, camera(frame), drawn.samples, seed + 1000003 * options.paths,
                      options.threads);
        drawn.figures = figures(batches, drawn.pictures);
        const bool fine =
            std::all_of(drawn.figures.begin(), drawn.figures.end(),
                        [](const Figures &f) { return 5.0 * f.rel_mse.error < f.rel_mse.value; });
        if (fine || drawn.samples >= options.samples) {
            if (!kept.empty() && !batches.write(kept, key)) {
                return Error{"cannot write " + kept + "*"};
            }
            return Expected<Drawn>(std::move(drawn));
        }
    }
}

std::string rows(std::uint64_t seed, const Options &options, const Drawn &drawn)
{
    const std::vector<Tier> tiers = tiers_asked(options);
    std::string text;
    const scene::Traits &t = drawn.traits;
    for (std::size_t k = 0; k < tiers.size(); k++) {
        const Figures &f = drawn.figures[k];
        for (std::size_t c = 0; c < 3; c++) {
            char line[512];
            std::snprintf(line, sizeof line,
                          "%llu,%s,%c,%.5g,%.4f,%.4f,%.4g,%.4g,%.4f,%.4f,%.0f,%.5g,%.2g,%.5f,%.2g,"
                          "%llu,%.5g,%.2g,%.5f,%.2g\n",
                          static_cast<unsigned long long>(seed), tiers[k].name, "rgb"[c],
                          t.sigma_a[int(c)], t.sky_share, t.light_cosine, t.strand_pixels, t.depth,
                          t.curl, t.beta_R, t.covered_pixels, f.channel_mse[c].value,
                          f.channel_mse[c].error, 1.0 + f.channel_error[c].value,
                          f.channel_error[c].error, static_cast<unsigned long long>(drawn.samples),
                          f.rel_mse.value, f.rel_mse.error, f.mean_error.value, f.mean_error.error);
            text += line;
        }
    }
    return text;
}

int run(const Options &options)
{
    const auto append = [&](const std::string &text) {
        std::ofstream file(options.path, std::ios::app);
        file << text;
        return bool(file.flush());
    };
    const std::set<std::uint64_t> there = scenes_in(options.path);
    if (!std::ifstream(options.path) && !append(head)) {
        std::fprintf(stderr, "trade_sweep: cannot write %s\n", options.path.c_str());
        return 1;
    }
    const Expected<std::unique_ptr<scene::Studio>> studio = scene::Studio::create();
    if (!studio) {
        std::fprintf(stderr, "trade_sweep: %s\n", studio.error().c_str());
        return 1;
    }
    for (std::uint64_t seed = options.from; seed < options.from + options.count; seed++) {
        if (there.count(seed)) {
            continue;
        }
        const Expected<Drawn> drawn = take(**studio, seed, options);
        if (!drawn) { // hair that cannot be grown: too few points for its curls
            std::fprintf(stderr, "trade_sweep: without scene %llu: %s\n",
                         static_cast<unsigned long long>(seed), drawn.error().c_str());
        } else if (!append(rows(seed, options, *drawn))) {
            std::fprintf(stderr, "trade_sweep: cannot write %s\n", options.path.c_str());
            return 1;
        }
    }
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    if (argc == 3 && std::string(argv[1]) == "--print") {
        for (const std::string &word : random_scene(std::strtoull(argv[2], nullptr, 10))) {
            std::printf("%s\n", word.c_str());
        }
        return 0;
    }
    Options options;
    if (!parse(argc, argv, options)) {
        std::fprintf(stderr, "usage: trade_sweep FILE.csv --from SEED --count N [--samples MOST] "
                             "[--threads T] [--paths SEED] [--films FOLDER] "
                             "[--tier TIER]\n");
        return 2;
    }
    try {
        // A folder that cannot be made is better found before the work than after it.
        if (!options.films.empty()) {
            std::filesystem::create_directories(options.films);
        }
        return run(options);
    } catch (const std::exception &error) { // of Embree, of folders; memory above all
        std::fprintf(stderr, "trade_sweep: %s\n", error.what());
        return 1;
    }
}

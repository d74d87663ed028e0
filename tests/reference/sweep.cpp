// The image table: the renderer's tiers against the reference, cell by cell, as CSV.
//
//   image_sweep FILE.csv [--size N] [--samples MOST] [--seed S] [--threads T] [--dome RADIANCE]
//               [--groom GROOM] [--color COLOR] [--light LIGHT] [--only GROOM,COLOR,LIGHT]
//               [--pictures FOLDER] [--films FOLDER]
//
// Adds rows to FILE.csv, a cell's at once when it is done; cells that stand there, by groom,
// color, light, dome and size, are left alone, so that the program goes on where it was stopped.
// --groom, also several times, names a groom: straight, curly or the path of a groom file, which
// is labelled with its name. Without it: straight and curly. --color and --light in the same way;
// without them: black, brown, blond, white, dyed; front, side, back.
// --pictures writes the reference and the tiers of each cell as EXR; --films keeps what was traced
// for another sweep with other tiers.
//
// A cell has the least number of samples, out of 32, 48, 80, 128, ... MOST (default 128), that
// holds the standard errors reference/cells.h asks for; a cell that needs more has MOST.
#include "reference/cells.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <thread>

namespace
{

using namespace tsuya;
using namespace tsuya::reference;

constexpr const char *head = "groom,color,light,dome,tier,size,seed,samples,mean,mean_se,"
                             "mean_error,mean_error_se,rel_mse,rel_mse_se,cost,scene\n";

struct Options {
    std::string path, pictures, only;
    std::vector<std::string> grooms = {"straight", "curly"};
    std::vector<std::string> colors = {"black", "brown", "blond", "white", "dyed"};
    std::vector<std::string> lights = {"front", "side", "back"};
    int size = 256;
    double dome = 1.5;
    std::uint64_t seed = 1;
    Limits limits{32, 128, std::max(1u, std::thread::hardware_concurrency()), {}};
};

bool parse(int argc, char **argv, Options &options)
{
    std::vector<std::string> grooms, colors, lights;
    for (int i = 1; i < argc; i++) {
        const std::string word = argv[i];
        if (word.rfind("--", 0) != 0 && options.path.empty()) {
            options.path = word;
            continue;
        }
        const char *const value = i + 1 < argc ? argv[++i] : nullptr;
        if (!value) {
            return false;
        } else if (word == "--size") {
            options.size = std::atoi(value);
        } else if (word == "--samples") {
            options.limits.most =
                std::strtoull(value, nullptr, 10) / Batches::count * std::uint64_t(Batches::count);
        } else if (word == "--seed") {
            options.seed = std::strtoull(value, nullptr, 10);
        } else if (word == "--threads") {
            options.limits.threads = unsigned(std::atoi(value));
        } else if (word == "--dome") {
            options.dome = std::atof(value);
        } else if (word == "--groom") {
            grooms.push_back(value);
        } else if (word == "--color") {
            colors.push_back(value);
        } else if (word == "--light") {
            lights.push_back(value);
        } else if (word == "--only") {
            options.only = value;
        } else if (word == "--pictures") {
            options.pictures = value;
        } else if (word == "--films") {
            options.limits.films = value;
        } else {
            return false;
        }
    }
    options.grooms = grooms.empty() ? options.grooms : grooms;
    options.colors = colors.empty() ? options.colors : colors;
    options.lights = lights.empty() ? options.lights : lights;
    return !options.path.empty() && options.size >= 8 && options.size <= 4096 &&
           options.limits.most >= options.limits.least;
}

// groom,color,light,dome,size of a cell.
std::string key(const Cell &cell)
{
    char dome[32];
    std::snprintf(dome, sizeof dome, "%g", cell.dome);
    return cell.name() + "," + cell.color + "," + cell.light + "," + dome + "," +
           std::to_string(cell.size);
}

std::set<std::string> keys_in(const std::string &path)
{
    std::set<std::string> result;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        std::vector<std::string> f;
        for (std::string field; f.size() < 6 && std::getline(fields, field, ',');) {
            f.push_back(field);
        }
        if (f.size() == 6) {
            result.insert(f[0] + "," + f[1] + "," + f[2] + "," + f[3] + "," + f[5]);
        }
    }
    return result;
}

bool append(const std::string &path, const std::string &text)
{
    std::ofstream file(path, std::ios::app);
    file << text;
    return bool(file.flush());
}

std::string rows(const Taken &taken, const Result &result)
{
    std::string text;
    for (std::size_t k = 0; k < tiers().size(); k++) {
        const Figures &f = result.figures[k];
        char line[512];
        std::snprintf(line, sizeof line,
                      "%s,%s,%s,%g,%s,%d,%llu,%llu,%.6g,%.2g,%.5f,%.5f,%.5f,%.5f,%.3f,",
                      taken.cell.name().c_str(), taken.cell.color.c_str(), taken.cell.light.c_str(),
                      taken.cell.dome, tiers()[k].name, taken.cell.size,
                      static_cast<unsigned long long>(taken.cell.seed),
                      static_cast<unsigned long long>(result.samples), f.mean.value, f.mean.error,
                      f.mean_error.value, f.mean_error.error, f.rel_mse.value, f.rel_mse.error,
                      taken.seconds[k] / taken.seconds[0]);
        text += line + ("\"" + line_of(taken.scene)) + "\"\n";
    }
    return text;
}

void save(const std::string &folder, const Taken &taken, const Result &result)
{
    const std::string start =
        folder + "/" + taken.cell.name() + "-" + taken.cell.color + "-" + taken.cell.light + "-";
    std::string error;
    bool good = image::write_exr(start + "reference.exr", result.film.image(), error);
    for (std::size_t k = 0; k < tiers().size() && good; k++) {
        const draw::Picture &picture = taken.pictures[k];
        const image::Image image = {
            picture.width, picture.height, 4, picture.pixels, {"R", "G", "B", "hair"}};
        good = image::write_exr(start + tiers()[k].name + ".exr", image, error);
    }
    if (!good) {
        std::fprintf(stderr, "image_sweep: %s\n", error.c_str());
    }
}

int run(const Options &options)
{
    const std::set<std::string> there = keys_in(options.path);
    if (!std::ifstream(options.path) && !append(options.path, head)) {
        std::fprintf(stderr, "image_sweep: cannot write %s\n", options.path.c_str());
        return 1;
    }
    const Expected<std::unique_ptr<scene::Studio>> studio = scene::Studio::create();
    if (!studio) {
        std::fprintf(stderr, "image_sweep: %s\n", studio.error().c_str());
        return 1;
    }
    for (const std::string &groom : options.grooms) {
        std::vector<Cell> cells;
        for (const std::string &color : options.colors) {
            for (const std::string &light : options.lights) {
                const Cell cell = {groom, color, light, options.dome, options.size, options.seed};
                const bool asked =
                    options.only.empty() || options.only == cell.name() + "," + color + "," + light;
                if (asked && !there.count(key(cell))) {
                    cells.push_back(cell);
                }
            }
        }
        const Expected<std::vector<Taken>> drawn = draw_cells(**studio, cells, tiers());
        if (!drawn) {
            std::fprintf(stderr, "image_sweep: %s\n", drawn.error().c_str());
            return 1;
        }
        for (const Taken &taken : *drawn) {
            const Expected<Result> result = trace(taken, options.limits);
            if (!result || !append(options.path, rows(taken, *result))) {
                std::fprintf(stderr, "image_sweep: %s\n",
                             result ? "cannot write rows" : result.error().c_str());
                return 1;
            }
            const Figures &last = result->figures.back();
            std::fprintf(stderr,
                         "%s: %llu samples, plane_parallel: mean %+.2f +- %.2f %%, "
                         "rel MSE %.4f +- %.4f\n",
                         key(taken.cell).c_str(), static_cast<unsigned long long>(result->samples),
                         100.0 * last.mean_error.value, 100.0 * last.mean_error.error,
                         last.rel_mse.value, last.rel_mse.error);
            if (!options.pictures.empty()) {
                save(options.pictures, taken, *result);
            }
        }
    }
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    Options options;
    if (!parse(argc, argv, options)) {
        std::fprintf(stderr, "usage: image_sweep FILE.csv [--size N] [--samples MOST] [--seed S] "
                             "[--threads T]\n       [--dome RADIANCE] [--groom GROOM] [--color COLOR] "
                             "[--light LIGHT]\n       [--only GROOM,COLOR,LIGHT] "
                             "[--pictures FOLDER] [--films FOLDER]\n");
        return 2;
    }
    try {
        // A folder that cannot be made is better found before the work than after it.
        for (const std::string &folder : {options.pictures, options.limits.films}) {
            if (!folder.empty()) {
                std::filesystem::create_directories(folder);
            }
        }
        return run(options);
    } catch (const std::exception &error) { // of Embree, of folders; memory above all
        std::fprintf(stderr, "image_sweep: %s\n", error.what());
        return 1;
    }
}

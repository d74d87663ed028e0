// `tsuya bench`: what each tier costs on this machine.
#include "arguments.h"
#include "commands.h"
#include "number.h"

#include "../bench/measure.h"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace
{

using namespace tsuya::command;
using namespace tsuya::bench;

const std::vector<std::string> parts = {"pixel", "memory", "bake", "api"};

Manual manual()
{
    return {
        "bench",
        "[--csv] [--only PART] [--size N] [--rounds N]",
        "Measures what each tier of shading costs here: time a pixel beside Lambert's and GGX's "
        "in\n"
        "the same run, memory, texture fetches, time of a bake on one core, and what the "
        "library's\n"
        "calls cost a frame with 1 to 10000 materials. Takes some ten seconds.\n"
        "\n"
        "The driver is OpenGL's first one; with Mesa, GALLIUM_DRIVER=softpipe asks for another.\n"
        "Pixels of a GPU are timed by timer queries; a software driver's, and all else, in "
        "processor\n"
        "time, glFinish included. What AMD's hardware would need is told by "
        "tests/bench/static.py.\n"
        "\n"
        "Columns of --csv, after lines that begin with # and describe the machine:\n"
        "  tier,quantity,key,value\n"
        "  TIER,pixel,DRIVER/ns|lambert|ggx   ns a pixel; over those of Lambert, of GGX\n"
        "  TIER,pixel,DRIVER/wall_ns          ns a pixel by the wall clock\n"
        "  TIER,fetches,   TIER,bytes,        texture fetches a light; bytes of tables\n"
        "  TIER,bake_ms,                      bake of one material\n"
        "  api,FRAME.WHAT,MATERIALS           FRAME: unchanged, one_changed, all_changed, bind;\n"
        "                                     WHAT: ns, calls, bytes, allocations\n",
        {{"--csv", "", "print CSV, not tables"},
         {"--only", "PART", "one of " + joined(parts)},
         {"--size", "N", "pixels along a side, 8 to 4096; default 256, softpipe 64"},
         {"--rounds", "N", "samples of each time, 1 to 10000; default 41"}},
        "  tsuya bench\n"
        "  GALLIUM_DRIVER=softpipe tsuya bench --csv --only pixel\n"};
}

// The model's name of the processor, where the system tells it.
std::string processor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos) {
            return line.substr(line.find(": ") + 2);
        }
    }
    return "unknown";
}

bool whole(const Arguments &arguments, const std::string &option, int low, int high, int &value,
           std::string &error)
{
    double number = 0;
    if (!arguments.has(option)) {
        return true;
    }
    const std::string text = arguments.get(option);
    if (!parse_number(text, number) || !(number >= low && number <= high) ||
        number != std::floor(number)) {
        error = option + ": " + text + " is not a whole number in [" + std::to_string(low) + ", " +
                std::to_string(high) + "].";
        return false;
    }
    value = int(number);
    return true;
}

// Counts are whole, times have four digits.
std::string text_of(double value)
{
    return number_text(value >= 1000.0 ? std::round(value) : value,
                       value == std::floor(value) || value >= 1000.0 ? 12 : 4);
}

std::string csv(const std::vector<std::string> &setup, const Rows &rows)
{
    std::string text;
    for (const std::string &line : setup) {
        text += "# " + line + "\n";
    }
    text += "tier,quantity,key,value\n";
    for (const Row &row : rows) {
        text += row.tier + "," + row.quantity + "," + row.key + "," + text_of(row.value) + "\n";
    }
    return text;
}

void pad(std::string &text, const std::string &cell, std::size_t width, bool left)
{
    const std::string blanks(width > cell.size() ? width - cell.size() : 0, ' ');
    text += left ? cell + blanks : "  " + blanks + cell;
}

// Rows of one name down, columns across, in the order in which they come.
std::string grid(const std::string &corner, const Rows &rows)
{
    std::vector<std::string> names, columns;
    const auto add = [](std::vector<std::string> &list, const std::string &name) {
        for (const std::string &known : list) {
            if (known == name) {
                return;
            }
        }
        list.push_back(name);
    };
    for (const Row &row : rows) {
        add(names, row.tier);
        add(columns, row.quantity);
    }
    std::string text;
    pad(text, corner, 20, true);
    for (const std::string &column : columns) {
        pad(text, column, 11, false);
    }
    text += "\n";
    for (const std::string &name : names) {
        pad(text, name, 20, true);
        for (const std::string &column : columns) {
            std::string cell = "-";
            for (const Row &row : rows) {
                if (row.tier == name && row.quantity == column) {
                    cell = text_of(row.value);
                }
            }
            pad(text, cell, 11, false);
        }
        text += "\n";
    }
    return text;
}

// The long form as two grids: tiers, and frames by the number of materials.
std::string tables(const std::vector<std::string> &setup, const Rows &rows)
{
    Rows by_tier, by_frame;
    std::string text;
    for (const std::string &line : setup) {
        text += line + "\n";
    }
    for (const Row &row : rows) {
        if (row.tier == "api") {
            const std::size_t dot = row.quantity.find('.');
            by_frame.push_back({row.quantity.substr(0, dot) + " " + row.key, "",
                                row.quantity.substr(dot + 1), row.value});
            by_frame.back().quantity = by_frame.back().key;
        } else if (row.quantity == "pixel") {
            const std::string what = row.key.substr(row.key.find('/') + 1);
            by_tier.push_back({row.tier,
                               what == "ns"        ? "ns/pixel"
                               : what == "wall_ns" ? "wall"
                                                   : "x " + what,
                               "", row.value});
        } else {
            by_tier.push_back({row.tier, row.quantity, "", row.value});
        }
    }
    text += by_tier.empty() ? "" : "\n" + grid("tier", by_tier);
    text += by_frame.empty() ? "" : "\n" + grid("frame, materials", by_frame);
    return text;
}

} // namespace

int command_bench(int argc, char **argv)
{
    Arguments arguments;
    std::string error;
    int size = 0, rounds = 0;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain("bench", error, exit_bad_input);
    }
    if (arguments.help()) {
        return print("bench", help_text(manual()));
    }
    if (!arguments.positional().empty()) {
        return complain("bench", "no argument is taken, " + arguments.positional()[0] + " is one.",
                        exit_bad_input);
    }
    const std::string only = arguments.get("--only");
    bool known = !arguments.has("--only");
    for (const std::string &part : parts) {
        known = known || part == only;
    }
    if (!known) {
        error = "--only: there is no part \"" + only + "\"" + suggestion(only, parts) +
                "; the parts are " + joined(parts) + ".";
        return complain("bench", error, exit_bad_input);
    }
    if (!whole(arguments, "--size", 8, 4096, size, error) ||
        !whole(arguments, "--rounds", 1, 10000, rounds, error)) {
        return complain("bench", error, exit_bad_input);
    }
    const Context context;
    std::vector<std::string> setup = {
        "processor: " + processor(), "GL: " + context.description(),
        std::string("pixels timed by: ") +
            (context.software() ? "processor time, glFinish included" : "timer queries")};
    Rows rows;
    const auto take = [&](const char *part, const auto &measure) {
        if (only.empty() || only == part) {
            const Rows more = measure();
            rows.insert(rows.end(), more.begin(), more.end());
        }
    };
    take("pixel", [&] { return measure_pixels(context, size, rounds); });
    take("memory", [] { return measure_memory(); });
    take("bake", [&] { return measure_bakes(rounds); });
    take("api", [&] { return measure_api(context, rounds); });
    return print("bench", arguments.has("--csv") ? csv(setup, rows) : tables(setup, rows));
}

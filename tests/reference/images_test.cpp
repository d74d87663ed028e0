// Four cells of the image table again, small, with another seed: every figure within three standard
// errors of the committed one. usage: images_test images.csv
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "reference/cells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <thread>
#include <utility>

extern "C" {
#include <cmocka.h>
}

namespace
{

using namespace tsuya;
using namespace tsuya::reference;

std::string table;
std::unique_ptr<scene::Studio> studio;

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string &line)
{
    std::vector<std::string> fields(1);
    bool quoted = false; // a scene has commas in its colours
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

// The committed row of a cell and a tier.
Row row_of(const Cell &cell, const std::string &tier)
{
    std::ifstream file(table);
    std::vector<std::string> names;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        const std::vector<std::string> fields = split(line);
        if (names.empty()) {
            names = fields;
            continue;
        }
        Row row;
        for (std::size_t i = 0; i < std::min(names.size(), fields.size()); i++) {
            row[names[i]] = fields[i];
        }
        if (row["groom"] == cell.groom && row["color"] == cell.color &&
            row["light"] == cell.light && row["tier"] == tier &&
            row["size"] == std::to_string(cell.size) && std::stod(row["dome"]) == cell.dome) {
            return row;
        }
    }
    fail_msg("%s has no row %s, %s, %s, %d, %s", table.c_str(), cell.groom.c_str(),
             cell.color.c_str(), cell.light.c_str(), cell.size, tier.c_str());
    return {};
}

void hold(const Row &row, const std::string &name, const Figure &now)
{
    const double committed = std::stod(row.at(name));
    const double error = std::hypot(now.error, std::stod(row.at(name + "_se")));
    std::printf("%s %s %s %s %s: %.5f +- %.5f, committed %.5f, %.1f standard errors off\n",
                row.at("groom").c_str(), row.at("color").c_str(), row.at("light").c_str(),
                row.at("tier").c_str(), name.c_str(), now.value, now.error, committed,
                std::abs(now.value - committed) / error);
    assert_true(now.error > 0.0 && std::abs(now.value - committed) <= 3.0 * error);
}

void again(Cell cell, std::uint64_t samples)
{
    cell.size = 64;
    cell.seed = 2;
    std::vector<Tier> best(tiers().end() - 2, tiers().end());
    const Expected<std::vector<Taken>> drawn = draw_cells(*studio, {cell}, best);
    if (!drawn) {
        fail_msg("%s", drawn.error().c_str());
    }
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    const Expected<Result> result = trace(drawn->front(), {samples, samples, threads, {}});
    if (!result) {
        fail_msg("%s", result.error().c_str());
    }
    for (std::size_t k = 0; k < best.size(); k++) {
        const Row row = row_of(cell, best[k].name);
        assert_string_equal(row.at("scene").c_str(), line_of(drawn->front().scene).c_str());
        hold(row, "mean_error", result->figures[k].mean_error);
        hold(row, "rel_mse", result->figures[k].rel_mse);
    }
}

void blond_straight_front(void **)
{
    again({"straight", "blond", "front"}, 64);
}

void brown_curly_side(void **)
{
    again({"curly", "brown", "side"}, 64);
}

void blond_straight_window(void **)
{
    again({"straight", "blond", "window", 0.0}, 256);
}

void brown_curly_rect(void **)
{
    again({"curly", "brown", "rect", 0.2}, 256);
}

// What noise does to the figures: of a picture that is the reference itself, and of one whose
// errors are known.
void figures_have_no_bias(void **)
{
    constexpr int size = 24, rounds = 24;
    Film film(size, size);
    double mean = 0.0, mse = 0.0, stated = 0.0, squares = 0.0;
    const double truth = 0.5, off = 0.05;
    draw::Picture picture;
    picture.width = picture.height = size;
    for (int i = 0; i < size * size; i++) {
        for (int c = 0; c < 3; c++) {
            picture.pixels.push_back(float(truth + off));
        }
        picture.pixels.push_back(i % 7 ? 1.0f : 0.0f);
    }
    for (int round = 0; round < rounds; round++) {
        Batches batches(size, size);
        batches.fill(64, [&](int b, int pixel, int sample) {
            Random random(std::uint64_t(100 * round + b), std::uint64_t(pixel),
                          std::uint64_t(sample));
            Sample s;
            // Noise as great as the value, and as skew as a light seldom met.
            s.radiance = glm::dvec3(random.unit() < 0.5 ? 0.0 : 2.0 * truth);
            s.hair = 1.0;
            return s;
        });
        const Figures f = figures(batches, {picture})[0];
        mean += f.mean_error.value / rounds;
        mse += f.rel_mse.value / rounds;
        stated += f.rel_mse.error * f.rel_mse.error / rounds;
        squares += f.rel_mse.value * f.rel_mse.value / rounds;
    }
    const double expected = off * off / (truth * truth * 1.01);
    const double spread = std::sqrt((squares - mse * mse) * rounds / (rounds - 1.0));
    std::printf("figures: mean error %.5f of %.5f, rel MSE %.5f of %.5f, spread %.5f, stated "
                "%.5f\n",
                mean, off / truth, mse, expected, spread, std::sqrt(stated));
    assert_true(std::abs(mean - off / truth) < 0.002);
    assert_true(std::abs(mse - expected) < 3.0 * spread / std::sqrt(double(rounds)));
    assert_true(std::abs(spread / std::sqrt(stated) - 1.0) < 0.45);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: images_test images.csv\n");
        return 2;
    }
    table = argv[1];
    groom::Expected<std::unique_ptr<scene::Studio>> made = scene::Studio::create();
    if (!made) {
        std::fprintf(stderr, "images_test: %s\n", made.error().c_str());
        return 1;
    }
    studio = std::move(*made);
    const CMUnitTest tests[] = {
        cmocka_unit_test(figures_have_no_bias),
        cmocka_unit_test(blond_straight_front),
        cmocka_unit_test(brown_curly_side),
        cmocka_unit_test(blond_straight_window),
        cmocka_unit_test(brown_curly_rect),
    };
    const int failed = cmocka_run_group_tests_name("images", tests, nullptr, nullptr);
    studio.reset();
    return failed;
}

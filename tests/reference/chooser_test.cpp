// The chooser on scenes that its table was not made from: whether the tier it picks is as good as
// was asked, and costs no more than it must.
//
//   chooser_test SCENES.csv [AGAIN.csv]
//
// SCENES.csv is what trade_sweep measured; each scene's true errors of all tiers stand in it. For
// each scene and for bounds from 0.1 to 3 that some tier meets in truth, the library chooses by the
// scene's traits. Held, as the README states them: the share of choices within the bound, that within
// twice the bound, and the share that costs at most 1.25 times the cheapest tier that truly meets
// it. AGAIN.csv holds some of the scenes measured once more, with other paths of light: their
// errors agree within 4 standard errors.
#include <tsuya/tsuya.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{

constexpr int bounds = 40;
constexpr double within_least = 0.90, twice_least = 0.999, cheap_least = 0.90;

struct Scene {
    tsu_choose_desc desc;
    std::map<std::string, double> mse, mse_error, luminance; // of each tier
};

int failures = 0;

void hold(bool good, const char *what)
{
    std::printf("%s: %s\n", good ? "holds" : "FAILS", what);
    failures += !good;
}

std::map<int, Scene> read(const char *path)
{
    std::map<int, Scene> scenes;
    std::ifstream file(path);
    std::vector<std::string> names;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) {
            cells.push_back(cell);
        }
        if (names.empty()) {
            names = cells;
            continue;
        }
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; i < std::min(names.size(), cells.size()); i++) {
            row[names[i]] = cells[i];
        }
        const auto number = [&](const char *name) { return std::atof(row[name].c_str()); };
        Scene &scene = scenes[int(number("scene"))];
        tsu_choose_desc &desc = scene.desc;
        if (scene.mse.empty()) {
            tsu_choose_desc_init(&desc);
        }
        desc.sigma_a[std::string("rgb").find(row["channel"])] = float(number("sigma_a"));
        desc.sky_share = float(number("sky_share"));
        desc.light_cosine = float(number("light_cosine"));
        desc.strand_pixels = float(number("strand_pixels"));
        desc.depth = float(number("depth"));
        desc.curl = float(number("curl"));
        desc.beta_R = float(number("beta_R"));
        desc.covered_pixels = float(number("covered"));
        desc.directional_lights = 2;
        desc.environments = 1;
        scene.mse[row["tier"]] = number("picture_rel_mse");
        scene.mse_error[row["tier"]] = number("picture_rel_mse_se");
        scene.luminance[row["tier"]] = number("luminance_error");
    }
    return scenes;
}

std::vector<tsu_tier_info> hair_tiers()
{
    std::vector<tsu_tier_info> tiers;
    for (std::uint32_t i = 0; i < tsu_tier_count(); i++) {
        tsu_tier_info info;
        tsu_tier_info_init(&info);
        if (tsu_tier_describe(tsu_tier(i), &info) == TSU_OK && info.kind == TSU_CHOOSE_HAIR) {
            tiers.push_back(info);
        }
    }
    return tiers;
}

double cost(tsu_context *context, const Scene &scene, const char *tier)
{
    tsu_prediction prediction;
    tsu_prediction_init(&prediction);
    tsu_choose_predict(context, &scene.desc, tsu_tier_find(tier), &prediction);
    return double(prediction.cost);
}

void judge(tsu_context *context, const std::map<int, Scene> &scenes)
{
    const std::vector<tsu_tier_info> tiers = hair_tiers();
    int count = 0, within = 0, twice = 0, cheap = 0;
    for (const auto &[seed, scene] : scenes) {
        for (int i = 0; i < bounds; i++) {
            tsu_choose_desc desc = scene.desc;
            desc.error_bound = float(0.1 * std::pow(30.0, (i + 0.5) / bounds));
            const double square = double(desc.error_bound) * double(desc.error_bound);
            double least = 1e300;
            for (const tsu_tier_info &tier : tiers) {
                if (scene.mse.at(tier.name) <= square) {
                    least = std::min(least, cost(context, scene, tier.name));
                }
            }
            tsu_choice choice;
            tsu_choice_init(&choice);
            if (least > 1e299) {
                continue; // no tier does
            }
            tsu_tier_info chosen;
            tsu_tier_info_init(&chosen);
            if (tsu_choose(context, &desc, &choice) != TSU_OK ||
                tsu_tier_describe(choice.tier, &chosen) != TSU_OK) {
                hold(false, "the scene has an answer");
                return;
            }
            const double mse = scene.mse.at(chosen.name);
            count++;
            within += mse <= square;
            twice += mse <= 4.0 * square;
            cheap += double(choice.cost) <= 1.25 * least;
            if (mse > 4.0 * square) {
                std::printf("scene %d, bound %.3f: %s errs by %.3f\n", seed,
                            double(desc.error_bound), chosen.name, std::sqrt(mse));
            }
        }
    }
    const double n = std::max(count, 1);
    std::printf("%zu scenes, %d choices: %.1f %% within the bound, %.2f %% within twice, "
                "%.1f %% at 1.25 times the least cost or below\n",
                scenes.size(), count, 100.0 * within / n, 100.0 * twice / n, 100.0 * cheap / n);
    hold(count >= 20 * int(scenes.size()), "most bounds can be met");
    hold(within >= within_least * count, "choices within the bound");
    hold(twice >= twice_least * count, "choices within twice the bound");
    hold(cheap >= cheap_least * count, "choices near the least cost");
}

// How far a switch of tier moves the mean luminance, with and without the gain for it.
void match(tsu_context *context, const std::map<int, Scene> &scenes)
{
    const std::vector<tsu_tier_info> tiers = hair_tiers();
    for (std::size_t k = 0; k + 1 < tiers.size(); k++) {
        double plain = 0.0, matched = 0.0;
        int near = 0;
        for (const auto &[seed, scene] : scenes) {
            float gain = 0.0f;
            tsu_choose_match(context, &scene.desc, tsu_tier_find(tiers[k + 1].name),
                             tsu_tier_find(tiers[k].name), &gain);
            const double step = (1.0 + scene.luminance.at(tiers[k].name)) /
                                (1.0 + scene.luminance.at(tiers[k + 1].name));
            plain += std::abs(std::log(step));
            matched += std::abs(std::log(double(gain) * step));
            near += std::abs(double(gain) * step - 1.0) <= 0.05;
        }
        const double n = double(scenes.size());
        std::printf("from %s to %s: mean luminance moves by %.1f %%, with the gain by %.1f %%, "
                    "below 5 %% in %.0f %% of scenes\n",
                    tiers[k + 1].name, tiers[k].name, 100.0 * plain / n, 100.0 * matched / n,
                    100.0 * near / n);
        hold(matched < plain, "the gain brings luminances nearer");
    }
}

void compare(const std::map<int, Scene> &committed, const std::map<int, Scene> &again)
{
    int count = 0, beyond = 0;
    for (const auto &[seed, scene] : again) {
        for (const auto &[tier, mse] : scene.mse) {
            const double error =
                std::hypot(scene.mse_error.at(tier), committed.at(seed).mse_error.at(tier));
            count++;
            beyond += std::abs(mse - committed.at(seed).mse.at(tier)) > 4.0 * error;
        }
    }
    std::printf("%d errors measured again, %d beyond 4 standard errors\n", count, beyond);
    hold(count > 0 && beyond <= 0.03 * count, "errors measured again are those of the table");
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2 && argc != 3) {
        std::fprintf(stderr, "usage: chooser_test SCENES.csv [AGAIN.csv]\n");
        return 2;
    }
    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    tsu_context *context = nullptr;
    tsu_context_create(&desc, &context);
    const std::map<int, Scene> scenes = read(argv[1]);
    hold(scenes.size() >= 60, "sixty scenes or more");
    judge(context, scenes);
    match(context, scenes);
    if (argc == 3) {
        compare(scenes, read(argv[2]));
    }
    tsu_context_destroy(context);
    return failures > 0;
}

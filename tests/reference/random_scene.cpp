#include "reference/random_scene.h"

#include <cmath>
#include <cstdio>

namespace tsuya::reference
{

namespace
{

// SplitMix64: the same numbers everywhere.
class Chance
{
  public:
    explicit Chance(std::uint64_t seed) : state_(mixed(seed + 0x632be59bd9b4e019u))
    {
    }
    double uniform(double low, double high)
    {
        state_ += 0x9e3779b97f4a7c15u;
        return low + (high - low) * double(mixed(state_) >> 11) * 0x1p-53;
    }
    double log_uniform(double low, double high)
    {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    bool with(double probability)
    {
        return uniform(0.0, 1.0) < probability;
    }
    template <std::size_t n> const char *one_of(const char *const (&names)[n])
    {
        return names[std::size_t(uniform(0.0, double(n)))];
    }

  private:
    static std::uint64_t mixed(std::uint64_t z)
    {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

class Words
{
  public:
    void add(const std::string &key, const std::string &value)
    {
        words.push_back(key + "=" + value);
    }
    void add(const std::string &key, double value)
    {
        char text[32];
        std::snprintf(text, sizeof text, "%.4g", value);
        add(key, std::string(text));
    }
    void add(const std::string &key, double x, double y, double z)
    {
        char text[96];
        std::snprintf(text, sizeof text, "%.4g,%.4g,%.4g", x, y, z);
        add(key, std::string(text));
    }
    std::vector<std::string> words;
};

void hair(Chance &chance, Words &words)
{
    const double kind = chance.uniform(0.0, 1.0);
    words.add("groom", std::string(kind < 0.4 ? "straight" : kind < 0.65 ? "wavy" : "curly"));
    words.add("seed", std::floor(chance.uniform(1.0, 1e4)));
    // Few wide strands stand for many: 15,000 to 60,000 as wide as hair.
    const double strands = std::floor(chance.log_uniform(1000.0, 3500.0));
    words.add("strands", strands);
    words.add("width_scale", chance.log_uniform(15000.0, 60000.0) / strands);
    words.add("length", chance.uniform(0.12, 0.4));
}

void color(Chance &chance, Words &words)
{
    static const char *const names[] = {"black", "brown", "blond", "white", "auburn", "red"};
    const double kind = chance.uniform(0.0, 1.0);
    if (kind < 0.5) {
        words.add("color", std::string(chance.one_of(names)));
    } else if (kind < 0.7) {
        words.add("eumelanin", chance.log_uniform(0.02, 3.0));
        words.add("pheomelanin", chance.log_uniform(0.02, 1.0));
    } else { // dyed
        const double r = chance.log_uniform(0.005, 4.0), g = chance.log_uniform(0.005, 4.0);
        words.add("sigma_a", r, g, chance.log_uniform(0.005, 4.0));
    }
    if (chance.with(0.5)) {
        words.add("beta_R_deg", chance.uniform(5.0, 12.0));
    }
}

void lights(Chance &chance, Words &words)
{
    static const char *const rigs[] = {"key", "front", "side", "back"};
    const bool rig = chance.with(0.5);
    words.add("light", std::string(rig ? chance.one_of(rigs) : "none"));
    const int own = rig ? 0 : 1 + int(chance.uniform(0.0, 3.0));
    for (int i = 0; i < own; i++) {
        const double azimuth = chance.uniform(0.0, 6.283185307179586);
        const double up = chance.uniform(-0.2, 0.95), side = std::sqrt(1.0 - up * up);
        const std::string name = "light" + std::to_string(i) + ".";
        words.add(name + "direction", side * std::sin(azimuth), up, side * std::cos(azimuth));
        words.add(name + "intensity", chance.log_uniform(0.5, 4.0));
    }
    words.add("dome", chance.log_uniform(0.1, 2.5));
}

void camera(Chance &chance, Words &words)
{
    words.add("camera.azimuth_deg",
              chance.with(0.3) ? 25.0 : std::floor(chance.uniform(0.0, 360.0)));
    words.add("camera.elevation_deg", std::floor(chance.uniform(-10.0, 40.0)));
    words.add("camera.zoom", chance.log_uniform(0.4, 2.0));
    const int size = int(chance.uniform(56.0, 97.0));
    words.add("size", std::to_string(size) + "x" + std::to_string(size));
}

} // namespace

std::vector<std::string> random_scene(std::uint64_t seed)
{
    Chance chance(seed);
    Words words;
    hair(chance, words);
    color(chance, words);
    lights(chance, words);
    camera(chance, words);
    return words.words;
}

} // namespace tsuya::reference

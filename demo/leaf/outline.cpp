#include "leaf/outline.h"

#include <algorithm>

namespace tsuya::leaf {

using groom::cosine;
using groom::mix;
using groom::Random;
using groom::sine;
using groom::smooth;

namespace {

// Uniform in [-1, 1), from a hash of place and seed.
double lattice(std::uint64_t seed, std::int64_t x, std::int64_t y)
{
    std::uint64_t h = seed * 0x9e3779b97f4a7c15u + std::uint64_t(x) * 0xbf58476d1ce4e5b9u +
                      std::uint64_t(y) * 0x94d049bb133111ebu;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    h ^= h >> 31;
    return double(h >> 11) * (1.0 / 4503599627370496.0) - 1.0;
}

double fade(double t)
{
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

std::int64_t floor_of(double x)
{
    const std::int64_t whole = std::int64_t(x);
    return double(whole) > x ? whole - 1 : whole;
}

// Profiles from 0 at q = 0 to 1 with slope 0 at q = 1.
double wedge(double q)
{
    return q * q * (3.0 - 2.0 * q);
}
double pointed(double q)
{
    return q * (2.0 - q);
}
double round(double q)
{
    return std::sqrt(std::max(0.0, q * (2.0 - q)));
}
// Round shoulders and a narrow end.
double drawn_out(double q)
{
    return mix(pointed(q), round(q), 0.5) * (0.12 + 0.88 * smooth(0.0, 0.55, q));
}

} // namespace

double noise(std::uint64_t seed, double x)
{
    const std::int64_t i = floor_of(x);
    return mix(lattice(seed, i, 0), lattice(seed, i + 1, 0), fade(x - double(i)));
}

double noise(std::uint64_t seed, double x, double y)
{
    const std::int64_t i = floor_of(x), j = floor_of(y);
    const double u = fade(x - double(i)), v = fade(y - double(j));
    return mix(mix(lattice(seed, i, j), lattice(seed, i + 1, j), u),
               mix(lattice(seed, i, j + 1), lattice(seed, i + 1, j + 1), u), v);
}

Outline::Outline(const LeafParams &params) : params_(params)
{
    Random random(params.seed, 1);
    uneven_ = 0.05 * params.roughness * random.range(-1.0, 1.0);
    sway_ = 0.03 * params.roughness * random.range(-1.0, 1.0);
    // Lobes stand out across the rows, which must not meet there.
    slant_ = (params.lobes > 0 ? 0.12 : 0.38) * params.sweep;
}

double Outline::half_width(double s) const
{
    const double m = params_.widest;
    double w;
    if (s < m) {
        const double q = s / m, b = params_.base;
        w = b < 0.5 ? mix(wedge(q), pointed(q), 2.0 * b) : mix(pointed(q), round(q), 2.0 * b - 1.0);
    } else {
        const double q = (1.0 - s) / (1.0 - m), t = params_.tip;
        w = t < 0.5 ? mix(round(q), pointed(q), 2.0 * t)
                    : mix(pointed(q), drawn_out(q), 2.0 * t - 1.0);
    }
    return 0.5 * params_.width * params_.length * w;
}

double Outline::sway(double y) const
{
    const double q = y / params_.length;
    return sway_ * params_.length * q * q * (2.2 - 1.8 * q);
}

// 0 in the middle of a lobe, 1 in the bay between two.
double Outline::lobe(double s) const
{
    const double bay = 0.5 - 0.5 * cosine(double(params_.lobes) * s);
    const double ends = smooth(0.02, 0.2, s) * (1.0 - smooth(0.84, 0.98, s));
    return bay * bay * ends;
}

// 0 between teeth, 1 at a tooth's tip, which lies towards the leaf's.
double Outline::tooth(double s) const
{
    const double at = s * double(params_.teeth);
    const double p = at - double(floor_of(at));
    const double rise = p < 0.8 ? p / 0.8 : (1.0 - p) / 0.2;
    const double size = 1.0 + 0.5 * params_.roughness * noise(params_.seed * 4 + 2, at - p);
    return size * rise * smooth(0.03, 0.2, s) * (1.0 - smooth(0.9, 1.0, s));
}

double Outline::vein(double end, double r) const
{
    double begin = end - 0.55 * params_.sweep * end * (1.0 - end);
    if (params_.heart > 0.0) {
        begin *= mix(1.0, smooth(0.0, 0.3, end), smooth(0.0, 0.1, params_.heart));
    }
    return mix(begin, end, mix(r, r * r, params_.curve));
}

Flat Outline::at(double s, double r, int side) const
{
    const LeafParams &p = params_;
    const double length = p.length;
    const double w = half_width(s);
    double x = w * r * (1.0 + double(side) * uneven_);
    if (p.lobes > 0) {
        // Only outwards, so that no two places of a row meet.
        x -= p.lobe_depth * lobe(s) * w * r * r;
    }
    if (p.teeth > 0) {
        x += p.tooth_depth * (tooth(s) - 0.5) * w * smooth(0.8, 1.0, r) * smooth(0.0, 0.1, s) *
             smooth(0.0, 0.1, 1.0 - s);
    }
    const std::uint64_t stream = p.seed * 4 + (side < 0 ? 0 : 1);
    x *= 1.0 + 0.04 * p.roughness * r * noise(stream, 7.0 * s);
    const double middle = s - slant_ * s * (1.0 - s);
    // Back beside the stalk, first straight so that rows do not meet.
    const double back = p.heart * std::sqrt(std::sqrt(s * 8.0)) * (1.0 - smooth(0.0, 0.5, s));
    const double margin = s - back;
    const double y = length * mix(middle, margin, r);
    return {double(side) * x + sway(y), y};
}

} // namespace tsuya::leaf

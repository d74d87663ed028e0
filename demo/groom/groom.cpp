#include "groom.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tsuya::groom {

namespace {

constexpr float smallest_extent = 0.05f;
constexpr float largest_extent = 2.0f;

bool usable(const glm::vec3 &p)
{
    // NaN fails every comparison.
    return std::fabs(p.x) <= coordinate_limit && std::fabs(p.y) <= coordinate_limit &&
           std::fabs(p.z) <= coordinate_limit;
}

struct Step {
    double x, y, z;

    double length() const
    {
        return std::sqrt(x * x + y * y + z * z);
    }
};

Step step(const glm::vec3 &a, const glm::vec3 &b)
{
    return {double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z};
}

// Adds strand [begin, end) to `report` and returns its length.
double measure(const glm::vec3 *begin, const glm::vec3 *end, Report &report)
{
    double length = 0.0;
    std::size_t kinks = 0;
    const glm::vec3 *last = nullptr;
    Step before{0.0, 0.0, 0.0};
    for (const glm::vec3 *p = begin; p != end; ++p) {
        if (!usable(*p)) {
            ++report.non_finite_points;
            continue;
        }
        report.lower = glm::vec3(std::min(report.lower.x, p->x), std::min(report.lower.y, p->y),
                                 std::min(report.lower.z, p->z));
        report.upper = glm::vec3(std::max(report.upper.x, p->x), std::max(report.upper.y, p->y),
                                 std::max(report.upper.z, p->z));
        if (last) {
            const Step s = step(*last, *p);
            const double l = s.length();
            if (!(l > double(shortest_segment))) {
                ++report.degenerate_segments;
                continue;
            }
            kinks += before.x * s.x + before.y * s.y + before.z * s.z < 0.0;
            length += l;
            before = s;
        }
        last = p;
    }
    report.kinks += kinks;
    report.kinked_strands += kinks > 0;
    return length;
}

template <class... Args> void line(std::string &out, const char *format, Args... args)
{
    char buffer[240];
    const int n = std::snprintf(buffer, sizeof buffer, format, args...);
    if (n > 0) {
        out.append(buffer, std::min<std::size_t>(std::size_t(n), sizeof buffer - 1));
    }
}

void count(std::vector<std::string> &facts, std::size_t n, const char *one, const char *many)
{
    if (n) {
        facts.push_back(std::to_string(n) + ' ' + (n == 1 ? one : many));
    }
}

float extent(const Report &r)
{
    const glm::vec3 size = r.upper - r.lower;
    return std::max(size.x, std::max(size.y, size.z));
}

} // namespace

Report inspect(const Groom &groom)
{
    Report r;
    r.strands = groom.strands();
    r.points = groom.points.size();
    r.lower = glm::vec3(coordinate_limit);
    r.upper = glm::vec3(-coordinate_limit);
    double total = 0.0;
    for (std::size_t s = 0; s < r.strands; ++s) {
        const glm::vec3 *data = groom.points.data();
        total += measure(data + groom.first[s], data + groom.first[s + 1], r);
    }
    if (r.lower.x > r.upper.x) {
        r.lower = r.upper = glm::vec3(0.0f);
    }
    r.mean_length = r.strands ? total / double(r.strands) : 0.0;
    r.plausible_size = extent(r) >= smallest_extent && extent(r) <= largest_extent;
    return r;
}

std::vector<std::string> repairs(const Report &r)
{
    std::vector<std::string> facts;
    count(facts, r.non_finite_points, "point dropped: not finite, or beyond 1e15",
          "points dropped: not finite, or beyond 1e15");
    count(facts, r.dropped_strands, "strand dropped: fewer than 2 finite distinct points",
          "strands dropped: fewer than 2 finite distinct points");
    count(facts, r.replaced_values, "width or uv replaced: not a usable number",
          "widths or uvs replaced: not usable numbers");
    return facts;
}

std::string text(const Report &r)
{
    std::string out;
    const double per = r.strands ? double(r.points) / double(r.strands) : 0.0;
    line(out, "%zu strands, %zu points (%.1f a strand)\n", r.strands, r.points, per);
    line(out, "box (%.4g, %.4g, %.4g) to (%.4g, %.4g, %.4g)\n", double(r.lower.x),
         double(r.lower.y), double(r.lower.z), double(r.upper.x), double(r.upper.y),
         double(r.upper.z));
    line(out, "mean strand length %.4g\n", r.mean_length);
    if (r.kinks) {
        line(out, "%zu kink%s above 90 degrees in %zu strand%s\n", r.kinks, r.kinks == 1 ? "" : "s",
             r.kinked_strands, r.kinked_strands == 1 ? "" : "s");
    }
    std::vector<std::string> facts;
    count(facts, r.degenerate_segments, "repeated point", "repeated points");
    for (std::string &fact : repairs(r)) {
        facts.push_back(std::move(fact));
    }
    count(facts, r.unused_bytes, "byte of the file not used", "bytes of the file not used");
    for (const std::string &fact : facts) {
        out += fact + '\n';
    }
    if (!r.plausible_size) {
        line(out,
             "warning: the groom is %.4g across, outside [%g, %g]; a head is about 0.2 m, "
             "so the file may not be in metres: set unit_scale\n",
             double(extent(r)), double(smallest_extent), double(largest_extent));
    }
    return out;
}

float strand_seed(std::uint32_t strand)
{
    // Source: the lowbias32 integer hash; the offset keeps 0 from mapping to 0.
    std::uint32_t x = strand + 0x9e3779b9u;
    x = (x ^ (x >> 16)) * 0x21f0aaadu;
    x = (x ^ (x >> 15)) * 0xd35a2d97u;
    x ^= x >> 15;
    return float(x >> 8) * (1.0f / 16777216.0f);
}

} // namespace tsuya::groom

// Private to the readers: collects points into a Groom and keeps its promises.
#ifndef TSUYA_GROOM_BUILDER_H
#define TSUYA_GROOM_BUILDER_H

#include "bytes.h"
#include "read.h"

#include <cmath>

namespace tsuya::groom {

// Give the points of a strand, each with its thickness if the file has any, then
// call end(); after the last strand finish() makes the groom and its report.
class Builder
{
  public:
    explicit Builder(const ReadOptions &options) : options_(options)
    {
        groom_.constant_radius = options.radius;
        groom_.first.push_back(0);
    }

    Groom &groom()
    {
        return groom_;
    }
    void reserve(std::uint64_t strands, std::uint64_t points)
    {
        groom_.points.reserve(points);
        groom_.first.reserve(strands + 1);
        groom_.seed.reserve(strands);
    }
    void point(const Bytes &file, std::uint64_t at)
    {
        const glm::vec3 p = place(file.f32(at), file.f32(at + 4), file.f32(at + 8));
        if (!(std::fabs(p.x) <= coordinate_limit && std::fabs(p.y) <= coordinate_limit &&
              std::fabs(p.z) <= coordinate_limit)) {
            ++non_finite_;
            kept_ = false;
            return;
        }
        kept_ = groom_.points.size() == groom_.first.back() || apart(groom_.points.back(), p);
        if (kept_) {
            groom_.points.push_back(p);
        } else {
            ++degenerate_;
        }
    }
    // Width of the point just given.
    void thickness(float value)
    {
        if (kept_) {
            groom_.radius.push_back(radius(value));
        }
    }
    float radius(float thickness)
    {
        const double r = 0.5 * double(thickness) * options_.unit_scale;
        if (r >= double(shortest_segment) && r <= double(coordinate_limit)) {
            return float(r);
        }
        ++replaced_;
        return options_.radius;
    }
    // Ends a strand. Returns: whether it was kept.
    bool end()
    {
        const std::uint32_t index = index_++;
        const std::size_t begin = groom_.first.back();
        if (groom_.points.size() - begin < 2) {
            groom_.points.resize(begin);
            groom_.radius.resize(groom_.radius.empty() ? 0 : begin);
            ++dropped_;
            return false;
        }
        groom_.first.push_back(std::uint32_t(groom_.points.size()));
        groom_.seed.push_back(strand_seed(index));
        return true;
    }
    void uv(float u, float v)
    {
        const bool good = std::fabs(u) <= coordinate_limit && std::fabs(v) <= coordinate_limit;
        replaced_ += !good;
        groom_.uv.push_back(good ? glm::vec2(u, v) : glm::vec2(0.0f));
    }
    Result finish(std::uint64_t unused)
    {
        if (groom_.strands() == 0) {
            return fail("none of the ", index_, " strands has 2 finite distinct points: ",
                        non_finite_, " points are not finite or beyond 1e15, ", degenerate_,
                        " repeat the one before");
        }
        Report report = inspect(groom_);
        report.degenerate_segments += degenerate_;
        report.non_finite_points = non_finite_;
        report.dropped_strands = dropped_;
        report.replaced_values = replaced_;
        report.unused_bytes = std::size_t(unused);
        return Loaded{std::move(groom_), report};
    }

  private:
    glm::vec3 place(float x, float y, float z) const
    {
        const double s = options_.unit_scale;
        const bool z_up = options_.up == Up::z;
        return {scaled(x, s), scaled(z_up ? z : y, s), scaled(z_up ? -y : z, s)};
    }
    // A double beyond float's range must not be converted.
    static float scaled(float value, double scale)
    {
        const double v = double(value) * scale;
        return std::fabs(v) <= double(coordinate_limit) ? float(v) : INFINITY;
    }
    static bool apart(const glm::vec3 &a, const glm::vec3 &b)
    {
        const double x = double(b.x) - a.x, y = double(b.y) - a.y, z = double(b.z) - a.z;
        return std::sqrt(x * x + y * y + z * z) > double(shortest_segment);
    }

    ReadOptions options_;
    Groom groom_;
    std::uint32_t index_ = 0;
    std::size_t non_finite_ = 0, degenerate_ = 0, dropped_ = 0, replaced_ = 0;
    bool kept_ = false;
};

} // namespace tsuya::groom

#endif

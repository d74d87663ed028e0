#include "leaf/veins.h"

#include <algorithm>

namespace tsuya::leaf {

using groom::mix;
using groom::Random;
using groom::smooth;

namespace {

// What a vein of one order does to the maps where it is strongest.
struct Paint {
    double pigment, thickness;
    double furrow; // depth, of the vein's own half width
    double wide;   // half width of the furrow, of the vein's
};

const Paint paints[] = {
    {0.7, 0.95, 0.55, 2.2}, // midrib
    {0.68, 0.22, 0.75, 2.8}, // secondary
    {0.5, 0.06, 0.7, 2.6}, // tertiary
};

double bump(double t)
{
    return t < 1.0 ? (1.0 - t * t) * (1.0 - t * t) : 0.0;
}

class Painter
{
  public:
    Painter(const Outline &outline, const Flat &lower, const Flat &size, Maps &maps)
        : outline_(outline), params_(outline.params()), lower_(lower), size_(size), maps_(maps)
    {
    }

    void paint()
    {
        texel_ = std::max(size_.x, size_.y) / double(params_.texels);
        width_ = std::max(1, int(size_.x / texel_ + 0.5));
        height_ = std::max(1, int(size_.y / texel_ + 0.5));
        maps_.width = width_;
        maps_.height = height_;
        maps_.metres = texel_;
        const std::size_t count = std::size_t(width_) * std::size_t(height_);
        fade_.assign(count, 0.0f);
        thick_.assign(count, 0.0f);
        furrow_.assign(count, 0.0f);
        rim_.assign(count, -1.0f);
        margin();
        const std::vector<Vein> all = veins(outline_);
        for (const Vein &vein : all) {
            strokes(vein);
        }
        far_from_veins(all);
        areoles(0.03 * params_.length, 5, 0.34, 0.03, 0.00065 * params_.length);
        areoles(0.0125 * params_.length, 6, 0.26, 0.02, 0.0005 * params_.length);
        combine();
    }

  private:
    std::size_t at(int x, int y) const
    {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }

    // Metres on the flat blade of a texel's centre; texels are as good as square.
    Flat place(int x, int y) const
    {
        return {lower_.x + (x + 0.5) / width_ * size_.x, lower_.y + (y + 0.5) / height_ * size_.y};
    }

    // Where a texel is between midrib and margin: r, by the flat blade's triangles.
    void margin()
    {
        constexpr int rows = 300, columns = 16;
        for (int side = -1; side <= 1; side += 2) {
            for (int i = 0; i < rows; i++) {
                for (int j = 0; j < columns; j++) {
                    const double s[2] = {double(i) / rows, double(i + 1) / rows};
                    const double r[2] = {double(j) / columns, double(j + 1) / columns};
                    const Flat a = outline_.at(s[0], r[0], side), b = outline_.at(s[0], r[1], side);
                    const Flat c = outline_.at(s[1], r[1], side), d = outline_.at(s[1], r[0], side);
                    fill(a, b, c, r[0], r[1], r[1]);
                    fill(a, c, d, r[0], r[1], r[0]);
                }
            }
        }
        maps_.inside.assign(rim_.size(), 0);
        for (std::size_t i = 0; i < rim_.size(); i++) {
            maps_.inside[i] = rim_[i] >= 0.0f;
            rim_[i] = rim_[i] < 0.0f ? 1.0f : rim_[i];
        }
    }

    void fill(const Flat &a, const Flat &b, const Flat &c, double ra, double rb, double rc)
    {
        const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if (area == 0.0) {
            return;
        }
        const double x0 = std::min({a.x, b.x, c.x}), x1 = std::max({a.x, b.x, c.x});
        const double y0 = std::min({a.y, b.y, c.y}), y1 = std::max({a.y, b.y, c.y});
        for (int y = row(y0); y <= row(y1); y++) {
            for (int x = column(x0); x <= column(x1); x++) {
                const Flat p = place(x, y);
                const double u = ((b.x - p.x) * (c.y - p.y) - (c.x - p.x) * (b.y - p.y)) / area;
                const double v = ((c.x - p.x) * (a.y - p.y) - (a.x - p.x) * (c.y - p.y)) / area;
                if (u >= 0.0 && v >= 0.0 && u + v <= 1.0) {
                    rim_[at(x, y)] = float(u * ra + v * rb + (1.0 - u - v) * rc);
                }
            }
        }
    }

    int column(double x) const
    {
        const double at = (x - lower_.x) / size_.x * width_;
        return int(std::min(std::max(at, 0.0), double(width_ - 1)));
    }
    int row(double y) const
    {
        const double at = (y - lower_.y) / size_.y * height_;
        return int(std::min(std::max(at, 0.0), double(height_ - 1)));
    }

    void strokes(const Vein &vein)
    {
        const Paint &paint = paints[int(vein.order)];
        for (std::size_t i = 0; i + 1 < vein.points.size(); i++) {
            stroke(vein.points[i], vein.points[i + 1], vein.half_widths[i], vein.half_widths[i + 1],
                   paint);
        }
    }

    void stroke(const Flat &a, const Flat &b, double wa, double wb, const Paint &paint)
    {
        const double least = 0.75 * texel_; // thinner ones are drawn so wide and fainter
        const double reach = paint.wide * std::max({wa, wb, least});
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double squared = std::max(dx * dx + dy * dy, 1e-30);
        for (int y = row(std::min(a.y, b.y) - reach); y <= row(std::max(a.y, b.y) + reach); y++) {
            for (int x = column(std::min(a.x, b.x) - reach);
                 x <= column(std::max(a.x, b.x) + reach); x++) {
                const Flat p = place(x, y);
                double t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared;
                t = std::min(std::max(t, 0.0), 1.0);
                const double ex = p.x - a.x - t * dx, ey = p.y - a.y - t * dy;
                const double d = std::sqrt(ex * ex + ey * ey);
                const double w = mix(wa, wb, t), drawn = std::max(w, least);
                const double share = w / drawn;
                const std::size_t i = at(x, y);
                const double core = share * bump(d / (1.25 * drawn));
                fade_[i] = std::max(fade_[i], float(paint.pigment * core));
                thick_[i] = std::max(thick_[i], float(paint.thickness * core));
                furrow_[i] = std::max(
                    furrow_[i], float(paint.furrow * w * share * bump(d / (paint.wide * drawn))));
            }
        }
    }

    // Distance to the nearest large vein, metres, on a grid four times as coarse.
    void far_from_veins(const std::vector<Vein> &all)
    {
        coarse_width_ = width_ / 4 + 2;
        coarse_height_ = height_ / 4 + 2;
        coarse_.assign(std::size_t(coarse_width_) * std::size_t(coarse_height_), 1e9f);
        for (const Vein &vein : all) {
            if (vein.order == Order::tertiary) {
                continue;
            }
            for (std::size_t i = 0; i + 1 < vein.points.size(); i++) {
                near(vein.points[i], vein.points[i + 1]);
            }
        }
    }

    void near(const Flat &a, const Flat &b)
    {
        const double reach = 0.09 * params_.length;
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double squared = std::max(dx * dx + dy * dy, 1e-30);
        const auto clamped = [](int i, int most) { return std::min(std::max(i, 0), most); };
        const int x0 = clamped(column(std::min(a.x, b.x) - reach) / 4 - 1, coarse_width_ - 1);
        const int x1 = clamped(column(std::max(a.x, b.x) + reach) / 4 + 1, coarse_width_ - 1);
        const int y0 = clamped(row(std::min(a.y, b.y) - reach) / 4 - 1, coarse_height_ - 1);
        const int y1 = clamped(row(std::max(a.y, b.y) + reach) / 4 + 1, coarse_height_ - 1);
        for (int y = y0; y <= y1; y++) {
            for (int x = x0; x <= x1; x++) {
                const Flat p = place(4 * x, 4 * y);
                double t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared;
                t = std::min(std::max(t, 0.0), 1.0);
                const double ex = p.x - a.x - t * dx, ey = p.y - a.y - t * dy;
                float &d = coarse_[std::size_t(y) * std::size_t(coarse_width_) + std::size_t(x)];
                d = std::min(d, float(std::sqrt(ex * ex + ey * ey)));
            }
        }
    }

    double vein_distance(int x, int y) const
    {
        const double u = x / 4.0, v = y / 4.0;
        const int i = int(u), j = int(v);
        const auto get = [&](int a, int b) {
            return double(coarse_[std::size_t(b) * std::size_t(coarse_width_) + std::size_t(a)]);
        };
        return mix(mix(get(i, j), get(i + 1, j), u - i),
                   mix(get(i, j + 1), get(i + 1, j + 1), u - i), v - j);
    }

    // A net of fine veins: borders between the cells of jittered points `cell` metres apart.
    void areoles(double cell, std::uint64_t stream, double pigment, double thickness, double half)
    {
        const int columns = int(size_.x / cell) + 3, rows = int(size_.y / cell) + 3;
        std::vector<Flat> points;
        Random random(params_.seed, 100 + stream);
        for (int j = 0; j < rows; j++) {
            for (int i = 0; i < columns; i++) {
                const double x = (i - 1 + random.range(0.08, 0.92)) * cell;
                points.push_back({x, (j - 1 + random.range(0.08, 0.92)) * cell});
            }
        }
        const double drawn = std::max(half, 0.6 * texel_), share = half / drawn;
        for (int y = 0; y < height_; y++) {
            for (int x = 0; x < width_; x++) {
                const Flat q = place(x, y);
                const Flat p{q.x - lower_.x, q.y - lower_.y};
                const double d = border(p, cell, columns, rows, points);
                const std::size_t i = at(x, y);
                const double core = share * bump(d / (1.4 * drawn));
                fade_[i] = std::max(fade_[i], float(pigment * core));
                thick_[i] = std::max(thick_[i], float(thickness * core));
                furrow_[i] =
                    std::max(furrow_[i], float(0.5 * half * share * bump(d / (3.0 * drawn))));
            }
        }
    }

    static double border(const Flat &p, double cell, int columns, int rows,
                         const std::vector<Flat> &points)
    {
        const int ci = std::min(int(p.x / cell) + 1, columns - 2);
        const int cj = std::min(int(p.y / cell) + 1, rows - 2);
        double first = 1e30, second = 1e30;
        Flat nearest, next;
        for (int j = cj - 1; j <= cj + 1; j++) {
            for (int i = ci - 1; i <= ci + 1; i++) {
                const Flat &c = points[std::size_t(j) * std::size_t(columns) + std::size_t(i)];
                const double d = (c.x - p.x) * (c.x - p.x) + (c.y - p.y) * (c.y - p.y);
                if (d < first) {
                    second = first;
                    next = nearest;
                    first = d;
                    nearest = c;
                } else if (d < second) {
                    second = d;
                    next = c;
                }
            }
        }
        const double dx = next.x - nearest.x, dy = next.y - nearest.y;
        return 0.5 * (second - first) / std::sqrt(std::max(dx * dx + dy * dy, 1e-30));
    }

    void combine()
    {
        const std::size_t count = fade_.size();
        maps_.pigment.resize(count);
        maps_.thickness.resize(count);
        maps_.relief.resize(count);
        const double length = params_.length;
        for (int y = 0; y < height_; y++) {
            for (int x = 0; x < width_; x++) {
                const std::size_t i = at(x, y);
                const Flat p = place(x, y);
                const double u = p.x / length, v = p.y / length;
                const double cloud = noise(params_.seed + 11, 5.0 * u, 5.0 * v) +
                                     0.6 * noise(params_.seed + 12, 13.0 * u, 13.0 * v) +
                                     0.35 * noise(params_.seed + 13, 37.0 * u, 37.0 * v);
                const double far = vein_distance(x, y) / length;
                const double rim = double(rim_[i]);
                const double beside = bump(far / 0.035);
                double pigment = 1.0 + params_.blotches * cloud;
                pigment *= 1.0 + params_.edge * smooth(0.7, 1.0, rim);
                pigment *= 1.0 - params_.halo * beside;
                maps_.pigment[i] = float(std::max(pigment, 0.2) * (1.0 - double(fade_[i])));
                maps_.thickness[i] =
                    float(0.97 + 0.05 * cloud + double(thick_[i]) - 0.18 * smooth(0.9, 1.0, rim));
                // The blade swells between the large veins.
                const double swell = 0.0085 * length * smooth(0.0, 0.045, far);
                const double fine = 0.0006 * length * noise(params_.seed + 14, 60.0 * u, 60.0 * v);
                maps_.relief[i] = float(params_.relief * (swell + fine - 1.1 * double(furrow_[i])));
            }
        }
        level(maps_.pigment, double(pigment_least), double(pigment_most));
        level(maps_.thickness, double(thickness_least), double(thickness_most));
    }

    // Scale to a mean of 1 over the blade within bounds.
    void level(std::vector<float> &map, double least, double most) const
    {
        for (int pass = 0; pass < 4; pass++) {
            double sum = 0.0, weight = 0.0;
            for (std::size_t i = 0; i < map.size(); i++) {
                if (maps_.inside[i]) {
                    sum += double(map[i]);
                    weight += 1.0;
                }
            }
            const double factor = sum > 0.0 ? weight / sum : 1.0;
            for (float &value : map) {
                value = float(std::min(std::max(factor * double(value), least), most));
            }
        }
    }

    const Outline &outline_;
    const LeafParams &params_;
    const Flat lower_, size_;
    Maps &maps_;
    double texel_ = 1.0;
    int width_ = 1, height_ = 1, coarse_width_ = 0, coarse_height_ = 0;
    std::vector<float> fade_, thick_, furrow_; // of veins
    std::vector<float> rim_;                   // 0 on the midrib, 1 at the margin and beyond
    std::vector<float> coarse_;
};

} // namespace

void paint(const Outline &outline, const Flat &lower, const Flat &size, Maps &maps)
{
    Painter(outline, lower, size, maps).paint();
}

std::vector<float> slopes(const Maps &maps)
{
    if (!maps.slope.empty()) {
        return maps.slope;
    }
    std::vector<float> out(maps.relief.size() * 2);
    const auto height = [&](int x, int y) {
        x = std::min(std::max(x, 0), maps.width - 1);
        y = std::min(std::max(y, 0), maps.height - 1);
        return double(maps.relief[std::size_t(y) * std::size_t(maps.width) + std::size_t(x)]);
    };
    for (int y = 0; y < maps.height; y++) {
        for (int x = 0; x < maps.width; x++) {
            const std::size_t i = std::size_t(y) * std::size_t(maps.width) + std::size_t(x);
            out[2 * i] = float((height(x + 1, y) - height(x - 1, y)) / (2.0 * maps.metres));
            out[2 * i + 1] = float((height(x, y + 1) - height(x, y - 1)) / (2.0 * maps.metres));
        }
    }
    return out;
}

} // namespace tsuya::leaf

#include "leaf/veins.h"

#include <algorithm>

namespace tsuya::leaf {

using groom::mix;
using groom::Random;
using groom::sine;
using groom::smooth;

namespace {

class Network
{
  public:
    explicit Network(const Outline &outline)
        : outline_(outline), params_(outline.params()), random_(params_.seed, 3)
    {
    }

    std::vector<Vein> draw()
    {
        midrib();
        for (int side = -1; side <= 1; side += 2) {
            const std::vector<double> ends = secondaries(side);
            for (std::size_t k = 1; k + 2 < ends.size(); k++) {
                between(side, ends[k], ends[k + 1]);
            }
        }
        return std::move(veins_);
    }

  private:
    double scale() const
    {
        return params_.length;
    }

    void add(Vein &vein, double s, double r, int side, double half_width)
    {
        vein.points.push_back(outline_.at(std::min(std::max(s, 0.0), 1.0), r, side));
        vein.half_widths.push_back(half_width);
    }

    void midrib()
    {
        Vein vein;
        vein.order = Order::midrib;
        for (int i = 0; i <= 80; i++) {
            const double y = scale() * i / 80.0, t = i / 80.0;
            vein.points.push_back({outline_.sway(y), y});
            vein.half_widths.push_back(scale() * (0.0075 * (1.0 - t) * (1.0 - 0.35 * t) + 0.0008));
        }
        veins_.push_back(vein);
    }

    // Where on the margin they end, from base to tip; the first and the last are no veins but
    // bounds of what lies before and behind.
    std::vector<double> secondaries(int side)
    {
        std::vector<double> ends = {0.004};
        const bool lobed = params_.lobes > 0;
        const std::size_t count = lobed ? params_.lobes - 1 : params_.veins;
        const double shift = lobed ? 0.0 : 0.22 * params_.roughness * random_.range(-1.0, 1.0);
        const double first = params_.heart > 0.01 ? 0.012 : 0.07;
        for (std::size_t k = 0; k < count; k++) {
            const double jitter = 0.3 * params_.roughness * random_.range(-0.5, 0.5);
            const double t = (double(k) + 0.5 + (lobed ? 0.0 : shift + jitter)) / double(count);
            // Closer to each other towards the tip.
            const double end = lobed ? (double(k) + 1.0) / double(params_.lobes)
                                     : mix(first, 0.985, t * (1.12 - 0.12 * t));
            ends.push_back(std::min(end, 0.99));
        }
        ends.push_back(0.998);
        for (std::size_t k = 1; k + 1 < ends.size(); k++) {
            secondary(side, ends[k]);
        }
        for (std::size_t k = 0; k + 1 < ends.size(); k++) {
            if (random_.unit() < 0.55 && k > 0) {
                short_one(side, 0.5 * (ends[k] + ends[k + 1]));
            }
            if (params_.loops > 0.0 && k > 0 && k + 2 < ends.size()) {
                loop(side, ends[k], ends[k + 1]);
            }
        }
        return ends;
    }

    double strength(double end) const
    {
        const double most = 0.5 * params_.width * params_.length;
        return 0.45 + 0.55 * std::min(outline_.half_width(end) / most, 1.0);
    }

    void secondary(int side, double end)
    {
        Vein vein;
        const double reach = params_.loops > 0.5 ? 0.88 : 0.992;
        const double size = strength(end);
        for (int i = 0; i <= 32; i++) {
            const double t = i / 32.0, r = reach * t;
            const double wander = 0.004 * params_.roughness *
                                  noise(params_.seed * 4 + 1, 9.0 * t, 900.0 * end + side);
            add(vein, outline_.vein(end, r) + wander * t, r, side,
                scale() * size * mix(0.0026, 0.0008, t));
        }
        veins_.push_back(vein);
    }

    void short_one(int side, double end)
    {
        Vein vein;
        vein.order = Order::tertiary;
        const double reach = random_.range(0.3, 0.62);
        for (int i = 0; i <= 16; i++) {
            const double t = i / 16.0, r = reach * t;
            add(vein, outline_.vein(end, r), r, side, scale() * mix(0.0014, 0.0007, t));
        }
        veins_.push_back(vein);
    }

    void loop(int side, double end, double next)
    {
        Vein vein;
        const double size = strength(end);
        for (int i = 0; i <= 24; i++) {
            const double t = i / 24.0;
            const double r = 0.88 + 0.07 * 4.0 * t * (1.0 - t) * (0.4 + 0.6 * t) - 0.06 * t * t;
            add(vein, outline_.vein(mix(end, next, t), r), r, side, scale() * size * 0.0009);
        }
        veins_.push_back(vein);
    }

    // Tertiaries from one secondary to the next, some forked.
    void between(int side, double end, double next)
    {
        const double most = 0.5 * params_.width * params_.length;
        const double wide = std::max(outline_.half_width(0.5 * (end + next)), 0.1 * most);
        const double step = std::min(0.034 * scale() / wide, 0.5);
        // At right angles to the secondaries rather than along the midrib.
        const double lean = -0.5 * (next - end) * scale() / wide;
        for (double r = 0.5 * step; r < 0.97; r += step * random_.range(0.65, 1.35)) {
            const double shift = lean + step * random_.range(-0.6, 0.6);
            const double swing = 0.35 * step * random_.range(-1.0, 1.0);
            const double fork = random_.unit() < 0.4 ? random_.range(0.35, 0.7) : 2.0;
            rung(side, end, next, r, r + shift, swing, 0.0, 1.0);
            if (fork < 1.0) {
                const double at = mix(r, r + shift, fork);
                const double away = step * (random_.unit() < 0.5 ? -0.75 : 0.75);
                rung(side, mix(end, next, fork), next, at, r + shift + away, 0.0, 0.2, 1.0);
            }
        }
    }

    void rung(int side, double from, double to, double r0, double r1, double swing, double thin,
              double thick)
    {
        Vein vein;
        vein.order = Order::tertiary;
        for (int i = 0; i <= 14; i++) {
            const double t = i / 14.0;
            const double r = mix(r0, r1, t) + swing * sine(t) + 0.4 * swing * sine(1.5 * t);
            if (r <= 0.0 || r >= 0.995) {
                continue;
            }
            // Thinnest in the middle, where it was met from both sides.
            const double width = thick * (0.6 + 0.4 * (2.0 * t - 1.0) * (2.0 * t - 1.0)) - thin;
            add(vein, outline_.vein(mix(from, to, t), r), r, side, scale() * 0.0011 * width);
        }
        if (vein.points.size() > 1) {
            veins_.push_back(vein);
        }
    }

    const Outline &outline_;
    const LeafParams &params_;
    Random random_;
    std::vector<Vein> veins_;
};

} // namespace

std::vector<Vein> veins(const Outline &outline)
{
    return Network(outline).draw();
}

} // namespace tsuya::leaf

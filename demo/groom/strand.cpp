#include "strand.h"

#include <algorithm>

namespace tsuya::groom {

namespace {

const Vec down{0.0, -1.0, 0.0};

// Where hair parts, in coordinates that make the head a unit sphere. A little
// to the left; the whorl is at its end on the crown.
constexpr double parting = 0.2;
const Vec whorl{0.12, 0.84, -0.53};

constexpr double stiffness = 0.022; // metres of path over which a strand takes a new direction

// A curl has no width at the root and all of it after 6 cm of path.
double opened(double s)
{
    return smooth(0.0, 0.06, s);
}

} // namespace

Grower::Grower(const HairParams &params, const Scalp &scalp) : params_(params), scalp_(scalp)
{
    if (params.style != Style::straight) {
        across_ = params.curl_radius;
        upward_ = params.curl_radius * (params.style == Style::wavy ? 0.35 : 1.0);
    }
    // Of an elliptic helix: exact for a circle, to second order else.
    const double k = 2.0 * pi * params.curl_frequency;
    winding_ = k * k * (across_ * across_ + upward_ * upward_) * 0.5;
}

double Grower::reach(double fibre) const
{
    constexpr int steps = 64;
    double s = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double g = opened(s);
        s += fibre / steps / std::sqrt(1.0 + winding_ * g * g);
    }
    return s;
}

Lock Grower::lock(const Root &root, Random &random) const
{
    const Vec u = scalp_.body.inside(root.position);
    // A parting is never a ruled line.
    const double at = parting + 0.03 * random.bell();
    Lock l;
    l.side = u.x > at ? 1 : -1;
    l.phase = random.unit();
    if (params_.style == Style::wavy) {
        // Waves of neighbours swing together, in bands around the crown.
        const double along = length(u - whorl) * 0.1 * params_.curl_frequency;
        l.phase = along + 0.35 * l.phase;
    }
    l.turn = random.unit() < 0.5 ? -1.0 : 1.0;
    l.pitch = 1.0 + 0.2 * random.bell();
    return l;
}

double Grower::level(const Root &root) const
{
    return std::min(1.0, length(scalp_.body.inside(root.position)));
}

// Direction in which hair is combed at `u` on the unit sphere, not normalised.
Vec Grower::comb(Vec u, int side) const
{
    // A strand that the whorl turned to the other side goes on from there.
    if (side * (u.x - parting) < -0.25) {
        side = -side;
    }
    const Vec n = unit(u, {0.0, 1.0, 0.0});
    const Vec from_whorl = n - whorl;
    const double near = 1.0 - smooth(0.2, 0.7, length(from_whorl));
    const Vec spin = cross(n, whorl) * (1.1 * near);
    Vec radial = from_whorl + spin;
    radial = unit(radial - n * dot(n, radial), down);
    // On top, away from the parting; at the temples, back over the ears.
    const double top = smooth(-0.5, -0.05, n.z) * smooth(0.1, 0.5, n.y);
    const Vec sideways{side * 1.0, -0.2, -0.42};
    const double front = smooth(0.1, 0.6, n.z);
    const Vec back{side * 0.55 * front, -0.55, -0.9 * front};
    const Vec low = radial + back;
    return mix(unit(low, down), unit(sideways, down), top);
}

// The nearest place outside, seen from the centre, of the head scaled by
// `scale` and then grown by `margin` metres.
Vec Grower::push_out(Vec p, double scale, double margin) const
{
    const Ellipsoid &body = scalp_.body;
    const Vec axes = body.axes * scale + Vec{margin, margin, margin};
    const Vec u = (p - body.centre) / axes;
    const double l = length(u);
    if (l < 1.0) {
        p = body.centre + unit(u, {0.0, 1.0, 0.0}) * axes;
    }
    if (scalp_.neck && p.y < neck_top) {
        const Vec wide{neck_width + margin, 1.0, neck_depth + margin};
        const Vec v = Vec{p.x, 0.0, p.z} / wide;
        if (length(v) < 1.0) {
            const Vec w = unit(v, {0.0, 0.0, -1.0}) * wide;
            p = {w.x, p.y, w.z};
        }
    }
    return p;
}

void Grower::path(const Root &root, int side, double fibre, double rise, Vec *out) const
{
    const int last = int(params_.points) - 1;
    const double step = reach(fibre) / last;
    const double scale = level(root);
    const double bend = step / (step + stiffness);
    const Vec start = scalp_.body.inside(root.position);
    // Hair from the crown lies over hair from below.
    const double layer = smooth(-0.7, 1.0, start.y);
    const double height =
        0.001 + params_.volume * (0.15 + 0.45 * layer + 0.4 * rise) * smooth(-0.8, 0.2, start.y) +
        0.8 * upward_;
    Vec direction = unit(root.normal * 0.7 + unit(comb(start, side), down), root.normal);
    out[0] = root.position;
    for (int i = 1; i <= last; ++i) {
        const Vec here = out[i - 1];
        const Vec u = scalp_.body.inside(here);
        const double away = smooth(1.1, 1.7, length(u));
        const double hang = smooth(0.5, -0.25, u.y);
        const Vec combed = unit(comb(u, side), down);
        const Vec wish = unit(mix(combed, down, std::max(away, hang) * 0.85) + down * 0.25, down);
        direction = unit(mix(direction, wish, bend), down);
        // Rises to its height within the first 4 cm, and keeps a margin to the
        // head that later displacements use up.
        const double margin = mix(0.0003, height, smooth(0.0, 0.04, step * i));
        Vec next = here + direction * step;
        for (int pass = 0; pass < 3; ++pass) {
            const Vec outside = push_out(next, scale, margin);
            direction = unit(outside - here, direction);
            next = here + direction * step;
        }
        out[i] = next;
    }
}

void Grower::wind(const Root &root, const Lock &lock, double fibre, Random &random,
                  Vec *points) const
{
    const int last = int(params_.points) - 1;
    const double step = reach(fibre) / last;
    const double scale = level(root);
    const double phase = lock.phase + 0.12 * (0.3 + params_.frizz) * random.bell();
    const double turns = params_.curl_frequency * lock.pitch * (1.0 + 0.06 * random.bell());
    // A strand sways twice around its lock; both sways are slow enough for the points.
    const double most = double(last) / (6.0 * fibre);
    struct {
        double frequency, phase_a, phase_b, size;
    } sway[2];
    for (int k = 0; k < 2; ++k) {
        const double frequency = random.range(3.0, k ? 30.0 : 9.0);
        sway[k] = {std::min(frequency, most), random.unit(), random.unit(),
                   params_.frizz * (k ? 0.0025 : 0.0075) * random.unit()};
    }

    Vec tangent = unit(points[1] - points[0], root.normal);
    Vec wide = unit(cross(tangent, root.normal), {1.0, 0.0, 0.0});
    Vec before = points[0];
    for (int i = 1; i <= last; ++i) {
        // The frame goes along without turning around the path.
        tangent = unit(points[i] - before, tangent);
        before = points[i];
        wide = unit(wide - tangent * dot(tangent, wide), wide);
        const Vec up = cross(wide, tangent);

        const double s = step * i;
        const double grown = opened(s);
        const double at = phase + turns * s;
        double a = across_ * grown * sine(at);
        double b = upward_ * grown * cosine(at) * lock.turn;
        for (const auto &w : sway) {
            a += w.size * grown * sine(w.phase_a + w.frequency * s);
            b += w.size * grown * sine(w.phase_b + w.frequency * s);
        }
        points[i] = push_out(points[i] + wide * a + up * b, scale, 0.0003);
    }
}

} // namespace tsuya::groom

#include "leaf/blade.h"

#include <algorithm>

namespace tsuya::leaf {

using groom::cosine;
using groom::mix;
using groom::pi;
using groom::Random;
using groom::sine;
using groom::smooth;
using groom::Vec;

namespace {

constexpr int spine_steps = 400;

glm::vec3 rounded(Vec v)
{
    return {float(v.x), float(v.y), float(v.z)};
}

// Places from 0 to 1, closer to each other at both ends.
double spread(std::size_t i, std::size_t count)
{
    const double t = double(i) / double(count);
    return mix(t, 0.5 - 0.5 * cosine(0.5 * t), 0.7);
}

// Places across a half: teeth live in its last fifth.
double across(std::size_t i, std::size_t count)
{
    const double t = double(i) / double(count);
    return t * (1.25 - 0.25 * t);
}

} // namespace

Blade::Blade(const Outline &outline) : outline_(outline)
{
    Random random(outline.params().seed, 2);
    phase_[0] = random.unit();
    phase_[1] = random.unit();
    const double step = outline.params().length / spine_steps;
    Vec p;
    spine_.push_back(p);
    for (int i = 0; i < spine_steps; i++) {
        const double h = heading((i + 0.5) / spine_steps);
        p = p + Vec{0.0, cosine(h), sine(h)} * step;
        spine_.push_back(p);
    }
}

double Blade::heading(double q) const
{
    const double t = std::min(std::max(q, 0.0), 1.0);
    // More of the bend towards the tip, where the blade is thin.
    return outline_.params().bend / (2.0 * pi) * (0.42 - t * (0.45 + 0.55 * t));
}

Vec Blade::middle(double y) const
{
    if (y < 0.0) {
        return along(0.0) * y;
    }
    const double at = std::min(y / outline_.params().length, 1.0) * spine_steps;
    const std::size_t i = std::min<std::size_t>(std::size_t(at), spine_steps - 1);
    return mix(spine_[i], spine_[i + 1], at - double(i));
}

Vec Blade::along(double y) const
{
    const double h = heading(y / outline_.params().length);
    return {0.0, cosine(h), sine(h)};
}

Vec Blade::up(double y) const
{
    const double h = heading(y / outline_.params().length);
    return {0.0, -sine(h), cosine(h)};
}

Vec Blade::at(double s, double r, int side) const
{
    const LeafParams &p = outline_.params();
    const Flat flat = outline_.at(s, r, side);
    const double sway = outline_.sway(flat.y);
    const double d = double(side) * (flat.x - sway); // from the midrib, >= 0
    const double q = flat.y / p.length;
    const double half = 0.5 * p.width * p.length;
    const double fold = p.fold / (2.0 * pi) * (1.0 - 0.35 * smooth(0.0, 0.9, q));
    // The cross-section as an arc whose slope falls from the fold as it goes outwards.
    Flat section;
    constexpr int steps = 8;
    for (int i = 0; i < steps; i++) {
        const double a = fold * (1.0 - p.curl * d * (i + 0.5) / steps / half);
        section.x += cosine(a) * d / steps;
        section.y += sine(a) * d / steps;
    }
    const double rho = d / half;
    const double swing = sine(2.6 * s + phase_[side < 0 ? 0 : 1]) +
                         0.7 * noise(p.seed * 4 + (side < 0 ? 2 : 3), 6.0 * s);
    section.y += p.wave * half * rho * rho * swing * smooth(0.0, 0.2, s);
    const double turn = p.twist / (2.0 * pi) * q;
    const double c = cosine(turn), n = sine(turn);
    const double x = double(side) * section.x;
    return middle(flat.y) + Vec{sway + x * c - section.y * n, 0.0, 0.0} +
           up(flat.y) * (section.y * c + x * n);
}

void flat_box(const Outline &outline, Flat &lower, Flat &size)
{
    lower = {0.0, 0.0};
    Flat upper{0.0, outline.params().length};
    for (int i = 0; i <= 4000; i++) {
        for (int side = -1; side <= 1; side += 2) {
            const Flat p = outline.at(i / 4000.0, 1.0, side);
            lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
            upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
        }
    }
    const double margin = 0.01 * outline.params().length;
    lower = {lower.x - margin, lower.y - margin};
    size = {upper.x - lower.x + margin, upper.y - lower.y + margin};
}

bool make_blade(const Blade &blade, const Flat &lower, const Flat &size, Mesh &mesh,
                double &flat_area)
{
    const LeafParams &p = blade.outline().params();
    const std::size_t rows = p.rows, columns = p.columns, across_all = 2 * columns + 1;
    std::vector<Flat> flat;
    const auto add = [&](double s, std::size_t column) {
        const int side = column < columns ? -1 : 1;
        const std::size_t from_middle = column < columns ? columns - column : column - columns;
        const double r = across(from_middle, columns);
        const Flat f = blade.outline().at(s, r, side);
        flat.push_back(f);
        mesh.positions.push_back(rounded(blade.at(s, r, side)));
        mesh.uvs.emplace_back(float((f.x - lower.x) / size.x), float((f.y - lower.y) / size.y));
    };
    add(0.0, columns);
    for (std::size_t row = 1; row < rows; row++) {
        for (std::size_t column = 0; column < across_all; column++) {
            add(spread(row, rows), column);
        }
    }
    add(1.0, columns);

    const auto index = [&](std::size_t row, std::size_t column) {
        return std::uint32_t(row == 0      ? 0
                             : row == rows ? flat.size() - 1
                                           : 1 + (row - 1) * across_all + column);
    };
    for (std::size_t row = 0; row < rows; row++) {
        for (std::size_t column = 0; column + 1 < across_all; column++) {
            const std::uint32_t a = index(row, column), b = index(row, column + 1);
            const std::uint32_t c = index(row + 1, column + 1), d = index(row + 1, column);
            if (row == 0) {
                mesh.indices.insert(mesh.indices.end(), {a, c, d});
            } else if (row + 1 == rows) {
                mesh.indices.insert(mesh.indices.end(), {a, b, c});
            } else if (column < columns) { // diagonals mirror each other
                mesh.indices.insert(mesh.indices.end(), {a, b, d, b, c, d});
            } else {
                mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
            }
        }
    }
    flat_area = 0.0;
    bool good = true;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Flat a = flat[mesh.indices[i]], b = flat[mesh.indices[i + 1]];
        const Flat c = flat[mesh.indices[i + 2]];
        const double area = 0.5 * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
        good = good && area > 0.0;
        flat_area += area;
    }
    make_normals(mesh);
    make_tangents(mesh);
    return good;
}

void make_stalk(const Blade &blade, Mesh &mesh, Vec &begin)
{
    const LeafParams &p = blade.outline().params();
    const double length = p.length, stalk = p.petiole * length;
    // As coarse as the blade.
    const bool fine = p.rows >= 40;
    const std::uint32_t around = fine ? 10 : 4;
    const std::size_t before = fine ? 14 : 3, under = fine ? 24 : 4;
    const double thick = 0.0085 * length;
    // The stalk turns up into the blade from a lower heading.
    constexpr double turned = 0.09; // turns
    std::vector<Vec> path, tops;
    std::vector<double> radii;
    Vec at;
    for (std::size_t i = 0; i < before; i++) {
        const double t = (double(i) + 0.5) / double(before);
        const Vec a = blade.along(0.0), u = blade.up(0.0);
        const double c = cosine(-turned * t), s = sine(-turned * t);
        at = at - (a * c - u * s) * (stalk / double(before));
        path.insert(path.begin(), at);
        tops.insert(tops.begin(), u * c + a * s);
        const double foot = 1.0 + 0.9 * smooth(0.85, 1.0, t);
        radii.insert(radii.begin(), thick * foot);
    }
    begin = path.front();
    for (std::size_t i = 0; i <= under; i++) {
        const double q = 0.6 * double(i) / double(under);
        const double radius = thick * (1.0 - 0.97 * smooth(-0.25, 0.6, q));
        // Its top touches the sheet from below.
        const Vec place =
            blade.middle(q * length) + Vec{blade.outline().sway(q * length), 0.0, 0.0};
        path.push_back(place);
        tops.push_back(blade.up(q * length));
        radii.push_back(radius);
    }
    const std::size_t rings = path.size();
    for (std::size_t i = 0; i < rings; i++) {
        const Vec along = groom::unit(path[std::min(i + 1, rings - 1)] - path[i > 0 ? i - 1 : 0],
                                      {0.0, 1.0, 0.0});
        const Vec side = groom::unit(groom::cross(along, tops[i]), {1.0, 0.0, 0.0});
        const Vec up = groom::cross(side, along);
        const Vec centre = path[i] - up * (1.05 * radii[i]);
        const double t = double(i) / double(rings - 1);
        for (std::uint32_t k = 0; k < around; k++) {
            const double turn = double(k) / double(around);
            const Vec out = side * cosine(turn) + up * sine(turn);
            mesh.positions.push_back(rounded(centre + out * radii[i]));
            mesh.uvs.emplace_back(float(turn), float(t));
            const double foot = 1.0 - smooth(0.0, 0.12, t);
            const Vec green{0.17, 0.2, 0.06}, brown{0.13, 0.085, 0.05};
            mesh.albedo.push_back(rounded(mix(green, brown, foot)));
        }
    }
    for (std::size_t i = 0; i + 1 < rings; i++) {
        for (std::uint32_t k = 0; k < around; k++) {
            const std::uint32_t a = std::uint32_t(i * around + k);
            const std::uint32_t b = std::uint32_t(i * around + (k + 1) % around);
            const std::uint32_t c = b + around, d = a + around;
            // `side` times `up` looks back along the path.
            mesh.indices.insert(mesh.indices.end(), {a, d, c, a, c, b});
        }
    }
    for (std::uint32_t k = 1; k + 1 < around; k++) {
        const std::uint32_t last = std::uint32_t((rings - 1) * around);
        mesh.indices.insert(mesh.indices.end(), {0, k, k + 1});
        mesh.indices.insert(mesh.indices.end(), {last, last + k + 1, last + k});
    }
    make_normals(mesh);
    make_tangents(mesh);
}

} // namespace tsuya::leaf

#include "strand.h"

#include <algorithm>
#include <exception>
#include <sstream>

namespace tsuya::groom {

namespace {

constexpr double points_per_turn = 6.0;

// Hair from the crown is longer than hair from the nape, or the tips would
// make a tail; this is the relative difference.
constexpr double layering = 0.45;

double crown(const Scalp &scalp, const Root &root)
{
    const double y = (scalp.body.inside(root.position).y + 0.6) / 1.6;
    return std::min(1.0, std::max(0.0, y));
}

template <class T> bool outside(const char *field, T value, double low, double high, Error &error)
{
    // Written so that NaN is outside.
    if (double(value) >= low && double(value) <= high) {
        return false;
    }
    std::ostringstream out;
    out << field << " is " << value << " but must be in [" << low << ", " << high << "]";
    error.message = out.str();
    return true;
}

bool invalid(const HairParams &p, Error &error)
{
    if (p.style != Style::straight && p.style != Style::wavy && p.style != Style::curly) {
        error.message = "style is " + std::to_string(int(p.style)) +
                        " but must be straight, wavy or curly (in [0, 2])";
        return true;
    }
    if (outside("strands", p.strands, 100, 100000, error) ||
        outside("points", p.points, 8, 256, error) ||
        outside("length", p.length, 0.02, 1.0, error) ||
        outside("length_variation", p.length_variation, 0.0, 0.5, error) ||
        outside("curl_radius", p.curl_radius, 0.0, 0.03, error) ||
        outside("curl_frequency", p.curl_frequency, 0.0, 200.0, error) ||
        outside("clumping", p.clumping, 0.0, 1.0, error) ||
        outside("frizz", p.frizz, 0.0, 1.0, error) ||
        outside("volume", p.volume, 0.0, 0.05, error) ||
        outside("radius", p.radius, 1e-6, 1e-3, error)) {
        return true;
    }
    return false;
}

bool invalid(const ScalpParams &p, Error &error)
{
    if (!(p.unit_scale > 0.0 && std::isfinite(p.unit_scale))) {
        std::ostringstream out;
        out << "unit_scale is " << p.unit_scale << " but must be finite and above 0";
        error.message = out.str();
        return true;
    }
    const glm::vec3 n = p.plane_normal;
    const double squared = double(n.x) * n.x + double(n.y) * n.y + double(n.z) * n.z;
    if (!(squared > 1e-12 && squared <= 1e80)) {
        error.message = "plane_normal must be finite and longer than 0.000001";
        return true;
    }
    return outside("plane_offset", p.plane_offset, -10.0, 10.0, error);
}

// Points a curl needs to be seen as one.
bool too_coarse(const HairParams &p, const Grower &grower, Error &error)
{
    const double longest = p.length * (1.0 + p.length_variation) * (1.0 + layering);
    const double turns = p.curl_frequency * grower.reach(longest);
    if (p.style == Style::straight || turns * points_per_turn <= double(p.points - 1)) {
        return false;
    }
    std::ostringstream out;
    const double needed = std::floor(turns * points_per_turn) + 2.0;
    if (needed > 256.0) {
        out << "curl_frequency is " << p.curl_frequency << " but at this length must be in [0, "
            << std::floor(255.0 / points_per_turn / grower.reach(longest)) << "]; it makes "
            << turns << " turns, and 256 points of 6 a turn hold 42";
    } else {
        out << "points is " << p.points << " but must be in [" << needed << ", 256]: length and "
            << "curl_frequency make " << turns << " turns of 6 points";
    }
    error.message = out.str();
    return true;
}

struct Guide {
    Lock lock;
    const Root *root;
};

// The lock with the nearest root on the same side of the parting, or the
// nearest at all when that side has none.
std::size_t nearest(const std::vector<Guide> &guides, Vec p, int side)
{
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < guides.size(); ++i) {
        const Vec d = guides[i].root->position - p;
        const double far = dot(d, d) + (guides[i].lock.side == side ? 0.0 : 1e6);
        if (far < least) {
            least = far;
            best = i;
        }
    }
    return best;
}

// Largest distance between the points of two paths, metres.
double farthest(const Vec *a, const Vec *b, std::size_t points)
{
    double most = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
        most = std::max(most, length(a[i] - b[i]));
    }
    return most;
}

void grow(const HairParams &params, const Scalp &scalp, const Grower &grower, HairyHead &out)
{
    const std::vector<Root> roots = sample_roots(scalp, params.strands, params.seed);
    const std::size_t n = params.points;
    double mean = 0.0;
    for (const Root &root : roots) {
        mean += crown(scalp, root) / double(roots.size());
    }
    const auto cut = [&](const Root &root) {
        return params.length * (1.0 + layering * (crown(scalp, root) - mean));
    };

    // Roots come in random order, so the first ones are spread over the scalp.
    const std::size_t locks = params.style == Style::straight ? 900 : 450;
    std::vector<Guide> guides(std::min<std::size_t>(locks, params.strands / 8));
    std::vector<Vec> paths(guides.size() * n);
    for (std::size_t g = 0; g < guides.size(); ++g) {
        Random random(params.seed, 2 + std::uint64_t(g) * 2);
        guides[g].root = &roots[g];
        guides[g].lock = grower.lock(roots[g], random);
        grower.path(roots[g], guides[g].lock.side, cut(roots[g]), random.unit(), &paths[g * n]);
    }

    Groom &groom = out.groom;
    groom.constant_radius = float(params.radius);
    groom.points.reserve(roots.size() * n);
    groom.first.reserve(roots.size() + 1);
    groom.first.push_back(0);
    std::vector<Vec> strand(n);
    for (std::size_t s = 0; s < roots.size(); ++s) {
        const Root &root = roots[s];
        Random random(params.seed, 3 + std::uint64_t(s) * 2);
        const int side = grower.lock(root, random).side;
        const double length = cut(root) * (1.0 + params.length_variation * random.range(-1.0, 1.0));
        const Guide &guide = guides[nearest(guides, root.position, side)];
        const Vec *lead = &paths[std::size_t(&guide - guides.data()) * n];

        grower.path(root, side, length, random.unit(), strand.data());
        // A few strands stay out of every lock.
        double join = params.clumping * (random.unit() < 0.04 ? 0.2 : 1.0);
        // Around the whorl the nearest lock may fall over the far side of the head.
        join *= 1.0 - smooth(0.04, 0.08, farthest(strand.data(), lead, n));
        for (std::size_t i = 1; i < n; ++i) {
            const double t = smooth(0.02, 0.9, double(i) / double(n - 1)) * join;
            strand[i] = mix(strand[i], lead[i], t);
        }
        Lock lock = guide.lock;
        lock.side = side;
        grower.wind(root, lock, length, random, strand.data());

        for (const Vec &p : strand) {
            groom.points.emplace_back(float(p.x), float(p.y), float(p.z));
        }
        groom.first.push_back(std::uint32_t(groom.points.size()));
        groom.seed.push_back(strand_seed(std::uint32_t(s)));
        const Vec u = scalp.body.inside(root.position);
        groom.uv.emplace_back(float(0.5 + 0.5 * u.x), float(0.5 + 0.5 * u.z));
        out.root_face.push_back(root.face);
    }
}

Expected<HairyHead> make(const HairParams &params, const ScalpParams &from)
{
    Expected<Scalp> scalp = from.path.empty() ? built_in_scalp() : load_scalp(from);
    if (!scalp) {
        return Error{scalp.error()};
    }
    const Grower grower(params, *scalp);
    Error error;
    if (too_coarse(params, grower, error)) {
        return error;
    }
    HairyHead out;
    grow(params, *scalp, grower, out);
    out.report = inspect(out.groom);
    if (out.report.degenerate_segments || out.report.non_finite_points) {
        return Error{"the segments of the hair are too short for float coordinates: use fewer "
                     "points, a larger length, or a mesh nearer to the origin"};
    }
    out.head = std::move(scalp->head);
    out.scalp = std::move(scalp->scalp);
    const Ellipsoid body = scalp->body;
    out.centre = {float(body.centre.x), float(body.centre.y), float(body.centre.z)};
    out.semi_axes = {float(body.axes.x), float(body.axes.y), float(body.axes.z)};
    if (scalp->neck) {
        const float back = float(neck_depth), front = float(throat_depth);
        out.neck_centre = {0.0f, 0.5f * (front - back)};
        out.neck_axes = {float(neck_width), 0.5f * (front + back)};
        out.neck_span = {float(head_bottom), float(neck_top) + 0.01f};
    }
    return out;
}

} // namespace

HairParams preset(Style style)
{
    HairParams p;
    p.style = style;
    if (style == Style::wavy) {
        p.points = 48;
        p.curl_radius = 0.008;
        p.curl_frequency = 14.0;
        p.clumping = 0.55;
        p.frizz = 0.25;
        p.volume = 0.022;
    } else if (style == Style::curly) {
        p.points = 64;
        p.curl_radius = 0.009;
        p.curl_frequency = 30.0;
        p.clumping = 0.7;
        p.frizz = 0.35;
        p.volume = 0.03;
    }
    return p;
}

Expected<HairyHead> generate(const HairParams &params, const ScalpParams &scalp)
{
    Error error;
    if (invalid(params, error) || invalid(scalp, error)) {
        return error;
    }
    try {
        return make(params, scalp);
    } catch (const std::exception &) {
        return Error{"memory ran out while generating the groom"};
    }
}

} // namespace tsuya::groom

#include "scalp.h"

// Copies of default-made vectors inside these headers look uninitialised to GCC.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <sstream>

namespace tsuya::groom {

namespace {

using TriMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Vertex = TriMesh::VertexHandle;

const Ellipsoid head_body{{0.0, 0.0, 0.0}, {0.075, 0.115, 0.095}};

glm::vec3 to_float(Vec v)
{
    return {float(v.x), float(v.y), float(v.z)};
}
Vec to_double(const glm::vec3 &v)
{
    return {v.x, v.y, v.z};
}

// Angle of the hairline from the top of the head, degrees, against the cosine
// of the azimuth: 1 forehead, 0 ear, -1 nape. Chosen to look like a person.
double hairline(double w)
{
    static const double knot[][2] = {{1.0, 54.0},  {0.82, 53.0},  {0.5, 68.0},  {0.25, 92.0},
                                     {-0.2, 94.0}, {-0.5, 112.0}, {-1.0, 124.0}};
    for (int i = 1; i < 7; ++i) {
        if (w >= knot[i][0]) {
            const double t = smooth(knot[i - 1][0], knot[i][0], w);
            return mix(knot[i - 1][1], knot[i][1], t);
        }
    }
    return knot[6][1];
}

Mesh to_arrays(TriMesh &mesh)
{
    mesh.request_face_normals();
    mesh.request_vertex_normals();
    mesh.update_normals();
    Mesh out;
    for (const Vertex v : mesh.vertices()) {
        const auto p = mesh.point(v);
        const auto n = mesh.normal(v);
        out.positions.emplace_back(p[0], p[1], p[2]);
        out.normals.push_back(to_float(unit({n[0], n[1], n[2]}, {0.0, 1.0, 0.0})));
    }
    for (const auto f : mesh.faces()) {
        for (const Vertex v : mesh.fv_range(f)) {
            out.indices.push_back(std::uint32_t(v.idx()));
        }
    }
    return out;
}

// Rings of `around` vertices from a first vertex down, `at(ring, sector)`, both
// as fractions, and a last vertex if `closed`.
template <class At> TriMesh rings(int down, int around, bool closed, At at)
{
    TriMesh mesh;
    const auto add = [&](double ring, double sector) {
        const Vec p = at(ring, sector);
        return mesh.add_vertex({float(p.x), float(p.y), float(p.z)});
    };
    const Vertex top = add(0.0, 0.0);
    std::vector<Vertex> above, ring(std::size_t(around), top);
    for (int i = 1; i <= down; ++i) {
        above = ring;
        for (int j = 0; j < around; ++j) {
            ring[std::size_t(j)] = add(double(i) / down, double(j) / around);
        }
        for (int j = 0; j < around; ++j) {
            const std::size_t a = std::size_t(j), b = std::size_t((j + 1) % around);
            mesh.add_face(above[a], ring[a], ring[b]);
            if (i > 1) {
                mesh.add_face(above[a], ring[b], above[b]);
            }
        }
    }
    if (closed) {
        const Vertex bottom = mesh.add_vertex({0.0f, mesh.point(ring[0])[1], 0.0f});
        for (int j = 0; j < around; ++j) {
            mesh.add_face(ring[std::size_t(j)], bottom, ring[std::size_t((j + 1) % around)]);
        }
    }
    return mesh;
}

// Point of the built-in head. The skull is the ellipsoid; below it the jaw, a
// neck and a nose are drawn from cross-sections that stay off the scalp.
Vec head_point(double ring, double sector)
{
    const Vec axes = head_body.axes;
    const double sx = sine(sector), sz = cosine(sector);
    const double split = 0.7;
    const double turn = std::min(ring / split, 1.0) * 0.42;
    const double base = axes.y * cosine(0.42);
    const double y =
        ring <= split ? axes.y * cosine(turn) : mix(base, head_bottom, (ring - split) / 0.3);
    const double u = y / axes.y;
    const double section = std::sqrt(std::max(0.0, 1.0 - u * u));
    const double low = smooth(-0.02, neck_top, y);
    const double width = std::max(axes.x * section, neck_width * low);
    double depth = std::max(axes.z * section, neck_depth * low);
    if (sz > 0.0) {
        const double chin = mix(axes.z * section, 0.088, smooth(-0.02, -0.09, y));
        depth = mix(chin, throat_depth, smooth(-0.100, -0.135, y));
    }
    const double jaw = smooth(-0.04, -0.1, y) * (1.0 - smooth(-0.105, -0.135, y));
    const double narrow = 1.0 - 0.45 * jaw * std::max(0.0, sz);
    Vec p{width * narrow * sx, y, depth * sz};
    if (sz > 0.0) {
        const double across = 1.0 - smooth(0.0, 0.014, std::fabs(p.x));
        const double along = smooth(0.025, -0.026, y) * (1.0 - smooth(-0.03, -0.042, y));
        p.z += 0.022 * across * along;
    }
    return p;
}

Vec scalp_point(double ring, double sector)
{
    const double turn = ring * hairline(cosine(sector)) / 360.0;
    const double s = sine(turn);
    return Vec{s * sine(sector), cosine(turn), s * cosine(sector)} * head_body.axes;
}

double twice_area(const Mesh &mesh, std::size_t face)
{
    const Vec a = to_double(mesh.positions[mesh.indices[face * 3]]);
    const Vec b = to_double(mesh.positions[mesh.indices[face * 3 + 1]]);
    const Vec c = to_double(mesh.positions[mesh.indices[face * 3 + 2]]);
    return length(cross(b - a, c - a));
}

Error refuse(const ScalpParams &params, const std::string &why)
{
    return Error{params.path + ": " + why};
}

// Faces of `head` above the plane, with all its vertices.
Mesh cut(const Mesh &head, const ScalpParams &params)
{
    if (!params.cut) {
        return head;
    }
    const Vec up = unit(to_double(params.plane_normal), {0.0, 1.0, 0.0});
    Mesh out{head.positions, head.normals, {}};
    for (std::size_t i = 0; i + 2 < head.indices.size(); i += 3) {
        Vec sum;
        for (std::size_t k = i; k < i + 3; ++k) {
            sum = sum + to_double(head.positions[head.indices[k]]);
        }
        if (dot(sum, up) * (1.0 / 3.0) >= params.plane_offset) {
            out.indices.insert(out.indices.end(),
                               {head.indices[i], head.indices[i + 1], head.indices[i + 2]});
        }
    }
    return out;
}

} // namespace

Scalp built_in_scalp()
{
    TriMesh head = rings(96, 160, true, head_point);
    TriMesh scalp = rings(48, 128, false, scalp_point);
    return {to_arrays(head), to_arrays(scalp), head_body, true};
}

Expected<Scalp> load_scalp(const ScalpParams &params)
{
    TriMesh mesh;
    omerr().disable();
    const bool good = OpenMesh::IO::read_mesh(mesh, params.path);
    omerr().enable();
    if (!good) {
        return refuse(params, "it cannot be read as an .obj, .ply, .off or .stl mesh");
    }
    if (mesh.n_faces() == 0) {
        return refuse(params, "it has no faces");
    }
    Vec low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
    for (const Vertex v : mesh.vertices()) {
        auto &p = mesh.point(v);
        Vec q;
        double *to[3] = {&q.x, &q.y, &q.z};
        for (unsigned k = 0; k < 3; ++k) {
            *to[k] = double(p[k]) * params.unit_scale;
            if (!(std::fabs(*to[k]) <= 10.0)) {
                std::ostringstream out;
                out << "vertex " << v.idx() << " has the coordinate " << p[k]
                    << " but times unit_scale it must be in [-10, 10] metres";
                return refuse(params, out.str());
            }
            p[k] = float(*to[k]);
        }
        low = {std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z)};
        high = {std::max(high.x, q.x), std::max(high.y, q.y), std::max(high.z, q.z)};
    }
    Scalp out;
    out.head = to_arrays(mesh);
    out.scalp = cut(out.head, params);
    double area = 0.0;
    for (std::size_t f = 0; f < out.scalp.indices.size() / 3; ++f) {
        area += twice_area(out.scalp, f);
    }
    if (!(area > 1e-10)) {
        return refuse(params, params.cut ? "no face with an area is above plane_offset"
                                         : "no face has an area");
    }
    // A flat scalp gets an ellipsoid too thin to matter instead of a division by 0.
    const Vec half = (high - low) * 0.5;
    out.body = {(high + low) * 0.5,
                {std::max(half.x, 1e-3), std::max(half.y, 1e-3), std::max(half.z, 1e-3)}};
    return out;
}

std::vector<Root> sample_roots(const Scalp &from, std::uint32_t count, std::uint64_t seed)
{
    const Mesh &mesh = from.scalp;
    std::vector<double> sum(mesh.indices.size() / 3);
    double total = 0.0;
    for (std::size_t f = 0; f < sum.size(); ++f) {
        total += twice_area(mesh, f);
        sum[f] = total;
    }
    Random random(seed, 1);
    std::vector<std::uint32_t> order(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        order[i] = i;
    }
    for (std::uint32_t i = count; i > 1; --i) {
        std::swap(order[i - 1], order[std::uint32_t(random.unit() * i)]);
    }
    std::vector<Root> roots(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double at = (order[i] + random.unit()) / count * total;
        const auto found = std::upper_bound(sum.begin(), sum.end() - 1, at);
        const std::size_t face = std::size_t(found - sum.begin());
        const double r = std::sqrt(random.unit()), s = random.unit();
        const double weight[3] = {1.0 - r, r * (1.0 - s), r * s};
        Vec p, n;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.indices[face * 3 + k];
            p = p + to_double(mesh.positions[v]) * weight[k];
            n = n + to_double(mesh.normals[v]) * weight[k];
        }
        if (from.neck) {
            // From the triangle onto the ellipsoid it approximates.
            const Vec u = unit(from.body.inside(p), {0.0, 1.0, 0.0});
            p = from.body.centre + u * from.body.axes;
            n = u / from.body.axes;
        }
        roots[i] = {p, unit(n, {0.0, 1.0, 0.0}), std::uint32_t(face)};
    }
    return roots;
}

} // namespace tsuya::groom

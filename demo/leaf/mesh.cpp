#include "groom/numeric.h"

#include "leaf/mesh.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <utility>

namespace tsuya::leaf {

using groom::Vec;

namespace {

Vec vec(const glm::vec3 &v)
{
    return {v.x, v.y, v.z};
}

glm::vec3 rounded(Vec v)
{
    return {float(v.x), float(v.y), float(v.z)};
}

// Any unit vector at right angles to the unit vector n.
Vec across(Vec n)
{
    const Vec other = n.x * n.x < 0.36 ? Vec{1.0, 0.0, 0.0} : Vec{0.0, 1.0, 0.0};
    return unit(other - n * dot(other, n), other);
}

// Number of each vertex's place.
std::vector<std::uint32_t> places_of(const Mesh &mesh, std::size_t &count)
{
    std::vector<std::uint32_t> order(mesh.positions.size()), place(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 &p = mesh.positions[i];
        return std::array<float, 3>{p.x, p.y, p.z};
    };
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
    count = 0;
    for (std::size_t i = 0; i < order.size(); i++) {
        count += i == 0 || key(order[i]) != key(order[i - 1]);
        place[order[i]] = std::uint32_t(count - 1);
    }
    return place;
}

std::uint32_t root(std::vector<std::uint32_t> &parent, std::uint32_t i)
{
    while (parent[i] != i) {
        i = parent[i] = parent[parent[i]];
    }
    return i;
}

struct Edge {
    std::size_t forward = 0, backward = 0; // triangles that run along it from its lower place, back
};

} // namespace

Report inspect(const Mesh &mesh)
{
    Report r;
    r.vertices = mesh.positions.size();
    r.triangles = mesh.triangles();
    const std::vector<std::uint32_t> place = places_of(mesh, r.places);
    std::map<std::pair<std::uint32_t, std::uint32_t>, Edge> edges;
    std::vector<std::uint32_t> piece(r.places), rim(r.places);
    std::iota(piece.begin(), piece.end(), 0u);
    std::iota(rim.begin(), rim.end(), 0u);
    for (std::size_t t = 0; t < r.triangles; t++) {
        const std::uint32_t *corner = &mesh.indices[3 * t];
        for (int k = 0; k < 3; k++) {
            const std::uint32_t a = place[corner[k]], b = place[corner[(k + 1) % 3]];
            Edge &edge = edges[{std::min(a, b), std::max(a, b)}];
            (a < b ? edge.forward : edge.backward)++;
            piece[root(piece, a)] = root(piece, b);
        }
        const Vec p = vec(mesh.positions[corner[0]]);
        r.area += 0.5 * length(cross(vec(mesh.positions[corner[1]]) - p,
                                     vec(mesh.positions[corner[2]]) - p));
        const glm::vec2 u = mesh.uvs[corner[0]], v = mesh.uvs[corner[1]], w = mesh.uvs[corner[2]];
        r.uv_area += 0.5 * ((double(v.x) - u.x) * (double(w.y) - u.y) -
                            (double(w.x) - u.x) * (double(v.y) - u.y));
    }
    r.edges = edges.size();
    r.euler = long(r.places) - long(r.edges) + long(r.triangles);
    std::vector<char> on_rim(r.places, 0);
    for (const auto &[ends, edge] : edges) {
        if (edge.forward > 1 || edge.backward > 1) {
            r.tangled_edges++;
        } else if (edge.forward + edge.backward == 1) {
            r.boundary_edges++;
            on_rim[ends.first] = on_rim[ends.second] = 1;
            rim[root(rim, ends.first)] = root(rim, ends.second);
        }
    }
    for (std::uint32_t i = 0; i < r.places; i++) {
        r.pieces += root(piece, i) == i;
        r.boundary_loops += on_rim[i] && root(rim, i) == i;
    }
    r.lower = r.upper = mesh.positions.empty() ? glm::vec3(0.0f) : mesh.positions[0];
    for (const glm::vec3 &p : mesh.positions) {
        for (int k = 0; k < 3; k++) {
            r.lower[k] = std::min(r.lower[k], p[k]);
            r.upper[k] = std::max(r.upper[k], p[k]);
        }
    }
    return r;
}

std::string text(const Report &r)
{
    std::string out;
    char line[240];
    const auto add = [&](auto... values) {
        std::snprintf(line, sizeof line, values...);
        out += line;
    };
    add("triangles        %zu, vertices %zu, pieces %zu\n", r.triangles, r.vertices, r.pieces);
    add("box              (%.4g, %.4g, %.4g) to (%.4g, %.4g, %.4g) m\n", double(r.lower.x),
        double(r.lower.y), double(r.lower.z), double(r.upper.x), double(r.upper.y),
        double(r.upper.z));
    add("area             %.4g m2\n", r.area);
    if (r.dropped_triangles) {
        add("dropped          %zu triangles without area\n", r.dropped_triangles);
    }
    if (r.mirrored_triangles) {
        add("mirrored uv      %zu triangles\n", r.mirrored_triangles);
    }
    if (r.tangled_edges) {
        add("tangled          %zu edges of three triangles, or wound against each other\n",
            r.tangled_edges);
    }
    if (r.computed_normals) {
        out += "normals          from the triangles: the file has none that can be used\n";
    }
    if (r.planar_uv) {
        out += "uv               projected along the thinnest side: the file has none\n";
    }
    return out;
}

void make_normals(Mesh &mesh)
{
    std::vector<Vec> sum(mesh.positions.size());
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const std::uint32_t *corner = &mesh.indices[t];
        const Vec p = vec(mesh.positions[corner[0]]);
        const Vec n = cross(vec(mesh.positions[corner[1]]) - p, vec(mesh.positions[corner[2]]) - p);
        for (int k = 0; k < 3; k++) {
            sum[corner[k]] = sum[corner[k]] + n;
        }
    }
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t i = 0; i < sum.size(); i++) {
        // Areas of small leaves are far below unit()'s shortest length.
        const double most =
            std::max({std::fabs(sum[i].x), std::fabs(sum[i].y), std::fabs(sum[i].z)});
        const Vec scaled = most > 0.0 ? sum[i] * (1.0 / most) : sum[i];
        mesh.normals[i] = rounded(unit(scaled, {0.0, 0.0, 1.0}));
    }
}

std::size_t make_tangents(Mesh &mesh)
{
    const std::size_t before = mesh.positions.size();
    std::vector<char> mirrored(mesh.triangles(), 0), flat(mesh.triangles(), 0);
    std::vector<Vec> along(mesh.triangles());
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles(); t++) {
        const std::uint32_t *c = &mesh.indices[3 * t];
        const Vec p = vec(mesh.positions[c[0]]);
        const Vec a = vec(mesh.positions[c[1]]) - p, b = vec(mesh.positions[c[2]]) - p;
        const double au = double(mesh.uvs[c[1]].x) - mesh.uvs[c[0]].x;
        const double av = double(mesh.uvs[c[1]].y) - mesh.uvs[c[0]].y;
        const double bu = double(mesh.uvs[c[2]].x) - mesh.uvs[c[0]].x;
        const double bv = double(mesh.uvs[c[2]].y) - mesh.uvs[c[0]].y;
        const double size = au * bv - bu * av;
        mirrored[t] = size < 0.0;
        flat[t] = size == 0.0;
        count += std::size_t(size < 0.0);
        const Vec d = a * bv - b * av;
        const double most = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z), 1e-300});
        // Unit length times area: thin triangles count little.
        along[t] =
            unit(d * ((size < 0.0 ? -1.0 : 1.0) / most), {0.0, 0.0, 0.0}) * length(cross(a, b));
    }

    // The first triangle with an area in the uv decides a vertex's sign; others get a twin.
    std::vector<signed char> sign(before, 0);
    std::vector<std::uint32_t> twin(before, 0);
    std::vector<Vec> sum(before);
    for (std::size_t t = 0; t < mesh.triangles(); t++) {
        if (flat[t]) {
            continue;
        }
        const signed char wanted = mirrored[t] ? -1 : 1;
        for (int k = 0; k < 3; k++) {
            std::uint32_t &i = mesh.indices[3 * t + std::size_t(k)];
            if (sign[i] == 0) {
                sign[i] = wanted;
            } else if (sign[i] != wanted) {
                if (twin[i] == 0) {
                    twin[i] = std::uint32_t(mesh.positions.size());
                    mesh.positions.push_back(glm::vec3(mesh.positions[i]));
                    mesh.normals.push_back(glm::vec3(mesh.normals[i]));
                    mesh.uvs.push_back(glm::vec2(mesh.uvs[i]));
                    if (!mesh.albedo.empty()) {
                        mesh.albedo.push_back(glm::vec3(mesh.albedo[i]));
                    }
                    sign.push_back(wanted);
                    sum.push_back({});
                    twin.push_back(0);
                }
                i = twin[i];
            }
            sum[i] = sum[i] + along[t];
        }
    }
    mesh.tangents.resize(mesh.positions.size());
    for (std::size_t i = 0; i < sum.size(); i++) {
        const Vec n = vec(mesh.normals[i]);
        const double most =
            std::max({std::fabs(sum[i].x), std::fabs(sum[i].y), std::fabs(sum[i].z), 1e-300});
        const Vec d = sum[i] * (1.0 / most);
        const Vec level = d - n * dot(d, n);
        const Vec t = length(level) > 1e-6 ? unit(level, n) : across(n);
        mesh.tangents[i] = glm::vec4(rounded(t), sign[i] < 0 ? -1.0f : 1.0f);
    }
    return count;
}

} // namespace tsuya::leaf

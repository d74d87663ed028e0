#include "leaf/read.h"

#include "leaf/check.h"

// Copies of default-made vectors inside these headers look uninitialised to GCC.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace tsuya::leaf {

namespace {

// Polygons, so that every corner keeps its own uv; fans are made here.
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using IO = OpenMesh::IO::Options;

std::string ending(const std::string &path)
{
    const std::size_t dot = path.rfind('.');
    std::string text = dot == std::string::npos ? "" : path.substr(dot);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

bool usable(const glm::vec3 &p)
{
    // NaN fails every comparison.
    return std::fabs(p.x) <= coordinate_limit && std::fabs(p.y) <= coordinate_limit &&
           std::fabs(p.z) <= coordinate_limit;
}

glm::vec3 upright(const glm::vec3 &p, groom::Up up)
{
    return up == groom::Up::z ? glm::vec3(p.x, p.z, -p.y) : p;
}

// Twice the area, in double: a leaf in metres is small.
double twice_area(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c)
{
    return glm::length(glm::cross(b - a, c - a));
}

class Builder
{
  public:
    Builder(const PolyMesh &from, const Counted &counted, const ReadOptions &options)
        : from_(from), counted_(counted), options_(options)
    {
    }

    // Returns: what is wrong; "" when nothing is.
    std::string build(bool corner_uvs)
    {
        for (const auto v : from_.vertices()) {
            const auto p = from_.point(v);
            const glm::dvec3 q = glm::dvec3(p[0], p[1], p[2]) * options_.unit_scale;
            if (!usable(glm::vec3(q))) {
                return "vertex " + std::to_string(v.idx()) +
                       " times unit_scale is not within 1000000 metres";
            }
            places_.push_back(upright(glm::vec3(q), options_.up));
        }
        normals_ = counted_.normals && take_normals();
        for (const auto face : from_.faces()) {
            std::vector<std::uint32_t> corners;
            for (const auto h : from_.fh_range(face)) {
                glm::vec2 uv(0.0f);
                if (counted_.uvs) {
                    const auto t = corner_uvs ? from_.texcoord2D(h)
                                              : from_.texcoord2D(from_.to_vertex_handle(h));
                    uv = glm::vec2(t[0], t[1]);
                }
                corners.push_back(vertex(std::uint32_t(from_.to_vertex_handle(h).idx()), uv));
            }
            for (std::size_t k = 2; k < corners.size(); k++) {
                triangle(corners[0], corners[k - 1], corners[k]);
            }
        }
        if (mesh.indices.empty()) {
            return "none of its faces has an area";
        }
        finish();
        return "";
    }

    Mesh mesh;
    std::size_t dropped = 0, mirrored = 0;
    bool computed_normals = false, planar_uv = false;

  private:
    bool take_normals()
    {
        for (const auto v : from_.vertices()) {
            const auto n = from_.normal(v);
            const glm::vec3 normal = upright(glm::vec3(n[0], n[1], n[2]), options_.up);
            const float size = glm::length(normal);
            if (!(size > 1e-6f && size <= 1e6f)) {
                return false;
            }
            directions_.push_back(normal / size);
        }
        return true;
    }

    std::uint32_t vertex(std::uint32_t place, const glm::vec2 &uv)
    {
        const auto found =
            known_.try_emplace({place, uv.x, uv.y}, std::uint32_t(mesh.positions.size()));
        if (found.second) {
            mesh.positions.push_back(places_[place]);
            mesh.uvs.push_back(uv);
            place_.push_back(place);
            if (normals_) {
                mesh.normals.push_back(directions_[place]);
            }
        }
        return found.first->second;
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        const glm::dvec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
        const double longest =
            std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
        // A height of less than a millionth of the length: no direction in float.
        if (!(twice_area(p, q, r) > 1e-6 * longest * longest)) {
            dropped++;
            return;
        }
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    }

    // Normals that go over a seam of the uv: computed by place.
    void normals_of_places()
    {
        Mesh whole;
        whole.positions = places_;
        for (const std::uint32_t i : mesh.indices) {
            whole.indices.push_back(place_[i]);
        }
        make_normals(whole);
        mesh.normals.resize(mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); i++) {
            mesh.normals[i] = whole.normals[place_[i]];
        }
        computed_normals = true;
    }

    void project()
    {
        glm::vec3 lower = mesh.positions[mesh.indices[0]], upper = lower;
        for (const std::uint32_t i : mesh.indices) {
            lower = glm::min(lower, mesh.positions[i]);
            upper = glm::max(upper, mesh.positions[i]);
        }
        const glm::vec3 size = upper - lower;
        const int thin = size.x < size.y && size.x < size.z ? 0 : size.y < size.z ? 1 : 2;
        int u = (thin + 1) % 3, v = (thin + 2) % 3;
        if (size[u] > size[v]) {
            std::swap(u, v);
        }
        for (std::size_t i = 0; i < mesh.positions.size(); i++) {
            const glm::vec3 p = (mesh.positions[i] - lower) / size[v];
            mesh.uvs[i] = glm::vec2(p[u] + 0.5f * (1.0f - size[u] / size[v]), p[v]);
        }
        // Counter-clockwise for the greater part, so that nothing counts as mirrored for no reason.
        double area = 0.0;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const glm::vec2 a = mesh.uvs[mesh.indices[t]];
            const glm::vec2 b = mesh.uvs[mesh.indices[t + 1]] - a;
            const glm::vec2 c = mesh.uvs[mesh.indices[t + 2]] - a;
            area += double(b.x) * double(c.y) - double(c.x) * double(b.y);
        }
        for (glm::vec2 &uv : mesh.uvs) {
            uv.x = area < 0.0 ? 1.0f - uv.x : uv.x;
        }
        planar_uv = true;
    }

    // Leave out vertices that no triangle has.
    void compact()
    {
        std::vector<std::uint32_t> to(mesh.positions.size(), 0xffffffffu);
        Mesh kept;
        std::vector<std::uint32_t> places;
        for (std::uint32_t &i : mesh.indices) {
            if (to[i] == 0xffffffffu) {
                to[i] = std::uint32_t(kept.positions.size());
                kept.positions.push_back(mesh.positions[i]);
                kept.uvs.push_back(mesh.uvs[i]);
                places.push_back(place_[i]);
                if (normals_) {
                    kept.normals.push_back(mesh.normals[i]);
                }
            }
            i = to[i];
        }
        kept.indices = std::move(mesh.indices);
        mesh = std::move(kept);
        place_ = std::move(places);
    }

    void finish()
    {
        compact();
        if (!normals_) {
            normals_of_places();
        }
        if (!counted_.uvs) {
            project();
        }
        mirrored = make_tangents(mesh);
    }

    const PolyMesh &from_;
    const Counted &counted_;
    const ReadOptions &options_;
    bool normals_ = false;
    std::vector<glm::vec3> places_, directions_;
    std::vector<std::uint32_t> place_; // of a vertex
    std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> known_;
};

Expected<Loaded> build(const std::string &path, const Counted &counted, const ReadOptions &options)
{
    PolyMesh from;
    from.request_vertex_normals();
    from.request_vertex_texcoords2D();
    from.request_halfedge_texcoords2D();
    IO found = IO::VertexNormal | IO::VertexTexCoord | IO::FaceTexCoord;
    omerr().disable();
    omlog().disable();
    const bool good = OpenMesh::IO::read_mesh(from, path, found);
    omlog().enable();
    omerr().enable();
    if (!good) {
        return Error{"it cannot be read as a mesh"};
    }
    if (from.n_vertices() > counted.vertices) {
        return Error{"it is no surface: an edge belongs to three faces, or two faces are wound "
                     "against each other (" +
                     std::to_string(from.n_vertices() - counted.vertices) +
                     " corners would have to be torn off)"};
    }
    if (from.n_vertices() != counted.vertices || from.n_faces() != counted.faces) {
        return Error{"of " + std::to_string(counted.faces) + " faces only " +
                     std::to_string(from.n_faces()) + " can be read"};
    }
    Builder builder(from, counted, options);
    const std::string wrong = builder.build(ending(path) == ".obj");
    if (!wrong.empty()) {
        return Error{wrong};
    }
    Loaded result;
    result.mesh = std::move(builder.mesh);
    result.report = inspect(result.mesh);
    result.report.dropped_triangles = builder.dropped + counted.skipped;
    result.report.mirrored_triangles = builder.mirrored;
    result.report.computed_normals = builder.computed_normals;
    result.report.planar_uv = builder.planar_uv;
    return Expected<Loaded>(std::move(result));
}

} // namespace

Expected<Loaded> read(const std::string &path, const ReadOptions &options)
{
    const auto refuse = [&](const std::string &why) { return Error{path + ": " + why}; };
    if (!(options.unit_scale > 0.0 && std::isfinite(options.unit_scale))) {
        return refuse("unit_scale must be finite and above 0");
    }
    const std::string kind = ending(path);
    if (kind != ".obj" && kind != ".ply") {
        return refuse("a leaf's mesh is an .obj or .ply file");
    }
    try {
        std::ifstream file(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file),
                                std::istreambuf_iterator<char>()};
        if (!file.is_open() || file.bad()) {
            return refuse("it cannot be read");
        }
        const Expected<Counted> counted = kind == ".obj" ? check_obj(bytes) : check_ply(bytes);
        if (!counted) {
            return refuse(counted.error());
        }
        if (counted->faces == 0) {
            return refuse("it has no faces");
        }
        Expected<Loaded> loaded = build(path, *counted, options);
        return loaded ? std::move(loaded) : Expected<Loaded>(refuse(loaded.error()));
    } catch (const std::exception &) {
        return refuse("memory ran out while reading it");
    }
}

} // namespace tsuya::leaf

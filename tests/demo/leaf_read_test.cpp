// Reading leaf meshes: good files come back as they were, bad ones are refused with a reason.
#include "leaf_checks.h"
#include "leaf_files.h"

#include "leaf/read.h"

#include <algorithm>
#include <utility>

using namespace leaf_checks;
using namespace leaf_files;

namespace {

namespace fs = std::filesystem;

fs::path folder;

tsuya::leaf::Expected<Loaded> load(const std::string &text, const char *name = "a.obj",
                                   const ReadOptions &options = {})
{
    const fs::path path = folder / name;
    std::ofstream(path, std::ios::binary) << text;
    return read(path.string(), options);
}

Loaded loaded(const std::string &text, const char *name = "a.obj", const ReadOptions &options = {})
{
    auto result = load(text, name, options);
    if (!result) {
        fail_msg("%s", result.error().c_str());
    }
    check_promises(result->mesh);
    return std::move(*result);
}

void refuse(const std::string &text, const std::vector<std::string> &words,
            const char *name = "a.obj")
{
    const auto result = load(text, name);
    if (result) {
        fail_msg("accepted: %.300s", text.c_str());
    }
    expect_error(result.error(), {name});
    expect_error(result.error(), words);
}

Mesh sample()
{
    LeafParams p;
    p.rows = 8;
    p.columns = 2;
    p.texels = 0;
    return generate(p)->blade;
}

// The triangles of two meshes, corner by corner: fans and vertices may be stored in another order.
void expect_same(const Mesh &a, const Mesh &b, bool normals)
{
    assert_int_equal(a.indices.size(), b.indices.size());
    for (std::size_t i = 0; i < a.indices.size(); i += 3) {
        // A reader may begin with another corner.
        int shift = 0;
        while (shift < 3 &&
               a.positions[a.indices[i]] != b.positions[b.indices[i + std::size_t(shift)]]) {
            shift++;
        }
        assert_true(shift < 3);
        for (std::size_t k = 0; k < 3; k++) {
            const std::uint32_t p = a.indices[i + k];
            const std::uint32_t q = b.indices[i + (k + std::size_t(shift)) % 3];
            assert_true(a.positions[p] == b.positions[q] && a.uvs[p] == b.uvs[q]);
            assert_true(!normals || glm::distance(a.normals[p], b.normals[q]) < 1e-6f);
            assert_true(glm::distance(a.tangents[p], b.tangents[q]) < 1e-5f);
        }
    }
}

void reads_back_what_was_written(void **)
{
    const Mesh mesh = sample();
    const Loaded obj = loaded(make_obj(mesh));
    expect_same(mesh, obj.mesh, true);
    assert_int_equal(obj.mesh.positions.size(), mesh.positions.size());
    assert_false(obj.report.computed_normals || obj.report.planar_uv);
    assert_int_equal(obj.report.euler, 1);
    for (const Ply format : {Ply::ascii, Ply::little, Ply::big}) {
        const Loaded ply = loaded(make_ply(mesh, format), "a.PLY");
        expect_same(mesh, ply.mesh, true);
        assert_int_equal(ply.report.dropped_triangles, 0);
        // Computed normals are the generator's, which computes them the same way.
        const Loaded bare = loaded(make_ply(mesh, format, true, false), "a.ply");
        assert_true(bare.report.computed_normals);
        expect_same(mesh, bare.mesh, true);
    }
    expect_error(text(loaded(make_obj(mesh, true, false)).report),
                 {"normals", "from the triangles"});
}

void scales_and_turns(void **)
{
    ReadOptions options;
    options.unit_scale = 0.01;
    options.up = tsuya::groom::Up::z;
    const Loaded r =
        loaded("v 1 2 3\nv 5 2 3\nv 1 2 9\nvn 0 0 1\nf 1//1 2//1 3//1\n", "a.obj", options);
    assert_true(glm::distance(r.mesh.positions[r.mesh.indices[0]], {0.01f, 0.03f, -0.02f}) < 1e-8f);
    assert_true(r.mesh.normals[0] == glm::vec3(0.0f, 1.0f, 0.0f));
    for (const double wrong : {0.0, -1.0, double(NAN), double(INFINITY)}) {
        options.unit_scale = wrong;
        const auto refused = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj", options);
        assert_false(bool(refused));
        expect_error(refused.error(), {"unit_scale", "above 0"});
    }
    options.unit_scale = 1e9;
    const auto huge = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj", options);
    expect_error(huge.error(), {"vertex 1", "1000000 metres"});
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\n";

void takes_polygons_and_corner_uvs(void **)
{
    // A quad as a fan, counted from the end.
    const Loaded quad = loaded(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                        "f -4/-4 -3/-3 -2/-2 -1/-1\n");
    assert_int_equal(quad.report.triangles, 2);
    assert_int_equal(quad.report.vertices, 4);
    assert_true(quad.report.uv_area == 1.0 && quad.report.area == 2.0);
    // The same position with another uv on each side of a seam: no boundary between them.
    const Loaded seam = loaded(square + "vt 0 0\nvt .5 0\nvt .5 1\nvt 1 1\nvt .6 1\nvt .6 0\n"
                                        "f 1/1 2/2 3/3\nf 1/6 3/5 4/4\n");
    assert_int_equal(seam.report.vertices, 6);
    assert_int_equal(seam.report.places, 4);
    assert_int_equal(seam.report.euler, 1);
    assert_int_equal(seam.report.boundary_edges, 4);
    for (const glm::vec3 &n : seam.mesh.normals) {
        assert_true(n == glm::vec3(0.0f, 0.0f, 1.0f));
    }
}

void projects_where_there_are_no_uvs(void **)
{
    const Mesh mesh = sample();
    const Loaded r = loaded(make_obj(mesh, false, true));
    assert_true(r.report.planar_uv);
    assert_int_equal(r.report.mirrored_triangles, 0);
    expect_error(text(r.report), {"uv", "projected"});
    // v along the longer side, over all of [0, 1]; u with the same scale, in the middle.
    const glm::vec3 size = r.report.upper - r.report.lower;
    const auto y = [&](const glm::vec3 &p) { return (p.y - r.report.lower.y) / size.y; };
    for (std::size_t i = 0; i < r.mesh.uvs.size(); i++) {
        const glm::vec3 &p = r.mesh.positions[i];
        assert_true(std::fabs(r.mesh.uvs[i].y - y(p)) < 1e-5f);
        const float u = (p.x - 0.5f * (r.report.lower.x + r.report.upper.x)) / size.y + 0.5f;
        assert_true(std::fabs(r.mesh.uvs[i].x - u) < 1e-5f);
    }
    // Lying on the ground and wide: projected from above, v along x.
    const Loaded flat = loaded("v 0 0 0\nv 0 0 1\nv 4 0 0\nf 1 2 3\n");
    assert_true(flat.mesh.uvs[flat.mesh.indices[2]].y == 1.0f);
    assert_true(flat.report.uv_area > 0.0);
}

void mirrored_uvs_get_a_mirrored_frame(void **)
{
    // Two halves of a leaf that share one half of a texture.
    const Loaded r = loaded("v -1 0 0\nv 0 0 0\nv 1 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                            "f 2/1 3/2 4/3\nf 1/2 2/1 4/3\n");
    assert_int_equal(r.report.mirrored_triangles, 1);
    expect_error(text(r.report), {"mirrored", "1"});
    // The midrib's vertices are there twice, once for each frame.
    assert_int_equal(r.report.vertices, 6);
    assert_int_equal(r.report.euler, 1);
    for (std::size_t i = 0; i < r.mesh.positions.size(); i++) {
        const glm::vec4 t = r.mesh.tangents[i];
        const glm::vec3 b = t.w * glm::cross(r.mesh.normals[i], glm::vec3(t));
        assert_true(glm::distance(b, {0.0f, 1.0f, 0.0f}) < 1e-6f);
        assert_true(r.mesh.positions[i].x == 0.0f || t.x * r.mesh.positions[i].x > 0.99f);
    }
}

void drops_what_has_no_area(void **)
{
    const Loaded r = loaded(square + "v 7 0 0\nv 8 0 0\nv 9 0 0\nv 5 5 5\n"
                                     "f 1 2 3\nf 1 3 4\nf 1 1 2\nf 5 6 7\n");
    assert_int_equal(r.report.triangles, 2);
    assert_int_equal(r.report.dropped_triangles, 2);
    // Nor are vertices kept that no triangle has.
    assert_int_equal(r.report.vertices, 4);
    expect_error(text(r.report), {"dropped", "2 triangles without area"});
    refuse("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", {"none of its faces has an area"});
    // Normals that are none are computed.
    const Loaded n = loaded(square + "vn 0 0 0\nf 1//1 2//1 3//1\n");
    assert_true(n.report.computed_normals && n.mesh.normals[0].z == 1.0f);
}

void refuses_bad_obj(void **)
{
    refuse("", {"no faces"});
    refuse(square, {"no faces"});
    refuse(square + "f 1 1 1\n", {"no faces"});
    refuse("v 0 0 nan\n" + square + "f 1 2 3\n", {"line 1", "nan", "finite"});
    refuse("v 0 0 inf\n" + square + "f 1 2 3\n", {"line 1", "inf"});
    refuse("v 0 0 1e39\n" + square + "f 1 2 3\n", {"line 1", "1e39"});
    refuse("v 0 0\n" + square + "f 1 2 3\n", {"line 1", "2 numbers of 3"});
    refuse("v 0 0 x\n" + square + "f 1 2 3\n", {"line 1", "\"x\""});
    refuse(square + "vt 0\nf 1/1 2/1 3/1\n", {"line 5", "1 numbers of 2"});
    refuse(square + "f 1 2 5\n", {"line 5", "number 5 of 4 vertices"});
    refuse(square + "f 0 1 2\n", {"line 5", "number 0"});
    refuse(square + "f -5 1 2\n", {"line 5", "number -5"});
    refuse(square + "f 1 2\n", {"line 5", "2 corners"});
    refuse(square + "f 1 2 3.5\n", {"line 5", "3.5"});
    refuse(square + "f 1/1 2/1 3/1\n", {"line 5", "number 1 of 0 uv"});
    refuse(square + "vt 0 0\nf 1/1 2/1 3\n", {"some corners"});
    refuse(square + "f 1//2 2//2 3//2\nvn 0 0 1\n", {"line 5", "number 2 of 1 normals"});
    refuse(square + "f 1/1/1/1 2 3\n", {"line 5", "three parts"});
    refuse(square + "f 1 2 2 3\n", {"line 5", "twice"});
    refuse(square + "f 1 2 3 # 4\n", {"line 5", "#"});
    // Three faces at an edge; two that are wound against each other.
    refuse(square + "v 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 3 5\n", {"no surface", "three faces"});
    refuse(square + "f 1 2 3\nf 1 4 3\n", {"no surface", "wound against"});
    refuse(square + "f 1 2 3\n", {"a leaf's mesh"}, "a.stl");
    const std::string missing = (folder / "missing.obj").string();
    expect_error(read(missing).error(), {missing, "cannot be read"});
    expect_error(read(folder.string() + "/").error(), {"a leaf's mesh"});
}

void refuses_bad_ply(void **)
{
    const auto changed = [](std::string text, const std::string &from, const std::string &to) {
        const std::size_t at = text.find(from);
        assert_true(at != std::string::npos);
        return text.replace(at, from.size(), to);
    };
    const Mesh mesh = sample();
    const std::string ascii = make_ply(mesh, Ply::ascii), binary = make_ply(mesh, Ply::little);
    refuse(changed(ascii, "ply\n", "plx\n"), {"line 1"}, "a.ply");
    refuse(changed(ascii, "ascii", "octal"), {"line 2", "octal"}, "a.ply");
    refuse(changed(ascii, " 1.0", " x.0"), {"line 2", "no format"}, "a.ply");
    refuse(changed(ascii, "float x\nproperty", "float x property"), {"line 5"}, "a.ply");
    refuse(changed(ascii, "end_header\n", ""), {"line", "not understood"}, "a.ply");
    refuse("ply\nformat ascii 1.0\ncomment x\n", {"header does not end"}, "a.ply");
    refuse(changed(ascii, "float z", "float w"), {"no x, y and z"}, "a.ply");
    refuse(changed(ascii, "element face", "element edge"), {"element edge"}, "a.ply");
    refuse(changed(ascii, "vertex_indices", "texcoord"), {"vertex_indices"}, "a.ply");
    refuse(changed(binary, "float x", "double x"), {"line 5", "double"}, "a.ply");
    refuse(changed(binary, "uchar int", "uint int"), {"uchar int"}, "a.ply");
    for (const char *count : {"4294967295", "99999999", "-1", "1e9"}) {
        for (const char *what : {"element vertex ", "element face "}) {
            const std::string from =
                what + std::to_string(what[8] == 'v' ? mesh.positions.size() : mesh.triangles());
            assert_false(bool(load(changed(binary, from, what + std::string(count)), "a.ply")));
            assert_false(bool(load(changed(ascii, from, what + std::string(count)), "a.ply")));
        }
    }
    refuse(changed(binary, "element vertex 3", "element vertex 9"), {"claims", "bytes"}, "a.ply");

    Mesh bad = mesh;
    bad.positions[2].y = std::nanf("");
    for (const Ply format : {Ply::ascii, Ply::little, Ply::big}) {
        refuse(make_ply(bad, format), {"vertex 2", "y", "not finite"}, "a.ply");
    }
    bad = mesh;
    bad.uvs[1].x = std::numeric_limits<float>::infinity();
    refuse(make_ply(bad, Ply::little), {"vertex 1", "u", "not finite"}, "a.ply");
    bad = mesh;
    bad.indices[4] = 1000;
    for (const Ply format : {Ply::ascii, Ply::little, Ply::big}) {
        refuse(make_ply(bad, format), {"face 1", "vertex 1000 of"}, "a.ply");
    }
    bad = mesh;
    bad.indices.clear();
    refuse(make_ply(bad, Ply::little), {"no faces"}, "a.ply");
    // Every cut is noticed.
    for (std::size_t size = 0; size + 1 < binary.size(); size++) {
        assert_false(bool(load(binary.substr(0, size), "a.ply")));
    }
}

void survives_mutations(void **)
{
    const Mesh mesh = sample();
    const std::pair<std::string, const char *> files[] = {
        {make_obj(mesh), "a.obj"},
        {make_ply(mesh, Ply::ascii), "a.ply"},
        {make_ply(mesh, Ply::little), "a.ply"},
        {make_ply(mesh, Ply::big, false, false), "a.ply"}};
    std::uint32_t state = 20261122u;
    const auto random = [&](std::size_t below) {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        return std::size_t(state) % below;
    };
    std::size_t accepted = 0;
    constexpr std::size_t rounds = 3000;
    for (std::size_t round = 0; round < rounds; round++) {
        const auto &[whole, name] = files[random(4)];
        std::string text = whole;
        for (std::size_t flips = 1 + random(3); flips > 0; flips--) {
            const std::size_t at =
                random(random(2) ? std::min<std::size_t>(text.size(), 300) : text.size());
            text[at] = char(random(3) ? text[at] ^ char(1u << random(8)) : char(random(256)));
        }
        const auto result = load(text, name);
        if (result) {
            accepted++;
            check_promises(result->mesh);
            assert_true(result->mesh.triangles() <= mesh.triangles() + 4);
        } else {
            assert_false(result.error().empty());
        }
    }
    assert_in_range(accepted, rounds / 20, rounds * 19 / 20);
}

} // namespace

int main()
{
    folder = fs::temp_directory_path() / "tsuya-leaf-test";
    folder += std::to_string(std::uintptr_t(&folder));
    fs::create_directories(folder);
    const CMUnitTest tests[] = {
        cmocka_unit_test(reads_back_what_was_written),
        cmocka_unit_test(scales_and_turns),
        cmocka_unit_test(takes_polygons_and_corner_uvs),
        cmocka_unit_test(projects_where_there_are_no_uvs),
        cmocka_unit_test(mirrored_uvs_get_a_mirrored_frame),
        cmocka_unit_test(drops_what_has_no_area),
        cmocka_unit_test(refuses_bad_obj),
        cmocka_unit_test(refuses_bad_ply),
        cmocka_unit_test(survives_mutations),
    };
    const int failed = cmocka_run_group_tests_name("leaf_read", tests, nullptr, nullptr);
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return failed;
}

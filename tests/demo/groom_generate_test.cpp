// The hair generator against its promises: same bytes, shape, statistics, errors.
#include "groom_measure.h"

#include <glm/geometric.hpp>

#include <algorithm>

#include "groom_checks.h"

using namespace groom_checks;
using namespace groom_measure;

namespace {

const Style styles[] = {Style::straight, Style::wavy, Style::curly};

HairParams small(Style style, std::uint32_t strands)
{
    HairParams p = preset(style);
    p.strands = strands;
    return p;
}

template <class T> bool same_bytes(const std::vector<T> &a, const std::vector<T> &b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void same_seed_same_bytes(void **)
{
    // Made once with GCC and Clang, with and without fused multiply-add.
    const std::uint64_t known[] = {0xb08827a7f0182951u, 0x2cdd31b0c242fe83u,
                                   0x174172401051193eu};
    for (const Style style : styles) {
        HairParams p = small(style, 500);
        const auto a = generate(p), b = generate(p);
        assert_true(bool(a) && bool(b));
        assert_true(same_bytes(a->groom.points, b->groom.points));
        assert_true(same_bytes(a->groom.uv, b->groom.uv));
        assert_true(same_bytes(a->groom.seed, b->groom.seed));
        assert_true(same_bytes(a->root_face, b->root_face));
        assert_true(same_bytes(a->head.positions, b->head.positions));
        assert_int_equal(fingerprint(a->groom), known[int(style)]);
        p.seed = 2;
        assert_false(same_bytes(a->groom.points, generate(p)->groom.points));
    }
}

void counts_are_exact(void **)
{
    for (const Style style : styles) {
        for (const std::uint32_t strands : {100u, 5000u}) {
            const HairParams p = small(style, strands);
            const auto head = generate(p);
            assert_true(bool(head));
            check_promises(head->groom);
            assert_int_equal(head->groom.strands(), strands);
            assert_int_equal(head->groom.points.size(), strands * p.points);
            assert_int_equal(head->groom.uv.size(), strands);
            assert_int_equal(head->root_face.size(), strands);
            for (std::size_t s = 0; s <= strands; ++s) {
                assert_int_equal(head->groom.first[s], s * p.points);
            }
            assert_true(head->report.plausible_size);
        }
    }
}

void stays_outside_the_head(void **)
{
    for (const Style style : styles) {
        HairParams p = small(style, 2000);
        for (const double frizz : {p.frizz, 1.0}) {
            p.frizz = frizz;
            p.clumping = frizz;
            p.volume = frizz < 1.0 ? p.volume : 0.0;
            const auto head = generate(p);
            double deepest = 0.0;
            for (const glm::vec3 &point : head->groom.points) {
                deepest = std::max(deepest, depth(*head, point));
            }
            assert_true(deepest < 0.001);
        }
    }
}

void face_is_free(void **)
{
    // Seen from the front: between the eyes and down to the mouth.
    for (const Style style : styles) {
        const auto head = generate(small(style, 3000));
        for (const glm::vec3 &p : head->groom.points) {
            assert_false(p.z > 0.05f && std::fabs(p.x) < 0.03f && p.y < 0.03f);
        }
    }
}

void length_is_what_was_asked(void **)
{
    for (const Style style : styles) {
        for (const double length : {0.05, 0.15, 0.3}) {
            HairParams p = small(style, 1000);
            p.length = length;
            const double mean = generate(p)->report.mean_length;
            assert_true(std::fabs(mean / length - 1.0) < 0.1);
        }
    }
}

void curls_by_style(void **)
{
    double curvature[3];
    for (const Style style : styles) {
        HairParams p = small(style, 1000);
        p.points = 64;
        const auto head = generate(p);
        curvature[int(style)] = mean_curvature(head->groom);
        // A strand in 200 with a kink would be seen.
        assert_in_range(head->report.kinked_strands, 0, 4);
    }
    assert_true(curvature[1] > 1.5 * curvature[0]);
    assert_true(curvature[2] > 1.5 * curvature[1]);
}

void roots_are_uniform_by_area(void **)
{
    const auto head = generate(small(Style::straight, 20000));
    // 63 degrees of freedom: chance alone stays below 104 in 99.9 % of cases.
    assert_true(chi_square(*head, 64) < 104.0);
    for (std::size_t s = 0; s < head->groom.strands(); ++s) {
        const glm::vec3 root = head->groom.points[head->groom.first[s]];
        const std::uint32_t *v = &head->scalp.indices[head->root_face[s] * 3];
        const std::vector<glm::vec3> &at = head->scalp.positions;
        const float edge = std::max(glm::length(at[v[1]] - at[v[0]]),
                                    glm::length(at[v[2]] - at[v[0]]));
        // On the triangle, but for the step from it to the ellipsoid.
        assert_true(glm::length(root - at[v[0]]) < edge + 0.0005f);
    }
}

void meshes_are_sound(void **)
{
    const auto made = generate(small(Style::straight, 100));
    for (const Mesh *mesh : {&made->head, &made->scalp}) {
        assert_int_equal(mesh->positions.size(), mesh->normals.size());
        assert_true(!mesh->indices.empty() && mesh->indices.size() % 3 == 0);
        for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
            assert_true(std::fabs(glm::length(mesh->normals[i]) - 1.0f) < 1e-4f);
        }
        for (const std::uint32_t i : mesh->indices) {
            assert_true(i < mesh->positions.size());
        }
    }
    for (std::size_t i = 0; i < made->scalp.positions.size(); ++i) {
        assert_true(glm::dot(made->scalp.positions[i], made->scalp.normals[i]) > 0.0f);
    }
}

void grows_on_a_loaded_mesh(void **)
{
    const Folder folder;
    const std::string obj = "v 10 0 0\nv 0 10 0\nv 0 0 10\nv -10 0 0\nv 0 -10 0\nv 0 0 -10\n"
                            "f 1 2 3\nf 3 2 4\nf 4 2 6\nf 6 2 1\n"
                            "f 3 5 1\nf 4 5 3\nf 6 5 4\nf 1 5 6\n";
    ScalpParams scalp;
    scalp.path = folder.write("octahedron.obj", Bytes(obj.begin(), obj.end()));
    scalp.unit_scale = 0.01;
    const HairParams p = small(Style::wavy, 500);
    const auto whole = generate(p, scalp);
    assert_true(bool(whole));
    check_promises(whole->groom);
    assert_int_equal(whole->scalp.indices.size(), 24);
    assert_true(std::fabs(whole->semi_axes.y - 0.1f) < 1e-6f);

    scalp.cut = true;
    scalp.plane_normal = glm::vec3(0.0f, 5.0f, 0.0f);
    scalp.plane_offset = 0.02;
    const auto half = generate(p, scalp);
    assert_int_equal(half->scalp.indices.size(), 12);
    assert_int_equal(half->head.indices.size(), 24);
    for (std::size_t s = 0; s < half->groom.strands(); ++s) {
        assert_true(half->groom.points[half->groom.first[s]].y >= 0.0f);
    }
    assert_true(chi_square(*half, 4) < 16.3);

    scalp.plane_offset = 0.5;
    expect_error(generate(p, scalp).error(), {"octahedron.obj", "plane_offset"});
    scalp.unit_scale = 1e6;
    expect_error(generate(p, scalp).error(), {"vertex 0", "unit_scale", "[-10, 10]"});
    scalp.path = folder.write("empty.obj", {});
    expect_error(generate(p, scalp).error(), {"empty.obj"});
    scalp.path = folder.path() + "/missing.ply";
    expect_error(generate(p, scalp).error(), {"missing.ply", "cannot be read"});
}

void errors_name_the_field(void **)
{
    const double nan = std::nan("");
    for (const double wrong : {-1.0, 1e9, nan}) {
        const std::pair<const char *, double HairParams::*> fields[] = {
            {"length", &HairParams::length},
            {"length_variation", &HairParams::length_variation},
            {"curl_radius", &HairParams::curl_radius},
            {"curl_frequency", &HairParams::curl_frequency},
            {"clumping", &HairParams::clumping},
            {"frizz", &HairParams::frizz},
            {"volume", &HairParams::volume},
            {"radius", &HairParams::radius},
        };
        for (const auto &[name, field] : fields) {
            HairParams p;
            p.*field = wrong;
            expect_error(generate(p).error(), {std::string(name) + " is ", "must be in ["});
        }
        ScalpParams scalp;
        scalp.plane_offset = wrong == -1.0 ? -2e3 : wrong;
        expect_error(generate({}, scalp).error(), {"plane_offset is ", "[-10, 10]"});
        scalp = ScalpParams();
        scalp.unit_scale = wrong == 1e9 ? INFINITY : wrong;
        expect_error(generate({}, scalp).error(), {"unit_scale is ", "above 0"});
        scalp = ScalpParams();
        scalp.plane_normal.y = wrong == -1.0 ? 0.0f : float(nan);
        expect_error(generate({}, scalp).error(), {"plane_normal"});
    }
    HairParams p;
    p.strands = 99;
    expect_error(generate(p).error(), {"strands is 99 ", "[100, 100000]"});
    p.strands = 100001;
    expect_error(generate(p).error(), {"strands is 100001 ", "[100, 100000]"});
    p = HairParams();
    p.points = 7;
    expect_error(generate(p).error(), {"points is 7 ", "[8, 256]"});
    p = preset(Style::curly);
    p.points = 16;
    expect_error(generate(p).error(), {"points is 16 ", ", 256]", "curl_frequency"});
    p.curl_frequency = 200.0;
    p.curl_radius = 0.001;
    p.length = 1.0;
    expect_error(generate(p).error(), {"curl_frequency is 200 ", "[0, "});
    p.style = Style(7);
    expect_error(generate(p).error(), {"style is 7 "});
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(same_seed_same_bytes),
        cmocka_unit_test(counts_are_exact),
        cmocka_unit_test(stays_outside_the_head),
        cmocka_unit_test(face_is_free),
        cmocka_unit_test(length_is_what_was_asked),
        cmocka_unit_test(curls_by_style),
        cmocka_unit_test(roots_are_uniform_by_area),
        cmocka_unit_test(meshes_are_sound),
        cmocka_unit_test(grows_on_a_loaded_mesh),
        cmocka_unit_test(errors_name_the_field),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}

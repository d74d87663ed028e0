// The leaf generator against its promises: bytes, areas, topology, frames, maps, errors.
#include "leaf_checks.h"

#include <algorithm>

using namespace leaf_checks;

namespace {

LeafParams shape(const std::string &name, std::uint64_t seed = 1, std::uint32_t texels = 256)
{
    LeafParams p = *preset(name);
    p.seed = seed;
    p.texels = texels;
    return p;
}

Leaf grown(const LeafParams &p)
{
    auto leaf = generate(p);
    if (!leaf) {
        fail_msg("%s", leaf.error().c_str());
    }
    return std::move(*leaf);
}

// Without chance, teeth, lobes and a heart.
LeafParams plain(double base, double tip)
{
    LeafParams p;
    p.base = base;
    p.tip = tip;
    p.roughness = 0.0;
    p.texels = 0;
    return p;
}

LeafParams flat(LeafParams p)
{
    p.fold = p.bend = p.twist = p.wave = 0.0;
    return p;
}

void same_seed_same_bytes(void **)
{
    // Made once with GCC and Clang, with and without fused multiply-add.
    const std::uint64_t known[] = {0x0463643e36515597u, 0x7e77528160d76a98u, 0xb44c7207a10a9a60u,
                                   0xe0fec41f8df22591u, 0x5c403f11a41a080au};
    std::size_t at = 0;
    for (const std::string &name : shapes()) {
        const Leaf a = grown(shape(name)), b = grown(shape(name)), c = grown(shape(name, 2));
        const auto print = [](const Leaf &leaf) {
            return Fingerprint()
                .add(leaf.blade)
                .add(leaf.stalk)
                .add(leaf.maps.pigment)
                .add(leaf.maps.thickness)
                .add(leaf.maps.relief)
                .add(leaf.maps.inside)
                .value();
        };
        assert_true(print(a) == print(b));
        assert_false(print(a) == print(c));
        if (print(a) != known[at]) {
            fail_msg("%s: 0x%016llx", name.c_str(), (unsigned long long)(print(a)));
        }
        at++;
    }
}

void has_the_area_of_its_outline(void **)
{
    // Of the unit outline, by hand: a parabola 2/3, a quarter of an ellipse pi/4, a cubic 1/2.
    const double parabola = 2.0 / 3.0, ellipse = 0.78539816339744831, cubic = 0.5;
    const struct {
        double base, tip, lower, upper;
    } cases[] = {{0.5, 0.5, parabola, parabola},
                 {1.0, 0.5, ellipse, parabola},
                 {0.0, 0.0, cubic, ellipse},
                 {1.0, 0.0, ellipse, ellipse}};
    for (const auto &c : cases) {
        for (const double widest : {0.3, 0.5, 0.7}) {
            LeafParams p = plain(c.base, c.tip);
            p.widest = widest;
            const double exact =
                p.width * p.length * p.length * (widest * c.lower + (1.0 - widest) * c.upper);
            double off[2];
            for (int i = 0; i < 2; i++) {
                p.rows = i == 0 ? 64 : 256;
                off[i] = grown(p).flat_area / exact - 1.0;
            }
            // Chords inside the outline: too small, by a sixteenth for four times the rows.
            assert_true(off[0] < 0.0 && off[0] > -2e-3);
            assert_true(off[1] < 0.0 && off[1] > 0.16 * off[0]);
        }
    }
    // A heart's lobes come on top.
    LeafParams p = plain(1.0, 0.5);
    const double without = grown(p).flat_area;
    p.heart = 0.2;
    p.rows = 256;
    assert_true(grown(p).flat_area > 1.05 * without);
}

void is_one_sheet_with_a_closed_stalk(void **)
{
    for (const std::string &name : shapes()) {
        for (std::uint64_t seed = 1; seed <= 6; seed++) {
            const LeafParams p = shape(name, seed, 0);
            const Leaf leaf = grown(p);
            check_promises(leaf.blade);
            check_promises(leaf.stalk);
            const Report r = inspect(leaf.blade);
            assert_int_equal(r.triangles, 4 * p.columns * (p.rows - 1));
            assert_int_equal(r.vertices, r.places);
            assert_int_equal(r.euler, 1);
            assert_int_equal(r.pieces, 1);
            assert_int_equal(r.boundary_loops, 1);
            assert_int_equal(r.boundary_edges, 2 * p.rows);
            assert_int_equal(r.tangled_edges, 0);
            const Report s = inspect(leaf.stalk);
            assert_int_equal(s.euler, 2);
            assert_int_equal(s.boundary_edges, 0);
            assert_int_equal(s.tangled_edges, 0);
            assert_int_equal(leaf.stalk.albedo.size(), leaf.stalk.positions.size());
        }
    }
    LeafParams p = shape("beech");
    p.petiole = 0.0;
    assert_int_equal(grown(p).stalk.triangles(), 0);
}

void frames_follow_the_triangles(void **)
{
    for (const std::string &name : shapes()) {
        const Mesh mesh = grown(shape(name, 3, 0)).blade;
        double up = 0.0;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const std::uint32_t *c = &mesh.indices[t];
            const glm::dvec3 p = mesh.positions[c[0]];
            const glm::dvec3 a = glm::dvec3(mesh.positions[c[1]]) - p;
            const glm::dvec3 b = glm::dvec3(mesh.positions[c[2]]) - p;
            const glm::dvec3 n = glm::normalize(glm::cross(a, b));
            const glm::dvec2 u = mesh.uvs[c[0]], ua = glm::dvec2(mesh.uvs[c[1]]) - u,
                             ub = glm::dvec2(mesh.uvs[c[2]]) - u;
            const double size = ua.x * ub.y - ub.x * ua.y;
            assert_true(size > 0.0);
            const glm::dvec3 along = glm::normalize((a * ub.y - b * ua.y) / size);
            const glm::dvec3 upward = glm::normalize((b * ua.x - a * ub.x) / size);
            up += n.z;
            for (int k = 0; k < 3; k++) {
                const glm::dvec3 normal = mesh.normals[c[k]];
                const glm::dvec3 tangent = glm::dvec3(glm::vec3(mesh.tangents[c[k]]));
                assert_true(glm::dot(normal, n) > 0.5);
                assert_true(glm::dot(tangent, along) > 0.5);
                assert_true(mesh.tangents[c[k]].w == 1.0f);
                assert_true(glm::dot(glm::cross(normal, tangent), upward) > 0.5);
            }
        }
        // The upper side looks to +z.
        assert_true(up / double(mesh.triangles()) > 0.7);
    }
}

void bends_without_stretching(void **)
{
    for (const std::string &name : shapes()) {
        LeafParams p = flat(shape(name, 1, 0));
        const Leaf level = grown(p);
        for (const glm::vec3 &q : level.blade.positions) {
            assert_true(q.z == level.blade.positions[0].z);
        }
        for (const glm::vec3 &n : level.blade.normals) {
            assert_true(n == glm::vec3(0.0f, 0.0f, 1.0f));
        }
        assert_true(std::fabs(inspect(level.blade).area / level.flat_area - 1.0) < 1e-5);
        p.fold = 0.6;
        p.curl = 1.0;
        assert_true(std::fabs(inspect(grown(p).blade).area / level.flat_area - 1.0) < 0.01);
        p.fold = 0.0;
        p.bend = 1.5;
        assert_true(std::fabs(inspect(grown(p).blade).area / level.flat_area - 1.0) < 0.01);
    }
    // As long and as wide as was asked.
    LeafParams p = flat(plain(0.5, 0.5));
    p.length = 0.2;
    p.width = 0.3;
    p.petiole = 0.0;
    const Report r = inspect(grown(p).blade);
    assert_true(std::fabs(r.upper.y - r.lower.y - 0.2f) < 1e-6f);
    assert_true(std::fabs(r.upper.x - r.lower.x - 0.06f) < 1e-4f);
}

// Mean of a map over the blade's texels for which `chosen` holds.
template <class Chosen> double mean(const Maps &maps, const std::vector<float> &map, Chosen chosen)
{
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < maps.height; y++) {
        for (int x = 0; x < maps.width; x++) {
            const std::size_t i = std::size_t(y * maps.width + x);
            if (maps.inside[i] && chosen(x, y)) {
                sum += double(map[i]);
                weight += 1.0;
            }
        }
    }
    assert_true(weight > 0.0);
    return sum / weight;
}

void maps_keep_range_and_mean(void **)
{
    for (const std::string &name : shapes()) {
        for (const std::uint32_t texels : {200u, 900u}) {
            const Leaf leaf = grown(shape(name, 5, texels));
            const Maps &maps = leaf.maps;
            assert_int_equal(std::max(maps.width, maps.height), texels);
            const auto all = [](int, int) { return true; };
            assert_true(std::fabs(mean(maps, maps.pigment, all) - 1.0) < 0.01);
            assert_true(std::fabs(mean(maps, maps.thickness, all) - 1.0) < 0.01);
            std::size_t inside = 0;
            for (std::size_t i = 0; i < maps.pigment.size(); i++) {
                assert_true(maps.pigment[i] >= pigment_least && maps.pigment[i] <= pigment_most);
                assert_true(maps.thickness[i] >= thickness_least &&
                            maps.thickness[i] <= thickness_most);
                assert_true(std::fabs(maps.relief[i]) < 0.02f * 0.11f);
                inside += maps.inside[i];
            }
            // The painted blade is the mesh's.
            const double area = double(inside) * maps.metres * maps.metres;
            assert_true(std::fabs(area / leaf.flat_area - 1.0) < 0.02);
            const double box = maps.width * maps.metres * maps.height * maps.metres;
            assert_true(std::fabs(inspect(leaf.blade).uv_area * box / leaf.flat_area - 1.0) < 0.02);
            for (const glm::vec2 &uv : leaf.blade.uvs) {
                assert_true(uv.x > 0.0f && uv.x < 1.0f && uv.y > 0.0f && uv.y < 1.0f);
            }
        }
    }
}

void veins_are_thick_pale_furrows(void **)
{
    LeafParams p = shape("beech", 1, 1200);
    p.roughness = 0.0;
    p.blotches = 0.0;
    const Maps maps = grown(p).maps;
    // Without roughness the midrib runs up the middle column.
    const int middle = maps.width / 2, low = maps.height / 8, high = maps.height / 2;
    const auto rib = [&](int x, int y) { return x == middle && y > low && y < high; };
    const auto blade = [&](int x, int y) {
        return std::abs(x - middle) > maps.width / 20 && y > low && y < high;
    };
    assert_true(mean(maps, maps.thickness, rib) > 1.7);
    assert_true(mean(maps, maps.pigment, rib) < 0.5);
    assert_true(mean(maps, maps.relief, rib) < mean(maps, maps.relief, blade) - 2e-4);
    // Up one half away from the midrib: nine secondaries, each a furrow.
    const int column = middle + maps.width / 5;
    const std::vector<float> slope = slopes(maps);
    int furrows = 0;
    double height = 0.0;
    for (int y = 1; y + 1 < maps.height; y++) {
        const auto at = [&](int row) { return std::size_t(row * maps.width + column); };
        const bool inside = maps.inside[at(y - 1)] && maps.inside[at(y)];
        furrows += inside && maps.thickness[at(y)] > 1.1f && maps.thickness[at(y - 1)] <= 1.1f;
        height += double(slope[2 * at(y) + 1]) * maps.metres;
    }
    assert_in_range(furrows, 7, 10);
    // The slopes add up to the relief: central differences telescope to the ends' means.
    const auto relief = [&](int row) {
        return double(maps.relief[std::size_t(row * maps.width + column)]);
    };
    const int last = maps.height - 1;
    const double rise = 0.5 * (relief(last) + relief(last - 1) - relief(0) - relief(1));
    assert_true(std::fabs(height - rise) < 1e-7);
}

void pigment_follows_its_parameters(void **)
{
    LeafParams p = shape("ficus", 1, 600);
    p.roughness = 0.0;
    p.blotches = 0.0;
    p.halo = 0.0;
    p.edge = 0.0;
    const auto rim = [](const Maps &maps) {
        // The outermost tenth of the middle rows, against the part between it and the midrib.
        const auto half = [&](int x) { return std::fabs(2.0 * (x + 0.5) / maps.width - 1.0); };
        const auto rows = [&](int y) { return std::abs(y - maps.height / 2) < maps.height / 50; };
        return mean(maps, maps.pigment, [&](int x, int y) { return rows(y) && half(x) > 0.85; }) /
               mean(maps, maps.pigment,
                    [&](int x, int y) { return rows(y) && half(x) > 0.2 && half(x) < 0.6; });
    };
    const double even = rim(grown(p).maps);
    p.edge = 0.8;
    assert_true(rim(grown(p).maps) > 1.3 * even);
    p.edge = -0.5;
    assert_true(rim(grown(p).maps) < 0.8 * even);

    const auto deviation = [](const Maps &maps) {
        const auto all = [](int, int) { return true; };
        std::vector<float> squares;
        for (const float v : maps.pigment) {
            squares.push_back((v - 1.0f) * (v - 1.0f));
        }
        return std::sqrt(mean(maps, squares, all));
    };
    p.edge = 0.0;
    const double veins_only = deviation(grown(p).maps);
    p.blotches = 0.8;
    assert_true(deviation(grown(p).maps) > 2.0 * veins_only);
}

void refuses_bad_parameters(void **)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refuse = [](const LeafParams &p, const std::vector<std::string> &words) {
        const auto leaf = generate(p);
        assert_false(bool(leaf));
        expect_error(leaf.error(), words);
    };
    LeafParams p;
    p.length = nan;
    refuse(p, {"length", "nan", "[0.005, 1]"});
    p = {};
    p.width = 2.0;
    refuse(p, {"width", "2", "[0.05, 1.5]"});
    p = {};
    p.fold = -1.3;
    refuse(p, {"fold", "[-1.2, 1.2]"});
    p = {};
    p.texels = 10;
    refuse(p, {"texels", "[64, 8192]"});
    p = {};
    p.lobes = 9;
    refuse(p, {"lobes", "[0, 8]"});
    p = {};
    p.teeth = 40;
    refuse(p, {"rows", "[200, 512]"});
    p = *preset("linden");
    p.heart = 0.25;
    p.base = 0.0;
    refuse(p, {"folds over itself"});
    expect_error(preset("fern").error(), {"fern", "beech", "oak"});
}

// Whatever is in range either grows a sound leaf or is refused with a sentence.
void random_parameters_are_sound(void **)
{
    std::uint32_t state = 12345u;
    const auto unit = [&] {
        state = state * 1664525u + 1013904223u;
        return double(state >> 8) / 16777216.0;
    };
    int good = 0;
    for (int i = 0; i < 150; i++) {
        LeafParams p;
        p.seed = state;
        p.length = 0.005 + 0.5 * unit();
        p.width = 0.05 + 1.45 * unit();
        p.widest = 0.2 + 0.6 * unit();
        p.tip = unit();
        p.base = unit();
        p.heart = i % 3 ? 0.0 : 0.25 * unit();
        p.lobes = i % 4 ? 0 : std::uint32_t(8.9 * unit());
        p.lobe_depth = 0.45 * unit();
        p.teeth = i % 5 ? 0 : std::uint32_t(30.0 * unit());
        p.tooth_depth = 0.2 * unit();
        p.roughness = unit();
        p.petiole = 1.5 * unit();
        p.veins = 2 + std::uint32_t(28.9 * unit());
        p.sweep = unit();
        p.curve = unit();
        p.loops = unit();
        p.fold = 2.4 * unit() - 1.2;
        p.curl = 3.0 * unit();
        p.bend = 6.0 * unit() - 3.0;
        p.twist = 4.0 * unit() - 2.0;
        p.wave = 0.5 * unit();
        p.blotches = unit();
        p.edge = 1.6 * unit() - 0.6;
        p.halo = 0.9 * unit();
        p.relief = 3.0 * unit();
        p.rows = 150;
        p.texels = i % 3 ? 0 : 64 + std::uint32_t(60.0 * unit());
        const auto leaf = generate(p);
        if (!leaf) {
            expect_error(leaf.error(), {"folds over itself"});
            continue;
        }
        good++;
        check_promises(leaf->blade);
        assert_int_equal(inspect(leaf->blade).euler, 1);
        for (const std::vector<float> *map :
             {&leaf->maps.pigment, &leaf->maps.thickness, &leaf->maps.relief}) {
            for (const float v : *map) {
                assert_true(std::isfinite(v));
            }
        }
    }
    assert_in_range(good, 110, 150);
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(same_seed_same_bytes),
        cmocka_unit_test(has_the_area_of_its_outline),
        cmocka_unit_test(is_one_sheet_with_a_closed_stalk),
        cmocka_unit_test(frames_follow_the_triangles),
        cmocka_unit_test(bends_without_stretching),
        cmocka_unit_test(maps_keep_range_and_mean),
        cmocka_unit_test(veins_are_thick_pale_furrows),
        cmocka_unit_test(pigment_follows_its_parameters),
        cmocka_unit_test(refuses_bad_parameters),
        cmocka_unit_test(random_parameters_are_sound),
    };
    return cmocka_run_group_tests_name("leaf_generate", tests, nullptr, nullptr);
}

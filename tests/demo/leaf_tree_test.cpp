// The tree generator against its promises: bytes, counts, wood, where leaves are and face, errors.
#include "leaf_checks.h"

#include "leaf/tree.h"

#include <glm/mat3x3.hpp>

#include <algorithm>

using namespace leaf_checks;

namespace {

TreeParams params(std::uint64_t seed = 1, std::uint32_t leaves = 3600)
{
    TreeParams p = *tree_preset("beech");
    p.seed = p.leaf.seed = seed;
    p.leaves = leaves;
    p.leaf.texels = 128;
    return p;
}

Plant grown(const TreeParams &p)
{
    auto plant = grow(p);
    if (!plant) {
        fail_msg("%s", plant.error().c_str());
    }
    return std::move(*plant);
}

glm::dvec3 place(const Placed &leaf)
{
    return glm::dvec3(leaf.place[3]);
}

// From p to the bone that ends at `node`.
double distance_to(const Plant &plant, std::uint32_t node, const glm::dvec3 &p)
{
    const glm::dvec3 b = plant.nodes[node].place;
    const glm::dvec3 a = plant.nodes[plant.nodes[node].parent].place;
    const double t = glm::dot(p - a, b - a) / std::max(glm::dot(b - a, b - a), 1e-30);
    return glm::distance(p, a + std::clamp(t, 0.0, 1.0) * (b - a));
}

void same_seed_same_bytes(void **)
{
    // Made once with GCC and Clang, with and without fused multiply-add.
    constexpr std::uint64_t known = 0xadcadb7ed5f847a6u;
    const auto print = [](const Plant &plant) {
        std::vector<float> places;
        for (const Placed &leaf : plant.leaves) {
            for (int i = 0; i < 16; i++) {
                places.push_back(leaf.place[i / 4][i % 4]);
            }
            places.insert(places.end(),
                          {float(leaf.kind), float(leaf.node), leaf.pigment, leaf.thickness});
        }
        Fingerprint all;
        all.add(plant.wood).add(places).add(plant.maps.pigment);
        for (const Kind &kind : plant.kinds) {
            all.add(kind.blade).add(kind.stalk);
        }
        return all.value();
    };
    const std::uint64_t one = print(grown(params()));
    assert_true(one == print(grown(params())));
    assert_false(one == print(grown(params(2))));
    if (one != known) {
        fail_msg("0x%016llx", (unsigned long long)(one));
    }
}

void has_the_leaves_that_were_asked(void **)
{
    for (const std::uint32_t count : {200u, 2000u, 3600u, 5000u, 20000u}) {
        const Plant plant = grown(params(3, count));
        assert_int_equal(plant.leaves.size(), count);
        std::vector<std::size_t> of(plant.kinds.size(), 0);
        for (const Placed &leaf : plant.leaves) {
            assert_true(leaf.kind < plant.kinds.size() && leaf.node < plant.nodes.size());
            of[leaf.kind]++;
            // A rotation and one scale.
            const glm::dmat3 m = glm::dmat3(leaf.place);
            const double scale = glm::length(m[0]);
            assert_true(scale > 0.3 && scale < 2.0);
            assert_true(std::fabs(glm::determinant(m) / (scale * scale * scale) - 1.0) < 1e-5);
            assert_true(std::fabs(glm::dot(m[0], m[1])) < 1e-5);
            assert_true(std::fabs(glm::length(m[1]) - scale) < 1e-5);
            assert_true(leaf.pigment > 0.2f && leaf.pigment < 2.0f);
            assert_true(leaf.thickness > 0.5f && leaf.thickness < 1.5f);
        }
        // Kinds share evenly.
        for (const std::size_t n : of) {
            assert_in_range(n * 4, count * 7 / 10, count * 13 / 10);
        }
    }
}

void leaves_grow_on_twigs(void **)
{
    for (std::uint64_t seed = 1; seed <= 5; seed++) {
        const Plant plant = grown(params(seed));
        const float trunk = plant.nodes[0].radius;
        std::vector<double> at;
        for (const Placed &leaf : plant.leaves) {
            const Node &node = plant.nodes[leaf.node];
            const double thick = std::max(node.radius, plant.nodes[node.parent].radius);
            // Begins inside the twig, on thin wood alone.
            assert_true(distance_to(plant, leaf.node, place(leaf)) <= thick);
            assert_true(node.radius < 0.25f * trunk);
            at.push_back(place(leaf).y);
        }
        // The blade is where its place is, a stalk's length off.
        const Placed &leaf = plant.leaves[100];
        const Kind &kind = plant.kinds[leaf.kind];
        double nearest = 1e9;
        for (const glm::vec3 &p : kind.stalk.positions) {
            nearest = std::min(nearest, distance_to(plant, leaf.node,
                                                    glm::dvec3(leaf.place * glm::vec4(p, 1.0f))));
        }
        assert_true(nearest < 0.003);
        // All through the crown.
        std::sort(at.begin(), at.end());
        assert_true(at.front() < 0.45 * 2.3 && at.back() > 0.9 * 2.3);
    }
}

void skeleton_is_a_tree(void **)
{
    for (std::uint64_t seed = 1; seed <= 5; seed++) {
        const TreeParams p = params(seed, 200);
        const Plant plant = grown(p);
        std::vector<double> squares(plant.nodes.size(), 0.0);
        std::size_t tips = 0;
        for (std::uint32_t i = 1; i < plant.nodes.size(); i++) {
            assert_true(plant.nodes[i].parent < i);
            const double r = double(plant.nodes[i].radius);
            squares[plant.nodes[i].parent] += r * r;
            const double span =
                glm::distance(plant.nodes[i].place, plant.nodes[plant.nodes[i].parent].place);
            assert_true(span > 1e-4 && span < 0.03 * p.height);
        }
        // Da Vinci's rule.
        for (std::size_t i = 0; i < squares.size(); i++) {
            const double r = double(plant.nodes[i].radius);
            if (squares[i] > 0.0) {
                assert_true(std::fabs(r * r / squares[i] - 1.0) < 1e-5);
            } else {
                tips++;
            }
        }
        assert_in_range(tips, 200, 1100);
        const double trunk = double(plant.nodes[0].radius), tip = 0.0005 * p.height;
        assert_true(std::fabs(trunk * trunk / (tip * tip) / double(tips) - 1.0) < 1e-4);
        // As high and as wide as was asked.
        glm::vec3 lower(1e9f), upper(-1e9f);
        for (const Node &node : plant.nodes) {
            lower = glm::min(lower, node.place);
            upper = glm::max(upper, node.place);
        }
        assert_true(lower.y == 0.0f);
        assert_true(upper.y > 0.9 * p.height && upper.y < 1.05 * p.height);
        const double width = double(upper.x - lower.x);
        assert_true(width > 0.75 * p.crown_width * p.height);
        assert_true(width < 1.25 * p.crown_width * p.height);
    }
}

void wood_is_closed(void **)
{
    for (std::uint64_t seed = 1; seed <= 4; seed++) {
        const Plant plant = grown(params(seed, 200));
        check_promises(plant.wood);
        const Report r = inspect(plant.wood);
        assert_int_equal(r.boundary_edges, 0);
        assert_int_equal(r.tangled_edges, 0);
        assert_int_equal(r.euler, 2 * long(r.pieces));
        assert_int_equal(plant.wood.albedo.size(), plant.wood.positions.size());
        // Outside is outside: the volume under the triangles is positive and that of the bones.
        double volume = 0.0, bones = 0.0;
        for (std::size_t t = 0; t < plant.wood.indices.size(); t += 3) {
            const std::uint32_t *c = &plant.wood.indices[t];
            volume += glm::dot(glm::dvec3(plant.wood.positions[c[0]]),
                               glm::cross(glm::dvec3(plant.wood.positions[c[1]]),
                                          glm::dvec3(plant.wood.positions[c[2]]))) /
                      6.0;
        }
        for (std::size_t i = 1; i < plant.nodes.size(); i++) {
            const Node &node = plant.nodes[i];
            bones += 3.14159265 * double(node.radius) * double(node.radius) *
                     double(glm::distance(node.place, plant.nodes[node.parent].place));
        }
        // Tubes of few corners hold less than round ones; branches begin inside others.
        assert_true(volume > 0.75 * bones && volume < 1.4 * bones);
    }
}

void blades_turn_to_the_light(void **)
{
    const auto lift = [](double phototropism) {
        TreeParams p = params(2);
        p.phototropism = phototropism;
        double sum = 0.0;
        const Plant plant = grown(p);
        for (const Placed &leaf : plant.leaves) {
            sum += double(leaf.place[2].y / glm::length(glm::vec3(leaf.place[2])));
        }
        return sum / double(plant.leaves.size());
    };
    const double strong = lift(1.0), weak = lift(0.0);
    assert_true(strong > 0.65);
    assert_true(weak < strong - 0.1);
    const auto fall = [](double droop) {
        TreeParams p = params(2);
        p.droop = droop;
        double sum = 0.0;
        const Plant plant = grown(p);
        for (const Placed &leaf : plant.leaves) {
            sum += double(leaf.place[1].y / glm::length(glm::vec3(leaf.place[1])));
        }
        return sum / double(plant.leaves.size());
    };
    assert_true(fall(1.0) < fall(0.0) - 0.4);
}

void leaves_differ(void **)
{
    for (const double variation : {0.0, 0.1, 0.3}) {
        TreeParams p = params(4);
        p.variation = variation;
        double sum = 0.0, squares = 0.0;
        const Plant plant = grown(p);
        for (const Placed &leaf : plant.leaves) {
            sum += double(leaf.pigment);
            squares += double(leaf.pigment) * double(leaf.pigment);
        }
        const double n = double(plant.leaves.size()), mean = sum / n;
        const double deviation = std::sqrt(squares / n - mean * mean);
        assert_true(mean > 0.93 && mean < 1.01);
        assert_true(deviation > 0.85 * variation && deviation < 1.1 * variation + 0.04);
    }
}

void single_leaves_are_plants(void **)
{
    LeafParams p;
    p.texels = 64;
    const Plant plant = single(*generate(p));
    assert_int_equal(plant.leaves.size(), 1);
    assert_true(plant.leaves[0].place == glm::mat4(1.0f));
    assert_true(plant.nodes.empty() && !plant.maps.empty());
    assert_true(plant.half == glm::vec3(0.0f));
}

void refuses_bad_parameters(void **)
{
    const auto refuse = [](const TreeParams &p, const std::vector<std::string> &words) {
        const auto plant = grow(p);
        assert_false(bool(plant));
        expect_error(plant.error(), words);
    };
    TreeParams p = params(1, 199);
    refuse(p, {"leaves", "199", "[200, 20000]"});
    p = params();
    p.height = std::numeric_limits<double>::quiet_NaN();
    refuse(p, {"height", "nan", "[0.5, 30]"});
    p = params();
    p.droop = 1.5;
    refuse(p, {"droop", "[0, 1]"});
    p = params();
    p.leaf.width = 9.0;
    refuse(p, {"leaf", "width", "[0.05, 1.5]"});
    expect_error(tree_preset("palm").error(), {"palm", "beech"});
}

// The extremes of every range grow.
void extremes_grow(void **)
{
    for (const std::string &shape : shapes()) {
        TreeParams p = *tree_preset(shape);
        p.leaves = 300;
        p.twigs = 40;
        p.height = 30.0;
        p.crown_width = 2.0;
        p.crown_base = 0.8;
        p.leaf.texels = 0;
        assert_int_equal(grown(p).leaves.size(), 300);
        p.twigs = 4000;
        p.height = 0.5;
        p.crown_width = 0.2;
        p.crown_base = 0.0;
        const Plant plant = grown(p);
        check_promises(plant.wood);
        check_promises(plant.kinds[1].blade);
        assert_int_equal(plant.leaves.size(), 300);
    }
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(same_seed_same_bytes),   cmocka_unit_test(has_the_leaves_that_were_asked),
        cmocka_unit_test(leaves_grow_on_twigs),   cmocka_unit_test(skeleton_is_a_tree),
        cmocka_unit_test(wood_is_closed),         cmocka_unit_test(blades_turn_to_the_light),
        cmocka_unit_test(leaves_differ),          cmocka_unit_test(single_leaves_are_plants),
        cmocka_unit_test(refuses_bad_parameters), cmocka_unit_test(extremes_grow),
    };
    return cmocka_run_group_tests_name("leaf_tree", tests, nullptr, nullptr);
}

// Slabs of thin parallel fibres in Embree against a random walk that knows no geometry.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "reference/slab_truth.h"
#include "reference/tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

extern "C" {
#include <cmocka.h>
}

namespace {

using namespace tsuya::reference;

constexpr double degree = 0.01745329251994329577;

// Free paths are the unit of length. The random walk has fibres without breadth; with this radius
// what is left of it, ways that go back where they have just come through, is a thousandth.
constexpr double radius = 1e-3;
// Of a fibre. A path is put back to its middle at every meeting, since the slab is the same all
// along.
constexpr double half_length = 40.0;
constexpr double half_depth = 16.0; // as deep as a half space has to be

// Ways side by side within a radius meet the same fibres, so a slab has to be broad.
double half_breadth(double depth)
{
    return std::max(480.0 / depth, 60.0);
}

// Light enters this far from the sides.
double margin(double depth)
{
    return depth > 8.0 ? 32.0 : 20.0;
}

bool is_long()
{
    const char *text = std::getenv("TSUYA_LONG");
    return text && *text == '1';
}

std::shared_ptr<const Geometry> slab(double depth, std::uint64_t seed)
{
    Strands strands;
    Random random(seed, 0, 0);
    const std::size_t count = std::size_t(half_breadth(depth) * depth / radius);
    strands.first.push_back(0);
    for (std::size_t i = 0; i < count; i++) {
        const double y = half_breadth(depth) * (2.0 * random.unit() - 1.0);
        const double z = -depth * random.unit();
        strands.points.push_back(glm::vec3(-half_length, y, z));
        strands.points.push_back(glm::vec3(half_length, y, z));
        strands.radius.insert(strands.radius.end(), 2, float(radius));
        strands.tangent.insert(strands.tangent.end(), 2, glm::vec3(1.0f, 0.0f, 0.0f));
        strands.first.push_back(std::uint32_t(strands.points.size()));
        strands.chance.push_back(0.0);
    }
    return std::make_shared<Geometry>(std::move(strands), Surface());
}

struct Tally {
    double sum = 0.0, squares = 0.0, count = 0.0;

    void add(double x)
    {
        sum += x;
        squares += x * x;
        count += 1.0;
    }
    void add(const Tally &other)
    {
        sum += other.sum;
        squares += other.squares;
        count += other.count;
    }
    double mean() const
    {
        return sum / count;
    }
    double error() const
    {
        return std::sqrt(std::max(squares / count - mean() * mean(), 0.0) / count);
    }
};

struct Measured {
    Tally back, through;
};

// Paths from the surface at inclination theta, added to `total`. They are traced like paths from
// the eye, which is the way light would take backwards.
void walk(const World &world, double depth, double theta, std::uint64_t seed, Measured &total)
{
    const Tracer tracer(world);
    constexpr int parts = 32, paths = 20000;
    const double half_window = half_breadth(depth) - margin(depth);
    std::vector<Measured> of(parts);
    std::atomic<int> next{0};
    const auto part = [&] {
        for (int k = next++; k < parts; k = next++) {
            for (int i = k; i < paths; i += parts) {
                Random random(seed, 1, std::uint64_t(i));
                Path path;
                path.start.position = {0.0, half_window * (2.0 * random.unit() - 1.0), 0.01};
                path.direction = {-std::sin(theta), 0.0, -std::cos(theta)};
                Fate fate = Fate::scattered;
                while (fate == Fate::scattered) {
                    fate = tracer.advance(path, random, nullptr, nullptr);
                    path.start.position.x = 0.0;
                }
                const double left = fate == Fate::escaped ? path.throughput.x : 0.0;
                of[std::size_t(k)].back.add(path.direction.z > 0.0 ? left : 0.0);
                of[std::size_t(k)].through.add(path.direction.z > 0.0 ? 0.0 : left);
            }
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); i++) {
        threads.emplace_back(part);
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    for (const Measured &one : of) {
        total.back.add(one.back);
        total.through.add(one.through);
    }
}

struct Row {
    SlabTruth truth;
    bool half_space;
    Measured measured;

    double depth() const
    {
        return half_space ? half_depth : truth.tau;
    }
};

constexpr Longitudinal kinds[] = {Longitudinal::gaussian, Longitudinal::deon};

// Every row for both kinds of fibre, in slabs of as many random arrangements as there are rounds.
std::map<Longitudinal, std::vector<Row>> walk_all()
{
    const int rounds = is_long() ? 20 : 1;
    std::map<std::pair<Longitudinal, double>, std::shared_ptr<const Fiber>> fibers;
    std::map<Longitudinal, std::vector<Row>> all;
    for (Longitudinal kind : kinds) {
        for (const SlabTruth &truth : slab_truth) {
            all[kind].push_back({truth, false, {}});
        }
        for (const SlabTruth &truth : half_space_truth) {
            all[kind].push_back({truth, true, {}});
        }
        for (double sigma_a : {0.02, 0.3}) {
            FiberParams params;
            params.longitudinal = kind;
            params.sigma_a = glm::dvec3(sigma_a);
            fibers[{kind, sigma_a}] = std::make_shared<Fiber>(params);
        }
    }
    std::uint64_t seed = 1;
    for (double depth : {1.0, 2.0, 4.0, 8.0, half_depth}) {
        for (int round = 0; round < rounds; round++) {
            World world;
            world.geometry = slab(depth, seed++);
            for (auto &[kind, rows] : all) {
                for (Row &row : rows) {
                    if (row.depth() == depth) {
                        world.fiber = fibers.at({kind, row.truth.sigma_a});
                        walk(world, depth, row.truth.theta * degree, seed++, row.measured);
                    }
                }
            }
        }
    }
    return all;
}

struct Scores {
    double squares = 0.0, most = 0.0;
    int count = 0;

    // `model` is how far the fibre may be from the truth's.
    void add(const Row &row, const char *what, const Tally &tally, double truth, double truth_error,
             double model)
    {
        const double off = tally.mean() - truth;
        const double z = off / std::hypot(tally.error(), truth_error);
        const double beyond = std::max(std::abs(off) - model, 0.0) * std::abs(z / off);
        std::printf("sigma_a %4g theta %3g tau %2g %-7s %.5f +- %.5f, truth %.5f: z %+.2f\n",
                    row.truth.sigma_a, row.truth.theta, row.truth.tau, what, tally.mean(),
                    tally.error(), truth, z);
        squares += beyond * beyond;
        most = std::max(most, beyond);
        count++;
    }
    double rms() const
    {
        return std::sqrt(squares / count);
    }
};

Scores compare(Longitudinal kind, double model)
{
    static const std::map<Longitudinal, std::vector<Row>> all = walk_all();
    Scores scores;
    for (const Row &row : all.at(kind)) {
        const SlabTruth &t = row.truth;
        scores.add(row, "back", row.measured.back, t.back, t.back_error, model);
        if (!row.half_space) {
            scores.add(row, "through", row.measured.through, t.through, t.through_error, model);
        }
    }
    std::printf("%d figures: rms z %.2f, max |z| %.2f\n", scores.count, scores.rms(), scores.most);
    return scores;
}

void agrees_with_the_random_walk(void **)
{
    const Scores scores = compare(Longitudinal::gaussian, 0.0);
    assert_true(scores.rms() <= 1.3);
    assert_true(scores.most <= 4.5);
}

// The shipped lobe is another one of the same shift, width and energy: its figures differ by at
// most 0.003 of the light that comes in, 0.0021 as far as 800000 paths a row tell.
void shipped_lobe_is_near(void **)
{
    assert_true(compare(Longitudinal::deon, 0.003).most <= 4.5);
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_the_random_walk),
        cmocka_unit_test(shipped_lobe_is_near),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}

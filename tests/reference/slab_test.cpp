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
// Of a fibre. A path is put back to its middle at every meeting, since the slab is the same all along.
constexpr double half_length = 40.0;
constexpr double half_space = 16.0; // as deep as a half space has to be

// Light that enters within two radii meets the same fibre first, so a thin slab has to be broad.
double half_breadth(double depth)
{
    return depth > 8.0 ? 56.0 : 40.0 * 8.0 / depth;
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
    double sum = 0.0, squares = 0.0;

    void add(double x)
    {
        sum += x;
        squares += x * x;
    }
    double mean(double n) const
    {
        return sum / n;
    }
    double error(double n) const
    {
        return std::sqrt(std::max(squares / n - mean(n) * mean(n), 0.0) / n);
    }
};

struct Measured {
    Tally back, through;
};

// Paths from the surface at inclination theta. They are traced like paths from the eye, which is the
// way light would take backwards.
Measured walk(const World &world, double depth, double theta, int paths, std::uint64_t seed)
{
    const Tracer tracer(world);
    constexpr int parts = 32;
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
    Measured total;
    for (std::thread &thread : threads) {
        thread.join();
    }
    for (const Measured &one : of) {
        total.back.sum += one.back.sum;
        total.back.squares += one.back.squares;
        total.through.sum += one.through.sum;
        total.through.squares += one.through.squares;
    }
    return total;
}

class Slabs
{
  public:
    explicit Slabs(Longitudinal kind) : kind_(kind)
    {
    }

    World world(double sigma_a, double depth)
    {
        std::shared_ptr<const Fiber> &fiber = fibers_[sigma_a];
        if (!fiber) {
            FiberParams params;
            params.longitudinal = kind_;
            params.sigma_a = glm::dvec3(sigma_a);
            fiber = std::make_shared<Fiber>(params);
        }
        std::shared_ptr<const Geometry> &geometry = slabs_[depth];
        if (!geometry) {
            geometry = slab(depth, std::uint64_t(depth));
        }
        World world;
        world.fiber = fiber;
        world.geometry = geometry;
        return world;
    }

  private:
    Longitudinal kind_;
    std::map<double, std::shared_ptr<const Fiber>> fibers_;
    std::map<double, std::shared_ptr<const Geometry>> slabs_;
};

struct Scores {
    double squares = 0.0, most = 0.0, difference = 0.0;
    int count = 0;

    void add(const SlabTruth &row, const char *what, const Tally &tally, int paths, double truth,
             double truth_error)
    {
        const double mean = tally.mean(paths), off = mean - truth;
        const double z = off / std::hypot(tally.error(paths), truth_error);
        std::printf("sigma_a %4g theta %3g tau %2g %-7s %.5f +- %.5f, truth %.5f: z %+.2f\n",
                    row.sigma_a, row.theta, row.tau, what, mean, tally.error(paths), truth, z);
        squares += z * z;
        most = std::max(most, std::abs(z));
        difference = std::max(difference, std::abs(off));
        count++;
    }
    double rms() const
    {
        return std::sqrt(squares / count);
    }
};

Scores compare(Longitudinal kind, int paths)
{
    Slabs slabs(kind);
    Scores scores;
    std::uint64_t seed = 1;
    for (const SlabTruth &row : slab_truth) {
        const Measured m = walk(slabs.world(row.sigma_a, row.tau), row.tau,
                                row.theta * degree, paths, seed++);
        scores.add(row, "back", m.back, paths, row.back, row.back_error);
        scores.add(row, "through", m.through, paths, row.through, row.through_error);
    }
    for (const SlabTruth &row : half_space_truth) {
        const Measured m = walk(slabs.world(row.sigma_a, half_space), half_space,
                                row.theta * degree, paths, seed++);
        scores.add(row, "back", m.back, paths, row.back, row.back_error);
    }
    std::printf("%d figures: rms z %.2f, max |z| %.2f, max difference %.5f\n", scores.count,
                scores.rms(), scores.most, scores.difference);
    return scores;
}

void agrees_with_the_random_walk(void **)
{
    const Scores scores = compare(Longitudinal::gaussian, is_long() ? 800000 : 40000);
    assert_true(scores.rms() <= 1.3);
    assert_true(scores.most <= 4.5);
}

// The shipped lobe is another one, of the same shift, width and energy.
void shipped_lobe_is_near(void **)
{
    const Scores scores = compare(Longitudinal::deon, is_long() ? 800000 : 40000);
    assert_true(scores.difference <= 0.003);
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

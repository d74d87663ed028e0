// The traced fibre against the runtime's double-precision reference.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "reference/fiber.h"

#include <tsuya/tsuya.h>
#include <tsuya/models/marschner.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

extern "C" {
#include <cmocka.h>
}

namespace {

using namespace tsuya::reference;

constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180.0;

// Unit vector at an inclination and an azimuth about the tangent (0, 0, 1).
glm::dvec3 toward(double theta, double phi)
{
    return {std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), std::sin(theta)};
}

const glm::dvec3 tangent(0.0, 0.0, 1.0);

class Model
{
  public:
    Model()
    {
        tsu_context_desc desc;
        tsu_context_desc_init(&desc);
        tsu_context_create(&desc, &context_);
        tsu_function_info info;
        tsu_info_init_sized(&info, sizeof info);
        while (tsu_model_function(tsu_marschner(), index_, &info) == TSU_OK &&
               std::strcmp(info.name, "hair")) {
            index_++;
        }
    }
    ~Model()
    {
        tsu_context_destroy(context_);
    }
    Model(const Model &) = delete;
    Model &operator=(const Model &) = delete;

    double value(const FiberParams &p, double theta_i, double theta_r, double phi,
                 double sigma_a) const
    {
        const double in[9] = {theta_i,   theta_r,  phi,       p.eta,         sigma_a,
                              p.alpha_R, p.beta_R, p.beta_az, p.scale_shifts};
        double out[5] = {};
        assert_int_equal(tsu_function_reference(context_, tsu_marschner(), index_, in, out),
                         TSU_OK);
        return out[4];
    }

  private:
    tsu_context *context_ = nullptr;
    std::uint32_t index_ = 0;
};

// Value in each channel against the model at the strand's own absorption, as a share of the peak
// over phi between the same inclinations.
void value_is_the_models(void **)
{
    const Model model;
    Random random(1, 0, 0);
    double worst = 0.0;
    for (int material = 0; material < 8; material++) {
        FiberParams p;
        p.eta = 1.3 + 0.5 * random.unit();
        p.beta_az = (material == 0 ? 5.0 : 5.0 + 15.0 * random.unit()) * degree;
        p.alpha_R = -10.0 * random.unit() * degree;
        p.beta_R = (3.0 + 12.0 * random.unit()) * degree;
        p.scale_shifts = material % 2 ? random.unit() : 0.0;
        p.sigma_a = {0.0, 2.0 * random.unit(), 0.3 * random.unit()};
        p.variation = material % 3 ? random.unit() : 0.0;
        const Fiber fiber(p);
        for (int i = 0; i < 40; i++) {
            const double theta_r = (178.0 * random.unit() - 89.0) * degree;
            const double theta_i = std::clamp(-theta_r + 0.3 * random.normal(), -1.5, 1.5);
            const double phi = pi * random.unit(), u = 2.0 * random.unit() - 1.0;
            const glm::dvec3 got =
                fiber.value(tangent, toward(theta_i, 0.7), toward(theta_r, 0.7 + phi), u);
            for (int c = 0; c < 3; c++) {
                const double sigma = p.sigma_a[c] * std::exp(std::sqrt(3.0) * p.variation * u);
                double peak = 0.0;
                for (int k = 0; k <= 18; k++) {
                    peak = std::max(peak, model.value(p, theta_i, theta_r, k * pi / 18.0, sigma));
                }
                const double off = got[c] - model.value(p, theta_i, theta_r, phi, sigma);
                worst = std::max(worst, std::abs(off) / std::max(peak, 1e-12));
            }
        }
    }
    std::printf("value: %.4f %% of the peak\n", 100.0 * worst);
    assert_true(worst < 0.001);
}

struct Bins {
    static constexpr int across = 10;
    double sum[across][across] = {}, squares[across][across] = {};
};

// Weighted samples in bins of theta_i and |phi| against integrals of the value.
void compare_samples(const FiberParams &p, double theta_r, int channel)
{
    constexpr int paths = 200000, fine = 16;
    const Fiber fiber(p);
    const glm::dvec3 v = toward(theta_r, 0.0);
    constexpr double u = 0.6;
    Bins bins;
    Random random(2, 0, 0);
    for (int i = 0; i < paths; i++) {
        glm::dvec3 throughput(1.0, 0.5, 0.25);
        const double start = throughput[channel];
        const glm::dvec3 l = fiber.sample(tangent, v, u, throughput, random);
        const double theta = std::asin(std::clamp(l.z, -1.0, 1.0));
        const double phi = std::abs(std::atan2(l.y, l.x));
        const int row = std::min(int((theta / pi + 0.5) * Bins::across), Bins::across - 1);
        const int column = std::min(int(phi / pi * Bins::across), Bins::across - 1);
        const double weight = throughput[channel] / start;
        bins.sum[row][column] += weight;
        bins.squares[row][column] += weight * weight;
    }
    double chi = 0.0, most = 0.0;
    int count = 0;
    for (int row = 0; row < Bins::across; row++) {
        for (int column = 0; column < Bins::across; column++) {
            double expected = 0.0;
            for (int i = 0; i < fine * fine; i++) {
                const double theta = pi * ((row + (i / fine + 0.5) / fine) / Bins::across - 0.5);
                const double phi = pi * (column + (i % fine + 0.5) / fine) / Bins::across;
                expected +=
                    fiber.value(tangent, toward(theta, phi), v, u)[channel] * std::cos(theta);
            }
            expected *= 2.0 * (pi / Bins::across) * (pi / Bins::across) / (fine * fine);
            if (expected * paths < 50.0) {
                continue; // too few for a normal law
            }
            const double mean = bins.sum[row][column] / paths;
            const double error =
                std::sqrt((bins.squares[row][column] / paths - mean * mean) / paths);
            // Midpoints and the table err by a few parts in a thousand.
            const double z = (mean - expected) / std::hypot(error, 0.003 * expected);
            chi += z * z;
            most = std::max(most, std::abs(z));
            count++;
        }
    }
    std::printf("samples: theta_r %3.0f, %d bins, rms z %.2f, max |z| %.2f\n", theta_r / degree,
                count, std::sqrt(chi / count), most);
    assert_true(count >= 8);
    assert_true(std::sqrt(chi / count) < 1.4);
    assert_true(most < 4.5);
}

void samples_follow_the_value(void **)
{
    for (Longitudinal kind : {Longitudinal::deon, Longitudinal::gaussian}) {
        FiberParams p;
        p.longitudinal = kind;
        p.sigma_a = {0.05, 0.5, 2.0};
        p.variation = 0.2;
        compare_samples(p, 0.0, 0);
        compare_samples(p, 40.0 * degree, 1);
        compare_samples(p, -75.0 * degree, 2);
    }
}

void white_fibre_keeps_all(void **)
{
    const Fiber white{FiberParams()};
    FiberParams p;
    p.sigma_a = {0.1, 1.0, 10.0};
    const Fiber dark(p);
    Random random(3, 0, 0);
    for (int i = 0; i < 20000; i++) {
        const glm::dvec3 v = toward((2.0 * random.unit() - 1.0) * 0.5 * pi, 1.0);
        glm::dvec3 throughput(1.0);
        const glm::dvec3 l = white.sample(tangent, v, 0.0, throughput, random);
        assert_true(std::abs(throughput.x - 1.0) < 1e-12 && std::isfinite(l.x + l.y + l.z));
        throughput = {0.2, 1.0, 0.7};
        dark.sample(tangent, v, 0.0, throughput, random);
        assert_true(throughput.x + throughput.y + throughput.z <= 1.9 + 1e-12);
    }
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(value_is_the_models),
        cmocka_unit_test(samples_follow_the_value),
        cmocka_unit_test(white_fibre_keeps_all),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}

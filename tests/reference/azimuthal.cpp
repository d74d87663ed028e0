#include "reference/azimuthal.h"

extern "C" {
#include "optics/angle.h"
#include "optics/fiber.h"
#include "optics/quadrature.h"
}

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace tsuya::reference {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int rows = 257;
constexpr int inner = 5;       // A_0 .. A_3 and all of p >= 4
constexpr int nodes_most = 16; // of the interpolation in u

// Columns a deviation apart would lose half a peak; linear interpolation between those beta/16
// apart loses a part in 2000 of it.
constexpr double columns_per_beta = 16.0;

int stride(std::size_t nodes)
{
    return 1 + 9 * int(nodes);
}

struct Attenuation {
    double a[inner];
};

// Of light that meets the surface with reflectance `fresnel` and goes `segment` radii inside.
Attenuation attenuation(double fresnel, double segment, double sigma_a)
{
    const double inside = std::exp(-sigma_a * segment);
    Attenuation result;
    result.a[0] = fresnel;
    result.a[1] = (1.0 - fresnel) * (1.0 - fresnel) * inside;
    result.a[2] = result.a[1] * fresnel * inside;
    result.a[3] = result.a[2] * fresnel * inside;
    result.a[4] = result.a[3] * fresnel * inside / std::max(1.0 - fresnel * inside, 1e-300);
    return result;
}

double wrapped_gaussian(double x, double beta)
{
    const double wrapped = tsu_i_angle_wrap(x);
    double sum = 0.0;
    for (int k = -1; k <= 1; k++) {
        const double z = (wrapped + 2.0 * pi * k) / beta;
        if (z * z < 80.0) {
            sum += std::exp(-0.5 * z * z);
        }
    }
    return sum / (beta * std::sqrt(2.0 * pi));
}

// What one impact parameter does.
struct Ray {
    double fresnel, segment, gamma_i, gamma_t;
};

Ray refract(double eta, double cos_theta, double h)
{
    const double sin2_theta = 1.0 - cos_theta * cos_theta;
    const double sin_t = h * cos_theta / std::sqrt(eta * eta - sin2_theta);
    const double cos_gamma = std::sqrt(std::max(0.0, 1.0 - h * h));
    const double cos_i = cos_theta * cos_gamma;
    const double cos_t = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (eta * eta));
    const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return {0.5 * (s * s + p * p),
            2.0 * std::sqrt(1.0 - sin_t * sin_t) / std::sqrt(1.0 - sin2_theta / (eta * eta)),
            std::asin(h), std::asin(sin_t)};
}

double row_cosine(int index)
{
    return std::max(double(index) / (rows - 1), 1e-5);
}

} // namespace

Azimuthal::Azimuthal(const AzimuthalParams &params) : params_(params)
{
    columns_ = int(std::ceil(columns_per_beta * pi / params.beta_az)) + 1;
    // Chebyshev's nodes: N is an entire function of u, so few suffice.
    const int count =
        params.variation > 0.0 ? std::min(4 + int(14.0 * params.variation), nodes_most) : 1;
    for (int k = 0; k < count; k++) {
        const double angle = pi * (2 * k + 1) / (2.0 * count);
        nodes_.push_back(std::cos(angle));
        weights_.push_back((k % 2 ? -1.0 : 1.0) * std::sin(angle));
    }
    table_.resize(std::size_t(rows) * std::size_t(columns_) * std::size_t(stride(nodes_.size())));
    std::atomic<int> next{0};
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); i++) {
        threads.emplace_back([&] {
            for (int r = next++; r < rows; r = next++) {
                row(r);
            }
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
}

glm::dvec3 Azimuthal::sigma_a(double u) const
{
    return params_.sigma_a * std::exp(std::sqrt(3.0) * params_.variation * u);
}

void Azimuthal::row(int index)
{
    const std::size_t width = std::size_t(stride(nodes_.size()));
    const std::size_t count = std::size_t(columns_);
    const int panels = std::max(4, int(std::ceil(1.0 / params_.beta_az)));
    std::vector<double> sums(count * width, 0.0);
    for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
        const tsu_i_ray ray = tsu_i_fiber_ray(params_.eta, row_cosine(index), panels, i);
        std::vector<Attenuation> passed;
        for (double node : nodes_) {
            for (int c = 0; c < 3; c++) {
                passed.push_back(attenuation(ray.fresnel, ray.segment, sigma_a(node)[c]));
            }
        }
        for (std::size_t column = 0; column < count; column++) {
            const double phi = pi * double(column) / double(columns_ - 1);
            double spread[lobes];
            for (int p = 0; p < lobes; p++) {
                const double exit = tsu_i_fiber_azimuth(&ray, p);
                spread[p] = 0.5 * ray.weight *
                            (wrapped_gaussian(phi - exit, params_.beta_az) +
                             wrapped_gaussian(phi + exit, params_.beta_az));
            }
            double *out = sums.data() + column * width;
            *out++ += spread[0] * ray.fresnel;
            for (std::size_t k = 0; k < nodes_.size(); k++, out += 9) {
                for (int c = 0; c < 3; c++) {
                    const double *a = passed[3 * k + std::size_t(c)].a;
                    out[c] += spread[1] * a[1];
                    out[3 + c] += spread[2] * a[2];
                    out[6 + c] += spread[3] * a[3] + ray.weight * a[4] / (2.0 * pi);
                }
            }
        }
    }
    std::copy(sums.begin(), sums.end(),
              table_.begin() + std::ptrdiff_t(std::size_t(index) * count * width));
}

void Azimuthal::density(double cos_theta_r, double phi, double u, glm::dvec3 n[lobes]) const
{
    const double y = std::clamp(cos_theta_r, 0.0, 1.0) * (rows - 1);
    const double x = std::abs(tsu_i_angle_wrap(phi)) / pi * (columns_ - 1);
    const int j = std::min(int(y), rows - 2), i = std::min(int(x), columns_ - 2);
    const double fy = y - j, fx = x - i;
    const double corner[4] = {(1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy};

    // Barycentric form of Lagrange's polynomial through the nodes.
    double share[nodes_most], total = 0.0;
    for (std::size_t k = 0; k < nodes_.size(); k++) {
        const double away = u - nodes_[k];
        share[k] = weights_[k] / (std::abs(away) < 1e-12 ? 1e-12 : away);
        total += share[k];
    }
    for (int p = 0; p < lobes; p++) {
        n[p] = glm::dvec3(0.0);
    }
    const std::size_t width = std::size_t(stride(nodes_.size()));
    for (int q = 0; q < 4; q++) {
        const std::size_t cell =
            std::size_t(j + q / 2) * std::size_t(columns_) + std::size_t(i + q % 2);
        const float *in = table_.data() + cell * width;
        n[0] += corner[q] * double(*in++);
        for (std::size_t k = 0; k < nodes_.size(); k++) {
            const double weight = corner[q] * share[k] / total;
            for (int p = 1; p < lobes; p++, in += 3) {
                n[p] += weight * glm::dvec3(in[0], in[1], in[2]);
            }
        }
    }
}

int Azimuthal::sample(double cos_theta_r, double u, glm::dvec3 &throughput, double *phi,
                      Random &random) const
{
    const Ray ray = refract(params_.eta, std::max(cos_theta_r, 1e-5), 2.0 * random.unit() - 1.0);
    const glm::dvec3 sigma = sigma_a(u);
    glm::dvec3 goes_on[inner];
    for (int c = 0; c < 3; c++) {
        const Attenuation passed = attenuation(ray.fresnel, ray.segment, sigma[c]);
        for (int p = 0; p < inner; p++) {
            goes_on[p][c] = throughput[c] * passed.a[p];
        }
    }
    double mean[inner], total = 0.0;
    for (int p = 0; p < inner; p++) {
        mean[p] = goes_on[p].x + goes_on[p].y + goes_on[p].z;
        total += mean[p];
    }
    double chance = random.unit() * total;
    int p = 0;
    while (p < inner - 1 && (chance >= mean[p] || mean[p] <= 0.0)) {
        chance -= mean[p++];
    }
    throughput = mean[p] > 0.0 ? goes_on[p] * (total / mean[p]) : glm::dvec3(0.0);
    *phi = p < inner - 1 ? 2 * p * ray.gamma_t - 2.0 * ray.gamma_i + p * pi +
                               params_.beta_az * random.normal()
                         : 2.0 * pi * random.unit();
    return std::min(p, lobes - 1);
}

} // namespace tsuya::reference

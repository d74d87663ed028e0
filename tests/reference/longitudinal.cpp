#include "reference/longitudinal.h"

extern "C" {
#include "optics/lobe.h"
#include "optics/quadrature.h"
}

#include <algorithm>
#include <cmath>

namespace tsuya::reference {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int intervals = 2048; // of K over theta_r

// cos^2(theta_i)/cos^2(theta_d), at most 4: with both angles within a right one,
// cos(theta_i) <= 2 cos(theta_d).
double projected(double theta_i, double theta_r)
{
    const double cos_i = std::cos(theta_i), cos_d = std::cos(0.5 * (theta_r - theta_i));
    return cos_d < 1e-9 ? 0.0 : cos_i * cos_i / (cos_d * cos_d);
}

double gauss(double x, double beta)
{
    const double z = x / beta;
    return std::exp(-0.5 * z * z) / (beta * std::sqrt(2.0 * pi));
}

double integral(double theta_r, double alpha, double beta)
{
    constexpr int panels = 8;
    const double middle = std::clamp(alpha - theta_r, -0.5 * pi, 0.5 * pi);
    const double ends[3] = {std::max(middle - 9.0 * beta, -0.5 * pi), middle,
                            std::min(middle + 9.0 * beta, 0.5 * pi)};
    double sum = 0.0;
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
            double weight = 0.0;
            const double t = tsu_i_quadrature_node(ends[side], ends[side + 1], panels, i, &weight);
            sum += weight * gauss(t + theta_r - alpha, beta) * projected(t, theta_r);
        }
    }
    return sum;
}

} // namespace

LongitudinalLobe::LongitudinalLobe(Longitudinal kind, double alpha, double beta)
    : kind_(kind), alpha_(alpha), beta_(beta)
{
    if (kind == Longitudinal::gaussian) {
        for (int i = 0; i <= intervals; i++) {
            k_.push_back(integral(pi * (double(i) / intervals - 0.5), alpha, beta));
        }
    }
}

double LongitudinalLobe::normaliser(double theta_r) const
{
    const double x = std::clamp((theta_r / pi + 0.5) * intervals, 0.0, intervals - 1e-9);
    const std::size_t i = std::size_t(x);
    return k_[i] + (x - double(i)) * (k_[i + 1] - k_[i]);
}

double LongitudinalLobe::density(double theta_i, double theta_r) const
{
    if (kind_ == Longitudinal::deon) {
        return tsu_i_lobe_deon(theta_i, theta_r - alpha_, beta_);
    }
    const double cos_i = std::max(std::cos(theta_i), 1e-300);
    return gauss(theta_i + theta_r - alpha_, beta_) * projected(theta_i, theta_r) /
           (cos_i * normaliser(theta_r));
}

double LongitudinalLobe::sample(double theta_r, Random &random) const
{
    if (kind_ == Longitudinal::deon) {
        // The lobe is a von Mises-Fisher density around a direction of inclination
        // alpha - theta_r, with all azimuths taken together.
        const double v = beta_ * beta_, chance = random.unit();
        const double along = 1.0 + v * std::log(1.0 - chance * -std::expm1(-2.0 / v));
        const double side = std::sqrt(std::max(0.0, 1.0 - along * along));
        const double centre = alpha_ - theta_r;
        const double sin_i =
            along * std::sin(centre) + side * std::cos(2.0 * pi * random.unit()) * std::cos(centre);
        return std::asin(std::clamp(sin_i, -1.0, 1.0));
    }
    for (;;) {
        const double theta_i = alpha_ - theta_r + beta_ * random.normal();
        if (std::abs(theta_i) <= 0.5 * pi && 4.0 * random.unit() < projected(theta_i, theta_r)) {
            return theta_i;
        }
    }
}

} // namespace tsuya::reference

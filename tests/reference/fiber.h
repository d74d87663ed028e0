// The fibre that light is scattered by: Marschner's, in double precision.
#ifndef TSUYA_TESTS_REFERENCE_FIBER_H
#define TSUYA_TESTS_REFERENCE_FIBER_H

#include "reference/azimuthal.h"
#include "reference/longitudinal.h"

#include <glm/vec3.hpp>

#include <vector>

namespace tsuya::reference {

// Field for field tsu_marschner_params, without its ranges.
struct FiberParams {
    Longitudinal longitudinal = Longitudinal::deon;
    double eta = 1.55;
    double alpha_R = -0.1308996938995747; // radians, like the next two
    double beta_R = 0.1308996938995747;
    double beta_az = 0.17453292519943295;
    double scale_shifts = 0.0;
    glm::dvec3 sigma_a{0.0};
    double variation = 0.0; // deviation of ln(sigma_a) from strand to strand, uniform
};

// Sum over p of M_p(theta_i | theta_r) N_p(phi; theta_r): a density over light directions for a
// given view that integrates to 1 without absorption. Radiance to the viewer is the integral over
// light directions of incoming radiance times it, with no further cosine.
//
// A strand is known by its chance u in [-1, 1].
class Fiber
{
  public:
    explicit Fiber(const FiberParams &params);

    // The density, 1/sr.
    //   t, l, v  unit: tangent from root to tip, to the light, to the viewer
    glm::dvec3 value(const glm::dvec3 &t, const glm::dvec3 &l, const glm::dvec3 &v, double u) const;

    // A light direction. `throughput` is multiplied by density over chance of the direction, whose
    // mean over channels is never above 1, and is exactly 1 without absorption.
    glm::dvec3 sample(const glm::dvec3 &t, const glm::dvec3 &v, double u, glm::dvec3 &throughput,
                      Random &random) const;

  private:
    Azimuthal azimuthal_;
    std::vector<LongitudinalLobe> longitudinal_;
};

} // namespace tsuya::reference

#endif

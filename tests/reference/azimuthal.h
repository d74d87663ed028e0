// Azimuthal scattering of a smooth circular fibre, N_p(phi; theta_r): tabled for light from a given
// direction, traced through the fibre's cross-section for light from a direction to be chosen.
#ifndef TSUYA_TESTS_REFERENCE_AZIMUTHAL_H
#define TSUYA_TESTS_REFERENCE_AZIMUTHAL_H

#include "reference/random.h"

#include <glm/vec3.hpp>

#include <vector>

namespace tsuya::reference {

constexpr int lobes = 4; // R, TT, TRT, and all paths with more internal reflections

// Conventions and definitions: runtime/optics/fiber.h.
struct AzimuthalParams {
    double eta = 1.55;
    double beta_az = 0.17453292519943295; // radians
    glm::dvec3 sigma_a{0.0};              // of a strand without variation, per fibre radius
    double variation = 0.0;               // sigma_a of a strand is sigma_a exp(sqrt(3) variation u)
};

class Azimuthal
{
  public:
    explicit Azimuthal(const AzimuthalParams &params);

    // N_p, 1/rad, for every lobe and colour channel, interpolated in a table.
    //   cos_theta_r  of the view, [0, 1]
    //   phi          radians, any
    //   u            the strand's chance, [-1, 1]
    // Error: 0.1 % of the peak over phi of the sum of lobes at the same u; tests/reference holds it
    // over eta [1.3, 1.8], beta_az [5, 20] degrees, theta to 89 degrees.
    void density(double cos_theta_r, double phi, double u, glm::dvec3 n[lobes]) const;

    // One way of light through the fibre, from a random h in [-1, 1].
    //
    //   throughput  in: of the path; a lobe is chosen by the mean over channels of what goes on.
    //               out: times A_p over the chance of p. Its mean never grows.
    // Returns: the lobe; *phi is Phi_p(h) blurred by beta_az, or uniform for p >= 4.
    int sample(double cos_theta_r, double u, glm::dvec3 &throughput, double *phi,
               Random &random) const;

    glm::dvec3 sigma_a(double u) const;

  private:
    void row(int index);

    AzimuthalParams params_;
    int columns_ = 0;
    std::vector<double> nodes_, weights_; // of the interpolation in u
    // By row of cos_theta_r, then column of phi in [0, pi]: N_R, then by node of u and lobe from TT
    // the three channels.
    std::vector<float> table_;
};

} // namespace tsuya::reference

#endif

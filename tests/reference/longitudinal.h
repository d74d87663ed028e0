// Longitudinal scattering of one lobe: its density over the light's inclination, and its sampling.
#ifndef TSUYA_TESTS_REFERENCE_LONGITUDINAL_H
#define TSUYA_TESTS_REFERENCE_LONGITUDINAL_H

#include "reference/random.h"

#include <vector>

namespace tsuya::reference {

enum class Longitudinal {
    // d'Eon et al. 2011, eq. 7, at theta_r - alpha: what tsuya's shaders evaluate.
    deon,
    // g(theta_i + theta_r - alpha; beta) cos(theta_i) / (cos^2(theta_d) K(theta_r)) with the unit
    // Gaussian g, theta_d = (theta_r - theta_i)/2 of the unshifted angles, and K such that it is
    // normalised as below. Marschner et al. 2003, section 5.1, made energy-conserving; for
    // comparison with computations that use it. |alpha| at most 2 beta.
    gaussian
};

// M(theta_i | theta_r) of a lobe with shift alpha and deviation beta, radians, in theta_i +
// theta_r. Int M cos(theta_i) dtheta_i = 1 for every theta_r.
class LongitudinalLobe
{
  public:
    LongitudinalLobe(Longitudinal kind, double alpha, double beta);

    // M, 1/rad. Error: d'Eon's 1e-12 relative; the Gaussian's K 1e-6 relative.
    double density(double theta_i, double theta_r) const;

    // theta_i with the density M cos(theta_i). Exact for both kinds.
    double sample(double theta_r, Random &random) const;

  private:
    double normaliser(double theta_r) const;

    Longitudinal kind_;
    double alpha_, beta_;
    std::vector<double> k_; // of the Gaussian, over theta_r from -pi/2 to pi/2
};

} // namespace tsuya::reference

#endif

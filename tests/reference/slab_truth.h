// Slabs of random parallel fibres: figures of an independent random walk without geometry
// (exponential free paths, 300000 photons a row for slabs, 800000 for the half space), for the
// fibre whose lobes are Gaussian in theta_i + theta_r, normalised, with all lobes: eta 1.55,
// beta_az 10, alpha_R -7.5, beta_R 7.5 degrees, azimuthal scattering at the fixed inclination. tau
// is the mean number of fibres that a straight way along the surface's normal meets; light comes in
// the plane of axis and normal at inclination theta, degrees. Power that comes back and goes
// through, the unscattered part included, over the power that comes in, with standard errors.
#ifndef TSUYA_TESTS_REFERENCE_SLAB_TRUTH_H
#define TSUYA_TESTS_REFERENCE_SLAB_TRUTH_H

namespace tsuya::reference {

struct SlabTruth {
    double sigma_a, theta, tau, back, back_error, through, through_error;
};

constexpr SlabTruth slab_truth[] = {
    {0.02, 0, 1, 0.09871064, 3.96e-04, 0.85876864, 4.11e-04},
    {0.02, 0, 2, 0.18383328, 5.90e-04, 0.72369237, 6.23e-04},
    {0.02, 0, 4, 0.29305051, 7.00e-04, 0.51027806, 7.29e-04},
    {0.02, 0, 8, 0.37435658, 6.80e-04, 0.25032219, 5.82e-04},
    {0.02, 30, 1, 0.10990578, 4.12e-04, 0.84435300, 4.27e-04},
    {0.02, 30, 2, 0.20099918, 6.06e-04, 0.70099164, 6.37e-04},
    {0.02, 30, 4, 0.31446465, 7.10e-04, 0.48556649, 7.29e-04},
    {0.02, 30, 8, 0.39535700, 6.85e-04, 0.24393244, 5.76e-04},
    {0.02, 60, 1, 0.18018304, 4.84e-04, 0.76403655, 4.96e-04},
    {0.02, 60, 2, 0.29525831, 6.67e-04, 0.58919258, 6.84e-04},
    {0.02, 60, 4, 0.41086929, 7.31e-04, 0.37105432, 7.05e-04},
    {0.02, 60, 8, 0.47867008, 6.82e-04, 0.17142816, 4.96e-04},
    {0.3, 0, 1, 0.03500202, 1.71e-04, 0.60247806, 2.66e-04},
    {0.3, 0, 2, 0.04652168, 2.18e-04, 0.34739515, 3.53e-04},
    {0.3, 0, 4, 0.05164990, 2.36e-04, 0.10781477, 2.70e-04},
    {0.3, 0, 8, 0.05210357, 2.39e-04, 0.00971505, 7.36e-05},
    {0.3, 30, 1, 0.03738044, 1.72e-04, 0.58585041, 2.64e-04},
    {0.3, 30, 2, 0.04926772, 2.19e-04, 0.32884987, 3.43e-04},
    {0.3, 30, 4, 0.05386541, 2.37e-04, 0.09744247, 2.53e-04},
    {0.3, 30, 8, 0.05435158, 2.39e-04, 0.00818634, 6.56e-05},
    {0.3, 60, 1, 0.06500173, 2.10e-04, 0.53252281, 2.73e-04},
    {0.3, 60, 2, 0.08010124, 2.62e-04, 0.27250306, 3.22e-04},
    {0.3, 60, 4, 0.08569039, 2.86e-04, 0.06786869, 2.12e-04},
    {0.3, 60, 8, 0.08556470, 2.88e-04, 0.00410514, 4.82e-05},
};

// The half space: its light that goes through is none.
constexpr SlabTruth half_space_truth[] = {
    {0.02, 0, 0, 0.39512943, 4.00e-04, 0, 0},   {0.02, 30, 0, 0.41820441, 4.01e-04, 0, 0},
    {0.02, 60, 0, 0.49720196, 3.99e-04, 0, 0},  {0.02, -30, 0, 0.41075523, 3.98e-04, 0, 0},
    {0.02, -60, 0, 0.49410043, 3.98e-04, 0, 0}, {0.3, 0, 0, 0.05197314, 1.47e-04, 0, 0},
    {0.3, 30, 0, 0.05409200, 1.47e-04, 0, 0},   {0.3, 60, 0, 0.08580360, 1.78e-04, 0, 0},
    {0.3, -30, 0, 0.05421248, 1.47e-04, 0, 0},  {0.3, -60, 0, 0.08786907, 1.77e-04, 0, 0},
};

} // namespace tsuya::reference

#endif

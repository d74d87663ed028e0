// Sums of Gaussians for profiles of light that spreads sideways: what a separable or mip-mapped
// blur uses.
//
// A profile P(r), power per area at distance r, becomes sum_j w_j G(v_j, r) with G(v, r) =
// exp(-r^2 / 2v) / (2 pi v), all w_j >= 0, and variances v_j on a geometric ladder: standard
// deviations s, s q, s q^2, ... Its transform is sum_j w_j exp(-v_j k^2 / 2), so the fit is made to
// the transform, of which solvers give exact samples, and the sum of the weights is P(0), the
// total.
#ifndef TSU_OPTICS_GAUSSIAN_SUM_H
#define TSU_OPTICS_GAUSSIAN_SUM_H

enum { TSU_I_GAUSSIANS = 6, TSU_I_GAUSSIAN_SAMPLES = 24, TSU_I_GAUSSIAN_PROFILES = 3 };

struct tsu_i_gaussians {
    int count;
    double variance[TSU_I_GAUSSIANS]; // rises
    double weight[TSU_I_GAUSSIANS];   // sum to the profile's total
};

// Samples of the transforms of several profiles that are to share their variances.
struct tsu_i_transforms {
    int samples, profiles;
    double k[TSU_I_GAUSSIAN_SAMPLES]; // rises from 0
    double value[TSU_I_GAUSSIAN_PROFILES][TSU_I_GAUSSIAN_SAMPLES];
};

// Fit `count` Gaussians, [1, TSU_I_GAUSSIANS], whose standard deviations lie in [least, most]: the
// ladder with the least sum of squares over all profiles, each relative to its total, that
// non-negative least squares leave. Weights are scaled so that totals are exact. A profile whose
// total is 0 gets weights 0. Returns the largest |error| of a transform over its total.
double tsu_i_gaussians_fit(const struct tsu_i_transforms *transforms, int count, double least,
                           double most, struct tsu_i_gaussians *out);

double tsu_i_gaussians_profile(const struct tsu_i_gaussians *sum, double r);
double tsu_i_gaussians_transform(const struct tsu_i_gaussians *sum, double k);
// Share of the total that lies within r, and the radius that holds a share; `straight` is power at
// r = 0 beside the sum's. 0 without any power.
double tsu_i_gaussians_within(const struct tsu_i_gaussians *sum, double straight, double r);
double tsu_i_gaussians_radius(const struct tsu_i_gaussians *sum, double straight, double share);

// A straight border between light and dark, blurred, in shares of the total: the mean over a strip
// of width `strip` > 0 on the dark side (at most 0.5), and the integral over all of the dark side,
// a length.
double tsu_i_gaussians_strip(const struct tsu_i_gaussians *sum, double strip);
double tsu_i_gaussians_spill(const struct tsu_i_gaussians *sum);

#endif

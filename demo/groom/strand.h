// Private to the generator: the path of one strand.
#ifndef TSUYA_GROOM_STRAND_H
#define TSUYA_GROOM_STRAND_H

#include "numeric.h"

#include "scalp.h"

#include <vector>

namespace tsuya::groom {

// What strands of one lock share.
struct Lock {
    double phase;  // of its curl, turns
    double turn;   // sense of its curl, -1 or 1
    double pitch;  // its curl_frequency relative to the parameter's
    int side;      // of the parting, -1 or 1
};

class Grower
{
  public:
    // Keeps references to both.
    Grower(const HairParams &params, const Scalp &scalp);

    // Length of the path around which a fibre of `fibre` metres curls, metres.
    double reach(double fibre) const;

    Lock lock(const Root &root, Random &random) const;

    // The path a strand winds around: `points` of it from the root, for a fibre
    // of `fibre` metres that keeps `rise` in [0, 1] of the volume over the scalp.
    void path(const Root &root, int side, double fibre, double rise, Vec *out) const;

    // Winds the strand around its path and adds its own deviations, in place.
    void wind(const Root &root, const Lock &lock, double fibre, Random &random, Vec *points) const;

  private:
    double level(const Root &root) const;
    Vec comb(Vec u, int side) const;
    Vec push_out(Vec p, double scale, double margin) const;

    const HairParams &params_;
    const Scalp &scalp_;
    double across_ = 0.0;  // curl radius along the scalp, metres
    double upward_ = 0.0;  // curl radius away from the scalp, metres
    double winding_ = 0.0; // squared way around the path per way along it
};

} // namespace tsuya::groom

#endif

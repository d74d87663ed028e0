// A picture by path tracing, on all cores.
#ifndef TSUYA_TESTS_REFERENCE_RENDER_H
#define TSUYA_TESTS_REFERENCE_RENDER_H

#include "reference/film.h"
#include "reference/tracer.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>

namespace tsuya::reference {

// A perspective camera. Pixels are squares over which samples are uniform.
struct Camera {
    glm::dvec3 eye{0.0};
    glm::dmat3 world{1.0}; // columns: right, up, back
    double tan_x = 0.5;    // of half the horizontal angle of view
    double tan_y = 0.5;
    double near = 0.0; // depth before which nothing is seen

    // Path through the picture at u to the right and v down, [0, 1].
    Path path(double u, double v) const;
};

struct Work {
    std::uint64_t samples = 16; // bring every pixel to this many
    std::uint64_t seed = 1;
    unsigned threads = 1;
};

// Take samples in every pixel that has fewer than work.samples. Sample n of a pixel depends on the
// seed, the pixel and n alone, so neither threads nor interruptions change the sums.
//
//   tick  called several times a second from the calling thread with the share that is done,
//         [0, 1]; false stops the work between two pixels. May be empty.
// Returns: false when it was stopped; the film is then good, and another call goes on.
bool render(const Tracer &tracer, const Camera &camera, const Work &work, Film &film,
            const std::function<bool(double done)> &tick = {});

} // namespace tsuya::reference

#endif

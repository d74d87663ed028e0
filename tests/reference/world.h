// A scene as the reference takes it: the strands, head, camera, lights and fibre of `tsuya render`.
#ifndef TSUYA_TESTS_REFERENCE_WORLD_H
#define TSUYA_TESTS_REFERENCE_WORLD_H

#include "reference/render.h"
#include "scene/build.h"

namespace tsuya::reference {

// The fibre of a scene's material. Errors: its model has no such fibre.
Expected<FiberParams> fiber_params(const scene::Scene &scene, const scene::Material &material);

// Strands of a groom in the world: placed, widened, tapered, with tangents as the renderer has
// them, central differences at points.
Strands strands(const groom::Groom &groom, const draw::Frame &frame);
// The head as the renderer shows it.
Surface surface(const groom::Mesh &head, const draw::Frame &frame);

// Everything. The dome is a uniform sky, not its samples; surroundings are their picture, not its
// harmonics, and lights are their size.
//   frame  without surroundings, as scene::frame() makes it by default
// Errors: those of fiber_params() and of the picture of surroundings.
Expected<World> world(const scene::Scene &scene, const scene::Hair &hair,
                      const scene::Material &material, const draw::Frame &frame,
                      unsigned threads = 0);

Camera camera(const draw::Frame &frame);

} // namespace tsuya::reference

#endif

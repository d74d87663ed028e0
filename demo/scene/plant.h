// A scene of kind leaf or tree turned into what the surface renderer takes.
#ifndef TSUYA_SCENE_PLANT_H
#define TSUYA_SCENE_PLANT_H

#include "draw/surface.h"
#include "leaf/tree.h"
#include "scene/light.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace tsuya::scene {

// A leaf or a tree, and what is said of it.
struct Surface {
    leaf::Plant plant;
    std::vector<glm::vec3> points; // all positions, for the camera
    std::string report;            // one fact a line
};

// Read or grow it. Errors: those of leaf::read(), leaf::generate() and leaf::grow().
Expected<Surface> surface(const Scene &scene);

// Everything but the material; as frame() for hair.
draw::SurfaceFrame frame(const Scene &scene, const Surface &surface, double turn = 0.0,
                         bool turntable = false, const Surroundings &around = {});

void aim(const Scene &scene, const Surface &surface, bool turntable, draw::View &frame);

} // namespace tsuya::scene

#endif

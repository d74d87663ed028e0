// A scene turned into what the renderer takes: hair, material, lights, camera.
#ifndef TSUYA_SCENE_BUILD_H
#define TSUYA_SCENE_BUILD_H

#include "draw/renderer.h"
#include "groom/generate.h"
#include "scene/light.h"
#include "scene/scene.h"

#include <tsuya/model.h>

#include <cstddef>
#include <vector>

namespace tsuya::scene {

// Hair of a scene and, where it was grown, the head under it.
struct Hair {
    groom::Groom groom;
    groom::Report report;
    groom::Mesh head; // no triangles for a file
    draw::Solid solid;
    std::string note; // for the user: what of the file could not be used; empty: nothing
};

// Read or grow the groom. Errors: those of groom::read() and groom::generate().
Expected<Hair> hair(const Scene &scene);

// Model and typed parameters of a scene.
struct Material {
    const tsu_model *model = nullptr;
    std::string variant;                  // of the model's entry point; empty: chosen
    std::vector<std::max_align_t> params; // the model's struct
    glm::dvec3 sigma_a{0.0};              // of the scene's colour, per fibre radius
    glm::dvec3 albedo{1.0};               // of one fibre of that colour
    std::string note;                     // for the user; empty: the scene's model is taken
};

// Without shadow a model that asks for the hair in the light's way falls back to marschner.
// Errors: a parameter out of the model's range; an albedo, of fibre or head, that no pigment
// gives.
Expected<Material> material(const Scene &scene);

// Lights of a scene: those of its rig and its own.
//
// Rigs, by azimuth and elevation in degrees and irradiance, beside the default dome of radiance
// 1.5:
//   key    (47, 36) 0.6 and a rim (202, 26) 1.0     front  (10, 20) 2.0
//   side   (95, 20) 3.0                             back   (195, 20) 3.0
// A single light shows two models differently even when they scatter the same energy in all, since
// each sends it another way: Marschner's fibre sends most of it on, away from the light. In the
// default rig the rim returns what the key loses and the dome, in which models of equal albedo are
// equal, carries most of the light, so that the mean of the hair stays when the model changes.
//
//   middle  of what they light
std::vector<draw::Light> lights(const Scene &scene, const glm::dvec3 &middle);
// Of the box around points; one at least.
glm::dvec3 middle(const std::vector<glm::vec3> &points);
// The scene's dome as lights; none when it is dark.
std::vector<draw::Light> sky(const Scene &scene);

// Everything but the material's parameters. `frames` of a turntable share one camera distance.
//
//   turn    degrees added to the scene's turn_deg
//   around  surroundings() of the scene, beside its dome
draw::Frame frame(const Scene &scene, const Hair &hair, const Material &material,
                  double turn = 0.0, bool turntable = false, const Surroundings &around = {});

// Camera of a frame alone, for a window that moves it.
void aim(const Scene &scene, const Hair &hair, bool turntable, draw::View &frame);

} // namespace tsuya::scene

#endif

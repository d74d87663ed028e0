// What a scene is to the chooser (tsuya/choose.h): the few numbers on which tiers' errors depend.
#ifndef TSUYA_SCENE_TRAITS_H
#define TSUYA_SCENE_TRAITS_H

#include "scene/build.h"

namespace tsuya::scene
{

struct Traits {
    glm::dvec3 sigma_a{0.0};    // of the hair, 1/radius
    double beta_R = 0.0;        // deviation of R, radians
    double strand_pixels = 0.0; // mean width of a strand, pixels
    double depth = 0.0;         // fibres that a ray of view crosses in front of the head, mean over
                                // pixels that hair covers by more than 0.3
    double curl = 0.0;          // mean squared sine between a strand and its own course, the chord
                                // over 40 % of the mean length: 0 straight, 0.5 tight curls
    double covered_pixels = 0.0;
    double sky_share = 0.0;    // of the irradiance, that which comes from sky or surroundings
    double light_cosine = 0.0; // mean cosine between the directions to light and to the viewer,
                               // weighed by irradiance: 1 front, -1 back; 0 without lights
    int directional_lights = 0, point_lights = 0, area_lights = 0, environments = 0;
};

// frame  frame() of the same scene, hair and material
Traits traits(const Scene &scene, const Hair &hair, const Material &material,
              const draw::Frame &frame);

} // namespace tsuya::scene

#endif

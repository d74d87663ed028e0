// Hair of one tier as bright as that of another.
//
// Tiers differ in mean luminance: the cheap ones miss the light that fibres scatter to each other.
// tsu_choose_match() predicts the factor between two tiers from a scene's traits; a program that can
// draw both measures it, as this does in three small pictures. Measured at 96 pixels and used at 112
// to 256 it holds the mean luminance of hair within 2 % (test `match`).
#ifndef TSUYA_SCENE_MATCH_H
#define TSUYA_SCENE_MATCH_H

#include "draw/renderer.h"
#include "scene/build.h"

namespace tsuya::scene
{

// Factor on the light of the scene's hair that gives it the mean luminance of the tier that its key
// match= names; 1 with match=none. The renderer has the hair; it is left with the scene's material.
//   turn_deg, turntable  as for frame()
// Errors: those of the material and of the renderer.
Expected<float> match(draw::Renderer &renderer, const Scene &scene, const Hair &hair,
                      const Surroundings &around, double turn_deg = 0.0, bool turntable = false);

} // namespace tsuya::scene

#endif

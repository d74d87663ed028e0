// A contact sheet: the traced picture and a scene by every tier, with maps of their errors below.
#ifndef TSUYA_SCENE_SHEET_H
#define TSUYA_SCENE_SHEET_H

#include "draw/screen.h"
#include "image/figures.h"
#include "image/image.h"
#include "scene/scene.h"

#include <vector>

namespace tsuya::scene {

// Upper row: the traced picture, then `pictures`, with the scene's exposure and tone. Lower row:
// nothing, then error_map() of each. Linear, to be written as PNG; all pictures of one size.
image::Image sheet(const Scene &scene, const image::Traced &traced,
                   const std::vector<draw::Picture> &pictures);

} // namespace tsuya::scene

#endif

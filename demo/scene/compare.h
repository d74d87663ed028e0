// Private to `tsuya compare`: whether a traced picture is one of the scene.
#ifndef TSUYA_SCENE_COMPARE_H
#define TSUYA_SCENE_COMPARE_H

#include "image/image.h"
#include "scene/scene.h"

#include <string>

namespace tsuya::scene {

// What keeps a picture that `tsuya reference` wrote from being one of `scene`: another size, or
// keys that the tracer reads and that differ between `scene` and the text in the picture. Keys of
// the renderer alone (model, variant, shadow, exposure, ...) may differ, and folders of files.
//
// Returns: "" when nothing does, or when the picture has no text and the right size.
std::string difference(const Scene &scene, const image::Image &picture);

} // namespace tsuya::scene

#endif

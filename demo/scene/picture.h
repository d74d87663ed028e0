// A scene drawn offscreen, and the numbers of a picture.
#ifndef TSUYA_SCENE_PICTURE_H
#define TSUYA_SCENE_PICTURE_H

#include "draw/renderer.h"
#include "draw/surface.h"
#include "scene/build.h"

#include <memory>
#include <string>

struct offscreen;

namespace tsuya::scene {

// Rec. 709 luminance of a linear picture.
struct Numbers {
    double mean = 0.0;     // over all pixels
    double hair = 0.0;     // over pixels, each weighed by the share that hair or leaves cover
    double coverage = 0.0; // mean of that share
};
Numbers numbers(const draw::Picture &picture);

// An offscreen context with a renderer in it. One per process at a time.
class Studio
{
  public:
    // Errors: no OpenGL 3.3 through EGL or OSMesa, with what each back-end said; a shader that does
    //         not compile.
    static Expected<std::unique_ptr<Studio>> create(const draw::Folders &folders = {});
    ~Studio();

    draw::Renderer &renderer()
    {
        return *renderer_;
    }
    // The renderer of leaves and trees, made at the first call.
    // Errors: a shader that does not compile.
    Expected<draw::SurfaceRenderer *> surfaces();
    // Back-end, vendor, renderer and version.
    std::string description() const;

    // Load the groom into the renderer and set the material.
    // Errors: those of Renderer::load() and Renderer::material().
    Expected<bool> take(const Hair &hair, const Material &material);

  private:
    Studio() = default;

    offscreen *context_ = nullptr;
    draw::Folders folders_;
    std::unique_ptr<draw::Renderer> renderer_;
    std::unique_ptr<draw::SurfaceRenderer> surfaces_;
};

// Write what was drawn last. .exr: linear R, G, B and the channel `hair` or, for leaves and trees,
// `leaf`: the share of the pixel that is covered, 32 bits. .png: exposure, tone and the sRGB curve.
// Errors: another ending; what the image writer says.
Expected<bool> save(const std::string &path, const Scene &scene, draw::Screen &screen);

// True for a path that save() takes.
bool savable(const std::string &path);

} // namespace tsuya::scene

#endif

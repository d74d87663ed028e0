// Draws a plant: a leaf or a tree, the one path that `tsuya render` has for surfaces.
//
// Order of a frame: depths from the first four lights, then leaves (both sides), wood and ground
// with a depth test into `supersample` times the picture's size, then the mean over each pixel's
// samples.
//
// What is simple: light that passes a leaf goes straight on, dimmed by the transmittance of a leaf
// that it meets at 45 degrees, and ends at a second leaf; light that leaves reflect onto others is
// left out; the sky is dimmed by leaves as a cloud (leaf_sky.h); lights that have a place or a size
// have the shadow of a far light in the direction of their centre from the origin; lights past the
// fourth have none.
#ifndef TSUYA_DRAW_SURFACE_H
#define TSUYA_DRAW_SURFACE_H

#include "draw/depth_maps.h"
#include "draw/guest.h"
#include "draw/leaf_sky.h"
#include "draw/lights.h"
#include "draw/plant.h"
#include "draw/screen.h"

#include <array>
#include <memory>
#include <string>

namespace tsuya::draw {

struct SurfaceFrame : View {
    std::array<float, 36> sky{}; // record of an environment: radiance from all sides
    int shadow_size = 2048;      // texels along a shadow map's side, [0, 4096]; 0: no shadow
    float roundness = 0.0f;      // how far shading normals follow a rounded crown, [0, 1]
    bool ground = false;         // draw the ground under a tree
};

class SurfaceRenderer
{
  public:
    // As Renderer::create().
    static Expected<std::unique_ptr<SurfaceRenderer>> create(tsu_gl_proc_fn proc, void *user,
                                                             const Folders &folders = {});
    ~SurfaceRenderer();

    void load(const leaf::Plant &plant);

    // Shade leaves with this model and these typed parameters.
    // Errors: a model that is none of leaves; the library's; a shader that does not compile.
    Expected<bool> material(const tsu_model *model, const void *params);

    // Errors: as Renderer::draw(); no material.
    Expected<bool> draw(const SurfaceFrame &frame);

    Picture picture() const
    {
        return screen_->picture();
    }
    Screen &screen()
    {
        return *screen_;
    }
    const Plant &plant() const
    {
        return *plant_;
    }

  private:
    SurfaceRenderer() = default;
    Expected<bool> build();
    Expected<bool> build(const tsu_model *model, Program &leaf, Program &passes);
    void use(const Program &program, const SurfaceFrame &frame) const;
    void dim_sky(const SurfaceFrame &frame);

    gl_api gl_{};
    std::unique_ptr<Guest> guest_;
    std::unique_ptr<Screen> screen_;
    std::unique_ptr<Plant> plant_;
    std::unique_ptr<DepthMaps> depths_;
    void ground(const SurfaceFrame &frame);

    Program depth_, second_, wood_, ground_, leaf_;
    glm::vec3 passes_{0.0f}; // share of light that passes a leaf
    leaf::Plant loaded_;
    glm::vec3 middle_{0.0f}; // of the plant
    float radius_ = 1.0f;
    LeafSky leaf_sky_;
    std::array<float, 36> sky_{}; // that leaf_sky_ was made for
    glm::mat4 sky_model_{0.0f};
    GLuint sky_texture_ = 0;
};

} // namespace tsuya::draw

#endif

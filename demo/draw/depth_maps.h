// Shadow maps of surfaces: depths from the first lights, as tiles of two textures: what is met
// first, and second. Wood that is met first is met second, too: behind one leaf there is light.
#ifndef TSUYA_DRAW_DEPTH_MAPS_H
#define TSUYA_DRAW_DEPTH_MAPS_H

#include "draw/lights.h"
#include "draw/plant.h"
#include "draw/program.h"

#include <vector>

namespace tsuya::draw {

constexpr int depth_maps_most = 4;

class DepthMaps
{
  public:
    explicit DepthMaps(const gl_api *gl) : gl_(gl)
    {
    }
    ~DepthMaps();
    DepthMaps(const DepthMaps &) = delete;
    DepthMaps &operator=(const DepthMaps &) = delete;

    // Draw the plant's depth along each light's way, parallel, around the sphere of `centre` and
    // `radius` (world).
    //
    //   size  texels along a map's side; 0: no maps
    // Returns: false when the context cannot draw them.
    bool draw(const Program &depth, const Program &second, const Plant &plant, const View &view,
              const glm::vec3 &centre, float radius, int size);

    // Textures to `unit` and the next, and the uniforms of surface_light.glsl.
    void bind(const Program &program, int unit) const;

  private:
    bool target(int size);
    void pass(const Program &program, const Plant &plant, const View &view, int layer) const;

    const gl_api *gl_;
    GLuint textures_[2] = {0, 0}, framebuffers_[2] = {0, 0};
    int size_ = 0; // of the texture, two maps a side
    float texel_ = 0.0f;
    std::vector<glm::mat4> cameras_;
    std::vector<glm::mat4> to_map_;
};

} // namespace tsuya::draw

#endif

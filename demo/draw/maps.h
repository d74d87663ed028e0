// Opacity shadow maps and deep opacity maps of the first lights, as tiles of one atlas.
//
// The library plans (tsuya/hair_shadow.h); this draws the strands with the camera's own ribbons and
// exact coverage, so that a texel holds the fibres that cross it, however thin. All maps together
// cost three samplers.
#ifndef TSUYA_DRAW_MAPS_H
#define TSUYA_DRAW_MAPS_H

#include "draw/lights.h"
#include "draw/program.h"
#include "draw/strands.h"
#include "groom/groom.h"

#include <tsuya/hair_shadow.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::draw {

constexpr int maps_most = 8; // lights that can have a map

// What maps depend on, besides the groom.
struct MapsAsked {
    const tsu_model *technique = nullptr; // NULL: none
    int layers = 8;                       // [1, 8]
    int size = 0;                         // texels; 0: chosen from the strands' spacing
    float opacity = 1.0f;                 // of a fibre
    tsu_format format = 0;                // that sums up; 0: the best that the context blends
    float width_scale = 1.0f;
    float taper = 0.1f;
    glm::mat4 model{1.0f};    // groom to world
    glm::mat4 to_solid{0.0f}; // world to where the head is the unit sphere; 0: no head
    glm::vec4 neck{0.0f};     // draw/solid.glsl
    glm::vec2 neck_span{0.0f};
    // At most maps_most, world: directions towards them, or with w = 1 their places.
    std::vector<glm::vec4> lights;

    bool operator==(const MapsAsked &other) const;
};

class Maps
{
  public:
    explicit Maps(const gl_api *gl) : gl_(gl)
    {
    }
    Maps(const Maps &) = delete;
    Maps &operator=(const Maps &) = delete;
    ~Maps();

    // Take a groom.
    void load(const groom::Groom &groom);

    // Draw the maps, again only when something changed. `write` is what Shading::maps() gives.
    //
    // Returns: false when the context cannot draw them; why() says what is missing.
    // GL:      leaves bindings and state undefined, and the strands' order with it.
    bool draw(tsu_context *context, const MapsAsked &asked, const Program &front,
              const Program &layers, Strands &strands);
    const std::string &why() const
    {
        return why_;
    }

    // Textures to units `unit` .. `unit` + 2, and the uniforms of shadow.glsl.
    void bind(const Program &program, int unit, bool on) const;

    const std::vector<tsu_hair_shadow_plan> &plans() const
    {
        return plans_;
    }

  private:
    bool plan(tsu_context *context, const MapsAsked &asked);
    bool targets(int width, int height, tsu_format format);
    void pass(const Program &program, const MapsAsked &asked, const Strands &strands) const;
    void clear();

    const gl_api *gl_;
    GLuint textures_[3] = {0, 0, 0}; // front, layers, deeper
    GLuint framebuffers_[2] = {0, 0};
    int width_ = 0, height_ = 0;
    tsu_format format_ = 0;
    int columns_ = 1;
    std::uint32_t tile_ = 0; // texels along the side of a tile
    glm::vec3 centre_{0.0f};
    float radius_ = 1.0f, length_ = 0.0f, diameter_ = 0.0f;
    MapsAsked drawn_;
    std::vector<tsu_hair_shadow_plan> plans_;
    std::string why_;
};

} // namespace tsuya::draw

#endif

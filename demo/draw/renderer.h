// Draws a head of hair: the one path that `tsuya render` and the window share.
//
// Order of a frame: the sky's light on every point of a strand; the head with depth, then all
// strand segments from far to near, lit by the other lights in each pixel and blended over, into
// `supersample` times the picture's size, then the mean over each pixel's samples. Sorting whole
// segments by their middle is exact where segments do not cross; no layer is lost or counted twice,
// so energy does not depend on the number of strands. What remains is that fibres inside one pixel
// are taken as crossing it independently, which understates gaps between aligned ones; the size of
// that error is the difference to supersample = 4, which tests/demo/draw_test prints.
#ifndef TSUYA_DRAW_RENDERER_H
#define TSUYA_DRAW_RENDERER_H

#include "draw/grid.h"
#include "draw/lights.h"
#include "draw/maps.h"
#include "draw/screen.h"
#include "draw/shading.h"
#include "draw/strands.h"
#include "draw/target.h"
#include "groom/generate.h"

#include <memory>
#include <string>
#include <vector>

namespace tsuya::draw {

// How light is dimmed by the hair in its way. Maps serve the first maps_most lights; the sky, the
// head and further lights have the grid. A context that cannot draw maps has the grid for all.
enum class Shadow { none, grid, deep_opacity, opacity_shadow };

// What to draw besides the material. Lengths in metres, colours linear Rec. 709.
struct Frame : View {
    std::vector<Light> sky;    // a uniform sky, evaluated in each point of a strand; at most
                               // sky_most directions, in which its shadow is looked up
    bool surrounded = false;   // light the strands by `surroundings`, and not by the sky's lights
    std::array<float, 36> surroundings{}; // record of an environment (tsuya/light.h)
    glm::vec3 skin{0.32f, 0.22f, 0.17f}; // albedo of the head
    bool head = true;
    int sky_samples = 24;     // of the model over the sphere, in each point of a strand, >= 1
    Shadow shadow = Shadow::grid;
    int shadow_layers = 8;    // of a map, [1, 8]
    int shadow_size = 0;      // texels along a map's side, [8, 8192]; 0: chosen from the strands
    glm::vec3 loss{1.0f};     // share of light that one fibre takes out of the way, [0, 1]
    glm::vec3 sigma_a{0.0f};  // absorption per fibre radius
    float variation = 0.0f;   // deviation of ln(sigma_a) from strand to strand
    float width_scale = 1.0f; // of every fibre
    float gain = 1.0f;        // on the light of hair, >= 0
    float taper = 0.1f;       // share of a strand's length over which its tip narrows, [0, 1]
};

class Renderer
{
  public:
    // The context of `proc` is current now and in every later call.
    // Errors: no float targets, a shader that does not compile, a context too old.
    static Expected<std::unique_ptr<Renderer>> create(tsu_gl_proc_fn proc, void *user,
                                                      const Folders &folders = {});
    ~Renderer();

    // Take a groom; `head` may have no triangles.
    // Errors: more points than the context's textures hold.
    Expected<bool> load(const groom::Groom &groom, const groom::Mesh &head, const Solid &solid);

    // Choose model and parameters; see Shading::set().
    Expected<bool> material(const tsu_model *model, const void *params,
                            const std::string &variant = {});
    // Read GLSL again; see Shading::reload().
    Expected<bool> reload();

    // Draw into a picture of this renderer.
    // Errors: a size that the context cannot draw, too many lights.
    // GL:     leaves bindings and state undefined, like every call here.
    Expected<bool> draw(const Frame &frame);

    // The picture of the last draw().
    Picture picture() const
    {
        return screen_->picture();
    }
    Screen &screen()
    {
        return *screen_;
    }
    // Wait for the GPU.
    void finish() const;

    // Strands that touch the picture's pixels and are not behind the head. Hair does not count as
    // hiding hair, being translucent: strands found in an identity pass are taken away and the rest
    // is drawn again, until a pass finds less than a thousandth of all or after 12 passes. Each
    // strand counted has reached the picture; in hair some 20 strands deep nearly all that have are
    // counted.
    std::size_t reached(const Frame &frame);

    // What the last draw() could not do as asked, and did in another way; empty: nothing.
    const std::string &note() const
    {
        return note_;
    }
    // Maps of the last draw().
    const Maps &maps() const
    {
        return *maps_;
    }

    const Shading &shading() const
    {
        return *shading_;
    }

  private:
    Renderer() = default;
    Expected<bool> build();
    void shadows(const Frame &frame);
    void sweep(const std::vector<glm::vec3> &directions, GLuint texture, bool beyond);
    void map_shadows(const Frame &frame);
    enum class Which { lights, sky, both };
    void lights(const Program &program, const Frame &frame, Which which) const;
    glm::mat4 to_solid(const Frame &frame) const;
    glm::vec4 neck(const Frame &frame) const;
    glm::vec2 neck_span(const Frame &frame) const;
    void sky(const Frame &frame);
    void strands(const Program &program, const Frame &frame, int width, int height) const;
    void head(const Frame &frame);

    gl_api gl_{};
    std::unique_ptr<Shading> shading_;
    std::unique_ptr<Strands> strands_;
    std::unique_ptr<Maps> maps_;
    bool mapped_ = false; // this frame's first lights have maps
    std::string note_;
    std::unique_ptr<Screen> screen_;
    std::unique_ptr<Target> sky_;
    Program head_program_, identity_;
    groom::Groom groom_;
    Solid solid_;
    Grid grid_;
    float grid_scale_ = 0.0f;     // width scale that the grid was filled with; 0: not filled
    bool grid_head_ = false;      // and whether with the head
    std::vector<glm::vec3> swept_; // light directions in the groom's space of the shadow texture
    bool swept_beyond_ = false;
    GLuint fibres_ = 0, beyond_ = 0;
    GLuint head_array_ = 0, head_vertices_ = 0, head_elements_ = 0;
    GLsizei head_count_ = 0;
};

} // namespace tsuya::draw

#endif

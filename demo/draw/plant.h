// A plant on the GPU: one buffer a mesh, leaves as instances of a few kinds.
#ifndef TSUYA_DRAW_PLANT_H
#define TSUYA_DRAW_PLANT_H

#include "gpu/gl.h"
#include "leaf/tree.h"

#include <vector>

namespace tsuya::draw {

class Plant
{
  public:
    explicit Plant(const gl_api *gl);
    ~Plant();
    Plant(const Plant &) = delete;
    Plant &operator=(const Plant &) = delete;

    // Take a plant: meshes, places and maps.
    void load(const leaf::Plant &plant);

    // Draw with the current program, surface.vert.glsl before any fragment shader.
    void blades() const;
    void wood() const; // stalks too

    // Pigment, thickness and the relief's slopes along u and v. One texel of 1, 1, 0, 0 where the
    // plant has no maps.
    GLuint maps() const
    {
        return maps_;
    }

    std::size_t triangles() const
    {
        return triangles_;
    }

  private:
    struct Part {
        GLuint array = 0, vertices = 0, elements = 0;
        GLsizei count = 0;
        GLsizei instances = 0; // 0: drawn once, as it stands
    };
    Part part(const leaf::Mesh &mesh);
    void place(Part &part, GLuint places, std::size_t first, std::size_t count) const;
    void draw(const Part &part) const;
    void load_maps(const leaf::Maps &maps);
    void clear();

    const gl_api *gl_;
    std::vector<Part> blades_, stalks_;
    Part wood_;
    GLuint places_ = 0, maps_ = 0;
    std::size_t triangles_ = 0;
};

} // namespace tsuya::draw

#endif

// Strands on the GPU: points in textures, and the order in which their segments are drawn.
#ifndef TSUYA_DRAW_STRANDS_H
#define TSUYA_DRAW_STRANDS_H

#include "gpu/gl.h"
#include "groom/groom.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <vector>

namespace tsuya::draw {

class Strands
{
  public:
    static constexpr int row_points = 2048; // points in a row of the textures

    explicit Strands(const gl_api *gl) : gl_(gl)
    {
    }
    Strands(const Strands &) = delete;
    Strands &operator=(const Strands &) = delete;
    ~Strands();

    // Upload a groom; it is not kept.
    // Returns: false when it has more points than the context's textures hold.
    bool load(const groom::Groom &groom);

    // Order all segments from far to near for a camera, nearer than `near` left out.
    //   view  world to eye space, model included
    void sort(const glm::mat4 &view, float near);
    // Take only the strands whose flag is set, in no special order.
    void choose(const std::vector<char> &strands, const glm::mat4 &view, float near);

    // Take all segments, in the groom's order.
    void all();

    // Draw what was ordered, with the program and its uniforms that are bound.
    // GL: leaves units 1 and 2, the vertex array and the element buffer bound.
    void draw() const;

    // Bind the points to unit 1 and the strands to unit 2.
    void bind() const;
    // Rows of row_points points.
    int rows() const
    {
        return rows_;
    }

    std::size_t strands() const
    {
        return strand_count_;
    }
    std::size_t segments() const
    {
        return first_.size();
    }

  private:
    void upload(const std::vector<std::uint32_t> &order);
    float depth(std::uint32_t point, const glm::mat4 &view) const;

    const gl_api *gl_;
    GLuint points_ = 0, data_ = 0, array_ = 0, elements_ = 0;
    std::size_t strand_count_ = 0;
    GLsizei count_ = 0;
    int rows_ = 0;
    std::vector<glm::vec3> place_;      // of points
    std::vector<std::uint32_t> first_;  // first point of each segment
    std::vector<std::uint32_t> strand_; // of each segment
};

} // namespace tsuya::draw

#endif

// How much hair lies between a point and a light: a cheap self-shadow that fits every model.
//
// Hair is spread over the cells of a grid as optical density, fibres per metre of a straight way: a
// fibre of length s and diameter w in a volume V is met w s sin(a) / V times per metre, a being the
// angle between fibre and way. A cell keeps w s / V and the mean of t t^T over its fibres' tangents
// t, of which sqrt(1 - d.(t t^T) d) is the mean sine for a way d, exact where a cell's fibres are
// parallel. A sweep from the light through the grid adds it up.
#ifndef TSUYA_DRAW_GRID_H
#define TSUYA_DRAW_GRID_H

#include "groom/groom.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace tsuya::draw {

// A solid ellipsoid inside the hair, opaque to light. No axis may be 0; all 0: there is none.
struct Solid {
    glm::vec3 centre{0.0f};
    glm::vec3 semi_axes{0.0f};
    // A neck under it: an upright elliptic cylinder, in x and z; no axes: there is none.
    glm::vec2 neck_centre{0.0f}, neck_axes{0.0f};
    glm::vec2 neck_span{0.0f}; // y of its ends
};

class Grid
{
  public:
    // Spread a groom over cubes, `resolution` of them along its longest side, and a border.
    //   hairy        the solid counts as thick hair instead
    //   width_scale  factor on every fibre's width, > 0
    void fill(const groom::Groom &groom, const Solid &solid, bool hairy, float width_scale,
              int resolution = 128);

    // Fibres between each cell's centre and the light, x fastest, then y, as if there were no
    // solid.
    //   direction  towards the light, unit, space of the groom
    std::vector<float> sweep(const glm::vec3 &direction) const;
    // Fibres on the same line away from the light, up to the solid, behind which no light gets.
    std::vector<float> beyond(const glm::vec3 &direction) const;

    glm::ivec3 size() const
    {
        return size_;
    }
    glm::vec3 corner() const
    {
        return corner_;
    }
    float cell() const
    {
        return cell_;
    }
    // Fibres per metre of each cell across all of them, as sweep() orders them.
    const std::vector<float> &density() const
    {
        return density_;
    }

  private:
    std::size_t index(int x, int y, int z) const
    {
        return (std::size_t(z) * std::size_t(size_.y) + std::size_t(y)) * std::size_t(size_.x) +
               std::size_t(x);
    }
    void splat(const glm::vec3 &place, const glm::vec3 &tangent, float amount);
    std::vector<float> add_up(const glm::vec3 &direction, bool stop) const;

    glm::ivec3 size_{0};
    glm::vec3 corner_{0.0f};
    float cell_ = 1.0f;
    std::vector<float> density_;   // w s / V
    std::vector<glm::mat3> along_; // the same times t t^T
    std::vector<char> solid_;      // 1: cell of the solid
};

} // namespace tsuya::draw

#endif

// The surroundings of a scene as a picture: the key environment=.
#ifndef TSUYA_SCENE_GLOBE_H
#define TSUYA_SCENE_GLOBE_H

#include "groom/expected.h"
#include "image/image.h"
#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <string>

namespace tsuya::scene
{

// Latitude and longitude: +y on top, -z in the middle, +x to its right. Points are rows of pixels,
// of even radiance each; a preset has 512 x 256.
class Globe
{
  public:
    // Errors: a file that cannot be read, is no picture twice as wide as high, or holds values that
    //         are no radiance. The scene has an environment.
    static Expected<Globe> of(const Scene &scene);

    std::size_t count() const
    {
        return std::size_t(width_) * std::size_t(height_);
    }
    glm::dvec3 radiance(std::size_t i) const; // linear Rec. 709
    double solid_angle(std::size_t i) const;
    glm::dvec3 direction(std::size_t i) const; // of its middle, unit
    // A direction inside point i, even over its solid angle: u, v in [0, 1).
    glm::dvec3 within(std::size_t i, double u, double v) const;
    // The point that a direction of any length is in.
    std::size_t find(const glm::dvec3 &direction) const;

  private:
    int width_ = 512, height_ = 256;
    double factor_ = 1.0;
    std::string name_;       // of a preset
    image::Image picture_{}; // of a file
};

} // namespace tsuya::scene

#endif

// A framebuffer of linear light, and reading it back.
#ifndef TSUYA_DRAW_TARGET_H
#define TSUYA_DRAW_TARGET_H

#include "gpu/gl.h"

#include <vector>

namespace tsuya::draw {

// Colour texture with four channels, with or without depth. OpenGL: 32-bit floats, so that
// thousands of thin layers add up; ES, which need not blend those: 16-bit floats.
class Target
{
  public:
    enum class Kind {
        light, // floats
        number // RGBA8, for identities
    };

    explicit Target(const gl_api *gl) : gl_(gl)
    {
    }
    Target(const Target &) = delete;
    Target &operator=(const Target &) = delete;
    ~Target();

    // Give it this size; nothing happens when it has it already.
    // Returns: false when the context cannot draw into it.
    bool resize(int width, int height, bool depth, Kind kind = Kind::light);

    // Draw into it from now on, all of it.
    void bind() const;

    GLuint texture() const
    {
        return color_;
    }
    int width() const
    {
        return width_;
    }
    int height() const
    {
        return height_;
    }

    // Four floats a pixel, rows from top to bottom.
    std::vector<float> read() const;
    // Four bytes a pixel, rows from bottom to top; for Kind::number.
    std::vector<unsigned char> read_bytes() const;

  private:
    void clear();

    const gl_api *gl_;
    GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
    int width_ = 0, height_ = 0;
    bool has_depth_ = false;
};

} // namespace tsuya::draw

#endif

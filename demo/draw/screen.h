// A picture in the making: samples, the mean of a pixel's samples, and what a screen shows of it.
#ifndef TSUYA_DRAW_SCREEN_H
#define TSUYA_DRAW_SCREEN_H

#include "draw/program.h"
#include "draw/target.h"

#include <memory>
#include <string>
#include <vector>

namespace tsuya::draw {

// Linear light: red, green, blue, and the share of the pixel that is covered by what the scene is
// about, hair or leaves. Top row first.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> pixels;
};

class Screen
{
  public:
    explicit Screen(const gl_api *gl);
    ~Screen();
    Screen(const Screen &) = delete;
    Screen &operator=(const Screen &) = delete;

    // Compile its programs, again after an edit of the files in `folder` (see source()).
    // Errors: a shader that does not compile; the old programs stay.
    Expected<bool> build(const std::string &folder);

    // Take the size of a picture and the samples along a pixel's side.
    // Errors: a size that the context cannot draw.
    Expected<bool> resize(int width, int height, int supersample);

    // Draw into the samples, which have depth, from now on.
    void begin() const
    {
        samples_.bind();
    }
    // Take the mean over each pixel's samples.
    void resolve();

    // The picture of the last resolve().
    Picture picture() const;
    // The same for a screen: exposure (a factor), film curve or a plain cut at 1, linear in [0, 1]
    // without alpha; the sRGB curve is left to the file's writer.
    Picture shown(float exposure, bool filmic);
    // The same again onto the window's framebuffer, with the sRGB curve.
    void present(float exposure, bool filmic);

    // A vertex array without attributes, for screen.vert.glsl.
    GLuint empty() const
    {
        return empty_;
    }

  private:
    void display(float exposure, bool filmic, bool encode) const;

    const gl_api *gl_;
    Target samples_, resolved_, shown_;
    Program resolve_, display_;
    GLuint empty_ = 0;
    int supersample_ = 1;
};

} // namespace tsuya::draw

#endif

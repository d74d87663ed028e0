// A window with OpenGL 3.3 core and Dear ImGui in it.
#ifndef TSUYA_VIEWER_WINDOW_H
#define TSUYA_VIEWER_WINDOW_H

#include "groom/expected.h"

#include <memory>

struct GLFWwindow;

namespace tsuya::viewer {

// What the pointer did over the picture since the last frame, in pixels and wheel steps.
struct Pointer {
    double orbit_x = 0.0, orbit_y = 0.0; // left button
    double pan_x = 0.0, pan_y = 0.0;     // right or middle button, or left with shift
    double wheel = 0.0;
};

class Window
{
  public:
    // Errors: no display; no OpenGL 3.3.
    static groom::Expected<std::unique_ptr<Window>> create(int width, int height);
    ~Window();
    Window(const Window &) = delete;
    Window &operator=(const Window &) = delete;

    bool open() const;
    // Begin a frame: events, panel. Returns the pointer's work outside the panel.
    Pointer begin();
    // Draw the panel over what is there and show it.
    void end();

    // True once after the key was pressed.
    bool pressed(int glfw_key);
    // Of the framebuffer, pixels.
    void size(int &width, int &height) const;

    // Address of an OpenGL function; `user` is not used.
    static void *proc(void *user, const char *name);

  private:
    explicit Window(GLFWwindow *window) : window_(window)
    {
    }

    GLFWwindow *window_;
    double last_x_ = 0.0, last_y_ = 0.0;
};

} // namespace tsuya::viewer

#endif

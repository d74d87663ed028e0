// GLSL programs of the demo, out of the binary or, for hot reload, out of a folder.
#ifndef TSUYA_DRAW_PROGRAM_H
#define TSUYA_DRAW_PROGRAM_H

#include "gpu/gl.h"
#include "groom/expected.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace tsuya::draw {

using groom::Error;
using groom::Expected;

// A GLSL file and its text.
struct Source {
    const char *name;
    const char *text;
};

// The files of this folder as they were built in; ends with a NULL name.
extern const Source embedded_sources[];

// Text of file `name`: from `folder` when it has one, else the embedded text.
//
// folder  path of demo/draw in a checkout; empty: embedded only
// Returns: the text; empty when there is no such file at all.
std::string source(const std::string &folder, const char *name);

// A linked program. Movable; the GL object goes with the last owner.
class Program
{
  public:
    Program() = default;
    Program(const gl_api *gl, GLuint id) : gl_(gl), id_(id)
    {
    }
    Program(Program &&other) noexcept;
    Program &operator=(Program &&other) noexcept;
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;
    ~Program();

    GLuint id() const
    {
        return id_;
    }

    // Uniforms of the current program by name; a name that the compiler left out is skipped.
    void set(const char *name, int value) const;
    void set(const char *name, float value) const;
    void set(const char *name, const glm::vec3 &value) const;
    void set(const char *name, const glm::vec4 &value) const;
    void set(const char *name, const glm::mat4 &value) const;
    void set(const char *name, const std::vector<glm::vec3> &values) const;
    void set(const char *name, float x, float y) const;

  private:
    const gl_api *gl_ = nullptr;
    GLuint id_ = 0;
};

// Compile and link. Each stage is the version line and precisions that the context wants, followed
// by the texts in order.
//
// Errors: the driver's message, with the stage.
// GL:     leaves no shader object; binds nothing.
Expected<Program> link(const gl_api &gl, const std::vector<std::string> &vertex,
                       const std::vector<std::string> &fragment);

} // namespace tsuya::draw

#endif

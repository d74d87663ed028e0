// A context for one GL test program, and the little drawing that such tests need.
//
// The rung of the ladder is the first argument of the program, or else the environment variable
// TSUYA_TEST_RUNG. Each rung is a process of its own. A context that cannot be made is a failure of
// the test, never a skip.
//
//   gl45-egl     OpenGL 4.5 core, EGL
//   gl33-egl     OpenGL 3.3 core, EGL; the driver is told to promise no more than 3.3
//   es3-egl      OpenGL ES 3.0 or later, EGL
//   gl45-osmesa  OpenGL 4.5 core, OSMesa
//   gl33-osmesa  OpenGL 3.3 core, OSMesa; as gl33-egl
#ifndef TSUYA_TESTS_SUPPORT_FIXTURE_H
#define TSUYA_TESTS_SUPPORT_FIXTURE_H

#include "../../demo/gpu/gl.h"
#include "../../demo/gpu/offscreen.h"

#ifdef __cplusplus
extern "C" {
#endif

struct fixture {
    struct gl_api gl;
    offscreen *context; // hand offscreen_proc and this to the library under test
    const char *rung;
    const char *version; // first lines of a shader: #version, and on ES the precisions
    GLuint vertex_array; // empty, for fixture_draw
};

// A framebuffer with one colour texture.
struct fixture_target {
    GLuint framebuffer, texture;
    int width, height;
};

// Makes the rung's context current on this thread and loads its functions.
//
// Returns: 1, or 0 after a sentence on stderr says what is wrong; `*f` is zero then.
int fixture_open(struct fixture *f, int argc, char **argv);

// Destroys the context. Reports an OpenGL error that nobody asked for.
//
// Returns: 1, or 0 when such an error was pending.
int fixture_close(struct fixture *f);

// Compiles and links a program. A failure prints the driver's log and the numbered source.
//
// vertex    whole source, or NULL for a triangle that covers the target and gives the fragment
//           stage `in vec2 uv`, (0,0) to (1,1) from the lower left corner
// fragment  whole source; begin it with f->version
//
// Returns: the program, or 0.
GLuint fixture_program(struct fixture *f, const char *vertex, const char *fragment);

// Makes a target of RGBA32F texels, all zero. Leaves it bound for drawing and reading.
//
// Returns: 1, or 0 after a sentence on stderr.
int fixture_target_create(struct fixture *f, struct fixture_target *target, int width, int height);
void fixture_target_destroy(struct fixture *f, struct fixture_target *target);

// Draws one triangle over the whole target with `program`. Sets the framebuffer, viewport, vertex
// array and every switch that could keep a fragment from being stored as it is; leaves textures,
// samplers and buffers alone.
void fixture_draw(struct fixture *f, GLuint program, const struct fixture_target *target);

// Reads the target, lower row first, into 4 * width * height floats.
void fixture_read(struct fixture *f, const struct fixture_target *target, float *rgba);

#ifdef __cplusplus
}
#endif

#endif

// A host that leaves OpenGL in the ugliest legal state, and a witness of what changes in it.
//
//   hostile_set(&gl, &host);
//   hostile_snapshot(&gl, &before);
//   ... the call under test ...
//   hostile_snapshot(&gl, &after);
//   assert_true(hostile_compare(&before, &after, why, sizeof why));   // why: for the message
//   hostile_clear(&gl, &host);
//
// Works on OpenGL 4.5 and 3.3 core and on OpenGL ES 3.
#ifndef TSUYA_TESTS_SUPPORT_HOSTILE_H
#define TSUYA_TESTS_SUPPORT_HOSTILE_H

#include "../../demo/gpu/gl.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HOSTILE_UNITS = 32, HOSTILE_VALUES = 512 };

// The objects the host has bound.
struct hostile {
    GLuint textures[3]; // 2D, 2D_ARRAY, 3D
    GLuint sampler;
    GLuint buffers[8];
    GLuint framebuffers[2]; // draw, read
    GLuint renderbuffers[3];
    GLuint vertex_array, program, query;
    GLint viewport[4], scissor[4]; // as they were before
};

// The values of about a hundred names of state, and of the first texture units, uniform and
// transform feedback bindings and vertex attributes.
struct hostile_state {
    int count;
    struct {
        const char *name; // "GL_TEXTURE_BINDING_2D"
        int index;        // unit, binding point, attribute, or 0 2D, 1 2D_ARRAY, 2 3D; or -1
        double value[4];
    } values[HOSTILE_VALUES];
};

// Makes the objects and sets: unit 7 active; every texture unit full, each with a sampler object;
// buffers at PIXEL_UNPACK, PIXEL_PACK and all other binding points, generic and indexed; row length
// 13, skips, alignment 8, swapped bytes; a program, vertex array, draw and read framebuffers,
// renderbuffer; an open occlusion query; scissor, blend, cull, depth, stencil, masks, rasteriser
// discard, and further switches.
//
// Returns: 1, or 0 when that raised an OpenGL error.
int hostile_set(const struct gl_api *gl, struct hostile *host);

// Puts back OpenGL's initial state, and the viewport and scissor box found by hostile_set, and
// deletes the objects.
void hostile_clear(const struct gl_api *gl, struct hostile *host);

// Reads the state. Takes a pending OpenGL error along as the value "glGetError"; otherwise leaves
// everything as it is.
void hostile_snapshot(const struct gl_api *gl, struct hostile_state *state);

// Compares two snapshots of one context.
//
// why  "GL_TEXTURE_BINDING_2D of 7 was 3 0 0 0 and is 0 0 0 0" for the first value that differs,
//      empty when none does; always terminated
//
// Returns: 1 when all values are equal, 0 otherwise.
int hostile_compare(const struct hostile_state *before, const struct hostile_state *after,
                    char *why, size_t why_size);

#ifdef __cplusplus
}
#endif

#endif

// OpenGL for the demo and the tests: one struct of function pointers, filled for one context.
//
// Types and constants are the ordinary ones of <GL/glcorearb.h>; there is no global pointer and no
// prototype, so two contexts of two drivers can live side by side and nothing is linked. Call a
// function by its name without "gl": gl->DrawArrays(GL_TRIANGLES, 0, 3).
//
// The demo runs on OpenGL 3.3 core and OpenGL ES 3.0 and uses a little of 4.3 and 4.5 when it is
// there. Functions that the context's version does not promise are NULL.
#ifndef TSUYA_DEMO_GPU_GL_H
#define TSUYA_DEMO_GPU_GL_H

#include "gl_functions.h"

#include <GL/glcorearb.h>

#ifdef __cplusplus
extern "C" {
#endif

// The functions of one context and its version.
struct gl_api {
    int major, minor; // version of the context, for instance 4, 5
    int es;           // 1 for OpenGL ES, 0 for OpenGL
#define GL_FIELD(type, name) PFNGL##type##PROC name;
    GL_FUNCTIONS(GL_FIELD)
#undef GL_FIELD
};

// Fills `*gl` for the context that is current on the calling thread.
//
// gl       every field is written; on failure the functions are not to be called
// proc     returns the address of a function by its full name ("glClear") or NULL
// user     handed to proc
// missing  on failure, what is missing: a function's name or a sentence on the version; may be NULL
//
// Returns: 1 on success, 0 when a promised function is missing or the version is too old.
// Owns:    *missing is static text.
int gl_load(struct gl_api *gl, void *(*proc)(void *user, const char *name), void *user,
            const char **missing);

// True when the context is at least of this version and of this kind of OpenGL.
//
// es  1 asks about OpenGL ES, 0 about OpenGL
int gl_at_least(const struct gl_api *gl, int es, int major, int minor);

#ifdef __cplusplus
}
#endif

#endif

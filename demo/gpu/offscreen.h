// An OpenGL or OpenGL ES context without a window, a display server or a GPU.
//
// The one place that knows EGL and OSMesa. Both are opened at run time, so a program that uses this
// file links neither, needs none of their headers, and starts where they are not installed.
//
// No default framebuffer is promised: draw into a framebuffer object of your own.
//
// One back-end per process. EGL and OSMesa share one hidden "current context" slot per thread, so
// whichever was made current last receives every call, through either one's function pointers.
// The second back-end is therefore refused as soon as the first has made a context.
#ifndef TSUYA_DEMO_GPU_OFFSCREEN_H
#define TSUYA_DEMO_GPU_OFFSCREEN_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

// Where the context comes from.
enum offscreen_backend {
    OFFSCREEN_EGL,    // EGL, surfaceless platform, then every device of the device platform
    OFFSCREEN_OSMESA, // OSMesa: software, OpenGL only
    OFFSCREEN_ANY     // EGL as above, then OSMesa; a back-end this process already uses, if any
};

// Which language the context speaks.
enum offscreen_api {
    OFFSCREEN_GL, // OpenGL, core profile
    OFFSCREEN_ES  // OpenGL ES; only EGL makes these
};

// What is asked for. The context may be of a later version, never of an earlier one.
typedef struct offscreen_desc {
    enum offscreen_backend backend;
    enum offscreen_api api;
    int major; // OpenGL 3.2 or later, OpenGL ES 2.0 or later
    int minor;
} offscreen_desc;

typedef struct offscreen offscreen;

// Makes a context and makes it current on the calling thread.
//
// desc        what is asked for
// out         the context, or NULL on failure
// error       text, always terminated: empty on success, on failure what each back-end said
// error_size  bytes at `error`, at least 1; 512 holds every message
//
// Returns: 1 on success, 0 on failure.
// Errors:  library missing, no such display, version not available, second back-end in a process.
// Owns:    the caller destroys *out. The libraries stay loaded and the EGL display stays open until
//          the process ends, because all contexts of a process share them.
// Threads: one at a time for create and destroy.
int offscreen_create(const offscreen_desc *desc, offscreen **out, char *error, size_t error_size);

// Destroys the context and releases it if it is current on the calling thread. NULL is allowed.
//
// Threads: the context is current on no other thread.
void offscreen_destroy(offscreen *context);

// Makes the context current on the calling thread.
//
// Returns: 1 on success, 0 when the back-end refuses, for instance because the context is current
//          on another thread.
int offscreen_make_current(offscreen *context);

// Leaves the calling thread without a current context, so that another thread may take it.
//
// Returns: 1 on success, 0 when the back-end refuses.
int offscreen_release(offscreen *context);

// The address of an OpenGL function.
//
// user  an offscreen context
// name  for instance "glDrawArrays"
//
// Returns: the address or NULL. An address is no proof that the context has the function: EGL
//          answers unknown names with a stub. Ask the context's version first.
void *offscreen_proc(void *user, const char *name);

// One line: back-end, vendor, renderer and version, for instance
// "EGL surfaceless: Mesa/X.org, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
//
// Owns: the context.
const char *offscreen_description(const offscreen *context);

#ifdef __cplusplus
}
#endif

#endif

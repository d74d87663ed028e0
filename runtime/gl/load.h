// The functions, version and limits of the host's GL context, read once.
#ifndef TSU_GL_LOAD_H
#define TSU_GL_LOAD_H

#include "gl/entry.h"

#include <tsuya/gl.h>

struct tsu_i_gl_api {
    // NULL when the context's version does not promise it or it does not resolve.
#define TSU_I_GL_FIELD(gl, es, type, name, parameters) type(TSU_I_GL_CALL *name) parameters;
    TSU_I_GL_ENTRIES(TSU_I_GL_FIELD)
#undef TSU_I_GL_FIELD
    int32_t es;      // 1 for GL ES
    int32_t version; // 10 * major + minor
    int32_t direct;  // 1 when every entry point of GL 4.5 in the list is there
    int32_t max_texture_size, max_units, max_bindings;
};

// Fill `*api` for the current context: everything but the limits.
// Errors: TSU_E_UNSUPPORTED, with a log line that says what is missing or too old.
tsu_status tsu_i_load_entries(const tsu_context *context, tsu_gl_proc_fn proc, void *user,
                              struct tsu_i_gl_api *api);

// Read the limits.
void tsu_i_load_limits(struct tsu_i_gl_api *api);

#endif

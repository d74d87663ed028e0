// A loader between the library and GL: counts every call, and lies on demand.
#ifndef TSUYA_TESTS_GL_COUNTED_H
#define TSUYA_TESTS_GL_COUNTED_H

#include "gl/entry.h"

#include <stddef.h>

struct counted {
    // The real loader; counted_open() sets it.
    void *(*proc)(void *user, const char *name);
    void *user;

    // Lies; all zero is the truth.
    int nothing;          // resolve no name
    const char *hide;     // resolve this name to NULL
    int fake_version;     // answer GL_VERSION with `version`
    const char *version;  // may be NULL
    int max_texture_size; // answer GL_MAX_TEXTURE_SIZE with it
    int no_textures;      // give the name 0 for every new texture
    int no_buffers;       // likewise
    int bad_unit;         // bind samplers to a unit that is not there: an error of GL
    unsigned stuck;       // answer glGetError with it, always

    // Since counted_reset().
    unsigned calls;                   // of any entry point
    unsigned gets;                    // of them glGetError
    unsigned uploads;                 // of them gl*SubImage2D and gl*BufferSubData
    unsigned long long texels, bytes; // sent by those
    unsigned resolved;                // names asked for
};
extern struct counted counted;

void counted_open(void *(*proc)(void *user, const char *name), void *user);
// No lies, all counts zero.
void counted_reset(void);
// Hand this to tsu_gl_create(); `user` is not read.
void *counted_proc(void *user, const char *name);
// Calls of one entry point since counted_reset().
unsigned counted_calls(const char *name);
// Name of entry point `index` and whether both GL 3.3 and ES 3.0 have it; NULL past the last.
const char *counted_name(size_t index, int *required);

#endif

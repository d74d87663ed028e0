// The object behind tsu_gl, and the error drain of TSU_GL_CHECK.
#ifndef TSU_GL_OBJECT_H
#define TSU_GL_OBJECT_H

#include "gl/load.h"

struct tsu_gl {
    const tsu_context *context;
    uint32_t flags;
    struct tsu_i_gl_api api;

    uint64_t set_id; // of the set that was synced last; 0 before the first sync
    uint64_t generation, texture_generation; // of that set then
    uint32_t texture, width, height;         // 0 before the first sync of a set with pages
    uint32_t buffer, page_capacity, page_count;
};

// With TSU_GL_CHECK: take the pending GL errors, at most 32, and log them in one line as the
// host's; end: as raised in `function`. Otherwise nothing.
void tsu_i_object_begin(const tsu_gl *gl, const char *function);
void tsu_i_object_end(const tsu_gl *gl, const char *function);

#endif

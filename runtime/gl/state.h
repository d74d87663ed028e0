// What an upload borrows from the host's GL state, and gives back.
//
// Nothing is remembered from one call to the next: each begin reads the state, its end restores it.
#ifndef TSU_GL_STATE_H
#define TSU_GL_STATE_H

#include "gl/load.h"

enum { TSU_I_STATE_UNPACK = 8 };

struct tsu_i_state {
    int32_t unpack_buffer;
    int32_t unpack[TSU_I_STATE_UNPACK];
    int32_t texture; // 2-D, of the active unit; only without direct access
    int32_t uniform_buffer;
};

// Before texels are sent from our memory: no unpack buffer, rows `row_length` texels apart, nothing
// skipped or swapped. Without direct access the caller may then bind a 2-D texture.
void tsu_i_state_begin_texture(const struct tsu_i_gl_api *api, struct tsu_i_state *state,
                               uint32_t row_length);
void tsu_i_state_end_texture(const struct tsu_i_gl_api *api, const struct tsu_i_state *state);

// Without direct access: the caller may then bind a buffer to UNIFORM_BUFFER. With it: nothing.
void tsu_i_state_begin_buffer(const struct tsu_i_gl_api *api, struct tsu_i_state *state);
void tsu_i_state_end_buffer(const struct tsu_i_gl_api *api, const struct tsu_i_state *state);

#endif

// The guest in the host's GL: uploads and binds a set through the host's own entry points.
//
// Needs GL 3.3 core or GL ES 3.0. Links no GL and includes no GL header. Draws nothing, compiles
// nothing, never calls glGetError (except under TSU_GL_CHECK) and keeps no copy of host state.
//
// State contract
//   tsu_gl_create, tsu_gl_bindings   touch nothing
//   tsu_gl_sync    when nothing changed: no GL call. Otherwise it saves, sets and restores
//                  PIXEL_UNPACK_BUFFER, UNPACK_{ALIGNMENT, ROW_LENGTH, IMAGE_HEIGHT, SKIP_PIXELS,
//                  SKIP_ROWS, SKIP_IMAGES} and, where it exists, UNPACK_SWAP_BYTES,
//                  UNPACK_LSB_FIRST, the 2-D texture of the active unit (not with direct state
//                  access), and the generic UNIFORM_BUFFER binding
//   tsu_gl_program_setup   saves, sets and restores CURRENT_PROGRAM (not on 4.1 and later, where
//                  the program is written without being current), sets tsu_tables and the block
//                  binding
//   tsu_gl_bind    leaves bound: the texture and no sampler object on `unit`, one page on
//                  `block_binding`. The active unit is as before. Below GL 4.4 the generic
//                  UNIFORM_BUFFER binding is left on our buffer, as glBindBufferRange does
//   tsu_gl_destroy deletes our names; GL unbinds them where they were bound
// Everything else is as it was, which a test with a hostile host checks.
//
// Threads: `context`: the GL context of create, or one of its share group, is current.
#ifndef TSUYA_GL_H
#define TSUYA_GL_H

#include <tsuya/set.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_gl tsu_gl;

// Host's loader: address of a GL function by name, or NULL.
typedef void *(*tsu_gl_proc_fn)(void *user, const char *name);

enum {
    // Drain GL errors on entry (logged as the host's) and on exit (as ours), at most 32 each.
    TSU_GL_CHECK = 1
};

typedef struct tsu_gl_desc {
    uint32_t struct_size;            // set by tsu_gl_desc_init()
    uint32_t flags;                  // TSU_GL_* bits
    tsu_gl_proc_fn get_proc_address; // required; used during create only
    void *user;
} tsu_gl_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_gl_desc_init_sized(tsu_gl_desc *desc, size_t size);
#define tsu_gl_desc_init(desc) tsu_gl_desc_init_sized((desc), sizeof *(desc))

// Resolve every entry point, read version and limits. Makes no GL object.
// Errors: TSU_E_STRUCT, TSU_E_PARAMETER (no get_proc_address), TSU_E_UNSUPPORTED (missing entry
// points, named in one log line, or a context older than GL 3.3 / ES 3.0), TSU_E_MEMORY.
// Threads: context.
TSU_API tsu_status tsu_gl_create(tsu_context *context, const tsu_gl_desc *desc, tsu_gl **out);
// Delete our GL names and free. NULL is fine. Threads: context.
TSU_API void tsu_gl_destroy(tsu_gl *gl);
// Free without a GL call, for a context that is already gone. NULL is fine. Threads: object.
TSU_API void tsu_gl_abandon(tsu_gl *gl);

// Upload what changed in `set` since the last call with it: new and re-baked tables, changed pages.
// One tsu_gl serves one set at a time; another set uploads everything anew. Makes no GL call and
// no allocation when nothing changed. A texture that grows gets a new name, the buffer keeps its.
// Errors: TSU_E_STATE (stale tables: bake first), TSU_E_LIMIT (texture larger than
// GL_MAX_TEXTURE_SIZE, named), TSU_E_PARAMETER (NULL), TSU_E_MEMORY. Threads: context.
TSU_API tsu_status tsu_gl_sync(tsu_gl *gl, const tsu_set *set);

// Once after a program is linked: sampler tsu_tables to `unit`, block tsu_materials to
// `block_binding`. A program without them is left alone.
// Errors: TSU_E_LIMIT (unit or binding past the context's limits, named), TSU_E_PARAMETER.
// Threads: context.
TSU_API tsu_status tsu_gl_program_setup(tsu_gl *gl, uint32_t program, uint32_t unit,
                                        uint32_t block_binding);

// Bind texture and page for a batch: at most 3 GL calls on GL 4.5, 6 on GL 3.3 and ES 3.
// Errors: TSU_E_STATE (not synced), TSU_E_PARAMETER (no such page), TSU_E_LIMIT.
// Threads: context.
TSU_API tsu_status tsu_gl_bind(tsu_gl *gl, uint32_t page, uint32_t unit, uint32_t block_binding);

// The same as data, for a host with its own state cache: bind `texture` (GL_TEXTURE_2D, linear
// filter, clamped, one level) with sampler 0 and `buffer` from `offset` for `size` bytes.
typedef struct tsu_gl_bindings_info {
    uint32_t struct_size; // set by tsu_gl_bindings_init()
    uint32_t flags;       // 0
    uint32_t texture, buffer;
    uint64_t offset, size;
} tsu_gl_bindings_info;
#define tsu_gl_bindings_init(info) tsu_info_init_sized((info), sizeof *(info))
// Errors as tsu_gl_bind(). Makes no GL call. Threads: object.
TSU_API tsu_status tsu_gl_bindings(const tsu_gl *gl, uint32_t page, tsu_gl_bindings_info *out);

#ifdef __cplusplus
}
#endif
#endif

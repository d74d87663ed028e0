// A context holds the host's callbacks and numbers the sets made from it. Two contexts never meet.
#ifndef TSUYA_CONTEXT_H
#define TSUYA_CONTEXT_H

#include <tsuya/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_context tsu_context;

// How to make a context. Every callback may be NULL; `user` pointers are handed back unread.
typedef struct tsu_context_desc {
    uint32_t struct_size;     // set by tsu_context_desc_init()
    uint32_t flags;           // 0
    uint32_t version;         // TSU_VERSION of the header; set by tsu_context_desc_init()
    uint32_t reserved;        // 0
    tsu_allocate_fn allocate; // NULL: malloc family
    void *allocate_user;
    tsu_log_fn log; // NULL: silence, the status still tells
    void *log_user;
    tsu_jobs_fn jobs; // NULL: in the calling thread
    void *jobs_user;
    tsu_read_fn read; // NULL: embedded GLSL
    void *read_user;
} tsu_context_desc;

// Fill `*desc` with defaults; use the macro, which passes the size and the version that the
// program was compiled with.
// Errors: TSU_E_STRUCT when `size` is smaller than the first released layout or `desc` is NULL.
// Threads: any.
TSU_API tsu_status tsu_context_desc_init_sized(tsu_context_desc *desc, size_t size,
                                               uint32_t version);
#define tsu_context_desc_init(desc) tsu_context_desc_init_sized((desc), sizeof *(desc), TSU_VERSION)

// Make a context; `desc` is copied. *out is NULL on failure.
// Errors: TSU_E_STRUCT, TSU_E_VERSION, TSU_E_PARAMETER (unknown flag, NULL out), TSU_E_MEMORY.
// Threads: any.
TSU_API tsu_status tsu_context_create(const tsu_context_desc *desc, tsu_context **out);

// Free a context; NULL is fine. Destroy what was made from it first.
// Threads: object.
TSU_API void tsu_context_destroy(tsu_context *context);

#ifdef __cplusplus
}
#endif
#endif

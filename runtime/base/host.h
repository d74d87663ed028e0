// The host's callbacks as the floors use them: memory, log, jobs.
#ifndef TSU_BASE_HOST_H
#define TSU_BASE_HOST_H

#include <tsuya/context.h>

struct tsu_context {
    tsu_context_desc desc;
    uint64_t sets; // made so far
};

// Zeroed memory, NULL when `count * size` overflows or the host has none (logged).
void *tsu_i_alloc(const tsu_context *context, size_t count, size_t size);
// Grow or shrink; new bytes are zero. NULL leaves `pointer` as it was.
void *tsu_i_realloc(const tsu_context *context, void *pointer, size_t old_count, size_t count,
                    size_t size);
void tsu_i_free(const tsu_context *context, void *pointer, size_t count, size_t size);

// One line to the host's logger, prefixed "[Ennnn] ". `context` may be NULL. Understands %s %d %u
// %g %% only (%d int, %u unsigned, %g double in at most 9 digits, always with a point).
void tsu_i_log(const tsu_context *context, int32_t level, int32_t code, const char *format, ...);

// Run job(data, i) for i < count on the host's jobs, or here.
void tsu_i_jobs(const tsu_context *context, void (*job)(void *, uint32_t), void *data,
                uint32_t count);

// Codes of log lines; append only.
enum {
    TSU_LOG_MEMORY = 1,
    TSU_LOG_STRUCT = 2,
    TSU_LOG_VERSION = 3,
    TSU_LOG_FLAGS = 4,
    TSU_LOG_NULL = 5,
    TSU_LOG_PARAMETER = 10,
    TSU_LOG_INPUT = 11,
    TSU_LOG_INDEX = 12,
    TSU_LOG_TEXTURE_LIMIT = 20,
    TSU_LOG_MATERIAL_LIMIT = 21,
    TSU_LOG_STALE = 22,
    TSU_LOG_CACHE = 23,
    TSU_LOG_SHADER = 30,
    TSU_LOG_SNIPPET = 31,
    TSU_LOG_GL_MISSING = 40,
    TSU_LOG_GL_VERSION = 41,
    TSU_LOG_GL_LIMIT = 42,
    TSU_LOG_GL_STATE = 43,
    TSU_LOG_GL_ERROR = 44,
    TSU_LOG_COLOR = 50,
    TSU_LOG_HAIR_SHADOW = 60,
    TSU_LOG_LIGHT = 61,
    TSU_LOG_LEAF = 70,
    TSU_LOG_CHOOSE = 80
};

#endif

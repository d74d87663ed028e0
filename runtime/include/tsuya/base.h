// Version, status codes, host callbacks: what every other header needs.
//
// Conventions of the whole library
//   angles      radians, named for what they are (theta_i, theta_d, phi); never degrees
//   colour      linear, Rec. 709 primaries, D65 white
//   absorption  sigma_a per fibre radius, >= 0
//   directions  unit vectors that point away from the surface point
//   strings     UTF-8, owned by the library unless a function says otherwise
//
// Errors: a fallible function returns a tsu_status, 0 for success and negative otherwise, and says
// why in one log line that names the field and the allowed range. After a failure every object is
// as it was before the call and every result is zeroed.
//
// Threads: each function carries one of three words. `any`: no shared state. `object`: calls on one
// object must not overlap. `context`: as `object`, and the GL context must be current.
#ifndef TSUYA_BASE_H
#define TSUYA_BASE_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(TSU_BUILD_SHARED)
#define TSU_API __declspec(dllexport)
#elif defined(_WIN32) && defined(TSU_USE_SHARED)
#define TSU_API __declspec(dllimport)
#elif defined(__GNUC__)
#define TSU_API __attribute__((visibility("default")))
#else
#define TSU_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define TSU_VERSION_MAJOR 0
#define TSU_VERSION_MINOR 1
#define TSU_VERSION_PATCH 0
#define TSU_VERSION                                                                               \
    (((uint32_t)TSU_VERSION_MAJOR << 22) | ((uint32_t)TSU_VERSION_MINOR << 12) |                  \
     (uint32_t)TSU_VERSION_PATCH)

// Version of the library that runs, packed as TSU_VERSION.
// Threads: any.
TSU_API uint32_t tsu_version(void);

// 0 is success, every failure is negative. Values are never renumbered.
typedef int32_t tsu_status;
enum {
    TSU_OK = 0,
    TSU_E_PARAMETER = -1,   // a value is not finite, out of range, or names nothing
    TSU_E_STRUCT = -2,      // struct_size is 0 (init was not called) or from a newer library
    TSU_E_VERSION = -3,     // header and library differ in major version
    TSU_E_MEMORY = -4,      // the host's allocator returned NULL
    TSU_E_LIMIT = -5,       // a limit of the host or of GL is exceeded; the log names it
    TSU_E_UNSUPPORTED = -6, // the GL context is too old or an entry point is missing
    TSU_E_STATE = -7,       // the call does not fit the object's state (bake first, ...)
    TSU_E_HOST = -8         // a host callback failed
};

// Name of a status ("TSU_E_LIMIT"); "unknown status" for other values.
// Threads: any.
TSU_API const char *tsu_status_text(tsu_status status);

// Log levels.
enum { TSU_LOG_ERROR = 1, TSU_LOG_WARNING = 2, TSU_LOG_INFO = 3 };

// Host allocator in the manner of realloc: `pointer` NULL allocates, `size` 0 frees and returns
// NULL. `old_size` is what was asked for before. Alignment as malloc. May return NULL.
typedef void *(*tsu_allocate_fn)(void *user, void *pointer, size_t old_size, size_t size);

// Host logger. `code` is the fine, stable number of the message; `text` is one line without a line
// end, valid during the call. May come from a job thread; never called while a lock is held.
typedef void (*tsu_log_fn)(void *user, int32_t level, int32_t code, const char *text);

// Host job system: call job(data, i) once for every i < count, in any order, on any threads, and
// return when all are done. Without it the library runs them one after the other.
typedef void (*tsu_jobs_fn)(void *user, void (*job)(void *data, uint32_t index), void *data,
                            uint32_t count);

// Host file source for GLSL snippets, for hot reload: set *text and *size for `name` (such as
// "marschner/eval.glsl") and return 1, or return 0 to use the embedded text. The bytes must stay
// valid until the next call or the end of the library call. The library itself opens no file.
typedef int32_t (*tsu_read_fn)(void *user, const char *name, const char **text, size_t *size);

#ifdef __cplusplus
}
#endif
#endif

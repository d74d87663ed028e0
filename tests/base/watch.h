// A host that watches: every block of memory with its size, every line of the log.
//
//   struct watch w;
//   tsu_context *context = watch_open(&w);   // allocator and logger are the watch's
//   ...
//   tsu_context_destroy(context);
//   watch_close(&w);                          // asserts: nothing left, no size ever wrong
//
// Not for allocation from several threads at once; the library makes none from its jobs.
#ifndef TSUYA_TESTS_BASE_WATCH_H
#define TSUYA_TESTS_BASE_WATCH_H

#include <tsuya/tsuya.h>

enum { WATCH_BLOCKS = 1024 };

struct watch {
    struct {
        void *pointer;
        size_t size;
    } blocks[WATCH_BLOCKS];
    size_t live, bytes;
    long calls;       // that asked for memory, failed ones included
    long fail_at;     // this call and no other gets NULL; 0: none
    long wrong_sizes; // old_size differed from what was asked for, or the block is not ours
    long log_count;
    int32_t log_level, log_code;
    char log[512]; // the last line
};

void watch_begin(struct watch *w);
void *watch_allocate(void *user, void *pointer, size_t old_size, size_t size);
void watch_log(void *user, int32_t level, int32_t code, const char *text);

// A descriptor with the watch's allocator and logger.
tsu_context_desc watch_desc(struct watch *w);
// Begins the watch and makes a context on it.
tsu_context *watch_open(struct watch *w);
void watch_close(const struct watch *w);
// Forgets the last line, so that the next one is known to be new.
void watch_quiet(struct watch *w);

#endif

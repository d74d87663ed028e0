#include "watch.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

void watch_begin(struct watch *w)
{
    memset(w, 0, sizeof *w);
}

static size_t find(const struct watch *w, const void *pointer)
{
    size_t i = 0;
    while (i < WATCH_BLOCKS && w->blocks[i].pointer != pointer)
        i++;
    return i;
}

static void forget(struct watch *w, size_t at)
{
    w->bytes -= w->blocks[at].size;
    w->live--;
    w->blocks[at].pointer = NULL;
    w->blocks[at].size = 0;
}

void *watch_allocate(void *user, void *pointer, size_t old_size, size_t size)
{
    struct watch *w = user;
    size_t at = WATCH_BLOCKS;
    if (pointer) {
        at = find(w, pointer);
        if (at == WATCH_BLOCKS || w->blocks[at].size != old_size) {
            w->wrong_sizes++;
            return NULL;
        }
    } else if (old_size) {
        w->wrong_sizes++;
    }
    if (size == 0) {
        if (pointer)
            forget(w, at);
        free(pointer);
        return NULL;
    }
    if (++w->calls == w->fail_at)
        return NULL;
    // Never in place, never zero: a stale pointer or a trusted zero shows.
    void *fresh = malloc(size);
    if (!fresh)
        return NULL;
    memset(fresh, 0xa5, size);
    if (pointer) {
        memcpy(fresh, pointer, old_size < size ? old_size : size);
        forget(w, at);
        free(pointer);
    }
    at = find(w, NULL);
    if (at == WATCH_BLOCKS) {
        free(fresh);
        return NULL;
    }
    w->blocks[at].pointer = fresh;
    w->blocks[at].size = size;
    w->live++;
    w->bytes += size;
    return fresh;
}

void watch_log(void *user, int32_t level, int32_t code, const char *text)
{
    struct watch *w = user;
    w->log_count++;
    w->log_level = level;
    w->log_code = code;
    strncpy(w->log, text, sizeof w->log - 1);
    w->log[sizeof w->log - 1] = 0;
}

tsu_context_desc watch_desc(struct watch *w)
{
    tsu_context_desc desc;
    assert_int_equal(tsu_context_desc_init(&desc), TSU_OK);
    desc.allocate = watch_allocate;
    desc.allocate_user = w;
    desc.log = watch_log;
    desc.log_user = w;
    return desc;
}

tsu_context *watch_open(struct watch *w)
{
    watch_begin(w);
    const tsu_context_desc desc = watch_desc(w);
    tsu_context *context = NULL;
    assert_int_equal(tsu_context_create(&desc, &context), TSU_OK);
    assert_non_null(context);
    return context;
}

void watch_close(const struct watch *w)
{
    assert_int_equal(w->wrong_sizes, 0);
    assert_int_equal(w->live, 0);
    assert_int_equal(w->bytes, 0);
}

void watch_quiet(struct watch *w)
{
    w->log_count = 0;
    w->log_code = 0;
    w->log[0] = 0;
}

// A context that is watched (watch.h), for tests that want one each: set up by open_watch, taken
// down by close_watch.
#ifndef TSUYA_TESTS_BASE_WATCHED_H
#define TSUYA_TESTS_BASE_WATCHED_H

#include "watch.h"

extern struct watch watch;
extern tsu_context *context;

int open_watch(void **state);
int close_watch(void **state);

#endif

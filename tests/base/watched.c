#include "watched.h"

struct watch watch;
tsu_context *context;

int open_watch(void **state)
{
    (void)state;
    context = watch_open(&watch);
    return 0;
}

int close_watch(void **state)
{
    (void)state;
    tsu_context_destroy(context);
    watch_close(&watch);
    return 0;
}

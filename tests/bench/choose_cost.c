// Times the chooser on one core: ns a call, median of many batches, for each kind of wish. Judged
// by no test; the bound that tsuya/choose.h states is 2000 ns. Run: bench_choose
#define _POSIX_C_SOURCE 199309L

#include <tsuya/tsuya.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { RUNS = 1001, CALLS = 50 };

static double now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void measure(tsu_context *context, const char *what, tsu_choose_desc desc)
{
    static double times[RUNS];
    tsu_choice choice;
    tsu_choice_init(&choice);
    for (int i = 0; i < RUNS; i++) {
        const double start = now_ns();
        for (int k = 0; k < CALLS; k++) {
            desc.depth = 5.0f + 0.01f * (float)k;
            desc.R_top[0] = 0.04f + 1e-5f * (float)k;
            desc.previous = choice.struct_size && k ? choice.tier : TSU_TIER_NONE;
            if (tsu_choose(context, &desc, &choice) != TSU_OK)
                exit(EXIT_FAILURE);
        }
        times[i] = (now_ns() - start) / CALLS;
    }
    qsort(times, RUNS, sizeof *times, ascending);
    printf("%-34s least %6.0f ns, median %6.0f ns\n", what, times[0], times[RUNS / 2]);
}

int main(void)
{
    tsu_context_desc context_desc;
    tsu_context *context;
    tsu_choose_desc desc;
    tsu_context_desc_init(&context_desc);
    if (tsu_context_create(&context_desc, &context) != TSU_OK)
        return EXIT_FAILURE;
    tsu_choose_desc_init(&desc);
    measure(context, "hair, no wish", desc);
    desc.error_bound = 0.4f;
    measure(context, "hair, a bound", desc);
    desc.luminance_bound = 0.2f;
    desc.cost_budget = 400.0f;
    measure(context, "hair, two bounds and a budget", desc);
    desc.kind = TSU_CHOOSE_LEAF;
    desc.flags = TSU_CHOOSE_BACKLIT;
    measure(context, "leaf, two bounds and a budget", desc);
    tsu_context_destroy(context);
    return EXIT_SUCCESS;
}

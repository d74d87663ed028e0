// Times what a host waits for, on one core: baking a material, changing one, asking an unchanged
// set. Prints medians of many; times nothing that a test would judge. Run: bench_bake
#define _POSIX_C_SOURCE 199309L

#include <tsuya/tsuya.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { RUNS = 31 };

static double now_us(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e6 + (double)t.tv_nsec * 1e-3;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print(const char *what, double *times, const char *unit, double scale)
{
    qsort(times, RUNS, sizeof *times, ascending);
    printf("%-46s median %8.3f %s, slowest %8.3f\n", what, times[RUNS / 2] * scale, unit,
           times[RUNS - 1] * scale);
}

static void require(tsu_status status)
{
    if (status != TSU_OK) {
        fprintf(stderr, "%s\n", tsu_status_text(status));
        exit(1);
    }
}

static void bake_with(tsu_context *context, float beta_az)
{
    double times[RUNS];
    char what[64];
    for (int i = 0; i < RUNS; i++) {
        tsu_set_desc desc;
        tsu_set *set;
        tsu_marschner_params params;
        uint32_t material;
        tsu_set_desc_init(&desc);
        require(tsu_set_create(context, &desc, &set));
        tsu_marschner_params_init(&params);
        params.beta_az = beta_az;
        params.eta = 1.3f + 0.015f * (float)i;
        require(tsu_set_add(set, tsu_marschner(), &params, &material));
        const double start = now_us();
        require(tsu_set_bake(set));
        times[i] = now_us() - start;
        tsu_set_destroy(set);
    }
    snprintf(what, sizeof what, "bake of one marschner, beta_az %.0f degrees",
             (double)beta_az * 57.29578);
    print(what, times, "ms", 1e-3);
}

static void bake_leaf(tsu_context *context)
{
    double times[RUNS];
    for (int i = 0; i < RUNS; i++) {
        tsu_set_desc desc;
        tsu_set *set;
        tsu_leaf_params params;
        uint32_t material;
        tsu_set_desc_init(&desc);
        require(tsu_set_create(context, &desc, &set));
        tsu_leaf_params_init(&params);
        params.n = 1.35f + 0.007f * (float)i;
        require(tsu_set_add(set, tsu_leaf(), &params, &material));
        const double start = now_us();
        require(tsu_set_bake(set));
        times[i] = now_us() - start;
        tsu_set_destroy(set);
    }
    print("bake of one leaf", times, "ms", 1e-3);

    tsu_set_desc desc;
    tsu_set *set;
    tsu_leaf_params params;
    uint32_t material;
    float numbers[72];
    tsu_set_desc_init(&desc);
    require(tsu_set_create(context, &desc, &set));
    tsu_leaf_params_init(&params);
    require(tsu_set_add(set, tsu_leaf(), &params, &material));
    require(tsu_set_bake(set));
    for (int i = 0; i < RUNS; i++) {
        params.pigment = 0.3f + 0.05f * (float)i;
        const double start = now_us();
        require(tsu_set_update(set, material, &params, NULL));
        times[i] = now_us() - start;
    }
    print("another pigment for a leaf, no bake", times, "us", 1.0);
    for (int i = 0; i < RUNS; i++) {
        const double start = now_us();
        require(tsu_leaf_body_uniform(set, material, 1.0f, 1.0f, numbers));
        times[i] = now_us() - start;
    }
    print("a leaf's numbers for uniforms", times, "us", 1.0);
    tsu_set_destroy(set);
}

int main(void)
{
    tsu_context_desc desc;
    tsu_context *context;
    tsu_context_desc_init(&desc);
    require(tsu_context_create(&desc, &context));
    for (float degrees = 5.0001f; degrees < 30.0f; degrees += 5.0f)
        bake_with(context, degrees / 57.29578f);

    bake_leaf(context);

    tsu_set_desc set_desc;
    tsu_set *set;
    tsu_marschner_params params;
    uint32_t material;
    double times[RUNS];
    tsu_set_desc_init(&set_desc);
    require(tsu_set_create(context, &set_desc, &set));
    tsu_marschner_params_init(&params);
    require(tsu_set_add(set, tsu_marschner(), &params, &material));
    require(tsu_set_bake(set));
    for (int i = 0; i < RUNS; i++) {
        const double start = now_us();
        for (int k = 0; k < 1000; k++) {
            params.alpha_R = -0.1f + 1e-4f * (float)k;
            require(tsu_set_update(set, material, &params, NULL));
            require(tsu_set_bake(set));
        }
        times[i] = (now_us() - start) / 1000.0;
    }
    print("change of colour, shift or roughness", times, "us", 1.0);
    for (int i = 0; i < RUNS; i++) {
        const double start = now_us();
        for (int k = 0; k < 1000; k++) {
            tsu_set_info info;
            tsu_set_info_init(&info);
            require(tsu_set_describe(set, &info));
        }
        times[i] = (now_us() - start) / 1000.0;
    }
    print("unchanged set, per frame", times, "ns", 1e3);
    tsu_set_destroy(set);
    tsu_context_destroy(context);
    return 0;
}

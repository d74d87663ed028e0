#include "sweep.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check(tsu_status status, const char *what)
{
    if (status != TSU_OK) {
        fprintf(stderr, "%s: %s\n", what, tsu_status_text(status));
        exit(1);
    }
}

void sweep_open(struct sweep *sweep, uint64_t seed)
{
    tsu_context_desc context;
    tsu_set_desc set;
    tsu_context_desc_init(&context);
    check(tsu_context_create(&context, &sweep->context), "context");
    tsu_set_desc_init(&set);
    check(tsu_set_create(sweep->context, &set, &sweep->set), "set");
    sweep->random = seed;
}

void sweep_close(struct sweep *sweep)
{
    tsu_set_destroy(sweep->set);
    tsu_context_destroy(sweep->context);
}

double sweep_between(struct sweep *sweep, double low, double high)
{
    // SplitMix64.
    uint64_t z = sweep->random += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * (double)(z >> 11) * 0x1p-53;
}

double sweep_corner(struct sweep *sweep, double low, double high)
{
    const double draw = sweep_between(sweep, 0.0, 5.0);
    return draw < 1.0 ? low : draw < 2.0 ? high : sweep_between(sweep, low, high);
}

double sweep_degrees(struct sweep *sweep, double low, double high)
{
    return sweep_between(sweep, low, high) * 0.0174532925199432958;
}

int sweep_material(struct sweep *sweep, const tsu_model *model, uint32_t function, const double *in)
{
    double params[32]; // room and alignment for any typed struct
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_set_info held;
    tsu_set_info_init(&held);
    check(tsu_model_describe(model, &info), "describe");
    check(tsu_model_params_init(model, params, info.params_size), "params");
    check(tsu_function_params(sweep->context, model, function, in, params), "function params");
    check(tsu_set_describe(sweep->set, &held), "describe set");
    uint32_t material = 0;
    if (held.material_count)
        check(tsu_set_remove(sweep->set, 0), "remove");
    check(tsu_set_add(sweep->set, model, params, &material), "add");
    check(tsu_set_bake(sweep->set), "bake");
    return material == 0;
}

void sweep_table(struct sweep *sweep, uint32_t function, const double *in, double *out)
{
    check(tsu_set_evaluate(sweep->set, 0, function, in, out), "evaluate");
}

void sweep_reference(struct sweep *sweep, const tsu_model *model, uint32_t function,
                     const double *in, double *out)
{
    check(tsu_function_reference(sweep->context, model, function, in, out), "reference");
}

double sweep_stated(const tsu_model *model, const char *name)
{
    tsu_error_info error;
    tsu_error_info_init(&error);
    for (uint32_t i = 0; tsu_model_error(model, i, &error) == TSU_OK; i++)
        if (strcmp(error.name, name) == 0)
            return error.value;
    return -1.0;
}

#include "api/params.h"
#include "base/desc.h"
#include "base/host.h"
#include "optics/leaf_inverse.h"
#include "optics/leaf_presets.h"
#include "optics/spectrum.h"

#include <tsuya/leaf.h>
#include <tsuya/models/leaf_body.h>

#include <math.h>
#include <string.h>

enum { MATURE = 1 }; // the preset that is the default

static void fill(const struct tsu_i_leaf_preset *leaf, tsu_leaf_pigments *out)
{
    *out = (tsu_leaf_pigments){.struct_size = sizeof *out,
                               .N = leaf->contents.N,
                               .chlorophyll = leaf->contents.chlorophyll,
                               .carotenoids = leaf->contents.carotenoids,
                               .anthocyanins = leaf->contents.anthocyanins,
                               .brown = leaf->contents.brown,
                               .water = leaf->contents.water,
                               .dry_matter = leaf->contents.dry_matter,
                               .n = 1.45,
                               .bottom = TSU_I_LEAF_PRESET_RATIO};
}

tsu_status tsu_leaf_pigments_init_sized(tsu_leaf_pigments *pigments, size_t size)
{
    tsu_leaf_pigments defaults;
    fill(tsu_i_leaf_presets + MATURE, &defaults);
    return tsu_i_desc_init(pigments, size, &defaults, sizeof defaults, sizeof defaults);
}

tsu_status tsu_leaf_reflectance_init_sized(tsu_leaf_reflectance *reflectance, size_t size)
{
    const tsu_leaf_reflectance defaults = {.struct_size = sizeof defaults, .n = 1.45};
    return tsu_i_desc_init(reflectance, size, &defaults, sizeof defaults, sizeof defaults);
}

uint32_t tsu_leaf_preset_count(void)
{
    return TSU_I_LEAF_PRESETS;
}

const char *tsu_leaf_preset_name(uint32_t index)
{
    return index < tsu_leaf_preset_count() ? tsu_i_leaf_presets[index].name : NULL;
}

tsu_status tsu_leaf_preset(uint32_t index, tsu_leaf_pigments *out)
{
    if (index >= tsu_leaf_preset_count())
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    tsu_leaf_pigments own;
    fill(tsu_i_leaf_presets + index, &own);
    return tsu_i_desc_write(out, &own, sizeof own);
}

static tsu_status out_of_range(const tsu_context *context, const char *field, double value,
                               double low, double high)
{
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF, "%s = %g, expected [%g, %g]", field, value, low,
              high);
    return TSU_E_PARAMETER;
}

static tsu_status read_pigments(const tsu_context *context, const tsu_leaf_pigments *pigments,
                                tsu_leaf_pigments *own, struct tsu_i_prospect *leaf)
{
    const tsu_status status =
        tsu_i_desc_read(context, "tsu_leaf_pigments", pigments, own, sizeof *own, sizeof *own);
    if (status != TSU_OK)
        return status;
    if (own->flags) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS, "tsu_leaf_pigments.flags = %u, expected 0",
                  own->flags);
        return TSU_E_PARAMETER;
    }
    const struct {
        const char *field;
        double value, low, high;
    } ranges[] = {{"tsu_leaf_pigments.N", own->N, 1, 10},
                  {"tsu_leaf_pigments.chlorophyll", own->chlorophyll, 0, 1e6},
                  {"tsu_leaf_pigments.carotenoids", own->carotenoids, 0, 1e6},
                  {"tsu_leaf_pigments.anthocyanins", own->anthocyanins, 0, 1e6},
                  {"tsu_leaf_pigments.brown", own->brown, 0, 1e6},
                  {"tsu_leaf_pigments.water", own->water, 0, 1e6},
                  {"tsu_leaf_pigments.dry_matter", own->dry_matter, 0, 1e6},
                  {"tsu_leaf_pigments.n", own->n, 1.2, 1.8},
                  {"tsu_leaf_pigments.bottom", own->bottom, 0.25, 4}};
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        if (!(ranges[i].value >= ranges[i].low && ranges[i].value <= ranges[i].high))
            return out_of_range(context, ranges[i].field, ranges[i].value, ranges[i].low,
                                ranges[i].high);
    *leaf = (struct tsu_i_prospect){.N = own->N,
                                    .chlorophyll = own->chlorophyll,
                                    .carotenoids = own->carotenoids,
                                    .anthocyanins = own->anthocyanins,
                                    .brown = own->brown,
                                    .water = own->water,
                                    .dry_matter = own->dry_matter};
    return TSU_OK;
}

tsu_status tsu_leaf_spectrum(tsu_context *context, const tsu_leaf_pigments *pigments, double lambda,
                             double *R, double *T)
{
    if (!R || !T)
        return TSU_E_PARAMETER;
    *R = *T = 0.0;
    tsu_leaf_pigments own;
    struct tsu_i_prospect leaf;
    const tsu_status status = read_pigments(context, pigments, &own, &leaf);
    if (status != TSU_OK)
        return status;
    const double last = TSU_I_SPECTRUM_FIRST + TSU_I_SPECTRUM_STEP * (TSU_I_SPECTRUM_POINTS - 1);
    if (!(lambda >= TSU_I_SPECTRUM_FIRST && lambda <= last))
        return out_of_range(context, "lambda", lambda, TSU_I_SPECTRUM_FIRST, last);
    tsu_i_prospect_leaf(&leaf, lambda, R, T);
    return TSU_OK;
}

static void color(const struct tsu_i_prospect *leaf, double R[3], double T[3])
{
    double r[TSU_I_SPECTRUM_POINTS], t[TSU_I_SPECTRUM_POINTS];
    tsu_i_prospect_spectrum(leaf, r, t);
    tsu_i_spectrum_rgb(r, R);
    tsu_i_spectrum_rgb(t, T);
}

tsu_status tsu_leaf_color(tsu_context *context, const tsu_leaf_pigments *pigments, double R[3],
                          double T[3])
{
    if (!R || !T)
        return TSU_E_PARAMETER;
    R[0] = R[1] = R[2] = T[0] = T[1] = T[2] = 0.0;
    tsu_leaf_pigments own;
    struct tsu_i_prospect leaf;
    const tsu_status status = read_pigments(context, pigments, &own, &leaf);
    if (status == TSU_OK)
        color(&leaf, R, T);
    return status;
}

// Three channels at work, each in memory of its own.
struct work {
    struct tsu_i_leaf_question asked[3];
    struct tsu_i_leaf_layers layers[3]; // for measuring
    struct tsu_i_leaf_inverse found[3];
    double *memory;
    void (*solve)(const struct tsu_i_leaf_question *, struct tsu_i_leaf_inverse *, double *);
};

static void solve_channel(void *data, uint32_t k)
{
    struct work *work = data;
    double *memory = work->memory + k * tsu_i_leaf_inverse_doubles();
    if (work->solve)
        work->solve(work->asked + k, work->found + k, memory);
    else
        tsu_i_leaf_solve(work->asked[k].n, TSU_LEAF_G, work->layers + k, &work->found[k].faces,
                         memory);
}

static tsu_status solve(const tsu_context *context, struct work *work)
{
    const size_t doubles = 3 * tsu_i_leaf_inverse_doubles();
    work->memory = tsu_i_alloc(context, doubles, sizeof *work->memory);
    if (!work->memory)
        return TSU_E_MEMORY;
    tsu_i_jobs(context, solve_channel, work, 3);
    tsu_i_free(context, work->memory, doubles, sizeof *work->memory);
    return TSU_OK;
}

static void report_of(const struct work *work, tsu_leaf_report *report)
{
    for (int k = 0; k < 3; k++) {
        report->R_top[k] = work->found[k].faces.R_top;
        report->R_bottom[k] = work->found[k].faces.R_bottom;
        report->T[k] = work->found[k].faces.T;
    }
}

enum { INDEX, SCATTER_TOP, ABSORPTION_TOP, SCATTER_BOTTOM, ABSORPTION_BOTTOM, PIGMENT, THICKNESS };
enum { FIELDS = THICKNESS + 1 };

// A model's typed parameters, checked, and where in them its layers are.
struct layers {
    const tsu_model *model;
    double params[TSU_I_PARAMS_BYTES / sizeof(double)];
    float *field[FIELDS];
};

static tsu_status read_layers(const tsu_context *context, const tsu_model *model,
                              const void *params, struct layers *out)
{
    static const char *const names[FIELDS] = {
        "n",       "scatter_top", "absorption_top", "scatter_bottom", "absorption_bottom",
        "pigment", "thickness"};
    if (!context || !model)
        return TSU_E_PARAMETER;
    *out = (struct layers){.model = model};
    for (int f = 0; f < FIELDS; f++)
        for (uint32_t i = 0; i < model->info.parameter_count; i++)
            if (strcmp(model->parameters[i].name, names[f]) == 0)
                out->field[f] =
                    (float *)(void *)((char *)out->params + model->parameters[i].offset);
    for (int f = 0; f < FIELDS; f++)
        if (!out->field[f]) {
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF, "model %s has no %s: it is no leaf",
                      model->info.name, names[f]);
            return TSU_E_PARAMETER;
        }
    return tsu_i_params_read(context, model, params, out->params);
}

static tsu_status write_layers(const struct work *work, const struct layers *layers, void *params)
{
    *layers->field[INDEX] = (float)work->asked[0].n;
    for (int k = 0; k < 3; k++) {
        const struct tsu_i_leaf_layers *found = &work->found[k].layers;
        layers->field[SCATTER_TOP][k] = (float)found->scatter_top;
        layers->field[ABSORPTION_TOP][k] = (float)found->absorption_top;
        layers->field[SCATTER_BOTTOM][k] = (float)found->scatter_bottom;
        layers->field[ABSORPTION_BOTTOM][k] = (float)found->absorption_bottom;
    }
    return tsu_i_desc_write(params, layers->params, layers->model->info.params_size);
}

#define NEAREST "; the nearest possible is R_top %g, R_bottom %g, T %g"

// One line about channel k, which nothing does.
static void explain(const tsu_context *context, const struct work *work, int k)
{
    const struct tsu_i_leaf_faces *asked = &work->asked[k].faces, *near = &work->found[k].faces;
    const double surface = tsu_i_leaf_surface(work->asked[k].n);
    const int below = asked->R_bottom > asked->R_top; // that is the brighter face
    if (work->found[k].answer == TSU_I_LEAF_ENERGY)
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF,
                  "tsu_leaf_reflectance.%s[%d] + T[%d] = %g, expected at most 1" NEAREST,
                  below ? "R_bottom" : "R_top", k, k,
                  asked->T + (below ? asked->R_bottom : asked->R_top), near->R_top, near->R_bottom,
                  near->T);
    else if (work->found[k].answer == TSU_I_LEAF_SURFACE && asked->T < 0.0)
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF,
                  "tsu_leaf_reflectance.T[%d] = %g, expected at least 0" NEAREST, k, asked->T,
                  near->R_top, near->R_bottom, near->T);
    else if (work->found[k].answer == TSU_I_LEAF_SURFACE)
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF,
                  "tsu_leaf_reflectance.%s[%d] = %g, expected at least %g, which a surface of "
                  "index %g reflects" NEAREST,
                  below ? "R_top" : "R_bottom", k, below ? asked->R_top : asked->R_bottom, surface,
                  work->asked[k].n, near->R_top, near->R_bottom, near->T);
    else
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_LEAF,
                  "tsu_leaf_reflectance.R_bottom[%d] = %g beside R_top %g and T %g is out of two "
                  "layers' reach" NEAREST,
                  k, asked->R_bottom, asked->R_top, asked->T, near->R_top, near->R_bottom, near->T);
}

tsu_status tsu_leaf_from_reflectance(tsu_context *context, const tsu_model *model,
                                     const tsu_leaf_reflectance *reflectance, void *params,
                                     tsu_leaf_report *report)
{
    tsu_leaf_reflectance own;
    struct layers layers;
    tsu_leaf_report made = {.struct_size = sizeof made};
    struct work work = {.solve = tsu_i_leaf_invert};
    tsu_status status = read_layers(context, model, params, &layers);
    if (status == TSU_OK)
        status = tsu_i_desc_read(context, "tsu_leaf_reflectance", reflectance, &own, sizeof own,
                                 sizeof own);
    if (status == TSU_OK && own.flags) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS,
                  "tsu_leaf_reflectance.flags = %u, expected 0", own.flags);
        status = TSU_E_PARAMETER;
    }
    if (status == TSU_OK && !(own.n >= 1.2 && own.n <= 1.8))
        status = out_of_range(context, "tsu_leaf_reflectance.n", own.n, 1.2, 1.8);
    for (int k = 0; k < 3 && status == TSU_OK; k++) {
        const struct tsu_i_leaf_faces faces = {own.R_top[k], own.R_bottom[k], own.T[k]};
        work.asked[k] = (struct tsu_i_leaf_question){.n = own.n, .g = TSU_LEAF_G, .faces = faces};
        if (!(fabs(faces.R_top) <= 1e3))
            status = out_of_range(context, "tsu_leaf_reflectance.R_top", faces.R_top, 0, 1);
        else if (!(fabs(faces.R_bottom) <= 1e3))
            status = out_of_range(context, "tsu_leaf_reflectance.R_bottom", faces.R_bottom, 0, 1);
        else if (!(fabs(faces.T) <= 1e3))
            status = out_of_range(context, "tsu_leaf_reflectance.T", faces.T, 0, 1);
    }
    if (status == TSU_OK)
        status = solve(context, &work);
    if (status != TSU_OK)
        return report ? tsu_i_desc_fail(report, sizeof *report, status) : status;
    report_of(&work, &made);
    for (int k = 0; k < 3; k++) {
        made.residual[k] = work.found[k].residual;
        if (work.found[k].answer != TSU_I_LEAF_REACHED && status == TSU_OK) {
            explain(context, &work, k);
            status = TSU_E_PARAMETER;
        }
    }
    const tsu_status told = report ? tsu_i_desc_write(report, &made, sizeof made) : TSU_OK;
    if (status == TSU_OK)
        status = told;
    return status == TSU_OK ? write_layers(&work, &layers, params) : status;
}

tsu_status tsu_leaf_from_pigments(tsu_context *context, const tsu_model *model,
                                  const tsu_leaf_pigments *pigments, void *params,
                                  tsu_leaf_report *report)
{
    // What is left of a channel that is darker than leaves can be.
    const double least_R = 0.002, least_T = 0.0005;
    tsu_leaf_pigments own;
    struct tsu_i_prospect leaf;
    struct layers layers;
    tsu_leaf_report made = {.struct_size = sizeof made};
    struct work work = {.solve = tsu_i_leaf_invert_near};
    tsu_status status = read_layers(context, model, params, &layers);
    if (status == TSU_OK)
        status = read_pigments(context, pigments, &own, &leaf);
    if (status == TSU_OK) {
        double R[3], T[3];
        color(&leaf, R, T);
        const double surface = tsu_i_leaf_surface(own.n);
        for (int k = 0; k < 3; k++) {
            const double top = fmax(R[k], surface + least_R), through = fmax(T[k], least_T);
            const double bottom = fmax(own.bottom * top, surface + least_R);
            made.raised |= top > R[k] || through > T[k] ? 1u << k : 0u;
            work.asked[k] = (struct tsu_i_leaf_question){
                .n = own.n, .g = TSU_LEAF_G, .faces = {top, bottom, through}};
        }
        status = solve(context, &work);
    }
    if (status != TSU_OK)
        return report ? tsu_i_desc_fail(report, sizeof *report, status) : status;
    report_of(&work, &made);
    for (int k = 0; k < 3; k++) {
        const struct tsu_i_leaf_faces *asked = &work.asked[k].faces, *done = &work.found[k].faces;
        made.residual[k] = fmax(fmax(fabs(done->R_top - asked->R_top), fabs(done->T - asked->T)),
                                fabs(done->R_bottom - asked->R_bottom));
        if (work.found[k].answer != TSU_I_LEAF_REACHED)
            made.raised |= 1u << k;
        if (fabs(done->R_bottom - asked->R_bottom) > TSU_I_LEAF_ENOUGH)
            made.limited |= 1u << k;
    }
    status = report ? tsu_i_desc_write(report, &made, sizeof made) : TSU_OK;
    return status == TSU_OK ? write_layers(&work, &layers, params) : status;
}

tsu_status tsu_leaf_measure(tsu_context *context, const tsu_model *model, const void *params,
                            tsu_leaf_report *report)
{
    if (!report)
        return TSU_E_PARAMETER;
    struct layers layers;
    tsu_leaf_report made = {.struct_size = sizeof made};
    struct work work = {.solve = NULL};
    tsu_status status = read_layers(context, model, params, &layers);
    if (status == TSU_OK) {
        float *const *field = layers.field;
        const double thickness = (double)*field[THICKNESS];
        const double pigment = (double)*field[PIGMENT] * thickness;
        for (int k = 0; k < 3; k++) {
            work.asked[k].n = (double)*field[INDEX];
            work.layers[k] = (struct tsu_i_leaf_layers){
                .scatter_top = thickness * (double)field[SCATTER_TOP][k],
                .absorption_top = pigment * (double)field[ABSORPTION_TOP][k],
                .scatter_bottom = thickness * (double)field[SCATTER_BOTTOM][k],
                .absorption_bottom = pigment * (double)field[ABSORPTION_BOTTOM][k]};
        }
        status = solve(context, &work);
    }
    if (status != TSU_OK)
        return tsu_i_desc_fail(report, sizeof *report, status);
    report_of(&work, &made);
    return tsu_i_desc_write(report, &made, sizeof made);
}

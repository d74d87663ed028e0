// The record that every model fills: data and pure functions. A model sees no GL, no thread, no
// allocation and no file.
//
// To add a model: a folder here with model.c; its twin in glsl/; a public header
// include/tsuya/models/NAME.h with its typed parameters; the word in `models` in the root
// meson.build; its names in tsuya.map; a test with numbers from the paper.
#ifndef TSU_MODELS_MODEL_H
#define TSU_MODELS_MODEL_H

#include <tsuya/model.h>

enum { TSU_I_STATE_BYTES = 256, TSU_I_MODEL_TABLES = 4 };

// Where a table lies in the texture; all 0 for one that the parameters' flags do not ask for.
struct tsu_i_place {
    uint32_t x, y;          // first texel
    uint32_t width, height; // of the whole texture, texels
};

// A baked table as the CPU reads it; NULL without it.
struct tsu_i_texels {
    const uint16_t *texels; // RGBA16F, the table's first texel
    uint32_t pitch;         // texels from row to row
};

struct tsu_i_table {
    tsu_table_info info;
    // The parameters that shape the table, copied out of the state: equal bytes, equal table.
    size_t key_offset, key_size;
    // A unit of work: rows unit, unit + units, unit + 2 units, ... one after the other in `texels`,
    // each of `info.width` texels of four floats, at most 8 TSU_CELL of them. `scratch`: room of scratch_bytes of the unit's own,
    // aligned for double.
    uint32_t units;
    size_t scratch_bytes;
    void (*bake)(const void *state, uint32_t unit, void *scratch, float *texels);
    // Last touch on the whole table, rows in order; may be NULL.
    void (*finish)(const void *state, float *texels);
};

// A table error that can be measured again: the worst of the shader's formula against the
// reference.
struct tsu_i_measure {
    const char *name;
    double (*worst)(const void *state, const struct tsu_i_texels *tables);
};

struct tsu_i_function {
    tsu_function_info info;
    const tsu_value_info *inputs, *outputs;
    const char *probe; // glsl file with tsu_probe(); NULL: reference only
    // Material parameters out of checked inputs, over initialised `params`.
    void (*params)(const double *in, void *params);
    void (*reference)(const double *in, double *out);
    // Instead of `reference` where it needs room: scratch_bytes, aligned for double; 0: it does not.
    size_t scratch_bytes;
    void (*solved)(const double *in, void *scratch, double *out);
    // Instead of `params` and `solved` where inputs within their ranges can still be impossible:
    // these log what is wrong, with the nearest that is possible. `scratch` as above.
    tsu_status (*material)(const tsu_context *context, const double *in, void *scratch,
                           void *params);
    tsu_status (*answer)(const tsu_context *context, const double *in, void *scratch, double *out);
    uint32_t params_flags; // that a material must have for `sampled`
    // As the shader, in float, from the baked tables and the record; NULL: reference only.
    void (*sampled)(const void *state, const float *record, const struct tsu_i_texels *tables,
                    const double *in, double *out);
};

struct tsu_model {
    tsu_model_info info;  // counts are filled by the arrays below
    const void *defaults; // typed parameters; struct_size first
    size_t params_least;  // first released layout
    uint32_t known_flags;
    const tsu_parameter_info *parameters;
    const struct tsu_i_table *tables;
    const struct tsu_i_measure *measures;
    uint32_t measure_count;
    const tsu_error_info *errors;
    const tsu_input_info *inputs;
    const tsu_variant_info *variants;
    const struct tsu_i_function *functions;
    const char *const *snippets; // glsl files in order, NULL-terminated
    // Derived constants of checked parameters, at most TSU_I_STATE_BYTES. Zeroed before.
    void (*prepare)(const void *params, void *state);
    // The record of TSU_RECORD_VEC4 vec4; `places` has one entry a table. Zeroed before.
    void (*record)(const void *state, const struct tsu_i_place *places, float *record);
};

// NULL-terminated lists: of models that shade a fibre, of techniques of self-shadow, which have no
// functions, no record and no prepare().
extern const struct tsu_model *const tsu_i_models[];
extern const struct tsu_model *const tsu_i_shadows[];

#endif

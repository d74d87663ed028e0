// What models exist, and what each one takes, bakes, promises and can be asked.
//
// Everything a panel, a serialiser or a command line needs is here as data, so that no host code
// has to name a model. Records are static: pointers in them live as long as the library.
#ifndef TSUYA_MODEL_H
#define TSUYA_MODEL_H

#include <tsuya/context.h>

#ifdef __cplusplus
extern "C" {
#endif

// One shading model ("marschner", "kajiya_kay", ...).
typedef struct tsu_model tsu_model;

// Number of models that shade a fibre or a surface. Threads: any.
TSU_API uint32_t tsu_model_count(void);
// Model that shades a fibre or a surface, by position; NULL when `index` is too large. Threads: any.
TSU_API const tsu_model *tsu_model_at(uint32_t index);
// Model by name, techniques of self-shadow (hair_shadow.h) too; NULL when there is none.
// Threads: any.
TSU_API const tsu_model *tsu_model_find(const char *name);

enum {
    // Tells what light reaches a fibre and shades none: no eval, no sum, no lobes, no material. A
    // set refuses it, a shader takes it, tsuya/hair_shadow.h plans it.
    TSU_MODEL_SHADOW = 1,
    // Shades a surface: takes a normal n in place of t and sigma_a, see its header.
    TSU_MODEL_SURFACE = 2
};

typedef struct tsu_model_info {
    uint32_t struct_size; // set by tsu_model_info_init()
    uint32_t flags;       // TSU_MODEL_* bits
    const char *name;     // "marschner"
    const char *title;    // "Marschner fibre"
    const char *source;   // citation
    size_t params_size;   // sizeof of the model's typed parameters
    uint32_t parameter_count;
    uint32_t table_count;
    uint32_t error_count;
    uint32_t input_count;
    uint32_t function_count;
    uint32_t variant_count;
} tsu_model_info;

// One field of the model's typed parameter struct.
typedef struct tsu_parameter_info {
    uint32_t struct_size; // set by tsu_parameter_info_init()
    uint32_t flags;       // 0
    const char *name;     // field name
    const char *unit;     // "rad", "1/radius", "1"
    const char *help;     // one sentence
    size_t offset;        // in the typed struct
    uint32_t count;       // 1, or 3 for a colour; always float
    uint32_t rebakes;     // 1 when a change of this parameter makes new tables
    double minimum, maximum, default_value;
} tsu_parameter_info;

// One table of a model: a rectangle of RGBA16F texels in the shared texture.
typedef struct tsu_table_info {
    uint32_t struct_size; // set by tsu_table_info_init()
    uint32_t flags;       // 0
    const char *name;     // "azimuthal"
    const char *axes;     // storage order with units
    const char *channels; // meaning of the texels
    uint32_t width, height;
    uint32_t bytes;
    uint32_t params_flags; // baked where the parameters' flags have these bits; 0: always
} tsu_table_info;

// One measured error. `value` is the maximum over `range`, in the measure that `measure` names.
typedef struct tsu_error_info {
    uint32_t struct_size; // set by tsu_error_info_init()
    uint32_t flags;       // 0
    const char *name;     // what is approximated
    const char *measure;  // "fraction of the peak over phi", ...
    const char *range;    // parameters over which it was measured
    double value;
} tsu_error_info;

// One argument of the model's GLSL entry point, in order.
typedef struct tsu_input_info {
    uint32_t struct_size; // set by tsu_input_info_init()
    uint32_t flags;       // TSU_INPUT_* bits
    const char *name;     // "t"
    const char *type;     // GLSL type
    const char *help;
} tsu_input_info;
enum {
    TSU_INPUT_EXTRA = 1,  // beyond material, t, l, v, sigma_a; of a surface material, n, l, v
    TSU_INPUT_VARIANT = 2 // taken by variants of the entry point alone
};

// Another GLSL entry point of a model, tsu_MODEL_NAME_eval, whose sum is the model's.
typedef struct tsu_variant_info {
    uint32_t struct_size; // set by tsu_variant_info_init()
    uint32_t flags;       // 0
    const char *name;     // "finite"
    const char *help;
    uint32_t inputs;       // bit i: it takes input i of the model
    uint32_t params_flags; // bits that the flags of its materials' parameters must have, or 0
} tsu_variant_info;

// One question that a model answers three times: by its double-precision reference, by the tables
// sampled in C, and by the GLSL (entry tsu_probe, see shader.h). Inputs hold material parameters
// and directions alike.
typedef struct tsu_function_info {
    uint32_t struct_size; // set by tsu_function_info_init()
    uint32_t flags;       // TSU_FUNCTION_* bits
    const char *name;     // "hair-azimuthal"
    const char *help;
    uint32_t input_count, output_count; // at most TSU_FUNCTION_INPUTS and TSU_FUNCTION_OUTPUTS
} tsu_function_info;
enum { TSU_FUNCTION_INPUTS = 48, TSU_FUNCTION_OUTPUTS = 8 };
enum {
    TSU_FUNCTION_REFERENCE_ONLY = 1,
    TSU_FUNCTION_FINE = 2 // its probe is assembled with TSU_SHADER_FINE
};

// One input (or output: then only name, unit and help count) of a function.
typedef struct tsu_value_info {
    uint32_t struct_size; // set by tsu_value_info_init()
    uint32_t flags;       // TSU_VALUE_MATERIAL: part of the material, not of the fragment
    const char *name;     // "theta_d"
    const char *unit;     // "rad" for angles; "a|b;c": the numbers 0, 1, 2 have these names, and
                          // those after the ; are known to the reference alone
    const char *help;
    double minimum, maximum, default_value;
} tsu_value_info;
enum { TSU_VALUE_MATERIAL = 1 };
// As a maximum it stands for infinity.
#define TSU_VALUE_INFINITE 1e9

// Zero an info struct and set its size. Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_info_init_sized(void *info, size_t size);
#define tsu_model_info_init(info) tsu_info_init_sized((info), sizeof *(info))
#define tsu_parameter_info_init(info) tsu_info_init_sized((info), sizeof *(info))
#define tsu_table_info_init(info) tsu_info_init_sized((info), sizeof *(info))
#define tsu_error_info_init(info) tsu_info_init_sized((info), sizeof *(info))
#define tsu_input_info_init(info) tsu_info_init_sized((info), sizeof *(info))
#define tsu_variant_info_init(info) tsu_info_init_sized((info), sizeof *(info))
#define tsu_function_info_init(info) tsu_info_init_sized((info), sizeof *(info))
#define tsu_value_info_init(info) tsu_info_init_sized((info), sizeof *(info))

// Fill an info struct. Errors: TSU_E_PARAMETER for a NULL or an index out of range, TSU_E_STRUCT.
// Threads: any.
TSU_API tsu_status tsu_model_describe(const tsu_model *model, tsu_model_info *out);
TSU_API tsu_status tsu_model_parameter(const tsu_model *model, uint32_t index,
                                       tsu_parameter_info *out);
TSU_API tsu_status tsu_model_table(const tsu_model *model, uint32_t index, tsu_table_info *out);
TSU_API tsu_status tsu_model_error(const tsu_model *model, uint32_t index, tsu_error_info *out);
TSU_API tsu_status tsu_model_input(const tsu_model *model, uint32_t index, tsu_input_info *out);
TSU_API tsu_status tsu_model_variant(const tsu_model *model, uint32_t index, tsu_variant_info *out);
TSU_API tsu_status tsu_model_function(const tsu_model *model, uint32_t index,
                                      tsu_function_info *out);
TSU_API tsu_status tsu_function_input(const tsu_model *model, uint32_t function, uint32_t index,
                                      tsu_value_info *out);
TSU_API tsu_status tsu_function_output(const tsu_model *model, uint32_t function, uint32_t index,
                                       tsu_value_info *out);

// Fill a model's typed parameters with its defaults. `params` must have room for `size` bytes and
// starts with struct_size and flags like every descriptor. The typed headers wrap this.
// Errors: TSU_E_PARAMETER (NULL), TSU_E_STRUCT (size below the first released layout).
// Threads: any.
TSU_API tsu_status tsu_model_params_init(const tsu_model *model, void *params, size_t size);

// Check typed parameters; the log line names the first bad field and its range.
// Errors: TSU_E_PARAMETER, TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_model_params_check(tsu_context *context, const tsu_model *model,
                                          const void *params);

// Material parameters of one row of function inputs (`in`: input_count doubles), written over
// `params`, which must have been initialised.
// Errors: TSU_E_PARAMETER, logged with the name of the input. Threads: any.
TSU_API tsu_status tsu_function_params(tsu_context *context, const tsu_model *model,
                                       uint32_t function, const double *in, void *params);

// The double-precision reference: `in` has input_count values, `out` gets output_count values.
// Errors: TSU_E_PARAMETER when an input is not finite or out of range, or `context` is NULL for a
// reference that needs room; TSU_E_MEMORY. Threads: any.
TSU_API tsu_status tsu_function_reference(tsu_context *context, const tsu_model *model,
                                          uint32_t function, const double *in, double *out);

#ifdef __cplusplus
}
#endif
#endif

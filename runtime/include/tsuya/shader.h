// GLSL text for one or more models, ready to paste into the host's own shader.
//
// The text holds functions, structs and macros that begin with tsu_ or TSU_, one sampler
// (`tsu_tables`) and one block (`tsu_materials`) however many models are asked for. It has no
// #version, no #extension, no main, no in or out: the host owns the stages. For each model M:
//
//   tsu_M_lobes tsu_M_eval(int material, vec3 t, vec3 l, vec3 v, vec3 sigma_a, ...);
//   vec3 tsu_M_sum(tsu_M_lobes lobes);
//
// `material` is the index inside the bound page. A lobe is S cos(theta_i) in 1/sr: multiply it by
// the light's radiance and solid angle (or irradiance from a small light) and add; no further
// cosine, no light colour inside. Arguments after sigma_a are the model's extra inputs (model.h).
//
// Lobes left out (TSU_SHADER_DROP_*). The text lacks their code, structs and functions keep their
// names: a dropped lobe's field is 0, sums have no term for it, hosts need not change. Tables stay
// the same, so that multiple scattering still knows all lobes; a model without the lobe ignores the
// flag. Light lost, in percent (tests/bench/results/lobes.csv has more; double precision,
// eta 1.55):
//
//   sigma_a                                       0    0.05  0.1   0.2   0.5   1     2
//   TRT: of what a fibre scatters, most over
//     theta 0 to 60 degrees                       10   9.1   8.0   6.1   2.5   0.8   0.1
//   RESIDUAL: the same                            2.7  2.0   1.5   0.9   0.2   0.02  0
//     theta 60 to 85 degrees                      14   8.2   5.2   2.4   0.2   0.01  0
//   BACK: of what a slab reflects, 0.1 fibres     13   11    10    8.4   4.8   1.5   0.1
//     1 fibre                                     53   50    46    40    25    8.4   0.5
//     any depth                                   89   80    73    61    36    12    0.6
//
//   TRT, RESIDUAL     one internal reflection, two and more: marschner's fibre, in dual_scattering
//                     and plane_parallel_hair the direct light's. Black hair needs neither; the
//                     residual matters in light hair at grazing views.
//   BACK              light of other fibres that comes back on the light's own side:
//   dual_scattering
//                     (zinke: local back scattering), plane_parallel_hair. For black hair; of blond
//                     hair it is lost light even one fibre deep.
//   TRANSMITTED       what comes through leaves, for leaves that are lit and seen from one side:
//                     ivy on a wall. Exact there; the coat is left out by using leaf_body.
// Estimated clocks on navi21: marschner 248, 228 without one of the first two, 188 without both;
// dual_scattering 414, 402, 352 and without BACK 376, without all 316; leaf_body 258 and 244.
//
// Techniques of self-shadow (hair_shadow.h) may be among the models: their text declares no sampler
// and no block, the host hands its maps to their functions. Alone they need no block at all.
#ifndef TSUYA_SHADER_H
#define TSUYA_SHADER_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t tsu_target;
enum {
    TSU_TARGET_330 = 1,   // GLSL 3.30 core
    TSU_TARGET_410 = 2,   // GLSL 4.10 core
    TSU_TARGET_450 = 3,   // GLSL 4.50 core
    TSU_TARGET_300ES = 4, // ESSL 3.00, WebGL 2
    TSU_TARGET_310ES = 5, // ESSL 3.10
    TSU_TARGET_VULKAN = 6 // GLSL 4.50 with set and binding, for SPIR-V
};

// Target by its name ("330", "410", "450", "300es", "310es", "vulkan"); 0 when there is none.
// Threads: any.
TSU_API tsu_target tsu_target_find(const char *name);
// The `#version ...` line of a target, with its line end; NULL for an unknown target.
// Threads: any.
TSU_API const char *tsu_target_version(tsu_target target);

enum {
    // Material records come as `uniform vec4 tsu_records[]` in place of a block, for hosts
    // without uniform blocks; see array_materials.
    TSU_SHADER_ARRAY = 1,
    // Add the probes: void tsu_probe(int material, float x[16], out float y[8]) answers function
    // `function` of the one model asked for, with x as tsu_function_input() orders them.
    TSU_SHADER_PROBE = 2,
    // Spend more where a model can use it. marschner: the residual gets a lobe of
    // its own for 20 more of navi21's clocks, and the sum's worst error falls from 15 to 0.6 % of
    // its peak.
    TSU_SHADER_FINE = 8,
    // A complete fragment shader with #version: varyings t, l, v, sigma_a, flat int material and
    // the models' extra inputs; o = vec4(sum of all lobes of all models, 1). Not with techniques of
    // self-shadow, which have no lobes.
    TSU_SHADER_HARNESS = 4,
    // Add the snippets of lights and environments (tsuya/light.h).
    TSU_SHADER_LIGHTS = 16,
    // Add the snippet of light that spreads inside leaves (tsuya/leaf_scale.h).
    TSU_SHADER_BLUR = 32,
    // Leave lobes out, where what they send can be missed: see "Lobes left out" below. Not with
    // TSU_SHADER_PROBE, whose functions answer for the whole model.
    TSU_SHADER_DROP_TRT = 64,
    TSU_SHADER_DROP_RESIDUAL = 128,
    TSU_SHADER_DROP_BACK = 256,
    TSU_SHADER_DROP_TRANSMITTED = 512,
    // Add the snippet that fades from one tier to another (tsu_fade*, glsl/prelude/fade.glsl).
    TSU_SHADER_FADE = 1024
};

typedef struct tsu_shader_desc {
    uint32_t struct_size; // set by tsu_shader_desc_init()
    uint32_t flags;       // TSU_SHADER_* bits
    tsu_target target;    // default TSU_TARGET_330
    uint32_t model_count; // at least 1
    const tsu_model *const *models;
    uint32_t function;        // for TSU_SHADER_PROBE
    uint32_t array_materials; // for TSU_SHADER_ARRAY: materials in the array, [1, 127], default 1
    uint32_t set;             // Vulkan descriptor set, default 0
    uint32_t sampler_binding; // Vulkan binding of tsu_tables, default 0
    uint32_t block_binding;   // Vulkan binding of tsu_materials, default 1
    uint32_t reserved;        // 0
    // Functions wanted, with commas or blanks between; NULL, the default, or "": all. A word is an
    // entry point ("eval"), a variant ("finite", "zinke", "bent"), what else follows the model's
    // name ("uniform", "ambient", "reflected"), or a whole name ("tsu_marschner_eval"). The text of
    // a model that has one of them holds these, its sum and what they need: 12.5 of 18.5 KB of
    // dual_scattering, 6.3 of 15.7 of leaf. A model that has none stays whole. A harness calls the
    // variant that is named. Not with TSU_SHADER_PROBE.
    const char *only;
} tsu_shader_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_shader_desc_init_sized(tsu_shader_desc *desc, size_t size);
#define tsu_shader_desc_init(desc) tsu_shader_desc_init_sized((desc), sizeof *(desc))

// Assembled text. Immutable.
typedef struct tsu_shader tsu_shader;

// Assemble. A model that is asked for twice appears once.
// Errors: TSU_E_STRUCT, TSU_E_PARAMETER (no model, unknown target, flag or function, a word of
// `only` that no model has), TSU_E_MEMORY, TSU_E_HOST (the read callback gave text that breaks the
// naming rules: #version, main). Threads: any.
TSU_API tsu_status tsu_shader_create(tsu_context *context, const tsu_shader_desc *desc,
                                     tsu_shader **out);
// NULL is fine. Threads: object.
TSU_API void tsu_shader_destroy(tsu_shader *shader);

// The text, zero-terminated; *size (may be NULL) gets its length. Threads: any.
TSU_API const char *tsu_shader_text(const tsu_shader *shader, size_t *size);
// 64-bit key of the text: equal keys, equal text. Threads: any.
TSU_API uint64_t tsu_shader_key(const tsu_shader *shader);
// File behind source string number `source` of a driver's message ("3:14: ..." is source 3, line
// 14): sources are numbered by #line. NULL when there is none. Threads: any.
TSU_API const char *tsu_shader_source(const tsu_shader *shader, uint32_t source);

// Threshold of strand (or leaf) number `strand`, in [0, 1), the same as the GLSL function of this
// name (TSU_SHADER_FADE): while a weight goes from 0 to 1, strands below it are of the new tier.
// Sorted by their thresholds, strands fade in two draws, each with one tier's program: the first
// weight * N with the new one. No shader holds both tiers and no pixel pays for both; where a
// shader chooses by pixel, it may. Keep the mean luminance by tsu_choose_match()'s gain on the new
// tier, and take seconds to bring that gain to 1 afterwards. Threads: any.
TSU_API float tsu_fade_strand(uint32_t strand);

#ifdef __cplusplus
}
#endif
#endif

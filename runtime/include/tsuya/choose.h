// Which model a scene requires: error against cost, from a table that was measured.
//
// Every way to shade hair or a leaf is a tier: a model, a variant of it, and what light reaches a
// fibre. Each has a cost (what a compiler for a real GPU says) and an error (against a path tracer
// for hair, against the transport solver for leaves) that depends on the scene. The chooser
// predicts both for the scene at hand and answers with the cheapest tier that is good enough, or
// the best that can be paid.
//
//   tsu_choose_desc desc;
//   tsu_choice choice;
//   tsu_choose_desc_init(&desc);
//   desc.strand_pixels = 0.3f;        // what the scene is
//   desc.shadow = TSU_CHOOSE_SHADOW_MAPS;
//   desc.error_bound = 0.3f;          // the wish: 30 %
//   tsu_choice_init(&choice);
//   tsu_choose(context, &desc, &choice);
//   choice.model, choice.variant, choice.passes, choice.drop; choice.reason says why
//
// Tiers of hair, by name (their order in the list is the table's, not a promise):
//   unshadowed       kajiya_kay, light goes through hair as if it were not there
//   kajiya_kay       kajiya_kay, times the transmittance of the fibres in the light's way
//   marschner        marschner, the same
//   exact            dual_scattering, variant finite
//   plane_parallel   plane_parallel_hair, variant finite
// All but the first must know how many fibres are in the light's way (hair_shadow.h). The variant
// zinke of dual_scattering is not on offer: it costs more than the last two and errs more, whatever
// the hair.
// Tiers of leaves:
//   leaf_coarse, leaf_body          a leaf without gloss
//   leaf                            under a rough cuticle
//   leaf_body_uniform, leaf_uniform the same with one pigment and thickness for the material, its
//                                   numbers in the host's uniforms (leaf_body.h): no fetch
//
// Error. Of hair: `error` is the root of the relative mean square error of a picture, mean over
// hair's pixels and the three channels; a pixel's square error is divided by the square of the true
// radiance around it plus the square of a tenth of the picture's mean. 0.3 is 30 %. `luminance` is
// the signed error of the mean luminance of all hair. Both are predicted: a polynomial in the
// scene's traits, fitted to pictures of random scenes against path-traced ones; tsu_trade_source()
// tells which. What the prediction leaves is in the table, too, and `error_high` is the prediction
// with a margin that is picked so that a choice by it holds in nine of ten scenes that the fit had
// not seen. Of leaves: `error` is the largest error of BRDF and, when back-lit, BTDF over all
// directions and both sides, as a fraction of that lobe's peak, of the nearest leaf of the table;
// `luminance` is the same for the hemispherical sum.
//
// Cost. Clocks a pixel: inverse throughput of one evaluation as a whole fragment shader, times the
// evaluations: directional and point lights 1, areas 13, environments 12 (light.h); and, with
// TSU_CHOOSE_SHADOW_MAPS, one look into the map of 8 layers for each light but environments. A
// comparison between tiers, not a time: passes that draw maps are not in it, nor what dropped lobes
// save. 0 lights cost as one.
//
// The same question has the same answer on every machine: no function of libm that machines round
// differently takes part in it. 2 us at the most on a core of 2020, no allocation, no state.
#ifndef TSUYA_CHOOSE_H
#define TSUYA_CHOOSE_H

#include <tsuya/shader.h>

#ifdef __cplusplus
extern "C" {
#endif

// A tier by position in this library's list. Positions may change with versions, names do not.
typedef int32_t tsu_tier;
enum { TSU_TIER_NONE = -1 };

typedef int32_t tsu_choose_kind;
enum { TSU_CHOOSE_HAIR = 1, TSU_CHOOSE_LEAF = 2 };

// What can be known of the fibres in a light's way.
typedef int32_t tsu_choose_shadow;
enum {
    TSU_CHOOSE_SHADOW_NONE = 1,  // nothing, and no pass can be drawn
    TSU_CHOOSE_SHADOW_COUNT = 2, // the host has counts of its own (voxels, rays, vertex data)
    TSU_CHOOSE_SHADOW_MAPS = 3   // the host can draw deep opacity maps; three samplers
};

// GPU whose static cost counts.
typedef int32_t tsu_choose_gpu;
enum {
    TSU_CHOOSE_NAVI21 = 1,
    TSU_CHOOSE_NAVI10 = 2,
    TSU_CHOOSE_VEGA10 = 3,
    TSU_CHOOSE_GFX1100 = 4
};

// Flags of a description: leaves.
enum {
    TSU_CHOOSE_BACKLIT = 1,     // light may come from behind: what goes through counts as well
    TSU_CHOOSE_PIGMENT_MAP = 2, // pigment or thickness vary over the leaf
    TSU_CHOOSE_COAT = 4         // gloss is wanted; without it, tiers with a coat are not considered
};

// The scene, the host and the wish. Fields of the other kind are not looked at.
typedef struct tsu_choose_desc {
    uint32_t struct_size; // set by tsu_choose_desc_init()
    uint32_t flags;       // TSU_CHOOSE_* bits; default 0
    tsu_choose_kind kind; // default TSU_CHOOSE_HAIR

    // Hair.
    float sigma_a[3];         // absorption per fibre radius, linear RGB, [0, 1e6], default brown
    float beta_R;             // longitudinal deviation of R, radians, [2, 30] degrees, default 7.5
    float strand_pixels;      // mean width of a strand in pixels, [1e-4, 1e4], default 0.5
    float depth;              // fibres that a ray of view crosses, mean over covered pixels,
                              // [0, 1e6], default 20
    float curl;               // mean squared sine between a strand and its own course, [0, 1]:
                              // 0 straight, 0.5 tight curls; default 0
    tsu_choose_shadow shadow; // default TSU_CHOOSE_SHADOW_MAPS

    // Leaves. Colours as in leaf.h, default a mature broad leaf.
    float R_top[3], R_bottom[3], T[3]; // [0, 1], R + T at most 1
    float footprint;                   // side of what a pixel covers on the leaf, mm, [1e-6, 1e6],
                                       // default 1
    float curvature;                   // smaller radius of curvature, mm, [1e-3, 1e9], 1e9: flat;
                                       // default 1e9
    float spread_R, spread_T;          // radius that holds 90 % of what spreads inside, the widest
                                       // channel's: reflected_radius, transmitted_radius of
    // tsu_leaf_scale, mm, [0, 1e3]; 0: a typical leaf's; default 0

    // Light.
    float covered_pixels;        // pixels that the material covers, [0, 1e12], default 1e5
    uint32_t directional_lights; // [0, 1000], default 1
    uint32_t point_lights;       // [0, 1000], default 0
    uint32_t area_lights;        // of 13 samples, [0, 1000], default 0
    uint32_t environments;       // of 12 samples, [0, 1000], default 0
    float sky_share;             // of the irradiance, that which comes from sky or environments,
                                 // [0, 1], default 0
    float light_cosine; // mean cosine between the directions to light and viewer, weighed by
                        // irradiance: 1 front, -1 back, [-1, 1], default 0.5

    // The host.
    uint32_t samplers;  // texture units that are free, default 16. Tables take one, deep opacity
                        // maps three
    uint32_t memory;    // bytes for tables on the GPU, default 4294967295: no limit
    tsu_target target;  // of the GLSL, default TSU_TARGET_330; every tier runs on every target
    tsu_choose_gpu gpu; // whose clocks are counted, default TSU_CHOOSE_NAVI21

    // The wish; 0: none. Without any, the tier of the smallest error.
    float error_bound;     // on error_high, [1e-6, 1e6] or 0, default 0
    float luminance_bound; // on |luminance| with its margin, [1e-6, 1e6] or 0, default 0
    float cost_budget;     // on cost, clocks a pixel, [1e-3, 1e12] or 0, default 0

    // Animation.
    tsu_tier previous; // tier of the frame before, of the same kind; default TSU_TIER_NONE
    float hysteresis;  // h, [0, 1], default 0.1
} tsu_choose_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_choose_desc_init_sized(tsu_choose_desc *desc, size_t size);
#define tsu_choose_desc_init(desc) tsu_choose_desc_init_sized((desc), sizeof *(desc))

typedef int32_t tsu_choice_status;
enum {
    // The wish is met: the cheapest of the tiers within the bounds and the budget; of those whose
    // cost is within 5 % of it, the one of the smallest error_high. With a budget alone, the
    // smallest error_high within it.
    TSU_CHOICE_MET = 1,
    // No tier is within the bounds, whatever it costs: the tier that exceeds them least (within the
    // budget, when there is one). `miss` says by how much.
    TSU_CHOICE_MISSED = 2,
    // No tier is within the budget: the cheapest tier. `over` says by how much.
    TSU_CHOICE_OVER_BUDGET = 3,
    // Some tier is within the bounds and some within the budget, and none within both: of those
    // within the budget, the one that exceeds the bounds least. `miss` says by how much.
    TSU_CHOICE_CONFLICT = 4
};

enum {
    // Flags of a choice: the previous tier was kept. Another would be the answer without it. Then
    // `miss` and `over` may be up to the hysteresis in a wish that is met.
    TSU_CHOICE_HELD = 1
};

// Passes and reads that a choice needs.
enum {
    TSU_PASS_COUNT = 1, // the host's own count of fibres, by tsu_hair_shadow_count()
    TSU_PASS_MAPS = 2,  // deep opacity maps, for each light that casts shadow
    TSU_PASS_BLUR = 4   // light that spreads inside the leaf: tsu_blur() (leaf_scale.h)
};

// Traits outside of what the table was measured for. The end of the table's range was taken, and
// the margin holds less.
enum {
    TSU_OUTSIDE_SIGMA_A = 1,
    TSU_OUTSIDE_SKY_SHARE = 2,
    TSU_OUTSIDE_LIGHT_COSINE = 4,
    TSU_OUTSIDE_STRAND_PIXELS = 8,
    TSU_OUTSIDE_DEPTH = 16,
    TSU_OUTSIDE_CURL = 32,
    TSU_OUTSIDE_BETA_R = 64,
    TSU_OUTSIDE_COLOR = 128,    // of a leaf: no leaf of the table is near; the errors are those of
                                // the model's whole range
    TSU_OUTSIDE_CURVATURE = 256 // of a leaf: too curved for a BRDF, whatever the tier
};

// The answer. Plain data.
typedef struct tsu_choice {
    uint32_t struct_size; // set by tsu_choice_init()
    uint32_t flags;       // TSU_CHOICE_HELD or 0
    tsu_choice_status status;
    tsu_tier tier;
    const tsu_model *model;
    const char *variant;  // of the model's entry point: "finite"; "": the plain one;
                          // "uniform": tsu_leaf_body_uniform() and its like
    uint32_t drop;        // TSU_SHADER_DROP_* bits (shader.h): lobes whose light is below a
                          // tenth of error_bound, or below 0.5 % without one
    uint32_t passes;      // TSU_PASS_* bits
    uint32_t outside;     // TSU_OUTSIDE_* bits
    uint32_t samplers;    // of tables and maps
    uint32_t bytes;       // of tables on the GPU, for the first material
    float error;          // predicted
    float error_high;     // with its margin
    float luminance;      // predicted, signed
    float luminance_high; // |luminance| with its margin
    float cost;           // clocks a pixel, all lights
    float frame_cost;     // cost times covered_pixels
    float miss;           // how far the bounds are exceeded: of error_high / error_bound and
                          // luminance_high / luminance_bound the larger, less 1; 0: they are not
    float over;           // cost / cost_budget - 1; 0: within
    tsu_tier better;      // the cheapest of the tiers that this host can have whose error is
                          // smaller; TSU_TIER_NONE: there is none
    float better_error, better_cost;
    tsu_tier cheaper; // of those that cost less, the one of the smallest error
    float cheaper_error, cheaper_cost;
    char reason[256]; // one to three sentences, English, zero-terminated
} tsu_choice;
#define tsu_choice_init(choice) tsu_info_init_sized((choice), sizeof *(choice))

// Choose. With `previous` p and hysteresis h, p is kept instead of another answer when the host can
// have it and
//   within bounds (MET)    p exceeds the bounds by at most h and costs at most 1 + h of the answer
//   without bounds         error_high of p is at most 1 + h of the answer's
//   MISSED, CONFLICT       p exceeds the bounds at most 1 + h times as much as the answer
//   OVER_BUDGET            p costs at most 1 + h of the answer
// and, but for the last, its cost is at most 1 + h of the budget. So a scene whose errors and costs
// swing by less than h around a limit changes its tier once and not each frame.
// Errors: TSU_E_PARAMETER (logged with field and range), TSU_E_STRUCT, TSU_E_LIMIT when the host
// can have no tier (the log says what is missing); *out is zero then. Threads: any.
TSU_API tsu_status tsu_choose(tsu_context *context, const tsu_choose_desc *desc, tsu_choice *out);

enum {
    // Flags of a tier.
    TSU_TIER_SHADOW = 1,  // must know the fibres in the light's way
    TSU_TIER_UNIFORM = 2, // one pigment and thickness for the material
    TSU_TIER_COAT = 4     // has gloss
};
enum {
    TSU_TONES = 5, // black, brown, blond, white, dyed
    TSU_CHOOSE_GPUS = 4
};

// A tier as the table has it.
typedef struct tsu_tier_info {
    uint32_t struct_size; // set by tsu_tier_info_init()
    uint32_t flags;       // TSU_TIER_* bits
    tsu_choose_kind kind;
    uint32_t fetches; // of tables, one evaluation
    const char *name; // "exact"
    const tsu_model *model;
    const char *variant;           // as in tsu_choice
    uint32_t bytes;                // of tables
    uint32_t samplers;             // of tables
    float clocks[TSU_CHOOSE_GPUS]; // one evaluation, on TSU_CHOOSE_NAVI21 and so on
    float rms[TSU_TONES];          // hair: mean error over the table's scenes of a tone
    float luminance[TSU_TONES];    // hair: mean signed error of the mean luminance
} tsu_tier_info;
#define tsu_tier_info_init(info) tsu_info_init_sized((info), sizeof *(info))

// Number of tiers, hair and leaves. Threads: any.
TSU_API uint32_t tsu_tier_count(void);
// Tier of a name; TSU_TIER_NONE when there is none. Threads: any.
TSU_API tsu_tier tsu_tier_find(const char *name);
// Errors: TSU_E_PARAMETER for NULL or a tier that is none, TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_tier_describe(tsu_tier tier, tsu_tier_info *out);

enum {
    // Why a host cannot have a tier, or the scene does not ask for it. 0: it can.
    TSU_LACKS_SHADOW = 1,   // no count of fibres
    TSU_LACKS_SAMPLERS = 2, // too few free
    TSU_LACKS_MEMORY = 4,   // for its tables
    TSU_LACKS_MAP = 8,      // it has one pigment, the leaf a map
    TSU_LACKS_COAT = 16     // it has no coat to leave out, or the other way round
};

// What one tier would be in a scene.
typedef struct tsu_prediction {
    uint32_t struct_size; // set by tsu_prediction_init()
    uint32_t lacks;       // TSU_LACKS_* bits
    uint32_t outside;     // TSU_OUTSIDE_* bits
    uint32_t passes;      // as in tsu_choice
    uint32_t samplers;
    uint32_t bytes;
    float error, error_high;
    float luminance, luminance_high;
    float cost;
} tsu_prediction;
#define tsu_prediction_init(prediction) tsu_info_init_sized((prediction), sizeof *(prediction))

// Predict one tier, whether or not the host can have it. The wish is checked and not looked at.
// Errors: TSU_E_PARAMETER (a tier of the other kind, or none; fields as tsu_choose()),
// TSU_E_STRUCT; *out is zero then. Threads: any.
TSU_API tsu_status tsu_choose_predict(tsu_context *context, const tsu_choose_desc *desc,
                                      tsu_tier tier, tsu_prediction *out);

// Factor on the light of tier `to` that keeps the mean luminance of tier `from`, as both are
// predicted in this scene: what keeps a switch from being seen as a change of exposure. From one to
// the other and back is 1 within rounding. Error: between exact and plane_parallel 2 % in the mean,
// else 9 % (test `reference-chooser` prints it). A host that needs less measures: it draws
// both tiers once in small and takes the ratio of their means, less what shows through the hair;
// 2 % at most (test `match`, demo/scene/match.h).
// Errors: as tsu_choose_predict(); *gain is 0 then. Threads: any.
TSU_API tsu_status tsu_choose_match(tsu_context *context, const tsu_choose_desc *desc,
                                    tsu_tier from, tsu_tier to, float *gain);

// Where the table comes from: commit, machine, compiler, scenes; lines that end in "\n".
// Threads: any.
TSU_API const char *tsu_trade_source(void);

#ifdef __cplusplus
}
#endif
#endif

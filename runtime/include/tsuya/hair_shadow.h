// Self-shadow of hair: how many fibres lie between a point and a light, and beyond it.
//
// The library plans and the host draws. A plan says, for one light and one head of hair, how large
// the maps are, which targets they need, which passes fill them with the host's own geometry, and
// the twelve vec4 that the snippets take. Two techniques share everything but where layers begin:
//
//   deep_opacity    layers behind the first fibre of each texel (Yuksel and Keyser 2008, "Deep
//                   Opacity Maps"): a depth pass, then one additive pass
//   opacity_shadow  layers at fixed distances from the light (Kim and Neumann 2001, "Opacity Shadow
//                   Maps"): the additive pass alone; bands show where layers are few
//
// GLSL. Ask for the technique with tsu_shader_create() like for a model, alone or with models; it
// has no material and no table. Every source of shadow fills the same struct,
//
//   struct tsu_hair_shadow {
//       float front;          // mean number of fibres between the point and the light
//       float behind;         // mean number further along the same line, away from the light
//       float direct;         // share of the direct light that arrives: mean of exp(-front) over
//                             // the filter's taps, each the chance to meet no fibre
//       float transmittance;  // mean of exp(-opacity front): models without multiple scattering
//   };
//
//   tsu_deep_opacity_read(front, layers, record, position)           up to 4 layers,  8 fetches
//   tsu_deep_opacity_read8(front, layers, deeper, record, position)  up to 8 layers, 12 fetches
//   tsu_opacity_shadow_read(layers, record, position)                up to 4 layers,  4 fetches
//   tsu_opacity_shadow_read8(layers, deeper, record, position)       up to 8 layers,  8 fetches
//   tsu_hair_shadow_count(front, behind)   counts of the host's own: voxels, rays, vertex data
//   tsu_hair_shadow_transmittance(t)       a transmittance of the host's own
//   tsu_hair_shadow_none()                 none is known: models with multiple scattering fall back
//                                          to their single fibre, lit in full
//
// Cost beside the fetches (clocks of navi21 as in tests/bench, all four results): 430 and 320 for
// deep opacity with 8 and 4 layers, 350 and 260 for opacity shadow; a result that is not used is
// not paid for: 330 and 250 for the transmittance alone. Memory: 4 bytes of depth and 8 or 16 bytes
// of half floats a texel and light.
//
// A number behind that nobody knows is TSU_HAIR_SHADOW_UNKNOWN: hair beyond the point is thick.
// Models that take `front`, `behind` and `direct` as extra inputs (model.h) get them as they are
// and are not multiplied by anything; the others are multiplied by `transmittance`.
//
// Solids. A head that hair grows on, or anything opaque in it, ends what is `behind`: light that
// gets there is lost to the hair (but for what the solid reflects, which no model takes up), and
// counted through the head it would come back as from thick hair: a third too much of white
// straight hair. Counts of the host's own stop at the solid. For maps, leave hair in a solid's
// shadow out of the pass "layers": test against a depth buffer of the solids, or discard. It gets
// no direct light in any case. That shadow is the host's: scale `direct` and `transmittance`, add
// many to `front`.
//
// Filter. A map holds the fibres that cross each texel, by the share of it that they cover, so a
// read is never of one fibre. Four texels around the point are read one by one, each with its own
// first fibre and layers, and their results, not their texels, are mixed linearly: a mean of
// exponentials stays one, and no texture has to be filtered. Bind them with nearest filters.
//
// What a map cannot know: where inside a texel fibres are. Hair that is even at that scale is met
// with the chance exp(-front), or lets exp(-opacity front) of the light through when each fibre
// takes the share `opacity`; locks and gaps narrower than a texel are averaged. Against rays
// averaged over a strand's spacing the error is least between half a spacing and two spacings a
// texel; 1.5, the default, is the cheapest that keeps it below 0.03 (tsu_model_error). A fibre
// counts itself in part: 0.5 width / texel in the mean, nothing where it is the first.
#ifndef TSUYA_HAIR_SHADOW_H
#define TSUYA_HAIR_SHADOW_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    TSU_HAIR_SHADOW_LAYERS = 8,       // most layers of a map
    TSU_HAIR_SHADOW_RECORD_VEC4 = 12, // vec4 that the snippets take, `record`
    TSU_HAIR_SHADOW_UNKNOWN = 1000    // fibres behind a point when nobody knows
};

// Techniques by position; NULL when `index` is too large. They are tsu_model records, found by
// tsu_model_find() and described by every function of model.h, with TSU_MODEL_SHADOW in their
// flags; tsu_model_count() and tsu_model_at() leave them out, because they shade nothing.
// Threads: any.
TSU_API uint32_t tsu_hair_shadow_count(void);
TSU_API const tsu_model *tsu_hair_shadow_at(uint32_t index);

enum {
    TSU_HAIR_SHADOW_POINT = 1,     // `light` is a place, not a direction
    TSU_HAIR_SHADOW_ZERO_TO_ONE = 2, // clip space depth is [0, 1]: Vulkan, glClipControl
    // What the host's targets can. Without either, sums go to RGBA8, which every context blends.
    TSU_HAIR_SHADOW_BLEND_32F = 4, // blend RGBA32F: GL 3.3; ES 3 with EXT_float_blend
    TSU_HAIR_SHADOW_BLEND_16F = 8  // blend RGBA16F: GL 3.3; ES 3 with EXT_color_buffer_float or
                                   // EXT_color_buffer_half_float
};

typedef int32_t tsu_format;
enum {
    TSU_FORMAT_DEPTH24 = 1, // DEPTH_COMPONENT24, no comparison
    TSU_FORMAT_RGBA32F = 2,
    TSU_FORMAT_RGBA16F = 3, // a sum stops growing at some 2048 times a fragment's share: at 40
                            // fibres in a layer where a texel is 50 fibres wide
    TSU_FORMAT_RGBA8 = 4    // rounded at random, so that sums are right in the mean; at most 32
                            // fibres in a layer
};

// Hair and one light. Lengths are in any one unit, the host's world.
typedef struct tsu_hair_shadow_desc {
    uint32_t struct_size;   // set by tsu_hair_shadow_desc_init()
    uint32_t flags;         // TSU_HAIR_SHADOW_* bits; default both BLEND bits
    const tsu_model *model; // technique; NULL: deep_opacity
    const void *params;     // its typed parameters; NULL: defaults
    float centre[3];        // of a sphere that holds all hair, default 0
    float radius;           // of the sphere, [1e-6, 1e9], default 1
    float light[3];         // towards the light, any length from 1e-6 to 1e9, default +y; or with
                            // TSU_HAIR_SHADOW_POINT its place
    float width;            // mean diameter of a fibre, [0, 1e9]; 0: no hair. For the twin and for
                            // the range of RGBA8; default 0
    float length;           // of all strands together, [0, 1e12]; 0: no hair; default 0
    float volume;           // that hair fills, [0, 1e30]; 0: 0.15 of the sphere, a head of hair
    float spacing;          // mean distance between neighbouring strands, [0, 1e9]; 0:
                            // sqrt(volume / length), the side of the square that is each strand's
    uint32_t size;          // texels along a side, [8, 8192]; 0, the default: chosen, as many as
                            // make a texel `spacings` strand spacings wide
    uint32_t least_size;    // of a chosen size, [8, 8192], default 16
    uint32_t most_size;     // of a chosen size, [8, 8192], default 512
    uint32_t tile_x;        // lower left texel of the map in the host's textures, [0, 65535],
    uint32_t tile_y;        // default 0: maps of many lights may share one atlas, and its samplers
    uint32_t reserved[2];   // 0
} tsu_hair_shadow_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_hair_shadow_desc_init_sized(tsu_hair_shadow_desc *desc, size_t size);
#define tsu_hair_shadow_desc_init(desc) tsu_hair_shadow_desc_init_sized((desc), sizeof *(desc))

enum {
    TSU_HAIR_SHADOW_EMPTY = 1,  // length or width is 0: clear the targets and draw nothing
    TSU_HAIR_SHADOW_PARTIAL = 2 // the light is in the hair or close to it: the map sees a cone of
                                // 76 degrees around the centre, hair outside casts no shadow
};

// What to make and to draw. Data only: it may be copied, kept and written to a file.
typedef struct tsu_hair_shadow_plan {
    uint32_t struct_size;  // set by tsu_hair_shadow_plan_init()
    uint32_t flags;        // TSU_HAIR_SHADOW_EMPTY, _PARTIAL
    uint32_t size;         // texels along a side of the map
    uint32_t layers;       // [1, 8]
    uint32_t target_count; // see tsu_hair_shadow_target()
    uint32_t pass_count;   // see tsu_hair_shadow_pass()
    float spacing;         // mean distance between neighbouring strands; 0 when empty
    float texel;           // side of a texel at the centre of the hair
    float near_plane;      // distance from the light's plane, or from its place, along the axis
    float far_plane;
    float boundary[9];     // distances behind the front at which layers begin and end, [0] = 0
    float opacity;         // of the technique's parameters
    int32_t color;         // tsu_format of the targets that sum up
    uint32_t reserved;     // 0
    float to_light[16];    // world to clip space, column after column
    // What the snippets take as `vec4 record[12]`:
    //   0, 1, 2   rows: place in the map in texels times w, w
    //   3         row: distance behind the near plane
    //   4         (a z + b) / (c z + d): stored depth z in [0, 1] to that distance
    //   5, 6      1 / thickness of layers 1..4, 5..8; 0: there is no such layer
    //   7, 8      -beginning / thickness of the layers
    //   9         tile x, tile y, size, 1 / size, in texels
    //   10        opacity, fibres in a stored 1, fibres of a step (0: floats), deepest distance
    //   11        0, reserved
    float record[48];
} tsu_hair_shadow_plan;
#define tsu_hair_shadow_plan_init(plan) tsu_info_init_sized((plan), sizeof *(plan))

// Plan the maps of one light. Pure computation; once when light, hair or limits change.
// A light in the hair gives a partial plan and one warning in the log.
// Errors: TSU_E_STRUCT, TSU_E_PARAMETER (a field that is not finite or out of range, named; a model
// that is no technique; parameters of the technique; least_size above most_size).
// Threads: any.
TSU_API tsu_status tsu_hair_shadow_make(tsu_context *context, const tsu_hair_shadow_desc *desc,
                                        tsu_hair_shadow_plan *out);

// A texture that a plan needs, `size` texels square. One level, nearest filter, clamped.
typedef struct tsu_hair_shadow_target_info {
    uint32_t struct_size; // set by tsu_hair_shadow_target_info_init()
    uint32_t flags;       // 0
    const char *name;     // "front", "layers", "deeper": the argument of the read function
    tsu_format format;
    float clear[4]; // value before the first pass; depth in [0]
} tsu_hair_shadow_target_info;
#define tsu_hair_shadow_target_info_init(info) tsu_info_init_sized((info), sizeof *(info))
// Errors: TSU_E_PARAMETER (NULL, index), TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_hair_shadow_target(const tsu_hair_shadow_plan *plan, uint32_t index,
                                          tsu_hair_shadow_target_info *out);

// A pass over all hair, in any order, with to_light and a viewport over the tile. No culling, no
// blending unless said. A fragment of share 0 may be discarded.
typedef struct tsu_hair_shadow_pass_info {
    uint32_t struct_size; // set by tsu_hair_shadow_pass_info_init()
    uint32_t flags;       // 0
    const char *name;     // "front", "layers"
    uint32_t targets;     // bit i: target i is drawn to, in this order
    uint32_t depth_test;  // 1: GL_LESS, with depth writes
    uint32_t blend_add;   // 1: GL_FUNC_ADD with GL_ONE, GL_ONE, all channels
    const char *function; // GLSL that gives the outputs; "": no output but depth
} tsu_hair_shadow_pass_info;
#define tsu_hair_shadow_pass_info_init(info) tsu_info_init_sized((info), sizeof *(info))
// Errors: TSU_E_PARAMETER (NULL, index), TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_hair_shadow_pass(const tsu_hair_shadow_plan *plan, uint32_t index,
                                        tsu_hair_shadow_pass_info *out);

// The same maps in memory, for hosts that shade on the CPU or bake shadow into vertices, and for
// tests: what the passes draw and what the snippets read, in float.
//
// A map is size x size distances of the first fibre, then `layers` images of size x size numbers of
// fibres. Floats that it takes; 0 for NULL. Threads: any.
TSU_API size_t tsu_hair_shadow_floats(const tsu_hair_shadow_plan *plan);

// Draw strands into `map`, both passes, from an empty map.
//   points   x, y, z and diameter of each point, one strand after the other
//   first    index of each strand's first point; one more than strands. May be NULL for 0 strands
// A segment with a coordinate that is not finite is left out.
// Errors: TSU_E_PARAMETER (NULL). Threads: object (`map`).
TSU_API tsu_status tsu_hair_shadow_write(const tsu_hair_shadow_plan *plan, const float *points,
                                         const uint32_t *first, uint32_t strands, float *map);

// Read `map` at a point: front, behind, direct, transmittance, as the GLSL. Outside of the map, and
// for a point that is not finite, there is no shadow: 0, TSU_HAIR_SHADOW_UNKNOWN or 0, 1, 1.
// Errors: TSU_E_PARAMETER (NULL). Threads: any.
TSU_API tsu_status tsu_hair_shadow_read(const tsu_hair_shadow_plan *plan, const float *map,
                                        const float position[3], float shadow[4]);

#ifdef __cplusplus
}
#endif
#endif

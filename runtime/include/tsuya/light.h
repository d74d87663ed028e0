// Lights: directional, point, rectangle, disk, and surroundings as spherical harmonics.
//
// A light becomes a record of four vec4, an environment one of nine, that the host puts wherever
// it likes (uniforms, a block, a texture). Snippets, asked for with TSU_SHADER_LIGHTS, turn a
// record, a fibre and a viewer into a few directions with radiance times solid angle, and any model
// of the library is evaluated in each and added: no model knows lights, no light knows models.
//
//   tsu_light_fiber tsu_light_lobes(float alpha_R, float beta_R)   marschner, dual_scattering, ...
//   tsu_light_fiber tsu_light_cone(float alpha_R, float beta_R)    kajiya_kay
//   tsu_light tsu_light_begin(vec4 record[4], tsu_light_fiber fiber, vec3 position, vec3 t, vec3 v)
//   vec3 tsu_light_sample(tsu_light light, int i, out vec3 l)       i < light.count
//   int tsu_environment_count(vec4 record[9])
//   vec3 tsu_environment_sample(vec4 record[9], tsu_light_fiber fiber, vec3 t, vec3 v, int i,
//                               out vec3 l)
//   vec3 tsu_environment_radiance(vec4 record[9], vec3 d)           a background, the head's skin
//
// Cost. Directional and point lights, and areas of less than some 0.0013 sr, are one evaluation of
// the model. Larger areas are `samples` evaluations, 13 by default, and some 20 arc tangents a
// direction; the environment `samples`, 12 by default.
//
// Error: mean of |estimate - truth| over fibres, views, lights and hair from black to white at
// random, of the mean truth; the truth sums the light densely. Measured by tests/light on the GPU,
// for every model at its default roughness:
//
//                          area to 1 sr, 13   smooth sky, 12   sky with a window or sun, 12 + 13
//   marschner                   4.1 %             4.5 %               8.8 %
//   kajiya_kay                  2.7 %             5.5 %               5.1 %
//   dual_scattering             3.6 %             4.7 %               7.0 %
//   plane_parallel_hair         3.7 %             4.3 %               6.8 %
//
// The mean itself is right within 1 % for areas, 2.5 % for surroundings. A rectangle (sides to
// 1 : 3) errs half again as much as a disk, a light at the fibre's pole more than twice as much; of
// single fibres, one in twenty is off by a quarter of the mean. White hair in uniform light gives
// back 1 +- 0.02 in the mean over views, up to 1.2 at the worst. marschner under 1 sr by evaluations:
// 3 15 %, 5 11 %, 8 7 %, 13 5 %, 21 4 %, 34 3 %; under 0.2 sr: 3 10 %, 5 7 %, 8 5 %, 13 3 %. Above
// 1 sr the error grows; a light whose plane holds the fibre makes up to 1.2 of its light.
//
// Shadow. One look in the direction of the light's centre (tsu_light.middle) for all its
// directions: front, behind, direct and transmittance are the centre's, and the shadow of a large
// light is as sharp as that of a small one. Looking in every direction is right, too, and costs a
// look each. An environment's directions each need their own.
//
// Units. Radiance L in any unit the host likes (W/m^2/sr, cd/m^2, "1 is white"), linear Rec. 709;
// irradiance is L times sr, intensity L times area in the host's unit of length.
#ifndef TSUYA_LIGHT_H
#define TSUYA_LIGHT_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t tsu_light_kind;
enum {
    TSU_LIGHT_DIRECTIONAL = 1, // far away; a disk with `angle` (the sun's is 0.00465)
    TSU_LIGHT_POINT = 2,
    TSU_LIGHT_RECT = 3, // of even radiance from all angles
    TSU_LIGHT_DISK = 4
};
enum { TSU_LIGHT_TWO_SIDED = 1 }; // rect and disk shine to both sides
enum {
    TSU_LIGHT_RECORD_VEC4 = 4,
    TSU_ENVIRONMENT_RECORD_VEC4 = 9,
    TSU_LIGHT_SAMPLES = 64 // most evaluations
};
// Largest mean errors over all models, see above: areas up to 1 sr; environments.
#define TSU_LIGHT_AREA_ERROR 0.05
#define TSU_LIGHT_ENVIRONMENT_ERROR 0.10

// One light. Places and lengths in the host's unit, in any one space.
typedef struct tsu_light_desc {
    uint32_t struct_size; // set by tsu_light_desc_init()
    uint32_t flags;       // TSU_LIGHT_TWO_SIDED; default 0
    tsu_light_kind kind;  // default TSU_LIGHT_DIRECTIONAL
    uint32_t samples;     // evaluations of an area, [1, 64], default 13
    float color[3];       // linear RGB, [0, 1e30], default 1: irradiance of a surface that faces a
                          // directional light, radiant intensity of a point, radiance of an area
    float angle;          // directional: angle between centre and rim, radians, [0, 0.6], default 0
    float direction[3];   // directional: towards the light, of any length from 1e-6 to 1e9;
                          // default +y
    float least;          // point: from nearer than this it is as bright as from here, [1e-6, 1e9],
                          // default 1e-3; what keeps a light inside the hair finite
    float position[3];    // point, rect, disk: centre, [-1e9, 1e9], default 0
    float reserved;       // 0
    float x[3];           // rect, disk: half axes, of lengths from 1e-6 to 1e9, at right angles
    float y[3];           // within 0.001 rad; of a disk equally long within 0.1 %. The light shines
                          // along the cross product x times y. Default x and z, length 0.5
} tsu_light_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_light_desc_init_sized(tsu_light_desc *desc, size_t size);
#define tsu_light_desc_init(desc) tsu_light_desc_init_sized((desc), sizeof *(desc))

// Check a light and write the snippets' record, zeroed on failure:
//   0  place, or unit vector towards a directional light; kind: 0 directional, 1 point, 2 rect,
//      3 disk, 4 directional with an angle
//   1  half axis x, samples       2  half axis y, 1 when two-sided
//   3  color (radiance for kinds 2, 3, 4), least
// Fields that the kind does not use are not looked at.
// Errors: TSU_E_STRUCT, TSU_E_PARAMETER (the log names the field and its range). Threads: any.
TSU_API tsu_status tsu_light_pack(tsu_context *context, const tsu_light_desc *desc,
                                  float record[16]);

// One sample of the surroundings: direction (any length), linear radiance, solid angle in sr.
// Called several times for each index, in order; the answers must not change.
typedef void (*tsu_radiance_fn)(void *user, uint32_t index, float direction[3], float radiance[3],
                                float *solid_angle);

typedef struct tsu_environment_desc {
    uint32_t struct_size;     // set by tsu_environment_desc_init()
    uint32_t flags;           // 0
    tsu_radiance_fn radiance; // not NULL; directions spread over the whole sphere
    void *user;
    uint32_t count;           // of samples, [6, 2^27]
    uint32_t samples;         // evaluations, [1, 64], default 12; 8 err by up to 15 %
    float threshold;          // what is brighter than this many times the mean is excess that may
                              // become the dominant light, [1, 1e9], default 3; 1e9: never
    uint32_t reserved;        // 0
} tsu_environment_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_environment_desc_init_sized(tsu_environment_desc *desc, size_t size);
#define tsu_environment_desc_init(desc) tsu_environment_desc_init_sized((desc), sizeof *(desc))

// Surroundings in two parts whose sum has the power of the samples, colour by colour.
typedef struct tsu_environment {
    uint32_t struct_size;      // set by tsu_environment_init()
    uint32_t flags;            // 0
    float light_direction[3];  // the dominant light: towards it, unit; +y when there is none
    float light_angle;         // from its centre to its rim, radians, [0, 0.6]
    float light_irradiance[3]; // 0: there is none. All three as in a directional tsu_light_desc
    float smoothing;           // factor on the harmonics above the constant that keeps the radiance
                               // from being negative, (0, 1]; 1: nothing had to be done
    float record[36];          // what the snippets take as vec4 record[9]
} tsu_environment;
#define tsu_environment_init(environment) tsu_info_init_sized((environment), sizeof *(environment))

// Project surroundings: the excess within 25 degrees of the brightest place becomes the dominant
// light, a disk of the same centre, spread and power; the rest spherical harmonics of order 2
// (Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps",
// for the order; radiance is kept here, not irradiance).
// Errors: TSU_E_STRUCT, TSU_E_PARAMETER (a field out of range; a sample that is not finite, or
// negative; solid angles that do not sum to 4 pi within 2 %). Threads: any.
TSU_API tsu_status tsu_environment_make(tsu_context *context, const tsu_environment_desc *desc,
                                        tsu_environment *out);

#ifdef __cplusplus
}
#endif
#endif

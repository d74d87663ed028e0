// A leaf without its gloss: what goes back and what comes through after scattering inside.
//
// A leaf is two plane layers, palisade on top of sponge, between smooth walls of one index n. Each
// layer scatters (Henyey-Greenstein, mean cosine TSU_LEAF_G) and absorbs; light obeys the
// plane-parallel transport equation (Shinya's survey, section 3.3, eq. 10), solved by adding and
// doubling when the table is baked. Green leaves reflect 1.4 to 2.4 times as much below as on top,
// which one layer cannot do.
//
//   BRDF or BTDF = (1 - r_l)(1 - r_v) F0 [1 + a S + b Q + c X + d (U^2 + V^2) + e Z + h (P - 1)
//                                          + j P S]
//
// r: Fresnel reflectance of the walls; U, V: 1 minus the cosine inside, below and above; S = U + V,
// D = U - V; Q = U V and X = c_l + c_v - 2 with the cosines outside, but Q = D and X = P D through
// the leaf; P = (1 + g^2 - 2 g cos)^(-3/2) of the scattering angle inside; Z its tangential part.
// F0 and a to j come from the table: 16 pigments x 7 thicknesses x 3 channels x 3 sets (reflection
// on top, below, transmission), 16 KiB.
//
// Light that crosses the leaf unscattered, or comes back so from the far wall, is given the
// distribution of a Lambert leaf: no cuticle is smooth enough to see through. The power is whole.
//
// GLSL (glsl/leaf_body/eval.glsl), six fetches a light:
//   tsu_leaf_body_lobes tsu_leaf_body_eval(int material, vec3 n, vec3 l, vec3 v, float pigment,
//                                          float thickness);
//   vec3 tsu_leaf_body_sum(lobes), tsu_leaf_body_reflected(lobes),
//   tsu_leaf_body_transmitted(lobes);
// times radiance and solid angle of the light, no further cosine. `n` is the normal of the leaf's
// top in all cases: never turn it towards the viewer. The variant `bent` takes the geometric normal
// as well, which tells the sides while `n` bends (normal maps, rounded canopies).
// tsu_leaf_body_ambient() has uniform light on each side in closed form.
//
// Range of a fragment's pigment x material's pigment: [0, 2], of thickness [0.5, 2]; beyond, the
// table ends and the last value holds. Errors: in the model's error table (tsu_model_error).
//
// Notes on the source. The survey prints Henyey-Greenstein's function with exponent 2/3 and a plus
// sign; it is 3/2, with a minus where both directions are those of travel. Its eigenvalue form
// (eq. 11) checks the solver in the tests.
#ifndef TSUYA_MODELS_LEAF_BODY_H
#define TSUYA_MODELS_LEAF_BODY_H

#include <tsuya/set.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TSU_LEAF_G 0.5 // mean cosine of scattering inside a leaf

// Depths are optical depths of the whole layer along its normal, without unit, linear RGB:
// scatter is reduced scattering, sigma_s (1 - g) d; absorption is sigma_a d. tsuya/leaf.h finds
// them from pigments, or from reflectance and transmittance.
typedef struct tsu_leaf_body_params {
    uint32_t struct_size; // set by tsu_leaf_body_params_init()
    uint32_t flags;       // 0
    float n;              // index of the walls and the inside, [1.2, 1.8], default 1.45
    float scatter_top[3], absorption_top[3];       // palisade, [0, 50], [0, 1e6]
    float scatter_bottom[3], absorption_bottom[3]; // sponge, the same; default a mature leaf
    float pigment;                                 // factor on absorption, [0, 2], default 1
    float thickness;                               // factor on all depths, [0.5, 2], default 1
} tsu_leaf_body_params;

TSU_API const tsu_model *tsu_leaf_body(void);
// Numbers of a leaf of one pigment and one thickness, for tsu_leaf_body_uniform() and
// tsu_leaf_uniform() in GLSL, which fetch nothing: six matrices of 3 columns (channels) of 4, for
// glUniformMatrix3x4fv(location, 6, GL_FALSE, numbers). Baked again by nothing, 5 us.
//   material   of leaf_body, leaf or a model that extends them, baked
//   pigment    factor as of a fragment, with the material's own in [0, 2]
//   thickness  the same, [0.5, 2]
// Errors: TSU_E_PARAMETER (logged; numbers are 0), TSU_E_STATE when tables are stale. Threads: as
// tsu_set_record().
TSU_API tsu_status tsu_leaf_body_uniform(tsu_set *set, uint32_t material, float pigment,
                                         float thickness, float numbers[72]);
#define tsu_leaf_body_params_init(params)                                                          \
    tsu_model_params_init(tsu_leaf_body(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

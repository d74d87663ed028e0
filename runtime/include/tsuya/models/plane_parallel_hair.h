// Light through a head of hair from the solved layer problem: the most accurate of the hair models.
//
// Sources: Shinya et al. 2010 (hair volume as plane-parallel layers of parallel fibres); van de Hulst
//          1980, "Multiple Light Scattering" (adding and doubling).
//
// Same inputs, lobes and parameters as dual_scattering.h. There, energies come from a closed form with
// one fitted constant; here the layer problem of this very fibre is solved for nine absorptions when
// its table is baked (optics/fiber_layer.h) and the closed form's four numbers are corrected, for each
// inclination and absorption, so that layers of 0.5 to 16 fibres and a half space reflect and transmit
// what the solution says. Light that is sent on keeps its way for some fibres before it is diffuse:
// the closed form counts n fibres to a surface as n - 1.8 (1 - 2^(-n/4)). The lobes are those that
// come nearest to the solution's distribution over theta_i + theta_r. The price a light is
// dual_scattering's and 6 to 18 clocks.
//
// Tables: azimuthal (marschner's), layer 64 x 128 = 64 KiB (all of the fibre's shape). Colour bakes
//         nothing and may vary per fragment. A bake takes seconds: give the context a jobs callback
//         (nine units of work) and bake away from the frame.
// GLSL:   tsu_plane_parallel_hair_eval, tsu_plane_parallel_hair_finite_eval (with `behind`),
//         tsu_plane_parallel_hair_sum, tsu_marschner_sigma_a; seven fetches a light.
// Errors: in the model's error table (tsu_model_error), measured by tests/models/plane_parallel_hair.
#ifndef TSUYA_MODELS_PLANE_PARALLEL_HAIR_H
#define TSUYA_MODELS_PLANE_PARALLEL_HAIR_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_plane_parallel_hair_params {
    uint32_t struct_size; // set by tsu_plane_parallel_hair_params_init()
    uint32_t flags;       // 0
    float eta;            // refractive index, [1.2, 2], default 1.55
    float alpha_R;        // shift of R in theta_i + theta_r, radians, [-20, 20] degrees,
                          // default -7.5
    float beta_R;         // deviation of R in theta_i + theta_r, radians, [2, 30] degrees,
                          // default 7.5
    float beta_az;        // azimuthal deviation, radians, [5, 30] degrees, default 10
    float sigma_a[3];     // absorption per fibre radius, linear RGB, [0, 1e6], default brown hair
    float scale_shifts;   // shifts of the later lobes, [0, 1], default 0, as in marschner.h
    float d_f;            // factor on the light that goes on, [0, 1], default 1
    float d_b;            // factor on the light that comes back, [0, 1], default 1
} tsu_plane_parallel_hair_params;

TSU_API const tsu_model *tsu_plane_parallel_hair(void);
#define tsu_plane_parallel_hair_params_init(params)                                                \
    tsu_model_params_init(tsu_plane_parallel_hair(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

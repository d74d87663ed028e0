// Kajiya and Kay's fibre: a diffuse sine and a highlight on a cone, with Marschner's energy.
//
// Source: Kajiya and Kay 1989, "Rendering Fur with Three Dimensional Textures", eqs. 14 and 16.
//
// The survey's form is L = k_s cos^n(theta_i - theta_o) with both angles measured from the same end
// of the tangent, so that the mirror cone is theta_i = theta_o. In tsuya's inclinations the mirror
// cone is theta_r = -theta_i: cos(theta_i - theta_o) reads cos(theta_i + theta_r - alpha_R), the
// shift as in Marschner's R; a shifted view past a pole comes back on the other side.
//
//   value = (1 - k_R) exp(-sigma_a s) cos(theta_i) / pi^2
//           + k_R cos^n(theta_i + theta_r - alpha_R) / E
//
// S cos(theta_i) in 1/sr as for every model. k_R(theta_r) is Marschner's surface reflection, E the
// integral of the highlight, s(theta_r) the path that gives the body Marschner's albedo, n =
// 1/beta_R^2: changing the model keeps the exposure.
//
// Tables: none. GLSL: tsu_kajiya_kay_eval, tsu_kajiya_kay_sum, tsu_kajiya_kay_sigma_a; no fetch.
// Errors: in the model's error table (tsu_model_error), measured by tests/models/kajiya_kay.
#ifndef TSUYA_MODELS_KAJIYA_KAY_H
#define TSUYA_MODELS_KAJIYA_KAY_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_kajiya_kay_params {
    uint32_t struct_size; // set by tsu_kajiya_kay_params_init()
    uint32_t flags;       // 0
    float eta;            // refractive index, [1.2, 2], default 1.55
    float alpha_R;    // shift of the highlight in theta_i + theta_r, radians, [-20, 20] degrees,
                      // default -7.5
    float beta_R;     // deviation of the highlight, radians, [2, 30] degrees, default 7.5
    float sigma_a[3]; // absorption per fibre radius, linear RGB, [0, 1e6], default brown hair
} tsu_kajiya_kay_params;

TSU_API const tsu_model *tsu_kajiya_kay(void);
#define tsu_kajiya_kay_params_init(params)                                                         \
    tsu_model_params_init(tsu_kajiya_kay(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

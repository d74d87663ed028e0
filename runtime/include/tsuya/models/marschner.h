// Marschner's hair fibre: R, TT, TRT and the residual of all longer paths.
//
// Sources: Marschner et al. 2003, "Light Scattering from Human Hair Fibers" (geometry, lobes);
//          d'Eon et al. 2011, "An Energy-Conserving Hair Reflectance Model" (longitudinal lobe,
//          blurred azimuthal scattering).
//
// Conventions. theta is the inclination from the fibre's normal plane (asin of direction . tangent,
// positive towards the tip), phi = phi_r - phi_i, phi = 0 straight back. A lobe p is
//
//     M_p(theta_i, theta_r - alpha_p) N_p(phi; theta_r)       = S cos(theta_i), 1/sr
//
// with the shift in theta_i + theta_r ("sum" convention: half the tilt of Marschner's theta_h),
//     alpha_p = (1, -1/2, -3/2, -5/2) alpha_R,  beta_p = (1, 1/2, 2, 2) beta_R,
// so L_r = Int L_i value dω_i with no further cosine. The shift rotates the view, N is taken at the
// view's inclination: the integral over all light directions is exactly 1 without absorption, for
// every view. The price is reciprocity: with the default shift, exchanging light and view changes
// the sum by up to the ratio that `reciprocity` in the error table prints.
//
// Tables: azimuthal, 128 x 128 RGBA16F = 128 KiB, depends on eta and beta_az alone. Colour, shift
//         and longitudinal roughness are free.
// GLSL:   tsu_marschner_eval, tsu_marschner_sum, tsu_marschner_sigma_a; two fetches a light.
//         The residual, 1 to 14 % of the light, is evaluated with TRT's longitudinal lobe (shift
//         -3/2 alpha_R): exact in energy, its highlight off by alpha_R. TSU_SHADER_FINE gives it
//         its own.
// Errors: in the model's error table (tsu_model_error), measured by tests/models/marschner.
#ifndef TSUYA_MODELS_MARSCHNER_H
#define TSUYA_MODELS_MARSCHNER_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_marschner_params {
    uint32_t struct_size; // set by tsu_marschner_params_init()
    uint32_t flags;       // 0
    float eta;            // refractive index, [1.2, 2], default 1.55
    float alpha_R;        // shift of R in theta_i + theta_r, radians, [-20, 20] degrees,
                          // default -7.5
    float beta_R;         // deviation of R in theta_i + theta_r, radians, [2, 30] degrees,
                          // default 7.5
    float beta_az;        // azimuthal deviation, radians, [5, 30] degrees, default 10
    float sigma_a[3];     // absorption per fibre radius, linear RGB, [0, 1e6], default brown hair
    float scale_shifts;   // shifts of the later lobes, [0, 1], default 0: the textbook's, above;
                          // 1: those that real tilted scales show, alpha_p = (1, -0.92, -3.2,
                          // -1.2) alpha_R (ray tracing of stacked cone frusta, 3 degree scales)
} tsu_marschner_params;

TSU_API const tsu_model *tsu_marschner(void);
#define tsu_marschner_params_init(params)                                                          \
    tsu_model_params_init(tsu_marschner(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

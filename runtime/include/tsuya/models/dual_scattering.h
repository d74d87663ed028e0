// Light through a head of hair: all of marschner plus the light that other fibres scatter.
//
// Sources: Zinke et al. 2008, "Dual Scattering Approximation for Fast Multiple Scattering in Hair"
//          (variant zinke, and the structure: light from in front, light back from behind);
//          Chandrasekhar 1960, "Radiative Transfer" (two-stream equations; variant exact).
//
// What the host gives beyond marschner's inputs, for each light and fibre (snippet hair_shadow
// computes all three from maps or takes the host's own):
//     front   mean number of fibres between this one and the light
//     behind  the same on the far side of this one, away from the light; unknown: a large number
//     direct  share of the direct light that arrives; fibres at random give exp(-front)
// L_r = Int L_i (direct S + multiple) cos(theta_i) dω_i: do not multiply by a transmittance again.
//
// exact, the default: all orders of scattering in closed form (optics/two_stream.h: aligned shares
// for the first event, averaged ones for the others, one fitted constant), split into the light that
// comes back on the viewer's side and the light that goes on, each with its own longitudinal lobe
// whose mean and variance are moments of the same solution. A slab drawn fibre by fibre reflects and
// transmits what the transport equation says, within `slab`; without absorption it gives back all
// but `slab_white` of what falls in.
//
// zinke: as published, with averaged shares, two orders of back scattering and forward scattering
// afz^n. Of the errata decided one by one: d_f once; (1 - D) T_f; sigma_b squared; A_3 over the cube;
// 0.7 in sigma_b is a fit constant and not d_b; the sign in Delta_b as printed; no pi in F_scatter,
// because N^G and f_back are normalised; Gaussians replaced by d'Eon's lobe of the same variance, so
// that A_b is what returns. It takes no `behind`, and a table of its own: a material without
// TSU_DUAL_SCATTERING_ZINKE has no light of other fibres in it.
//
// Tables: azimuthal (marschner's, 128 KiB; the same cell serves both models' own materials), fields
//         64 x 32 = 16 KiB (eta, beta_az), spread 32 x 32 = 8 KiB (these and alpha_R, beta_R,
//         scale_shifts); with TSU_DUAL_SCATTERING_ZINKE zinke, 64 x 128 = 64 KiB (all of them).
//         Colour bakes nothing and may vary per fragment.
// GLSL:   tsu_dual_scattering_eval (hair that is thick behind every fibre),
//         tsu_dual_scattering_finite_eval (with `behind`), tsu_dual_scattering_zinke_eval,
//         tsu_dual_scattering_sum, tsu_marschner_sigma_a; seven fetches a light.
// Errors: in the model's error table (tsu_model_error), measured by tests/models/dual_scattering.
#ifndef TSUYA_MODELS_DUAL_SCATTERING_H
#define TSUYA_MODELS_DUAL_SCATTERING_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_dual_scattering_params {
    uint32_t struct_size; // set by tsu_dual_scattering_params_init()
    uint32_t flags;       // TSU_DUAL_SCATTERING_* bits, default 0
    float eta;            // refractive index, [1.2, 2], default 1.55
    float alpha_R;        // shift of R in theta_i + theta_r, radians, [-20, 20] degrees,
                          // default -7.5
    float beta_R;         // deviation of R in theta_i + theta_r, radians, [2, 30] degrees,
                          // default 7.5
    float beta_az;        // azimuthal deviation, radians, [5, 30] degrees, default 10
    float sigma_a[3];     // absorption per fibre radius, linear RGB, [0, 1e6], default brown hair
    float scale_shifts;   // shifts of the later lobes, [0, 1], default 0, as in marschner.h
    float d_f;            // factor on the light that goes on (zinke: on forward scattering, the
                          // density factor d_f, applied once), [0, 1], default 1
    float d_b;            // factor on the light that comes back (zinke: d_b), [0, 1], default 1
} tsu_dual_scattering_params;
enum {
    TSU_DUAL_SCATTERING_ZINKE = 1 // bakes the table of variant zinke as well
};

TSU_API const tsu_model *tsu_dual_scattering(void);
#define tsu_dual_scattering_params_init(params)                                                    \
    tsu_model_params_init(tsu_dual_scattering(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

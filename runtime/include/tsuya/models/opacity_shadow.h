// Opacity shadow maps: layers of hair at fixed distances from the light.
//
// Source: Kim and Neumann 2001, "Opacity Shadow Maps".
// How it is planned, drawn and read: tsuya/hair_shadow.h.
// Errors: in the model's error table (tsu_model_error), measured by tests/hair_shadow.
#ifndef TSUYA_MODELS_OPACITY_SHADOW_H
#define TSUYA_MODELS_OPACITY_SHADOW_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_opacity_shadow_params {
    uint32_t struct_size; // set by tsu_opacity_shadow_params_init()
    uint32_t flags;       // 0
    float opacity;        // share of the light that one fibre takes out of its way, [0, 1], default
                          // 1; transmittance = exp(-opacity front)
    float spacings;       // side of a texel in strand spacings, [0.1, 100], default 1.5
    float layers;         // number of layers, whole, [1, 8], default 8
    float growth;         // thickness of a layer over that of the one before it, [1, 4], or 0, the
                          // default: chosen, all alike
} tsu_opacity_shadow_params;

TSU_API const tsu_model *tsu_opacity_shadow(void);
#define tsu_opacity_shadow_params_init(params)                                                    \
    tsu_model_params_init(tsu_opacity_shadow(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

// Deep opacity maps: layers of hair behind the first fibre of each texel of a light's map.
//
// Source: Yuksel and Keyser 2008, "Deep Opacity Maps".
// How it is planned, drawn and read: tsuya/hair_shadow.h.
// Errors: in the model's error table (tsu_model_error), measured by tests/hair_shadow.
#ifndef TSUYA_MODELS_DEEP_OPACITY_H
#define TSUYA_MODELS_DEEP_OPACITY_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tsu_deep_opacity_params {
    uint32_t struct_size; // set by tsu_deep_opacity_params_init()
    uint32_t flags;       // 0
    float opacity;        // share of the light that one fibre takes out of its way, [0, 1], default
                          // 1; transmittance = exp(-opacity front)
    float spacings;       // side of a texel in strand spacings, [0.1, 100], default 1.5
    float layers;         // number of layers, whole, [1, 8], default 8
    float growth;         // thickness of a layer over that of the one before it, [1, 4], or 0, the
                          // default: chosen, 1 + 4.8 / layers
} tsu_deep_opacity_params;

TSU_API const tsu_model *tsu_deep_opacity(void);
#define tsu_deep_opacity_params_init(params)                                                      \
    tsu_model_params_init(tsu_deep_opacity(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

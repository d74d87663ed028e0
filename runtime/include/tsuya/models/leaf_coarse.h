// The body of a leaf by four numbers in place of eight: three fetches a light, not six.
//
//   BRDF or BTDF = (1 - r_l)(1 - r_v) F0 [1 + a S + b Q + h (P - 1)], terms as in leaf_body.h
//
// Same parameters, same ranges, same record; its table is fitted for this form and is its own.
// GLSL (glsl/leaf_coarse/eval.glsl): tsu_leaf_coarse_eval, _sum, _reflected, _transmitted.
// Errors: in the model's error table, measured by tests/models/leaf_coarse.
#ifndef TSUYA_MODELS_LEAF_COARSE_H
#define TSUYA_MODELS_LEAF_COARSE_H

#include <tsuya/models/leaf_body.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef tsu_leaf_body_params tsu_leaf_coarse_params;

TSU_API const tsu_model *tsu_leaf_coarse(void);
#define tsu_leaf_coarse_params_init(params)                                                        \
    tsu_model_params_init(tsu_leaf_coarse(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

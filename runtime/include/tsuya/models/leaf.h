// A leaf: the body of leaf_body.h under a rough cuticle.
//
// The coat is one bounce of GGX facets (Cook-Torrance form, Fresnel of index n, masking correlated
// by height). What it does not send back enters the leaf: the walls' 1 - r of the body becomes
// 1 - E, E the coat's albedo at that cosine, scaled so that a leaf without absorption returns all
// of uniform light. The scale is one number, so that single directions may have a few per cent more
// or less (see the error table). BRDF and BTDF are reciprocal.
//
// Lobes come separately: specular, and the body's, which was reflected or came through; the
// highlight belongs to the lit side, top or bottom alike.
//
// GLSL (glsl/leaf/eval.glsl), six fetches a light: tsu_leaf_eval, tsu_leaf_bent_eval, tsu_leaf_sum,
// tsu_leaf_reflected, tsu_leaf_transmitted, tsu_leaf_ambient; arguments as of leaf_body.
//
// Sources: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eqs. 20
// and 33; Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs",
// eq. 99.
#ifndef TSUYA_MODELS_LEAF_H
#define TSUYA_MODELS_LEAF_H

#include <tsuya/models/leaf_body.h>

#ifdef __cplusplus
extern "C" {
#endif

// Fields up to thickness as in tsu_leaf_body_params.
typedef struct tsu_leaf_params {
    uint32_t struct_size; // set by tsu_leaf_params_init()
    uint32_t flags;       // 0
    float n;
    float scatter_top[3], absorption_top[3];
    float scatter_bottom[3], absorption_bottom[3];
    float pigment;
    float thickness;
    float roughness; // width alpha of the facets, [0.05, 1], default 0.35
} tsu_leaf_params;

TSU_API const tsu_model *tsu_leaf(void);
#define tsu_leaf_params_init(params) tsu_model_params_init(tsu_leaf(), (params), sizeof *(params))

#ifdef __cplusplus
}
#endif
#endif

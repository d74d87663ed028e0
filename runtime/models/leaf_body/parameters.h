// Parameters and inputs that all models of leaves begin with.
#ifndef TSU_MODELS_LEAF_BODY_PARAMETERS_H
#define TSU_MODELS_LEAF_BODY_PARAMETERS_H

// A mature broad leaf: PROSPECT-D with N 1.5, 40 ug/cm2 of chlorophyll, R below 1.4 times R on top.
#define LEAF_DEFAULTS                                                                              \
    .n = 1.45f, .scatter_top = {0.1f, 0.1f, 0.1f}, .absorption_top = {0.73f, 0.26f, 1.6f},         \
    .scatter_bottom = {2.12f, 2.12f, 2.12f}, .absorption_bottom = {0.82f, 0.29f, 1.8f},            \
    .pigment = 1.0f, .thickness = 1.0f

#define LEAF_PARAMETERS(params)                                                                    \
    TSU_I_PARAMETER(params, n, 1, "1", 1, 1.2, 1.8, 1.45, "refractive index of walls and inside"), \
        TSU_I_PARAMETER(params, scatter_top, 3, "1", 1, 0, 50, 0.1,                                \
                        "reduced scattering depth of the top layer (palisade), linear RGB"),       \
        TSU_I_PARAMETER(params, absorption_top, 3, "1", 1, 0, 1e6, 0.26,                           \
                        "absorption depth of the top layer, linear RGB"),                          \
        TSU_I_PARAMETER(params, scatter_bottom, 3, "1", 1, 0, 50, 2.12,                            \
                        "reduced scattering depth of the bottom layer (sponge), linear RGB"),      \
        TSU_I_PARAMETER(params, absorption_bottom, 3, "1", 1, 0, 1e6, 0.29,                        \
                        "absorption depth of the bottom layer, linear RGB"),                       \
        TSU_I_PARAMETER(params, pigment, 1, "1", 0, 0, 2, 1, "factor on absorption"),              \
        TSU_I_PARAMETER(params, thickness, 1, "1", 0, 0.5, 2, 1, "factor on all depths")

#define LEAF_INPUTS                                                                                \
    TSU_I_INPUT("material", "int", 0, "index of the material in the bound page"),                  \
        TSU_I_INPUT("n", "vec3", 0, "unit normal of the leaf's top, whichever side is seen"),      \
        TSU_I_INPUT("l", "vec3", 0, "unit vector to the light"),                                   \
        TSU_I_INPUT("v", "vec3", 0, "unit vector to the viewer"),                                  \
        TSU_I_INPUT("pigment", "float", TSU_INPUT_EXTRA, "factor on absorption, [0, 2]"),          \
        TSU_I_INPUT("thickness", "float", TSU_INPUT_EXTRA, "factor on all depths, [0.5, 2]")

// Of models with the variant that takes it.
#define LEAF_FACE_INPUT                                                                            \
    TSU_I_INPUT("face", "vec3", TSU_INPUT_EXTRA | TSU_INPUT_VARIANT,                               \
                "geometric normal of the leaf's top")

#endif

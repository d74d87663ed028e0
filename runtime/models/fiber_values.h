// What marschner and the models that add multiple scattering to it say alike: a fibre's parameters,
// their defaults, a shader's inputs.
#ifndef TSU_MODELS_FIBER_VALUES_H
#define TSU_MODELS_FIBER_VALUES_H

#include "models/values.h"

// Of brown hair: eumelanin 1.3 of melanin.c.
#define TSU_I_FIBER_DEFAULTS                                                                       \
    .eta = 1.55f, .alpha_R = (float)TSU_I_DEGREES(-7.5), .beta_R = (float)TSU_I_DEGREES(7.5),      \
    .beta_az = (float)TSU_I_DEGREES(10), .sigma_a = {0.5447f, 0.9061f, 1.781f}

// t: the typed struct; lobes: 1 when the longitudinal lobes are baked
#define TSU_I_FIBER_PARAMETERS(t, lobes)                                                           \
    TSU_I_PARAMETER(t, eta, 1, "1", 1, 1.2, 2.0, 1.55, "refractive index of the fibre"),           \
        TSU_I_PARAMETER(t, alpha_R, 1, "rad", lobes, TSU_I_DEGREES(-20), TSU_I_DEGREES(20),        \
                        TSU_I_DEGREES(-7.5),                                                       \
                        "shift of the R lobe in theta_i + theta_r; negative is towards the root"), \
        TSU_I_PARAMETER(t, beta_R, 1, "rad", lobes, TSU_I_DEGREES(2), TSU_I_DEGREES(30),           \
                        TSU_I_DEGREES(7.5), "longitudinal deviation of R in theta_i + theta_r"),   \
        TSU_I_PARAMETER(t, beta_az, 1, "rad", 1, TSU_I_DEGREES(5), TSU_I_DEGREES(30),              \
                        TSU_I_DEGREES(10), "azimuthal deviation"),                                 \
        TSU_I_PARAMETER(t, sigma_a, 3, "1/radius", 0, 0, 1e6, 0.9061,                              \
                        "absorption per fibre radius, linear RGB"),                                \
        TSU_I_PARAMETER(t, scale_shifts, 1, "1", lobes, 0, 1, 0,                                   \
                        "lobe shifts from the textbook's (0) to those of real tilted scales (1)")

#define TSU_I_FIBER_INPUTS                                                                         \
    TSU_I_INPUT("material", "int", 0, "index of the material in the bound page"),                  \
        TSU_I_INPUT("t", "vec3", 0, "unit tangent, root to tip"),                                  \
        TSU_I_INPUT("l", "vec3", 0, "unit vector to the light"),                                   \
        TSU_I_INPUT("v", "vec3", 0, "unit vector to the viewer"),                                  \
        TSU_I_INPUT("sigma_a", "vec3", 0, "absorption per fibre radius, linear RGB")

// What multiple scattering adds.
#define TSU_I_MULTIPLE_PARAMETERS(t)                                                               \
    TSU_I_PARAMETER(t, d_f, 1, "1", 0, 0, 1, 1,                                                    \
                    "factor on multiply scattered light that goes on"),                            \
        TSU_I_PARAMETER(t, d_b, 1, "1", 0, 0, 1, 1,                                                \
                        "factor on multiply scattered light that comes back")

#define TSU_I_MULTIPLE_INPUTS                                                                      \
    TSU_I_INPUT("front", "float", TSU_INPUT_EXTRA,                                                 \
                "mean number of fibres between here and the light"),                               \
        TSU_I_INPUT("behind", "float", TSU_INPUT_EXTRA | TSU_INPUT_VARIANT,                        \
                    "mean number of fibres on the far side, away from the light"),                 \
        TSU_I_INPUT("direct", "float", TSU_INPUT_EXTRA, "share of the direct light that arrives")

#endif

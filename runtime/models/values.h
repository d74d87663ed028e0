// Shorthand for static descriptions of parameters, inputs and outputs.
#ifndef TSU_MODELS_VALUES_H
#define TSU_MODELS_VALUES_H

#include <tsuya/model.h>

#define TSU_I_DEGREES(x) ((x) * 0.0174532925199432958)

// A function's input that belongs to the fragment, one that belongs to the material, an output.
#define TSU_I_FRAGMENT(n, u, h, low, high, start)                                                 \
    {                                                                                             \
        .struct_size = sizeof(tsu_value_info), .name = n, .unit = u, .help = h, .minimum = low,   \
        .maximum = high, .default_value = start                                                   \
    }
#define TSU_I_MATERIAL(n, u, h, low, high, start)                                                 \
    {                                                                                             \
        .struct_size = sizeof(tsu_value_info), .flags = TSU_VALUE_MATERIAL, .name = n, .unit = u, \
        .help = h, .minimum = low, .maximum = high, .default_value = start                        \
    }
#define TSU_I_OUTPUT(n, u, h)                                                                     \
    {                                                                                             \
        .struct_size = sizeof(tsu_value_info), .name = n, .unit = u, .help = h                    \
    }

// A model parameter: field `f` of typed struct `t`, `c` floats.
#define TSU_I_PARAMETER(t, f, c, u, bakes, low, high, start, h)                                   \
    {                                                                                             \
        .struct_size = sizeof(tsu_parameter_info), .name = #f, .unit = u, .help = h,              \
        .offset = offsetof(t, f), .count = c, .rebakes = bakes, .minimum = low, .maximum = high,  \
        .default_value = start                                                                    \
    }

#define TSU_I_INPUT(n, ty, fl, h)                                                                 \
    {                                                                                             \
        .struct_size = sizeof(tsu_input_info), .flags = fl, .name = n, .type = ty, .help = h      \
    }

#define TSU_I_ERROR(n, m, r, v)                                                                   \
    {                                                                                             \
        .struct_size = sizeof(tsu_error_info), .name = n, .measure = m, .range = r, .value = v    \
    }

#endif

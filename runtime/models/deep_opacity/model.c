#include <tsuya/models/deep_opacity.h>

#include "models/model.h"
#include "models/values.h"

typedef tsu_deep_opacity_params params;

static const params defaults = {.struct_size = sizeof(params),
                                .opacity = 1.0f,
                                .spacings = 1.5f,
                                .layers = 8.0f,
                                .growth = 0.0f};

static const tsu_parameter_info parameters[] = {
    TSU_I_PARAMETER(params, opacity, 1, "1", 0, 0, 1, 1,
                    "share of the light that one fibre takes out of its way"),
    TSU_I_PARAMETER(params, spacings, 1, "1", 0, 0.1, 100, 1.5,
                    "side of a texel in strand spacings"),
    TSU_I_PARAMETER(params, layers, 1, "1", 0, 1, 8, 8, "number of layers, whole"),
    TSU_I_PARAMETER(params, growth, 1, "1", 0, 0, 4, 0,
                    "thickness of a layer over that of the one before it; 0: chosen")};

static const tsu_error_info errors[] = {
#include "models/deep_opacity/errors.inc"
};

static const tsu_input_info inputs[] = {
    TSU_I_INPUT("front", "sampler2D", 0, "depth of the first fibre, nearest filter"),
    TSU_I_INPUT("layers", "sampler2D", 0, "fibres in layers 1 to 4, nearest filter"),
    TSU_I_INPUT("deeper", "sampler2D", 0,
                "fibres in layers 5 to 8, for the function whose name ends in 8"),
    TSU_I_INPUT("record", "vec4[12]", 0, "record of the plan"),
    TSU_I_INPUT("position", "vec3", 0, "point to shade, world")};

static const char *const snippets[] = {"prelude/hair_shadow.glsl", "prelude/hair_shadow_map.glsl",
                                       "deep_opacity/map.glsl", NULL};

const struct tsu_model tsu_i_model_deep_opacity = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .flags = TSU_MODEL_SHADOW,
             .name = "deep_opacity",
             .title = "Deep opacity maps",
             .source = "Yuksel and Keyser 2008, Deep Opacity Maps",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .parameters = parameters,
    .errors = errors,
    .inputs = inputs,
    .snippets = snippets,
};

const tsu_model *tsu_deep_opacity(void)
{
    return &tsu_i_model_deep_opacity;
}

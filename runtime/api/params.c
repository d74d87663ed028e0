#include "api/params.h"

#include "base/desc.h"
#include "base/host.h"

#include <math.h>
#include <string.h>

static float read_float(const void *params, const tsu_parameter_info *info, uint32_t component)
{
    float value;
    memcpy(&value, (const char *)params + info->offset + component * sizeof value, sizeof value);
    return value;
}

// Ranges are doubles, fields floats: a bound that a float cannot hold is met by its neighbour.
static int within(double value, double minimum, double maximum)
{
    return value >= minimum - 1e-6 * fabs(minimum) && value <= maximum + 1e-6 * fabs(maximum);
}

tsu_status tsu_i_params_read(const tsu_context *context, const tsu_model *model, const void *host,
                             void *own)
{
    char name[64];
    struct { uint32_t size, flags; } head;
    size_t length = 0;
    static const char *const parts[2] = {"tsu_", "_params"};
    for (const char *c = parts[0]; *c; c++)
        name[length++] = *c;
    for (const char *c = model->info.name; *c && length < 48; c++)
        name[length++] = *c;
    for (const char *c = parts[1]; *c; c++)
        name[length++] = *c;
    name[length] = 0;

    memcpy(own, model->defaults, model->info.params_size);
    const tsu_status status = tsu_i_desc_read(context, name, host, own, model->info.params_size,
                                              model->params_least);
    if (status != TSU_OK)
        return status;
    memcpy(&head, own, sizeof head);
    if (head.flags & ~model->known_flags) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_FLAGS, "%s.flags = %u has unknown bits", name,
                  head.flags);
        return TSU_E_PARAMETER;
    }
    for (uint32_t i = 0; i < model->info.parameter_count; i++) {
        const tsu_parameter_info *info = model->parameters + i;
        for (uint32_t k = 0; k < info->count; k++) {
            const double value = (double)read_float(own, info, k);
            if (within(value, info->minimum, info->maximum))
                continue;
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_PARAMETER,
                      "%s.%s = %g, expected [%g, %g] %s", name, info->name, value, info->minimum,
                      info->maximum, info->unit);
            return TSU_E_PARAMETER;
        }
    }
    return TSU_OK;
}

tsu_status tsu_i_inputs_check(const tsu_context *context, const tsu_model *model, uint32_t function,
                              const double *in)
{
    if (!model || function >= model->info.function_count || !in) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_INDEX, "no such model function, or no inputs");
        return TSU_E_PARAMETER;
    }
    const struct tsu_i_function *f = model->functions + function;
    for (uint32_t i = 0; i < f->info.input_count; i++) {
        const tsu_value_info *info = f->inputs + i;
        if (within(in[i], info->minimum, info->maximum))
            continue;
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_INPUT, "%s of %s = %g, expected [%g, %g] %s",
                  info->name, f->info.name, in[i], info->minimum, info->maximum, info->unit);
        return TSU_E_PARAMETER;
    }
    return TSU_OK;
}

void tsu_i_outputs_zero(const tsu_model *model, uint32_t function, double *out)
{
    if (model && out && function < model->info.function_count)
        memset(out, 0, model->functions[function].info.output_count * sizeof *out);
}

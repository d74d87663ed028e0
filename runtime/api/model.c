#include "api/params.h"
#include "base/desc.h"
#include "base/host.h"

#include <string.h>

tsu_status tsu_info_init_sized(void *info, size_t size)
{
    return tsu_i_desc_init(info, size, NULL, 0, 2 * sizeof(uint32_t));
}

tsu_status tsu_model_describe(const tsu_model *model, tsu_model_info *out)
{
    return model ? tsu_i_desc_write(out, &model->info, sizeof model->info)
                 : tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
}

#define DESCRIBE(model, index, count, entry, out)                                                  \
    ((model) && (index) < (count) ? tsu_i_desc_write(out, entry, sizeof *(entry))                  \
                                  : tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER))

tsu_status tsu_model_parameter(const tsu_model *model, uint32_t index, tsu_parameter_info *out)
{
    return DESCRIBE(model, index, model->info.parameter_count, model->parameters + index, out);
}

tsu_status tsu_model_table(const tsu_model *model, uint32_t index, tsu_table_info *out)
{
    return DESCRIBE(model, index, model->info.table_count, &model->tables[index].info, out);
}

tsu_status tsu_model_error(const tsu_model *model, uint32_t index, tsu_error_info *out)
{
    return DESCRIBE(model, index, model->info.error_count, model->errors + index, out);
}

tsu_status tsu_model_input(const tsu_model *model, uint32_t index, tsu_input_info *out)
{
    return DESCRIBE(model, index, model->info.input_count, model->inputs + index, out);
}

tsu_status tsu_model_variant(const tsu_model *model, uint32_t index, tsu_variant_info *out)
{
    return DESCRIBE(model, index, model->info.variant_count, model->variants + index, out);
}

tsu_status tsu_model_function(const tsu_model *model, uint32_t index, tsu_function_info *out)
{
    return DESCRIBE(model, index, model->info.function_count, &model->functions[index].info, out);
}

tsu_status tsu_function_input(const tsu_model *model, uint32_t function, uint32_t index,
                              tsu_value_info *out)
{
    if (!model || function >= model->info.function_count)
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    const struct tsu_i_function *f = model->functions + function;
    return DESCRIBE(model, index, f->info.input_count, f->inputs + index, out);
}

tsu_status tsu_function_output(const tsu_model *model, uint32_t function, uint32_t index,
                               tsu_value_info *out)
{
    if (!model || function >= model->info.function_count)
        return tsu_i_desc_fail(out, sizeof *out, TSU_E_PARAMETER);
    const struct tsu_i_function *f = model->functions + function;
    return DESCRIBE(model, index, f->info.output_count, f->outputs + index, out);
}

tsu_status tsu_model_params_init(const tsu_model *model, void *params, size_t size)
{
    if (!model || !params)
        return TSU_E_PARAMETER;
    return tsu_i_desc_init(params, size, model->defaults, model->info.params_size,
                           model->params_least);
}

tsu_status tsu_model_params_check(tsu_context *context, const tsu_model *model, const void *params)
{
    char own[TSU_I_PARAMS_BYTES];
    if (!context || !model)
        return TSU_E_PARAMETER;
    return tsu_i_params_read(context, model, params, own);
}

tsu_status tsu_function_params(tsu_context *context, const tsu_model *model, uint32_t function,
                               const double *in, void *params)
{
    const tsu_status status = tsu_i_inputs_check(context, model, function, in);
    if (status != TSU_OK)
        return status;
    char own[TSU_I_PARAMS_BYTES];
    const tsu_status read = tsu_i_params_read(context, model, params, own);
    if (read != TSU_OK)
        return read;
    const struct tsu_i_function *f = model->functions + function;
    if (!f->material) {
        f->params(in, own);
        return tsu_i_desc_write(params, own, model->info.params_size);
    }
    void *scratch = context ? tsu_i_alloc(context, f->scratch_bytes, 1) : NULL;
    if (!scratch)
        return context ? TSU_E_MEMORY : TSU_E_PARAMETER;
    const tsu_status made = f->material(context, in, scratch, own);
    tsu_i_free(context, scratch, f->scratch_bytes, 1);
    return made == TSU_OK ? tsu_i_desc_write(params, own, model->info.params_size) : made;
}

tsu_status tsu_function_reference(tsu_context *context, const tsu_model *model, uint32_t function,
                                  const double *in, double *out)
{
    const tsu_status status =
        out ? tsu_i_inputs_check(context, model, function, in) : TSU_E_PARAMETER;
    if (status != TSU_OK) {
        tsu_i_outputs_zero(model, function, out);
        return status;
    }
    const struct tsu_i_function *f = model->functions + function;
    if (!f->scratch_bytes) {
        f->reference(in, out);
        return TSU_OK;
    }
    void *scratch = context ? tsu_i_alloc(context, f->scratch_bytes, 1) : NULL;
    if (!scratch) {
        tsu_i_outputs_zero(model, function, out);
        return context ? TSU_E_MEMORY : TSU_E_PARAMETER;
    }
    tsu_status answered = TSU_OK;
    if (f->answer)
        answered = f->answer(context, in, scratch, out);
    else
        f->solved(in, scratch, out);
    tsu_i_free(context, scratch, f->scratch_bytes, 1);
    if (answered != TSU_OK)
        tsu_i_outputs_zero(model, function, out);
    return answered;
}

#include "base/desc.h"
#include "base/hash.h"
#include "base/host.h"
#include "shade/assemble.h"
#include "shade/dialect.h"

#include <stddef.h>

struct tsu_shader {
    const tsu_context *context;
    struct tsu_i_assembly assembly;
    uint64_t key;
};

// Without `only`.
#define FIRST_LAYOUT offsetof(tsu_shader_desc, only)

tsu_status tsu_shader_desc_init_sized(tsu_shader_desc *desc, size_t size)
{
    const tsu_shader_desc defaults = {.struct_size = sizeof defaults,
                                      .target = TSU_TARGET_330,
                                      .array_materials = 1,
                                      .block_binding = 1};
    return tsu_i_desc_init(desc, size, &defaults, sizeof defaults, FIRST_LAYOUT);
}

enum {
    DROPS = TSU_SHADER_DROP_TRT | TSU_SHADER_DROP_RESIDUAL | TSU_SHADER_DROP_BACK |
            TSU_SHADER_DROP_TRANSMITTED
};

static tsu_status reject(const tsu_context *context, const char *what, uint32_t value,
                         const char *expected)
{
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_SHADER, "tsu_shader_desc.%s = %u, expected %s", what,
              value, expected);
    return TSU_E_PARAMETER;
}

static tsu_status check(const tsu_context *context, const tsu_shader_desc *desc)
{
    const uint32_t known = TSU_SHADER_ARRAY | TSU_SHADER_PROBE | TSU_SHADER_HARNESS |
                           TSU_SHADER_FINE | TSU_SHADER_LIGHTS | TSU_SHADER_BLUR | TSU_SHADER_FADE |
                           DROPS;
    if (desc->flags & ~known)
        return reject(context, "flags", desc->flags, "TSU_SHADER_* bits");
    if (desc->reserved)
        return reject(context, "reserved", desc->reserved, "0");
    if (!tsu_i_dialect_find(desc->target))
        return reject(context, "target", (uint32_t)desc->target, "a TSU_TARGET_* value");
    if (desc->model_count < 1 || desc->model_count > 1024 || !desc->models)
        return reject(context, "model_count", desc->model_count, "1 to 1024 models");
    for (uint32_t i = 0; i < desc->model_count; i++)
        if (!desc->models[i])
            return reject(context, "models", i, "no NULL entry");
    for (uint32_t i = 0; i < desc->model_count && desc->flags & TSU_SHADER_HARNESS; i++)
        if (desc->models[i]->info.flags & TSU_MODEL_SHADOW)
            return reject(context, "models", i,
                          "a model that shades fibres: a harness has no maps to read");
    if (desc->flags & TSU_SHADER_PROBE &&
        (desc->model_count != 1 || desc->function >= desc->models[0]->info.function_count ||
         !desc->models[0]->functions[desc->function].sampled))
        return reject(context, "function", desc->function, "a function of the one model asked for");
    if (desc->flags & TSU_SHADER_PROBE && desc->flags & DROPS)
        return reject(context, "flags", desc->flags, "no TSU_SHADER_DROP_* with a probe");
    if (desc->flags & TSU_SHADER_PROBE && desc->only && desc->only[0])
        return reject(context, "flags", desc->flags, "no TSU_SHADER_PROBE with `only`");
    if (desc->flags & TSU_SHADER_ARRAY && desc->target == TSU_TARGET_VULKAN)
        return reject(context, "flags", desc->flags, "no TSU_SHADER_ARRAY for Vulkan");
    if (desc->array_materials < 1 || desc->array_materials > 127)
        return reject(context, "array_materials", desc->array_materials, "[1, 127]");
    return TSU_OK;
}

tsu_status tsu_shader_create(tsu_context *context, const tsu_shader_desc *desc, tsu_shader **out)
{
    if (!out)
        return TSU_E_PARAMETER;
    *out = NULL;
    if (!context)
        return TSU_E_PARAMETER;
    tsu_shader_desc own = {0};
    tsu_status status =
        tsu_i_desc_read(context, "tsu_shader_desc", desc, &own, sizeof own, FIRST_LAYOUT);
    if (status == TSU_OK)
        status = check(context, &own);
    if (status == TSU_OK && own.flags & TSU_SHADER_PROBE &&
        own.models[0]->functions[own.function].info.flags & TSU_FUNCTION_FINE)
        own.flags |= TSU_SHADER_FINE;
    if (status != TSU_OK)
        return status;
    tsu_shader *shader = tsu_i_alloc(context, 1, sizeof *shader);
    if (!shader)
        return TSU_E_MEMORY;
    shader->context = context;
    status = tsu_i_assemble(context, &own, &shader->assembly);
    if (status != TSU_OK) {
        tsu_shader_destroy(shader);
        return status;
    }
    const struct tsu_i_text *text = &shader->assembly.text;
    shader->key = tsu_i_hash(TSU_I_HASH_START, text->bytes, text->size);
    *out = shader;
    return TSU_OK;
}

void tsu_shader_destroy(tsu_shader *shader)
{
    if (!shader)
        return;
    tsu_i_text_free(&shader->assembly.text);
    tsu_i_free(shader->context, shader, 1, sizeof *shader);
}

const char *tsu_shader_text(const tsu_shader *shader, size_t *size)
{
    if (size)
        *size = shader ? shader->assembly.text.size : 0;
    return shader ? shader->assembly.text.bytes : NULL;
}

uint64_t tsu_shader_key(const tsu_shader *shader)
{
    return shader ? shader->key : 0;
}

const char *tsu_shader_source(const tsu_shader *shader, uint32_t source)
{
    return shader && source < shader->assembly.source_count && source < TSU_I_SOURCES
               ? shader->assembly.sources[source]
               : NULL;
}

float tsu_fade_strand(uint32_t strand)
{
    uint32_t x = strand * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    x = (x >> 22) ^ x;
    return (float)(x >> 8) * (1.0f / 16777216.0f);
}

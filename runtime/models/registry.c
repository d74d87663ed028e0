#include "models/model.h"

#include <tsuya/hair_shadow.h>

#include <string.h>

#define TSU_MODEL(name) extern const struct tsu_model tsu_i_model_##name;
#include "models/registry.inc"
#undef TSU_MODEL

const struct tsu_model *const tsu_i_models[] = {
#define TSU_MODEL(name) &tsu_i_model_##name,
#include "models/registry.inc"
#undef TSU_MODEL
    NULL};

#define TSU_MODEL(name) extern const struct tsu_model tsu_i_model_##name;
#include "models/shadows.inc"
#undef TSU_MODEL

const struct tsu_model *const tsu_i_shadows[] = {
#define TSU_MODEL(name) &tsu_i_model_##name,
#include "models/shadows.inc"
#undef TSU_MODEL
    NULL};

uint32_t tsu_model_count(void)
{
    return (uint32_t)(sizeof tsu_i_models / sizeof *tsu_i_models - 1);
}

const tsu_model *tsu_model_at(uint32_t index)
{
    return index < tsu_model_count() ? tsu_i_models[index] : NULL;
}

uint32_t tsu_hair_shadow_count(void)
{
    return (uint32_t)(sizeof tsu_i_shadows / sizeof *tsu_i_shadows - 1);
}

const tsu_model *tsu_hair_shadow_at(uint32_t index)
{
    return index < tsu_hair_shadow_count() ? tsu_i_shadows[index] : NULL;
}

static const tsu_model *find(const struct tsu_model *const *models, const char *name)
{
    for (; *models; models++)
        if (strcmp((*models)->info.name, name) == 0)
            return *models;
    return NULL;
}

const tsu_model *tsu_model_find(const char *name)
{
    if (!name)
        return NULL;
    const tsu_model *model = find(tsu_i_models, name);
    return model ? model : find(tsu_i_shadows, name);
}

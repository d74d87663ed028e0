#include "models/model.h"

#include <string.h>

#define TSU_MODEL(name) extern const struct tsu_model tsu_i_model_##name;
#include "models/registry.inc"
#undef TSU_MODEL

const struct tsu_model *const tsu_i_models[] = {
#define TSU_MODEL(name) &tsu_i_model_##name,
#include "models/registry.inc"
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

const tsu_model *tsu_model_find(const char *name)
{
    for (uint32_t i = 0; name && tsu_i_models[i]; i++)
        if (strcmp(tsu_i_models[i]->info.name, name) == 0)
            return tsu_i_models[i];
    return NULL;
}

#include "shade/dialect.h"

#include <string.h>

#define ES_PRECISION "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"

static const struct tsu_i_dialect dialects[] = {
    {TSU_TARGET_330, "330", "#version 330 core\n", "", 0, 0},
    {TSU_TARGET_410, "410", "#version 410 core\n", "", 1, 0},
    {TSU_TARGET_450, "450", "#version 450 core\n", "", 1, 0},
    {TSU_TARGET_300ES, "300es", "#version 300 es\n", ES_PRECISION, 0, 0},
    {TSU_TARGET_310ES, "310es", "#version 310 es\n", ES_PRECISION, 1, 0},
    {TSU_TARGET_VULKAN, "vulkan", "#version 450\n", "", 1, 1}};

enum { DIALECTS = sizeof dialects / sizeof *dialects };

const struct tsu_i_dialect *tsu_i_dialect_find(tsu_target target)
{
    for (int i = 0; i < DIALECTS; i++)
        if (dialects[i].target == target)
            return dialects + i;
    return NULL;
}

tsu_target tsu_target_find(const char *name)
{
    for (int i = 0; name && i < DIALECTS; i++)
        if (strcmp(dialects[i].name, name) == 0)
            return dialects[i].target;
    return 0;
}

const char *tsu_target_version(tsu_target target)
{
    const struct tsu_i_dialect *dialect = tsu_i_dialect_find(target);
    return dialect ? dialect->version : NULL;
}

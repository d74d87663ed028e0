// Self-shadow of hair as mathematics: plans of light maps, and the maps in memory.
#ifndef TSU_HAIR_SHADOW_HAIR_SHADOW_H
#define TSU_HAIR_SHADOW_HAIR_SHADOW_H

#include <tsuya/hair_shadow.h>

// Offsets in a plan's record, in floats.
enum {
    TSU_I_SHADOW_X = 0,
    TSU_I_SHADOW_Y = 4,
    TSU_I_SHADOW_W = 8,
    TSU_I_SHADOW_DISTANCE = 12,
    TSU_I_SHADOW_STORED = 16,
    TSU_I_SHADOW_SCALE = 20,
    TSU_I_SHADOW_OFFSET = 28,
    TSU_I_SHADOW_TILE = 36,
    TSU_I_SHADOW_OPACITY = 40
};

// What both techniques take.
struct tsu_i_shadow_params {
    float opacity, spacings, layers, growth;
    int from_front; // layers begin at the first fibre
};

// Plan of a checked descriptor; `plan` is zeroed before, but for its head.
void tsu_i_shadow_plan(const tsu_hair_shadow_desc *desc, const struct tsu_i_shadow_params *params,
                       tsu_hair_shadow_plan *plan);

// 1 when layers of the plan begin at the first fibre.
int tsu_i_shadow_from_front(const tsu_hair_shadow_plan *plan);

void tsu_i_shadow_write(const tsu_hair_shadow_plan *plan, const float *points,
                        const uint32_t *first, uint32_t strands, float *map);
void tsu_i_shadow_read(const tsu_hair_shadow_plan *plan, const float *map, const float position[3],
                       float shadow[4]);

#endif

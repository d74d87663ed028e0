// The distinct tables of a set: found by key, counted, placed, baked into one image.
#ifndef TSU_BAKE_POOL_H
#define TSU_BAKE_POOL_H

#include "bake/atlas.h"
#include "models/model.h"

struct tsu_i_pool_table {
    const struct tsu_i_table *definition;
    unsigned char state[TSU_I_STATE_BYTES]; // of a material that uses it; the key is inside
    uint32_t users;                         // 0: the entry is free
    uint32_t x, y;
    uint32_t baked;
    uint64_t generation; // of the last bake, or of its texels' move
};

struct tsu_i_pool {
    const struct tsu_context *context;
    struct tsu_i_atlas atlas;
    struct tsu_i_pool_table *tables;
    uint32_t count, capacity;
    uint32_t live, stale; // tables in use, and those of them that wait for a bake
    uint16_t *texels; // atlas.width * atlas.height RGBA16F
    uint32_t width, height;
    uint64_t texture_generation; // last change of size or of a texel
    uint64_t *generation;        // the set's counter
};

// Take a table for a material with this state: an equal one, or a new one that is stale.
// The image grows when it must; texels keep their place. TSU_E_LIMIT, TSU_E_MEMORY; nothing changes
// then.
tsu_status tsu_i_pool_take(struct tsu_i_pool *pool, const struct tsu_i_table *definition,
                           const void *state, uint32_t *table);
void tsu_i_pool_give(struct tsu_i_pool *pool, uint32_t table);
// Bake what is stale. TSU_E_MEMORY.
tsu_status tsu_i_pool_bake(struct tsu_i_pool *pool);
// Note that a stale table's texels have been written.
void tsu_i_pool_filled(struct tsu_i_pool *pool, uint32_t table);
struct tsu_i_texels tsu_i_pool_texels(const struct tsu_i_pool *pool, uint32_t table);
void tsu_i_pool_free(struct tsu_i_pool *pool);

#endif

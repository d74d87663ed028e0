#include "bake/pool.h"

#include "base/half.h"

#include <tsuya/set.h>

#include <string.h>

static int same_key(const struct tsu_i_pool_table *table, const struct tsu_i_table *definition,
                    const void *state)
{
    return table->users && table->definition == definition &&
           memcmp(table->state + definition->key_offset,
                  (const char *)state + definition->key_offset, definition->key_size) == 0;
}

static void touch(struct tsu_i_pool *pool, struct tsu_i_pool_table *table)
{
    table->generation = pool->texture_generation = ++*pool->generation;
}

// Give the image the atlas's size; rows move, texel coordinates stay.
static tsu_status grow_image(struct tsu_i_pool *pool)
{
    const uint32_t width = pool->atlas.width, height = pool->atlas.height;
    if (width == pool->width && height == pool->height)
        return TSU_OK;
    const size_t row = (size_t)pool->width * 4;
    uint16_t *texels = tsu_i_alloc(pool->context, (size_t)width * height, 8);
    if (!texels)
        return TSU_E_MEMORY;
    for (uint32_t y = 0; y < pool->height; y++)
        memcpy(texels + (size_t)y * width * 4, pool->texels + y * row, row * sizeof *texels);
    tsu_i_free(pool->context, pool->texels, (size_t)pool->width * pool->height, 8);
    pool->texels = texels;
    pool->width = width;
    pool->height = height;
    pool->texture_generation = ++*pool->generation;
    return TSU_OK;
}

static tsu_status free_entry(struct tsu_i_pool *pool, uint32_t *table)
{
    for (*table = 0; *table < pool->count; ++*table)
        if (!pool->tables[*table].users)
            return TSU_OK;
    if (*table == pool->capacity) {
        const uint32_t capacity = pool->capacity ? 2 * pool->capacity : 8;
        struct tsu_i_pool_table *tables =
            tsu_i_realloc(pool->context, pool->tables, pool->capacity, capacity, sizeof *tables);
        if (!tables)
            return TSU_E_MEMORY;
        pool->tables = tables;
        pool->capacity = capacity;
    }
    pool->count++;
    return TSU_OK;
}

tsu_status tsu_i_pool_take(struct tsu_i_pool *pool, const struct tsu_i_table *definition,
                           const void *state, uint32_t *table)
{
    for (uint32_t i = 0; i < pool->count; i++)
        if (same_key(pool->tables + i, definition, state)) {
            pool->tables[i].users++;
            *table = i;
            return TSU_OK;
        }
    uint32_t entry, x, y;
    tsu_status status = free_entry(pool, &entry);
    if (status == TSU_OK)
        status =
            tsu_i_atlas_take(&pool->atlas, definition->info.width, definition->info.height, &x, &y);
    if (status != TSU_OK)
        return status;
    status = grow_image(pool);
    if (status != TSU_OK) {
        // The atlas keeps its larger size; the next take tries the image again.
        tsu_i_atlas_give(&pool->atlas, x, y);
        return status;
    }
    struct tsu_i_pool_table *t = pool->tables + entry;
    *t = (struct tsu_i_pool_table){.definition = definition, .users = 1, .x = x, .y = y};
    memcpy(t->state, state, sizeof t->state);
    for (uint32_t row = 0; row < definition->info.height; row++)
        memset(pool->texels + ((size_t)(y + row) * pool->width + x) * 4, 0,
               (size_t)definition->info.width * 8);
    touch(pool, t);
    pool->live++;
    pool->stale++;
    *table = entry;
    return TSU_OK;
}

void tsu_i_pool_give(struct tsu_i_pool *pool, uint32_t table)
{
    struct tsu_i_pool_table *t = pool->tables + table;
    if (--t->users)
        return;
    tsu_i_atlas_give(&pool->atlas, t->x, t->y);
    pool->live--;
    pool->stale -= !t->baked;
}

void tsu_i_pool_filled(struct tsu_i_pool *pool, uint32_t table)
{
    pool->tables[table].baked = 1;
    pool->stale--;
    touch(pool, pool->tables + table);
}

struct bake {
    struct tsu_i_pool *pool;
    const uint32_t *stale; // tables to bake
    float **rows;          // whole tables, one each
    char **scratch;        // of all units of each table
    const uint32_t *first; // first job of each table, and the number of all jobs
    uint32_t count;
};

static uint32_t table_of(const struct bake *bake, uint32_t job)
{
    uint32_t i = 0;
    while (bake->first[i + 1] <= job)
        i++;
    return i;
}

static void bake_unit(void *data, uint32_t job)
{
    const struct bake *bake = data;
    const uint32_t i = table_of(bake, job), unit = job - bake->first[i];
    const struct tsu_i_pool_table *t = bake->pool->tables + bake->stale[i];
    const struct tsu_i_table *d = t->definition;
    const uint32_t rows = d->info.height / d->units, pitch = d->info.width * 4;
    float local[4 * 8 * TSU_CELL];
    d->bake(t->state, unit, d->scratch_bytes ? bake->scratch[i] + unit * d->scratch_bytes : NULL,
            local);
    for (uint32_t r = 0; r < rows; r++)
        memcpy(bake->rows[i] + (size_t)(unit + r * d->units) * pitch, local + r * pitch,
               pitch * sizeof *local);
}

static void finish(const struct bake *bake, uint32_t i)
{
    struct tsu_i_pool *pool = bake->pool;
    struct tsu_i_pool_table *t = pool->tables + bake->stale[i];
    const struct tsu_i_table *d = t->definition;
    if (d->finish)
        d->finish(t->state, bake->rows[i]);
    const uint32_t pitch = d->info.width * 4;
    for (uint32_t y = 0; y < d->info.height; y++) {
        uint16_t *out = pool->texels + ((size_t)(t->y + y) * pool->width + t->x) * 4;
        for (uint32_t k = 0; k < pitch; k++)
            out[k] = tsu_i_half(bake->rows[i][(size_t)y * pitch + k]);
    }
    tsu_i_pool_filled(pool, bake->stale[i]);
}

static size_t floats(const struct tsu_i_pool *pool, uint32_t table)
{
    const struct tsu_i_table *d = pool->tables[table].definition;
    return (size_t)d->info.width * d->info.height * 4;
}

static size_t scratch_of(const struct tsu_i_pool *pool, uint32_t table)
{
    const struct tsu_i_table *d = pool->tables[table].definition;
    return d->scratch_bytes * d->units;
}

// At most BATCH tables at a time keep the working memory below a few MiB.
enum { BATCH = 16 };

tsu_status tsu_i_pool_bake(struct tsu_i_pool *pool)
{
    tsu_status status = TSU_OK;
    for (uint32_t next = 0; next < pool->count && status == TSU_OK;) {
        uint32_t stale[BATCH], first[BATCH + 1] = {0};
        float *rows[BATCH];
        char *scratch[BATCH] = {NULL};
        struct bake bake = {pool, stale, rows, scratch, first, 0};
        for (; next < pool->count && bake.count < BATCH; next++) {
            const struct tsu_i_pool_table *t = pool->tables + next;
            if (!t->users || t->baked)
                continue;
            rows[bake.count] = tsu_i_alloc(pool->context, floats(pool, next), sizeof(float));
            if (rows[bake.count] && scratch_of(pool, next)) {
                scratch[bake.count] = tsu_i_alloc(pool->context, scratch_of(pool, next), 1);
                if (!scratch[bake.count]) {
                    tsu_i_free(pool->context, rows[bake.count], floats(pool, next), sizeof(float));
                    rows[bake.count] = NULL;
                }
            }
            if (!rows[bake.count]) {
                status = TSU_E_MEMORY;
                break;
            }
            stale[bake.count] = next;
            first[bake.count + 1] = first[bake.count] + t->definition->units;
            bake.count++;
        }
        if (status == TSU_OK && bake.count) {
            tsu_i_jobs(pool->context, bake_unit, &bake, first[bake.count]);
            for (uint32_t i = 0; i < bake.count; i++)
                finish(&bake, i);
        }
        for (uint32_t i = 0; i < bake.count; i++) {
            tsu_i_free(pool->context, rows[i], floats(pool, stale[i]), sizeof(float));
            if (scratch[i])
                tsu_i_free(pool->context, scratch[i], scratch_of(pool, stale[i]), 1);
        }
    }
    return status;
}

struct tsu_i_texels tsu_i_pool_texels(const struct tsu_i_pool *pool, uint32_t table)
{
    const struct tsu_i_pool_table *t = pool->tables + table;
    return (struct tsu_i_texels){pool->texels + ((size_t)t->y * pool->width + t->x) * 4,
                                 pool->width};
}

void tsu_i_pool_free(struct tsu_i_pool *pool)
{
    tsu_i_free(pool->context, pool->texels, (size_t)pool->width * pool->height, 8);
    tsu_i_free(pool->context, pool->tables, pool->capacity, sizeof *pool->tables);
    tsu_i_atlas_free(&pool->atlas);
}

#include "bake/cache.h"

#include "base/hash.h"

#include <tsuya/set.h>

#include <string.h>

enum { FORMAT = 1, HEAD = 32, TABLE_HEAD = 24, TAIL = 8, NAME_MOST = 128 };
static const unsigned char magic[8] = {'T', 'S', 'U', 'C', 'A', 'C', 'H', 'E'};

static void put(unsigned char **out, uint64_t value, int bytes)
{
    for (int i = 0; i < bytes; i++)
        *(*out)++ = (unsigned char)(value >> 8 * i);
}

static uint64_t get(const unsigned char *in, int bytes)
{
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++)
        value |= (uint64_t)in[i] << 8 * i;
    return value;
}

// What a table is, apart from its key.
struct identity {
    char name[NAME_MOST];
    uint32_t length;
    uint64_t hash;
};

static void append(struct identity *identity, const char *text)
{
    for (; *text && identity->length < NAME_MOST; text++)
        identity->name[identity->length++] = *text;
}

static struct identity identify(const struct tsu_i_table *definition)
{
    struct identity identity = {.hash = TSU_I_HASH_START};
    for (const struct tsu_model *const *model = tsu_i_models; *model; model++)
        for (uint32_t i = 0; i < (*model)->info.table_count; i++)
            if ((*model)->tables + i == definition)
                append(&identity, (*model)->info.name);
    append(&identity, "/");
    append(&identity, definition->info.name);
    const char *const texts[2] = {definition->info.axes, definition->info.channels};
    for (int i = 0; i < 2; i++)
        identity.hash = tsu_i_hash(identity.hash, texts[i], strlen(texts[i]) + 1);
    const uint64_t numbers[4] = {definition->info.width, definition->info.height, definition->units,
                                 definition->key_size};
    unsigned char bytes[sizeof numbers], *at = bytes;
    for (int i = 0; i < 4; i++)
        put(&at, numbers[i], 8);
    identity.hash = tsu_i_hash(identity.hash, bytes, sizeof bytes);
    return identity;
}

static size_t texel_bytes(const struct tsu_i_table *definition)
{
    return (size_t)definition->info.width * definition->info.height * 8;
}

size_t tsu_i_cache_size(const struct tsu_i_pool *pool)
{
    size_t size = HEAD + TAIL;
    for (uint32_t i = 0; i < pool->count; i++) {
        const struct tsu_i_pool_table *t = pool->tables + i;
        if (t->users && t->baked)
            size += TABLE_HEAD + identify(t->definition).length + t->definition->key_size +
                    texel_bytes(t->definition);
    }
    return size;
}

static void put_table(const struct tsu_i_pool *pool, const struct tsu_i_pool_table *t,
                      unsigned char **out)
{
    const struct tsu_i_table *d = t->definition;
    const struct identity identity = identify(d);
    put(out, identity.hash, 8);
    put(out, identity.length, 4);
    put(out, d->key_size, 4);
    put(out, d->info.width, 4);
    put(out, d->info.height, 4);
    memcpy(*out, identity.name, identity.length);
    *out += identity.length;
    memcpy(*out, t->state + d->key_offset, d->key_size);
    *out += d->key_size;
    for (uint32_t y = 0; y < d->info.height; y++) {
        const uint16_t *row = pool->texels + ((size_t)(t->y + y) * pool->width + t->x) * 4;
        for (uint32_t x = 0; x < d->info.width * 4; x++)
            put(out, row[x], 2);
    }
}

void tsu_i_cache_write(const struct tsu_i_pool *pool, unsigned char *out)
{
    unsigned char *const begin = out;
    uint32_t count = 0;
    for (uint32_t i = 0; i < pool->count; i++)
        count += pool->tables[i].users && pool->tables[i].baked;
    memcpy(out, magic, sizeof magic);
    out += sizeof magic;
    put(&out, FORMAT, 4);
    put(&out, tsu_version(), 4);
    put(&out, tsu_i_cache_size(pool), 8);
    put(&out, count, 4);
    put(&out, 0, 4);
    for (uint32_t i = 0; i < pool->count; i++)
        if (pool->tables[i].users && pool->tables[i].baked)
            put_table(pool, pool->tables + i, &out);
    put(&out, tsu_i_hash(TSU_I_HASH_START, begin, (size_t)(out - begin)), 8);
}

// One table of a block.
struct entry {
    uint64_t hash;
    uint32_t length, key_size, width, height;
    const unsigned char *name, *key, *texels;
};

// Read the entry at *at and step over it; 0 when it does not fit before `end`.
static int next_entry(const unsigned char **at, const unsigned char *end, struct entry *e)
{
    if (end - *at < TABLE_HEAD)
        return 0;
    e->hash = get(*at, 8);
    e->length = (uint32_t)get(*at + 8, 4);
    e->key_size = (uint32_t)get(*at + 12, 4);
    e->width = (uint32_t)get(*at + 16, 4);
    e->height = (uint32_t)get(*at + 20, 4);
    if (e->length > NAME_MOST || e->key_size > TSU_I_STATE_BYTES || e->width > TSU_CELL ||
        e->height > TSU_CELL)
        return 0;
    e->name = *at + TABLE_HEAD;
    e->key = e->name + e->length;
    e->texels = e->key + e->key_size;
    const size_t bytes = (size_t)e->length + e->key_size + (size_t)e->width * e->height * 8;
    if ((size_t)(end - e->name) < bytes)
        return 0;
    *at = e->name + bytes;
    return 1;
}

static tsu_status check(const struct tsu_i_pool *pool, const unsigned char *bytes, size_t size)
{
    const char *wrong = NULL;
    if (size < HEAD + TAIL || memcmp(bytes, magic, sizeof magic) != 0) {
        wrong = "it does not begin like one";
    } else if (get(bytes + 8, 4) != FORMAT || get(bytes + 12, 4) != tsu_version()) {
        tsu_i_log(pool->context, TSU_LOG_ERROR, TSU_LOG_CACHE,
                  "the block of baked tables has format %u of library %u, expected %u of %u",
                  (unsigned)get(bytes + 8, 4), (unsigned)get(bytes + 12, 4), (unsigned)FORMAT,
                  (unsigned)tsu_version());
        return TSU_E_VERSION;
    } else if (get(bytes + 16, 8) != size) {
        wrong = "its length is not the one it states";
    } else if (get(bytes + size - TAIL, 8) != tsu_i_hash(TSU_I_HASH_START, bytes, size - TAIL)) {
        wrong = "its bytes do not have the hash it states";
    } else {
        const unsigned char *at = bytes + HEAD, *const end = bytes + size - TAIL;
        struct entry e;
        uint32_t count = 0;
        while (at < end && next_entry(&at, end, &e))
            count++;
        if (at != end || count != get(bytes + 24, 4) || get(bytes + 28, 4) != 0)
            wrong = "its tables do not fill it";
    }
    if (!wrong)
        return TSU_OK;
    tsu_i_log(pool->context, TSU_LOG_ERROR, TSU_LOG_CACHE,
              "this is no block of tsu_set_cache_write(): %s", wrong);
    return TSU_E_PARAMETER;
}

static int is_of(const struct entry *e, const struct tsu_i_pool_table *t)
{
    const struct tsu_i_table *d = t->definition;
    const struct identity identity = identify(d);
    return e->hash == identity.hash && e->length == identity.length && e->width == d->info.width &&
           e->height == d->info.height && e->key_size == d->key_size &&
           memcmp(e->name, identity.name, e->length) == 0 &&
           memcmp(e->key, t->state + d->key_offset, e->key_size) == 0;
}

tsu_status tsu_i_cache_read(struct tsu_i_pool *pool, const unsigned char *bytes, size_t size,
                            uint32_t *taken)
{
    *taken = 0;
    const tsu_status status = check(pool, bytes, size);
    if (status != TSU_OK)
        return status;
    const unsigned char *at = bytes + HEAD;
    struct entry e;
    while (next_entry(&at, bytes + size - TAIL, &e))
        for (uint32_t i = 0; i < pool->count; i++) {
            const struct tsu_i_pool_table *t = pool->tables + i;
            if (!t->users || t->baked || !is_of(&e, t))
                continue;
            for (uint32_t y = 0; y < e.height; y++) {
                uint16_t *row = pool->texels + ((size_t)(t->y + y) * pool->width + t->x) * 4;
                for (uint32_t x = 0; x < e.width * 4; x++)
                    row[x] = (uint16_t)get(e.texels + ((size_t)y * e.width * 4 + x) * 2, 2);
            }
            tsu_i_pool_filled(pool, i);
            ++*taken;
        }
    return TSU_OK;
}

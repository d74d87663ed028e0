#include "api/set.h"
#include "bake/cache.h"

size_t tsu_set_cache_size(const tsu_set *set)
{
    return set ? tsu_i_cache_size(tsu_i_set_pool((tsu_set *)set)) : 0;
}

tsu_status tsu_set_cache_write(const tsu_set *set, void *buffer, size_t size)
{
    if (!set || !buffer)
        return TSU_E_PARAMETER;
    const struct tsu_i_pool *pool = tsu_i_set_pool((tsu_set *)set);
    const size_t least = tsu_i_cache_size(pool);
    if (size < least) {
        tsu_i_log(pool->context, TSU_LOG_ERROR, TSU_LOG_CACHE,
                  "size = %u, expected at least tsu_set_cache_size(), %u", (unsigned)size,
                  (unsigned)least);
        return TSU_E_PARAMETER;
    }
    tsu_i_cache_write(pool, buffer);
    return TSU_OK;
}

tsu_status tsu_set_cache_read(tsu_set *set, const void *buffer, size_t size, uint32_t *taken)
{
    uint32_t count = 0;
    if (taken)
        *taken = 0;
    if (!set || !buffer)
        return TSU_E_PARAMETER;
    const tsu_status status = tsu_i_cache_read(tsu_i_set_pool(set), buffer, size, &count);
    if (taken)
        *taken = count;
    return status;
}

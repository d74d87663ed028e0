// Baked tables as a block of bytes, and back.
//
// All numbers little-endian:
//   8 "TSUCACHE"   4 format, 1   4 library version   8 bytes of the whole   4 number of tables   4 0
//   one a table:  8 hash of the definition   4 length of the name   4 length of the key   4 width
//                 4 height   name, "model/table"   key, as the machine holds it   texels, RGBA16F
//   8 hash of all bytes before
// A definition's hash covers what its description says of axes, channels and size.
#ifndef TSU_BAKE_CACHE_H
#define TSU_BAKE_CACHE_H

#include "bake/pool.h"

#include <stddef.h>

// Bytes for the baked tables of a pool.
size_t tsu_i_cache_size(const struct tsu_i_pool *pool);
void tsu_i_cache_write(const struct tsu_i_pool *pool, unsigned char *out);

// Fill stale tables from a block; *taken counts them. All of the block is checked first.
// TSU_E_VERSION: of another library or format. TSU_E_PARAMETER: not a whole block. Both logged.
tsu_status tsu_i_cache_read(struct tsu_i_pool *pool, const unsigned char *bytes, size_t size,
                            uint32_t *taken);

#endif

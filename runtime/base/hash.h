// 64-bit FNV-1a: keys of tables and texts. Not for hostile input.
#ifndef TSU_BASE_HASH_H
#define TSU_BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

#define TSU_I_HASH_START 0xcbf29ce484222325u
uint64_t tsu_i_hash(uint64_t start, const void *bytes, size_t size);

#endif

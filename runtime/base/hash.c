#include "base/hash.h"

uint64_t tsu_i_hash(uint64_t start, const void *bytes, size_t size)
{
    const unsigned char *b = bytes;
    for (size_t i = 0; i < size; i++)
        start = (start ^ b[i]) * 0x100000001b3u;
    return start;
}

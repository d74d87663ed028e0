#include "base/half.h"

#include <string.h>

static uint32_t bits(float value)
{
    uint32_t b;
    memcpy(&b, &value, sizeof b);
    return b;
}

static float from_bits(uint32_t b)
{
    float value;
    memcpy(&value, &b, sizeof value);
    return value;
}

uint16_t tsu_i_half(float value)
{
    const uint32_t b = bits(value), sign = b >> 16 & 0x8000u, magnitude = b & 0x7fffffffu;
    if (magnitude > 0x7f800000u)
        return (uint16_t)(sign | 0x7e00u);
    if (magnitude >= 0x477ff000u) // rounds past the largest half
        return (uint16_t)(sign | 0x7c00u);
    if (magnitude < 0x38800000u) {
        // Adding 0.5 puts the half's subnormal step at the last bit of the sum's mantissa.
        const float shifted = from_bits(magnitude) + 0.5f;
        return (uint16_t)(sign | (bits(shifted) - bits(0.5f)));
    }
    const uint32_t odd = magnitude >> 13 & 1u;
    return (uint16_t)(sign | ((magnitude - 0x38000000u + 0xfffu + odd) >> 13));
}

float tsu_i_half_float(uint16_t half)
{
    const uint32_t sign = (uint32_t)(half & 0x8000u) << 16, magnitude = half & 0x7fffu;
    if (magnitude >= 0x7c00u)
        return from_bits(sign | 0x7f800000u | (magnitude & 0x3ffu) << 13);
    if (magnitude < 0x400u) {
        const float value = (float)magnitude * (1.0f / 16777216.0f);
        return sign ? -value : value;
    }
    return from_bits(sign | ((magnitude << 13) + 0x38000000u));
}

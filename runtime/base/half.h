// binary32 <-> binary16.
#ifndef TSU_BASE_HALF_H
#define TSU_BASE_HALF_H

#include <stdint.h>

// Round to nearest even; overflow gives infinity, NaN stays NaN.
uint16_t tsu_i_half(float value);
// Exact.
float tsu_i_half_float(uint16_t half);

#endif

// Lights as mathematics: records of the snippets, and surroundings as spherical harmonics.
#ifndef TSU_LIGHT_LIGHT_H
#define TSU_LIGHT_LIGHT_H

#include <tsuya/light.h>

// Record of a checked descriptor.
void tsu_i_light_record(const tsu_light_desc *desc, float record[16]);

// What a sample of the surroundings must not be, in the order in which it is looked for.
enum { TSU_I_SAMPLE_GOOD, TSU_I_SAMPLE_DIRECTION, TSU_I_SAMPLE_RADIANCE, TSU_I_SAMPLE_ANGLE };

// First sample that is not finite, negative or without direction: its index and what is wrong; the
// sum of solid angles of the samples before it.
int tsu_i_environment_check(const tsu_environment_desc *desc, uint32_t *index, double *angle);

// Project checked samples whose solid angles sum to `angle`; `out` is zeroed before, but for its
// head.
void tsu_i_environment_make(const tsu_environment_desc *desc, double angle, tsu_environment *out);

#endif

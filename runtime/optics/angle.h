// Angles on the circle.
#ifndef TSU_OPTICS_ANGLE_H
#define TSU_OPTICS_ANGLE_H

#include <math.h>

#define TSU_I_PI 3.14159265358979323846
#define TSU_I_LOG2E 1.44269504088896340736

// The same angle within [-pi, pi]; exact for |x| below 2^20, and without a loop for any finite x.
static inline double tsu_i_angle_wrap(double x)
{
    return x - 2.0 * TSU_I_PI * floor(x / (2.0 * TSU_I_PI) + 0.5);
}

#endif

#include "light/light.h"

#include <math.h>

static double length(const float v[3])
{
    return sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] +
                (double)v[2] * (double)v[2]);
}

enum { DIRECTIONAL, POINT, RECT, DISK, CAP }; // kinds of the snippets

// A directional light with an angle: a disk at distance 1, across the direction.
static void put_cap(const tsu_light_desc *desc, float record[16])
{
    const double radius = tan((double)desc->angle), *d;
    double unit[3], x[3], y[3];
    d = unit;
    for (int k = 0; k < 3; k++)
        unit[k] = (double)desc->direction[k] / length(desc->direction);
    // Duff et al. 2017, "Building an Orthonormal Basis, Revisited"
    const double sign = d[2] < 0.0 ? -1.0 : 1.0, a = -1.0 / (sign + d[2]), b = d[0] * d[1] * a;
    x[0] = 1.0 + sign * d[0] * d[0] * a;
    x[1] = sign * b;
    x[2] = -sign * d[0];
    y[0] = b;
    y[1] = sign + d[1] * d[1] * a;
    y[2] = -d[1];
    for (int k = 0; k < 3; k++) {
        record[4 + k] = (float)(radius * x[k]);
        record[8 + k] = (float)(radius * y[k]);
        // Irradiance of even radiance L within the angle a is pi sin^2(a) L.
        record[12 + k] =
            (float)((double)desc->color[k] /
                    (3.14159265358979323846 * sin((double)desc->angle) * sin((double)desc->angle)));
    }
    record[3] = CAP;
}

void tsu_i_light_record(const tsu_light_desc *desc, float record[16])
{
    for (int k = 0; k < 16; k++)
        record[k] = 0.0f;
    const int far = desc->kind == TSU_LIGHT_DIRECTIONAL;
    const double size = far ? length(desc->direction) : 1.0;
    for (int k = 0; k < 3; k++) {
        record[k] = far ? (float)((double)desc->direction[k] / size) : desc->position[k];
        record[12 + k] = desc->color[k];
    }
    record[7] = (float)desc->samples;
    record[15] = desc->least;
    // Below a thousandth of a radian a disk is a direction.
    if (far && desc->angle > 1e-3f)
        put_cap(desc, record);
    if (desc->kind == TSU_LIGHT_POINT)
        record[3] = POINT;
    if (desc->kind != TSU_LIGHT_RECT && desc->kind != TSU_LIGHT_DISK)
        return;
    record[3] = desc->kind == TSU_LIGHT_RECT ? RECT : DISK;
    for (int k = 0; k < 3; k++) {
        record[4 + k] = desc->x[k];
        record[8 + k] = desc->y[k];
    }
    record[11] = desc->flags & TSU_LIGHT_TWO_SIDED ? 1.0f : 0.0f;
}

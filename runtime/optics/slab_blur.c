#include "optics/slab_blur.h"

#include <math.h>

static double thickness_of(const struct tsu_i_spread_slab *slab)
{
    double sum = 0.0;
    for (int i = 0; i < slab->layers; i++)
        sum += slab->layer[i].thickness;
    return sum;
}

void tsu_i_blur_frequencies(const struct tsu_i_spread_slab *slabs, int count,
                            struct tsu_i_transforms *transforms)
{
    double densest = 0.0; // mean free paths in a thickness
    const double thickness = thickness_of(slabs);
    for (int c = 0; c < count; c++)
        for (int i = 0; i < slabs[c].layers; i++) {
            const struct tsu_i_spread_layer *layer = slabs[c].layer + i;
            const double depth = layer->scatter * (1.0 - fmax(slabs[c].g, 0.0)) + layer->absorption;
            densest = fmax(densest, depth * thickness / layer->thickness);
        }
    const double low = 0.04, high = fmax(25.0, 8.0 * densest);
    transforms->samples = TSU_I_BLUR_SAMPLES;
    transforms->profiles = count;
    transforms->k[0] = 0.0;
    for (int i = 1; i < TSU_I_BLUR_SAMPLES; i++)
        transforms->k[i] =
            low / thickness * pow(high / low, (i - 1) / (double)(TSU_I_BLUR_SAMPLES - 2));
}

double tsu_i_blur_fit(const struct tsu_i_transforms *transforms, int count, double thickness,
                      struct tsu_i_gaussians *out)
{
    const double finest = 0.5 / transforms->k[transforms->samples - 1];
    return tsu_i_gaussians_fit(transforms, count, finest, 10.0 * thickness, out);
}

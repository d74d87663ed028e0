#include "scenes.h"

#include "choose/trade.h"

double scenes_between(struct scenes *scenes, double low, double high)
{
    // Steele et al. 2014, "Fast Splittable Pseudorandom Number Generators"
    uint64_t z = scenes->random += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * (double)(z >> 11) * 0x1p-53;
}

static float trait(struct scenes *scenes, int index)
{
    const double *range = tsu_i_trade.range[index];
    return (float)scenes_between(scenes, range[0], range[1]);
}

static void lights(struct scenes *scenes, tsu_choose_desc *desc)
{
    desc->directional_lights = (uint32_t)scenes_between(scenes, 0.0, 4.0);
    desc->point_lights = (uint32_t)scenes_between(scenes, 0.0, 3.0);
    desc->area_lights = (uint32_t)scenes_between(scenes, 0.0, 2.0);
    desc->environments = (uint32_t)scenes_between(scenes, 0.0, 2.0);
}

tsu_choose_desc scenes_hair(struct scenes *scenes)
{
    tsu_choose_desc desc;
    tsu_choose_desc_init(&desc);
    lights(scenes, &desc);
    // Light hair is as likely as dark.
    const double *range = tsu_i_trade.range[0];
    for (int c = 0; c < 3; c++) {
        const double share = scenes_between(scenes, 0.0, 1.0);
        desc.sigma_a[c] = (float)(range[0] + (range[1] - range[0]) * share * share * share);
    }
    desc.sky_share = trait(scenes, 1);
    desc.light_cosine = trait(scenes, 2);
    desc.strand_pixels = trait(scenes, 3);
    desc.depth = trait(scenes, 4);
    desc.curl = trait(scenes, 5);
    desc.beta_R = trait(scenes, 6);
    return desc;
}

tsu_choose_desc scenes_leaf(struct scenes *scenes)
{
    tsu_choose_desc desc;
    tsu_choose_desc_init(&desc);
    lights(scenes, &desc);
    desc.kind = TSU_CHOOSE_LEAF;
    desc.flags = (uint32_t)scenes_between(scenes, 0.0, 8.0);
    const double *color =
        tsu_i_trade.species[(int)scenes_between(scenes, 0.0, tsu_i_trade.species_count)].color;
    for (int c = 0; c < 3; c++) {
        desc.R_top[c] = (float)(color[c] * scenes_between(scenes, 0.8, 1.1));
        desc.R_bottom[c] = (float)(color[3 + c] * scenes_between(scenes, 0.8, 1.1));
        desc.T[c] = (float)(color[6 + c] * scenes_between(scenes, 0.8, 1.0));
        desc.T[c] = desc.T[c] > 0.0f ? desc.T[c] : 0.0f;
    }
    return desc;
}

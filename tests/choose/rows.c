// Prints scenes at random and what every hair tier is predicted to be in them, as CSV, for
// predictor_test.py. Traits go a little beyond the table's ranges now and then.
#include "scenes.h"

#include <stdio.h>
#include <stdlib.h>

enum { SCENES = 200 };

int main(void)
{
    struct scenes scenes = {21};
    printf("tier,r,g,b,sky_share,light_cosine,strand_pixels,depth,curl,beta_R,error,luminance,"
           "outside\n");
    for (int i = 0; i < SCENES; i++) {
        tsu_choose_desc desc = scenes_hair(&scenes);
        if (i % 5 == 0) {
            desc.strand_pixels *= 7.0f;
            desc.sigma_a[i % 3] *= 100.0f;
            desc.depth = 2.0f * desc.depth + 3.0f;
        }
        for (tsu_tier tier = 0; tier < (tsu_tier)tsu_tier_count(); tier++) {
            tsu_tier_info info;
            tsu_prediction one;
            tsu_tier_info_init(&info);
            tsu_prediction_init(&one);
            if (tsu_tier_describe(tier, &info) != TSU_OK || info.kind != TSU_CHOOSE_HAIR)
                continue;
            if (tsu_choose_predict(NULL, &desc, tier, &one) != TSU_OK)
                return EXIT_FAILURE;
            printf("%s,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%u\n", info.name,
                   (double)desc.sigma_a[0], (double)desc.sigma_a[1], (double)desc.sigma_a[2],
                   (double)desc.sky_share, (double)desc.light_cosine, (double)desc.strand_pixels,
                   (double)desc.depth, (double)desc.curl, (double)desc.beta_R, (double)one.error,
                   (double)one.luminance, one.outside);
        }
    }
    return EXIT_SUCCESS;
}

// What each tier would be in a scene: error, luminance, cost, and what the host lacks for it.
//
// Hair. Traits of a channel: u = sqrt(sigma_a) / (sqrt(sigma_a) + sqrt(0.1)), q = sqrt(sky_share),
// k = light_cosine, w = log2(strand_pixels), d = log2(1 + depth), o = curl, b = beta_R over 7.5
// degrees. A polynomial in them is the logarithm of the channel's relative MSE, another that of its
// mean over the true one; tests/bench/trade.py fits both. The picture's relative MSE is the mean
// over the channels; its luminance weighs channels by Rec. 709 and by exp(-5.9 sqrt(sigma_a)),
// about the colour of a head of such hair.
#ifndef TSU_CHOOSE_PREDICT_H
#define TSU_CHOOSE_PREDICT_H

#include <tsuya/choose.h>

enum { TSU_I_TIERS_MOST = 16 }; // of one kind

struct tsu_i_candidate {
    tsu_tier tier;
    uint32_t lacks, passes, samplers, bytes;
    double error, high, luminance, luminance_high; // luminance is signed
    double cost, excess; // excess: error and luminance over their bounds, the larger; 0 without
};

struct tsu_i_field {
    uint32_t count, outside;
    const char *species; // of a leaf: the nearest of the table, or NULL
    struct tsu_i_candidate tiers[TSU_I_TIERS_MOST];
};

// All tiers of the description's kind. `desc` is checked by the caller.
void tsu_i_predict(const tsu_choose_desc *desc, struct tsu_i_field *field);

#endif

// The trade table as constants: made from trade.csv by embed.py.
#ifndef TSU_CHOOSE_TRADE_H
#define TSU_CHOOSE_TRADE_H

#include <tsuya/choose.h>

enum {
    TSU_I_TRAITS = 7, // u q k w d o b: see predict.h
    TSU_I_TERMS = 50  // 1, the traits, their products of two, u*u and u*u*u times each; in order
};

// Of ln relative MSE of a channel, or of ln(its mean over the true one).
struct tsu_i_trade_fit {
    double
        spread; // deviation of what a scene's ln rms, or ln luminance, is off by; scenes left out
    double mean[TSU_TONES]; // over the table's scenes of a tone, not logarithmic
    double term[TSU_I_TERMS];
};

struct tsu_i_trade_tier {
    const char *name, *model, *variant;
    tsu_choose_kind kind;
    uint32_t flags, drops; // lobes that its text can be without
    double clocks[TSU_CHOOSE_GPUS], map_clocks[TSU_CHOOSE_GPUS];
    uint32_t fetches, bytes, samplers;
    const struct tsu_i_trade_fit *rms, *luminance; // hair
    // Leaves: a number for each species, the last for the whole range of the model.
    const double *reflected, *transmitted, *leaf_luminance;
    const double *coat, *coat_luminance; // without the coat that is wanted; NULL: it has one
};

struct tsu_i_trade_species {
    const char *name;
    double color[9]; // R_top, R_bottom, T
};

// Light that is lost with a lobe. Rows of `sigmas` shares: TRT, residual, then back scattering in
// slabs of so many fibres.
struct tsu_i_trade_lobes {
    uint32_t sigmas, depths;
    const double *sigma, *depth; // they rise
    const double *share;
};

struct tsu_i_trade {
    const char *source;
    uint32_t tier_count;
    const struct tsu_i_trade_tier *tiers;
    uint32_t species_count;
    const struct tsu_i_trade_species *species;
    double range[TSU_I_TRAITS][2]; // in the fields' units, in the order of the TSU_OUTSIDE_* bits
    double margin;                 // error_high is the prediction times exp(margin * spread)
    struct tsu_i_trade_lobes lobes;
};
extern const struct tsu_i_trade tsu_i_trade;

#endif

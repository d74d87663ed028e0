#include "choose/predict.h"

#include "choose/plain.h"
#include "choose/trade.h"

#include <math.h>
#include <stddef.h>

_Static_assert((int)TSU_I_TERMS == 1 + 3 * TSU_I_TRAITS + TSU_I_TRAITS * (TSU_I_TRAITS + 1) / 2,
               "terms are 1, traits, products of two, u*u and u*u*u times traits");

static const double ln2 = 0.6931471805599453, degree = 0.017453292519943295;

// A value within the table's range of trait `index`. A thousandth beyond it is not worth a word.
static double held(double value, int index, uint32_t *outside)
{
    const double low = tsu_i_trade.range[index][0], high = tsu_i_trade.range[index][1];
    if (value < low - (1e-3 * fabs(low) + 1e-6) || value > high + (1e-3 * fabs(high) + 1e-6))
        *outside |= 1u << index;
    return value < low ? low : value > high ? high : value;
}

enum { LANES = 4 }; // three channels and nothing, so that a loop over them is one vector

struct channels {
    double term[TSU_I_TERMS][LANES];
    double weight[3]; // of luminance; they sum to 1
};

static void put_terms(const double trait[TSU_I_TRAITS], int c, double term[TSU_I_TERMS][LANES])
{
    int n = 0;
    term[n++][c] = 1.0;
    for (int i = 0; i < TSU_I_TRAITS; i++)
        term[n++][c] = trait[i];
    for (int i = 0; i < TSU_I_TRAITS; i++)
        for (int k = i; k < TSU_I_TRAITS; k++)
            term[n++][c] = trait[i] * trait[k];
    for (int i = 0; i < TSU_I_TRAITS; i++)
        term[n++][c] = trait[0] * trait[0] * trait[i];
    for (int i = 0; i < TSU_I_TRAITS; i++)
        term[n++][c] = trait[0] * trait[0] * trait[0] * trait[i];
}

static void read_scene(const tsu_choose_desc *desc, struct channels *scene, uint32_t *outside)
{
    static const double rec709[3] = {0.2126, 0.7152, 0.0722};
    double trait[TSU_I_TRAITS], sum = 0.0;
    for (int i = 0; i < TSU_I_TERMS; i++)
        scene->term[i][3] = 0.0;
    trait[1] = sqrt(held((double)desc->sky_share, 1, outside));
    trait[2] = held((double)desc->light_cosine, 2, outside);
    trait[3] = tsu_i_plain_log(held((double)desc->strand_pixels, 3, outside)) / ln2;
    trait[4] = tsu_i_plain_log(1.0 + held((double)desc->depth, 4, outside)) / ln2;
    trait[5] = held((double)desc->curl, 5, outside);
    trait[6] = held((double)desc->beta_R, 6, outside) / (7.5 * degree);
    for (int c = 0; c < 3; c++) {
        const double root = sqrt(held((double)desc->sigma_a[c], 0, outside));
        trait[0] = root / (root + sqrt(0.1));
        put_terms(trait, c, scene->term);
        scene->weight[c] = rec709[c] * tsu_i_plain_exp(-5.9 * root);
        sum += scene->weight[c];
    }
    for (int c = 0; c < 3; c++)
        scene->weight[c] /= sum;
}

// Both polynomials of a tier, all channels at once.
static void fit(const struct tsu_i_trade_tier *tier, const struct channels *scene,
                double rms[LANES], double luminance[LANES])
{
    for (int c = 0; c < LANES; c++)
        rms[c] = luminance[c] = 0.0;
    for (int i = 0; i < TSU_I_TERMS; i++)
        for (int c = 0; c < LANES; c++) {
            rms[c] += tier->rms->term[i] * scene->term[i][c];
            luminance[c] += tier->luminance->term[i] * scene->term[i][c];
        }
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static void predict_hair(const struct tsu_i_trade_tier *tier, const struct channels *scene,
                         struct tsu_i_candidate *out)
{
    double square = 0.0, gain = 0.0, rms[LANES], luminance[LANES];
    fit(tier, scene, rms, luminance);
    for (int c = 0; c < 3; c++) {
        square += tsu_i_plain_exp(rms[c]) / 3.0;
        gain += scene->weight[c] * tsu_i_plain_exp(luminance[c]);
    }
    const double margin = tsu_i_trade.margin;
    const double swing = tsu_i_plain_exp(margin * tier->luminance->spread);
    out->error = sqrt(square);
    out->high = out->error * tsu_i_plain_exp(margin * tier->rms->spread);
    out->luminance = gain - 1.0;
    out->luminance_high = larger(fabs(gain * swing - 1.0), fabs(gain / swing - 1.0));
}

// Nearest leaf of the table: by the root of its nine numbers, which is about what eyes compare.
static uint32_t nearest(const tsu_choose_desc *desc, uint32_t *outside)
{
    // Presets differ from their nearest by 0.02 to 0.2; so far from all, none tells anything.
    const double far = 0.25;
    uint32_t best = 0;
    double least = 1e300;
    for (uint32_t s = 0; s < tsu_i_trade.species_count; s++) {
        const double *color = tsu_i_trade.species[s].color;
        double sum = 0.0;
        for (int i = 0; i < 9; i++) {
            const float *own = i < 3 ? desc->R_top : i < 6 ? desc->R_bottom : desc->T;
            const double off = sqrt((double)own[i % 3]) - sqrt(color[i] > 0.0 ? color[i] : 0.0);
            sum += off * off / 9.0;
        }
        if (sum < least) {
            least = sum;
            best = s;
        }
    }
    if (least <= far * far)
        return best;
    *outside |= TSU_OUTSIDE_COLOR;
    return tsu_i_trade.species_count;
}

static void predict_leaf(const tsu_choose_desc *desc, const struct tsu_i_trade_tier *tier,
                         uint32_t species, struct tsu_i_candidate *out)
{
    out->error = tier->reflected[species];
    if (desc->flags & TSU_CHOOSE_BACKLIT)
        out->error = larger(out->error, tier->transmitted[species]);
    out->luminance = tier->leaf_luminance[species];
    if (desc->flags & TSU_CHOOSE_COAT && tier->coat) {
        out->error = larger(out->error, tier->coat[species]);
        if (fabs(tier->coat_luminance[species]) > fabs(out->luminance))
            out->luminance = tier->coat_luminance[species];
    }
    out->high = out->error;
    out->luminance_high = fabs(out->luminance);
}

// Of a leaf that light spreads in, one Gaussian of the same 90 % radius: a border of shadow puts
// sigma / (sqrt(2 pi) pixel) into the first pixel beyond it. Curvature as tsu_leaf_scale_judge()
// with the typical ratio of radius and thickness, 1.3 and 1.65.
static uint32_t spread(const tsu_choose_desc *desc, uint32_t *outside)
{
    const double tolerance = desc->error_bound > 0.0f ? (double)desc->error_bound : 0.1;
    double R = (double)desc->spread_R, T = (double)desc->spread_T;
    R = R > 0.0 ? R : 0.26;
    T = T > 0.0 ? T : 0.33;
    if (!(desc->flags & TSU_CHOOSE_BACKLIT))
        T = 0.0;
    const double sigma = larger(R, T) / 2.145966026289347; // sqrt(2 ln 10)
    const double bent = larger(1.95 * R, 0.3 * T) / (double)desc->curvature;
    if (bent > tolerance)
        *outside |= TSU_OUTSIDE_CURVATURE;
    return 0.3989422804014327 * sigma / (double)desc->footprint > tolerance ? TSU_PASS_BLUR : 0;
}

// Lights that have a map.
static double single(const tsu_choose_desc *desc)
{
    return (double)desc->directional_lights + (double)desc->point_lights +
           (double)desc->area_lights;
}

static double evaluations(const tsu_choose_desc *desc)
{
    const double n = (double)desc->directional_lights + (double)desc->point_lights +
                     13.0 * (double)desc->area_lights + 12.0 * (double)desc->environments;
    return n > 0.0 ? n : 1.0;
}

static void allow(const tsu_choose_desc *desc, const struct tsu_i_trade_tier *tier,
                  struct tsu_i_candidate *out)
{
    enum { MAP_SAMPLERS = 3 };
    out->samplers = tier->samplers;
    out->bytes = tier->bytes;
    if (tier->flags & TSU_TIER_SHADOW) {
        if (desc->shadow == TSU_CHOOSE_SHADOW_NONE)
            out->lacks |= TSU_LACKS_SHADOW;
        if (desc->shadow == TSU_CHOOSE_SHADOW_COUNT)
            out->passes |= TSU_PASS_COUNT;
        if (desc->shadow == TSU_CHOOSE_SHADOW_MAPS) {
            out->passes |= TSU_PASS_MAPS;
            out->samplers += MAP_SAMPLERS;
        }
    }
    if (out->samplers > desc->samplers)
        out->lacks |= TSU_LACKS_SAMPLERS;
    if (out->bytes > desc->memory)
        out->lacks |= TSU_LACKS_MEMORY;
    if (tier->flags & TSU_TIER_UNIFORM && desc->flags & TSU_CHOOSE_PIGMENT_MAP)
        out->lacks |= TSU_LACKS_MAP;
    if (desc->kind == TSU_CHOOSE_LEAF && tier->flags & TSU_TIER_COAT &&
        !(desc->flags & TSU_CHOOSE_COAT))
        out->lacks |= TSU_LACKS_COAT;
}

void tsu_i_predict(const tsu_choose_desc *desc, struct tsu_i_field *field)
{
    struct channels scene;
    uint32_t species = 0, blur = 0;
    const double count = evaluations(desc);
    *field = (struct tsu_i_field){0};
    if (desc->kind == TSU_CHOOSE_HAIR) {
        read_scene(desc, &scene, &field->outside);
    } else {
        species = nearest(desc, &field->outside);
        blur = spread(desc, &field->outside);
        if (species < tsu_i_trade.species_count)
            field->species = tsu_i_trade.species[species].name;
    }
    for (uint32_t i = 0; i < tsu_i_trade.tier_count; i++) {
        const struct tsu_i_trade_tier *tier = tsu_i_trade.tiers + i;
        if (tier->kind != desc->kind || field->count == TSU_I_TIERS_MOST)
            continue;
        struct tsu_i_candidate *out = field->tiers + field->count++;
        out->tier = (tsu_tier)i;
        out->passes = blur;
        out->cost = tier->clocks[desc->gpu - TSU_CHOOSE_NAVI21] * count;
        if (desc->shadow == TSU_CHOOSE_SHADOW_MAPS && desc->kind == TSU_CHOOSE_HAIR)
            out->cost += tier->map_clocks[desc->gpu - TSU_CHOOSE_NAVI21] * single(desc);
        if (desc->kind == TSU_CHOOSE_HAIR)
            predict_hair(tier, &scene, out);
        else
            predict_leaf(desc, tier, species, out);
        allow(desc, tier, out);
        if (desc->error_bound > 0.0f)
            out->excess = out->high / (double)desc->error_bound;
        if (desc->luminance_bound > 0.0f)
            out->excess = larger(out->excess, out->luminance_high / (double)desc->luminance_bound);
    }
}

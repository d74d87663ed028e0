#include "choose/drop.h"

#include "choose/trade.h"

// Between two nodes a line, which is above the share: shares fall ever more slowly. Beyond the last
// node they stay.
static double share_at(const double *share, double sigma)
{
    const struct tsu_i_trade_lobes *lobes = &tsu_i_trade.lobes;
    uint32_t i = 1;
    while (i < lobes->sigmas && lobes->sigma[i] < sigma)
        i++;
    if (i >= lobes->sigmas)
        return share[lobes->sigmas - 1];
    const double t = (sigma - lobes->sigma[i - 1]) / (lobes->sigma[i] - lobes->sigma[i - 1]);
    return share[i - 1] + t * (share[i] - share[i - 1]);
}

// Row of back scattering: the next slab that is at least as thick; shares rise with depth.
static uint32_t back_row(double depth)
{
    uint32_t i = 0;
    while (i + 1 < tsu_i_trade.lobes.depths && tsu_i_trade.lobes.depth[i] < depth)
        i++;
    return 2 + i;
}

uint32_t tsu_i_drop(const tsu_choose_desc *desc, tsu_tier tier)
{
    enum { LOBES = 3 };
    static const uint32_t bit[LOBES] = {TSU_SHADER_DROP_TRT, TSU_SHADER_DROP_RESIDUAL,
                                        TSU_SHADER_DROP_BACK};
    const uint32_t possible = tsu_i_trade.tiers[tier].drops;
    if (desc->kind == TSU_CHOOSE_LEAF)
        return desc->flags & TSU_CHOOSE_BACKLIT ? 0 : possible & TSU_SHADER_DROP_TRANSMITTED;
    const uint32_t row[LOBES] = {0, 1, back_row((double)desc->depth)};
    double lost[LOBES] = {0.0};
    for (int lobe = 0; lobe < LOBES; lobe++)
        for (int c = 0; c < 3; c++) {
            const double share =
                share_at(tsu_i_trade.lobes.share + row[lobe] * tsu_i_trade.lobes.sigmas,
                         (double)desc->sigma_a[c]);
            lost[lobe] = share > lost[lobe] ? share : lost[lobe];
        }
    double left = desc->error_bound > 0.0f ? 0.1 * (double)desc->error_bound : 0.005;
    uint32_t dropped = 0;
    for (int n = 0; n < LOBES; n++) {
        int least = -1;
        for (int lobe = 0; lobe < LOBES; lobe++)
            if (possible & bit[lobe] & ~dropped && (least < 0 || lost[lobe] < lost[least]))
                least = lobe;
        if (least < 0 || lost[least] >= left)
            break;
        left -= lost[least];
        dropped |= bit[least];
    }
    return dropped;
}

// Lobes whose light can be missed.
#ifndef TSU_CHOOSE_DROP_H
#define TSU_CHOOSE_DROP_H

#include <tsuya/choose.h>

// TSU_SHADER_DROP_* bits of what a tier's text can be without: of hair, lobes whose shares of light
// in the channel that loses most sum to less than a tenth of error_bound (0.005 without one), the
// smallest first; of leaves, transmission where no light comes from behind.
uint32_t tsu_i_drop(const tsu_choose_desc *desc, tsu_tier tier);

#endif

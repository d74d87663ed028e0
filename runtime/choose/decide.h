// The choice among predicted tiers: pure rules, stated in tsuya/choose.h.
#ifndef TSU_CHOOSE_DECIDE_H
#define TSU_CHOOSE_DECIDE_H

#include "choose/predict.h"

struct tsu_i_decision {
    tsu_choice_status status;
    int held;                                       // the previous tier was kept
    const struct tsu_i_candidate *chosen;           // NULL: the host can have none
    const struct tsu_i_candidate *better, *cheaper; // NULL: there is none
    uint32_t within;                                // tiers that meet bounds and budget
};

void tsu_i_decide(const tsu_choose_desc *desc, const struct tsu_i_field *field,
                  struct tsu_i_decision *out);

#endif

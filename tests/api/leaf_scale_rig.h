// What the tests of leaf_scale.h begin with. In the context of watched.h.
#ifndef TSUYA_TESTS_API_LEAF_SCALE_RIG_H
#define TSUYA_TESTS_API_LEAF_SCALE_RIG_H

#include <tsuya/leaf_scale.h>

tsu_leaf_scale_desc scale_usual(void);
tsu_leaf_scale scale_empty(void);
tsu_leaf_scale scale_solve(const tsu_leaf_scale_desc *desc);
// All layers alike in all channels but for what is given.
tsu_leaf_scale_desc scale_leaf(const double scatter[3], const double absorption[3]);

#endif

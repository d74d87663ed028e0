#include "leaf_scale_rig.h"

#include "watched.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>

tsu_leaf_scale_desc scale_usual(void)
{
    tsu_leaf_scale_desc desc;
    assert_int_equal(tsu_leaf_scale_desc_init(&desc), TSU_OK);
    return desc;
}

tsu_leaf_scale scale_empty(void)
{
    tsu_leaf_scale scale;
    assert_int_equal(tsu_leaf_scale_init(&scale), TSU_OK);
    return scale;
}

tsu_leaf_scale scale_solve(const tsu_leaf_scale_desc *desc)
{
    tsu_leaf_scale scale = scale_empty();
    assert_int_equal(tsu_leaf_scale_solve(context, desc, &scale), TSU_OK);
    return scale;
}

tsu_leaf_scale_desc scale_leaf(const double scatter[3], const double absorption[3])
{
    tsu_leaf_scale_desc desc = scale_usual();
    for (int c = 0; c < 3; c++) {
        desc.scatter_top[c] = desc.scatter_bottom[c] = (float)(0.5 * scatter[c]);
        desc.absorption_top[c] = desc.absorption_bottom[c] = (float)(0.5 * absorption[c]);
    }
    return desc;
}

// Scenes at random within what the table was measured for: the same on every machine.
#ifndef TSUYA_TESTS_CHOOSE_SCENES_H
#define TSUYA_TESTS_CHOOSE_SCENES_H

#include <tsuya/choose.h>

struct scenes {
    uint64_t random;
};

// Uniform in [low, high).
double scenes_between(struct scenes *scenes, double low, double high);
// Hair, no wish.
tsu_choose_desc scenes_hair(struct scenes *scenes);
// A leaf, no wish.
tsu_choose_desc scenes_leaf(struct scenes *scenes);

#endif

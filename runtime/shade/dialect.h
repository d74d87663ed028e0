// What differs between the targets, in one table.
#ifndef TSU_SHADE_DIALECT_H
#define TSU_SHADE_DIALECT_H

#include <tsuya/shader.h>

struct tsu_i_dialect {
    tsu_target target;
    const char *name;
    const char *version;  // the #version line
    const char *preamble; // before any declaration
    int locations;        // fragment inputs carry layout(location)
    int bindings;         // resources carry layout(set, binding)
};

// NULL for an unknown target.
const struct tsu_i_dialect *tsu_i_dialect_find(tsu_target target);

#endif

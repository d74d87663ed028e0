// Leaves by name: what they are made of (PROSPECT-D), and the reflectance and transmittance that
// follow in three bands (means over red 610..680, green 530..570, blue 430..490 nm).
//
// Contents are typical values of the field; young green, dark shade, needle, yellow autumn and dry
// brown are those of the table that the bands were checked against, the others ours.
#ifndef TSU_OPTICS_LEAF_PRESETS_H
#define TSU_OPTICS_LEAF_PRESETS_H

#include "optics/prospect.h"

enum { TSU_I_LEAF_PRESETS = 9 };

struct tsu_i_leaf_preset {
    const char *name; // "young_green"
    const char *title;
    struct tsu_i_prospect contents;
    double R[3],
        T[3]; // at normal incidence, top side, mirror reflection included; red, green, blue
};

extern const struct tsu_i_leaf_preset tsu_i_leaf_presets[TSU_I_LEAF_PRESETS];
// Index in the three bands, of all presets.
extern const double tsu_i_leaf_preset_n[3];
// R_bottom over R_top, which PROSPECT does not know: the presets'.
#define TSU_I_LEAF_PRESET_RATIO 1.4

#endif

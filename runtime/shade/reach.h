// Only the functions that are wanted, and what they need.
#ifndef TSU_SHADE_REACH_H
#define TSU_SHADE_REACH_H

#include "shade/assemble.h"

// Words of `only`: the size of the next one, with *list at its begin; 0 at the end.
size_t tsu_i_only_word(const char **list);

// Drop from the assembled text, in place, every function, struct and macro of the models' own files
// that nothing wanted needs: see tsu_shader_desc.only. What no model lists stays whole. Lines keep
// their numbers.
// Errors: TSU_E_PARAMETER (a name that no model has, logged), TSU_E_MEMORY.
tsu_status tsu_i_reach(const tsu_context *context, const tsu_shader_desc *desc,
                       struct tsu_i_assembly *out);

#endif

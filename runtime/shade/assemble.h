// Snippets to text.
#ifndef TSU_SHADE_ASSEMBLE_H
#define TSU_SHADE_ASSEMBLE_H

#include "base/text.h"
#include "models/model.h"

#include <tsuya/shader.h>

enum { TSU_I_SOURCES = 64 };

struct tsu_i_assembly {
    struct tsu_i_text text;
    const char *sources[TSU_I_SOURCES]; // by source string number; 0 is our own glue
    uint32_t source_count;
};

// Assemble a checked descriptor. TSU_E_MEMORY, TSU_E_HOST (text from the host breaks a rule,
// logged).
tsu_status tsu_i_assemble(const tsu_context *context, const tsu_shader_desc *desc,
                          struct tsu_i_assembly *out);

#endif

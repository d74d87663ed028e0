// A choice in words.
#ifndef TSU_CHOOSE_REASON_H
#define TSU_CHOOSE_REASON_H

#include "choose/decide.h"

#include <stddef.h>

// One to three sentences, zero-terminated; what does not fit is cut. Numbers are written by
// arithmetic on integers, so that the text is the same everywhere.
void tsu_i_reason(const tsu_choose_desc *desc, const struct tsu_i_field *field,
                  const struct tsu_i_decision *decision, char *text, size_t capacity);

#endif

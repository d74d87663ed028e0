// Conditional parts of snippets, decided while the text is assembled.
//
// In a snippet, `#ifdef NAME`, `#ifndef NAME` and `#if defined(NAME) || !defined(OTHER)` with #else
// and #endif choose lines where every name is one of ours: TSU_FINE and TSU_DROP_*. The text holds
// the chosen lines alone. All other directives stay as they are.
#ifndef TSU_SHADE_STRIP_H
#define TSU_SHADE_STRIP_H

#include "base/text.h"

// Drop what `flags` (TSU_SHADER_*) do not choose, in place. Lines keep their numbers.
void tsu_i_strip(struct tsu_i_text *text, unsigned flags);

// Rewriting of a text in place, line by line: what is left out becomes line ends or a #line, so
// that a driver's messages still point to the right line.
struct tsu_i_rewrite {
    struct tsu_i_text *text;
    size_t read, written;  // bytes
    unsigned line, source; // of the line at `read`
    unsigned missing;      // lines left out right before `read`
};
struct tsu_i_rewrite tsu_i_rewrite_begin(struct tsu_i_text *text);
// Size of the line at `read` with its line end; 0 at the end of the text.
size_t tsu_i_rewrite_line(const struct tsu_i_rewrite *rewrite);
// Go past that line: keep it or leave it out.
void tsu_i_rewrite_next(struct tsu_i_rewrite *rewrite, int keep);
void tsu_i_rewrite_end(struct tsu_i_rewrite *rewrite);

#endif

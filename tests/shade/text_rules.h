// A reader of GLSL just able enough to list what a text declares at file scope.
#ifndef TSUYA_TESTS_SHADE_TEXT_RULES_H
#define TSUYA_TESTS_SHADE_TEXT_RULES_H

#include <stddef.h>

enum { GLOBALS_MOST = 256 };

struct globals {
    struct {
        char name[64];
        char kind; // 'f' function, 's' struct, 'm' macro, 'v' variable, 'b' block, 'u' sampler
    } items[GLOBALS_MOST];
    int count;
};

// Comments become blanks of the same lines.
char *text_without_comments(const char *text); // the caller frees
void text_globals(const char *text, struct globals *out);
int text_occurrences(const char *text, const char *word);
// How many globals of this kind, and of this name when it is not NULL.
int globals_count(const struct globals *g, char kind, const char *name);

#endif

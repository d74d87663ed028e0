// The GLSL files inside the library.
#ifndef TSU_SHADE_SNIPPET_H
#define TSU_SHADE_SNIPPET_H

#include <stddef.h>

struct tsu_i_snippet {
    const char *name; // "marschner/eval.glsl"
    const unsigned char *bytes;
    size_t size;
};

// Ends with a NULL name. Written by glsl/embed.py.
extern const struct tsu_i_snippet tsu_i_snippets[];

#endif

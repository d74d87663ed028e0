// What the tests of slabs share: one or more layers asked in a line.
#ifndef TESTS_OPTICS_SLAB_SUPPORT_H
#define TESTS_OPTICS_SLAB_SUPPORT_H

#include "optics/slab.h"

#include <stdlib.h>

enum { SLAB_DIRECTIONS = 16 };

// A slab to be solved, and its solution. Zero it with slab_of().
struct slab_case {
    struct tsu_i_slab_desc desc;
    struct tsu_i_slab_direction directions[SLAB_DIRECTIONS];
    struct tsu_i_slab solved;
    double *memory;
};

static inline struct slab_case slab_of(const struct tsu_i_slab_layer *layers, uint32_t count,
                                       uint32_t nodes)
{
    struct slab_case c = {.desc = {.layers = layers,
                                   .layer_count = count,
                                   .slide_top = 1.0,
                                   .slide_bottom = 1.0,
                                   .nodes = nodes,
                                   .modes = 1}};
    return c;
}

static inline uint32_t slab_direction(struct slab_case *c, double mu, double n)
{
    c->directions[c->desc.direction_count] = (struct tsu_i_slab_direction){mu, n};
    return c->desc.direction_count++;
}

// NULL, or what is wrong with it. Free with slab_free().
static inline const char *slab_solve(struct slab_case *c)
{
    c->desc.directions = c->directions;
    const char *wrong = tsu_i_slab_check(&c->desc);
    c->memory = NULL;
    if (wrong)
        return wrong;
    c->memory = malloc(tsu_i_slab_doubles(&c->desc) * sizeof(double));
    if (!c->memory)
        return "no memory";
    tsu_i_slab_solve(&c->solved, &c->desc, c->memory);
    return NULL;
}

static inline void slab_free(struct slab_case *c)
{
    free(c->memory);
    c->memory = NULL;
}

#endif

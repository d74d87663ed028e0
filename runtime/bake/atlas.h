// Places for tables in one texture: cells of TSU_CELL texels along a Z-order curve, so that the
// texture grows by doubling while every table keeps its texel. A table of a whole cell takes one; a
// smaller one shares a cell with tables of its own size.
#ifndef TSU_BAKE_ATLAS_H
#define TSU_BAKE_ATLAS_H

#include "base/host.h"

struct tsu_i_atlas_cell {
    uint32_t width, height; // of the tables in it; 0 when the cell is free
    uint32_t used;          // slots taken
    uint64_t slots;         // one bit a slot, at most 64 of them
};

struct tsu_i_atlas {
    const struct tsu_context *context;
    struct tsu_i_atlas_cell *cells;
    uint32_t cell_count, cell_capacity;
    uint32_t max_size;      // texels along a side
    uint32_t width, height; // of the texture that holds all cells, texels; 0 at first
};

// Find a place for a table of width x height texels, both at most TSU_CELL and at least 16.
// TSU_E_LIMIT when the texture would pass max_size (logged), TSU_E_MEMORY.
tsu_status tsu_i_atlas_take(struct tsu_i_atlas *atlas, uint32_t width, uint32_t height, uint32_t *x,
                            uint32_t *y);
void tsu_i_atlas_give(struct tsu_i_atlas *atlas, uint32_t x, uint32_t y);
void tsu_i_atlas_free(struct tsu_i_atlas *atlas);

#endif

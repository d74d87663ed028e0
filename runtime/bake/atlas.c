#include "bake/atlas.h"

#include <tsuya/set.h>

// Every second bit of a Z-order index.
static uint32_t even_bits(uint32_t code)
{
    uint32_t value = 0;
    for (int bit = 0; bit < 16; bit++)
        value |= (code >> (2 * bit) & 1u) << bit;
    return value;
}

static uint32_t spread_bits(uint32_t value)
{
    uint32_t code = 0;
    for (int bit = 0; bit < 16; bit++)
        code |= (value >> bit & 1u) << (2 * bit);
    return code;
}

static uint32_t cell_x(uint32_t cell)
{
    return even_bits(cell);
}

static uint32_t cell_y(uint32_t cell)
{
    return even_bits(cell >> 1);
}

static tsu_status take_slot(struct tsu_i_atlas *atlas, uint32_t cell, uint32_t *x, uint32_t *y)
{
    struct tsu_i_atlas_cell *c = atlas->cells + cell;
    const uint32_t across = TSU_CELL / c->width;
    uint32_t slot = 0;
    while (c->slots >> slot & 1u)
        slot++;
    c->slots |= (uint64_t)1 << slot;
    c->used++;
    *x = cell_x(cell) * TSU_CELL + slot % across * c->width;
    *y = cell_y(cell) * TSU_CELL + slot / across * c->height;
    return TSU_OK;
}

static uint32_t slots_in(uint32_t width, uint32_t height)
{
    return TSU_CELL / width * (TSU_CELL / height);
}

static tsu_status new_cell(struct tsu_i_atlas *atlas, uint32_t *cell)
{
    for (*cell = 0; *cell < atlas->cell_count; ++*cell)
        if (atlas->cells[*cell].used == 0)
            return TSU_OK;
    uint32_t width = atlas->width ? atlas->width : TSU_CELL;
    uint32_t height = atlas->height ? atlas->height : TSU_CELL;
    while (width / TSU_CELL * (height / TSU_CELL) <= *cell) {
        if (width == height)
            width *= 2;
        else
            height *= 2;
    }
    if (width > atlas->max_size || height > atlas->max_size) {
        tsu_i_log(atlas->context, TSU_LOG_ERROR, TSU_LOG_TEXTURE_LIMIT,
                  "the tables need a texture of %u x %u, tsu_set_desc.max_texture_size is %u",
                  width, height, atlas->max_size);
        return TSU_E_LIMIT;
    }
    if (*cell == atlas->cell_capacity) {
        const uint32_t capacity = atlas->cell_capacity ? 2 * atlas->cell_capacity : 4;
        struct tsu_i_atlas_cell *cells = tsu_i_realloc(
            atlas->context, atlas->cells, atlas->cell_capacity, capacity, sizeof *cells);
        if (!cells)
            return TSU_E_MEMORY;
        atlas->cells = cells;
        atlas->cell_capacity = capacity;
    }
    atlas->cell_count++;
    atlas->width = width;
    atlas->height = height;
    return TSU_OK;
}

tsu_status tsu_i_atlas_take(struct tsu_i_atlas *atlas, uint32_t width, uint32_t height, uint32_t *x,
                            uint32_t *y)
{
    for (uint32_t i = 0; i < atlas->cell_count; i++) {
        const struct tsu_i_atlas_cell *c = atlas->cells + i;
        if (c->used && c->width == width && c->height == height &&
            c->used < slots_in(width, height))
            return take_slot(atlas, i, x, y);
    }
    uint32_t cell;
    const tsu_status status = new_cell(atlas, &cell);
    if (status != TSU_OK)
        return status;
    atlas->cells[cell] = (struct tsu_i_atlas_cell){.width = width, .height = height};
    return take_slot(atlas, cell, x, y);
}

void tsu_i_atlas_give(struct tsu_i_atlas *atlas, uint32_t x, uint32_t y)
{
    const uint32_t cell = spread_bits(x / TSU_CELL) | spread_bits(y / TSU_CELL) << 1;
    struct tsu_i_atlas_cell *c = atlas->cells + cell;
    const uint32_t across = TSU_CELL / c->width;
    const uint32_t slot = y % TSU_CELL / c->height * across + x % TSU_CELL / c->width;
    c->slots &= ~((uint64_t)1 << slot);
    c->used--;
}

void tsu_i_atlas_free(struct tsu_i_atlas *atlas)
{
    tsu_i_free(atlas->context, atlas->cells, atlas->cell_capacity, sizeof *atlas->cells);
    atlas->cells = NULL;
    atlas->cell_count = atlas->cell_capacity = atlas->width = atlas->height = 0;
}

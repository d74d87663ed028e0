#include "fake_set.h"

#include <stdlib.h>
#include <string.h>

static uint32_t mix(uint32_t a)
{
    a ^= a >> 16;
    a *= 0x7feb352dU;
    a ^= a >> 15;
    a *= 0x846ca68bU;
    return a ^ (a >> 16);
}

static void *must(void *pointer)
{
    if (!pointer)
        exit(99);
    return pointer;
}

static void fill_region(tsu_set *set, uint32_t region, uint32_t seed)
{
    tsu_region *const r = &set->regions[region];
    for (uint32_t y = r->y; y < r->y + r->height; y++)
        for (uint32_t i = 4 * r->x; i < 4 * (r->x + r->width); i++)
            set->texels[4 * set->width * y + i] = (uint16_t)mix(mix(seed + y) + i);
    r->generation = set->generation;
}

// Ordinary numbers, so that a shader's copy can be compared bit for bit.
static void fill_page(tsu_set *set, uint32_t page, uint32_t seed)
{
    float *const values = set->pages + (size_t)page * set->page_stride;
    for (uint32_t i = 0; i < 4 * TSU_PAGE_VEC4; i++)
        values[i] = (float)(mix(mix(seed + page) + i) >> 8) - 8388607.5F;
    set->page_generations[page] = set->generation;
}

static void add_regions(tsu_set *set, uint32_t seed)
{
    const uint32_t w = set->width < TSU_CELL ? set->width : TSU_CELL;
    const uint32_t h = set->height < TSU_CELL ? set->height : TSU_CELL;
    for (uint32_t y = 0; h && y + h <= set->height; y += h)
        for (uint32_t x = 0; w && x + w <= set->width; x += w) {
            uint32_t i = 0;
            while (i < set->region_count && (set->regions[i].x != x || set->regions[i].y != y))
                i++;
            if (i < set->region_count || i >= FAKE_REGIONS)
                continue;
            set->regions[i] = (tsu_region){x, y, w, h, 0};
            set->region_count++;
            fill_region(set, i, seed);
        }
}

static void next(tsu_set *set, int texture)
{
    set->generation++;
    if (texture)
        set->texture_generation = set->generation;
}

tsu_set *fake_set_create(uint32_t width, uint32_t height, uint32_t page_count, uint32_t page_stride,
                         uint32_t seed)
{
    tsu_set *const set = must(calloc(1, sizeof *set));
    set->page_stride = page_stride;
    set->generation = set->texture_generation = 1;
    set->width = width;
    set->height = height;
    set->texels = must(calloc((size_t)width * height + 1, 4 * sizeof *set->texels));
    add_regions(set, seed);
    set->pages = must(calloc((size_t)page_count + 1, page_stride * sizeof *set->pages));
    set->page_generations = must(calloc((size_t)page_count + 1, sizeof *set->page_generations));
    set->page_count = page_count;
    for (uint32_t i = 0; i < page_count; i++)
        fill_page(set, i, seed);
    return set;
}

void fake_set_destroy(tsu_set *set)
{
    if (!set)
        return;
    free(set->texels);
    free(set->pages);
    free(set->page_generations);
    free(set);
}

void fake_set_touch_region(tsu_set *set, uint32_t region, uint32_t seed)
{
    next(set, 1);
    fill_region(set, region, seed);
}

void fake_set_touch_page(tsu_set *set, uint32_t page, uint32_t seed)
{
    next(set, 0);
    fill_page(set, page, seed);
}

void fake_set_grow(tsu_set *set, uint32_t width, uint32_t height, uint32_t seed)
{
    uint16_t *const texels = must(calloc((size_t)width * height + 1, 4 * sizeof *texels));
    for (uint32_t y = 0; y < set->height && y < height; y++)
        memcpy(texels + (size_t)4 * width * y, set->texels + (size_t)4 * set->width * y,
               4 * sizeof *texels * (set->width < width ? set->width : width));
    free(set->texels);
    set->texels = texels;
    set->width = width;
    set->height = height;
    next(set, 1);
    add_regions(set, seed);
}

void fake_set_grow_pages(tsu_set *set, uint32_t page_count, uint32_t seed)
{
    set->pages = must(realloc(set->pages, ((size_t)page_count + 1) * set->page_stride * 4));
    set->page_generations =
        must(realloc(set->page_generations, ((size_t)page_count + 1) * sizeof(uint64_t)));
    next(set, 0);
    for (; set->page_count < page_count; set->page_count++)
        fill_page(set, set->page_count, seed);
}

// The library's functions, as tsuya/set.h describes them.

tsu_status tsu_set_describe(const tsu_set *set, tsu_set_info *out)
{
    if (out->struct_size != sizeof *out)
        return TSU_E_STRUCT;
    ((tsu_set *)(uintptr_t)set)->describe_calls++;
    out->page_count = set->page_count;
    out->table_count = set->region_count;
    out->stale_count = set->stale_count;
    out->width = set->width;
    out->height = set->height;
    out->generation = set->generation;
    out->id = set->id ? set->id : (uint64_t)(uintptr_t)set;
    out->texture_generation = set->texture_generation;
    return TSU_OK;
}

const uint16_t *tsu_set_texels(const tsu_set *set)
{
    ((tsu_set *)(uintptr_t)set)->read_calls++;
    return set->width ? set->texels : NULL;
}

int32_t tsu_set_region(const tsu_set *set, uint32_t index, tsu_region *out)
{
    ((tsu_set *)(uintptr_t)set)->read_calls++;
    if (index >= set->region_count)
        return 0;
    *out = set->regions[index];
    return 1;
}

const float *tsu_set_page(const tsu_set *set, uint32_t page, uint64_t *generation)
{
    ((tsu_set *)(uintptr_t)set)->read_calls++;
    if (page >= set->page_count)
        return NULL;
    if (generation)
        *generation = set->page_generations[page];
    return set->pages + (size_t)page * set->page_stride;
}

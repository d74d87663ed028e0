// A set without models: any size, any regions, any pages, every generation under control.
//
// Stands in for the library's tsu_set in tests of the GL floor alone: link one or the other.
#ifndef TSUYA_TESTS_GL_FAKE_SET_H
#define TSUYA_TESTS_GL_FAKE_SET_H

#include <tsuya/set.h>

enum { FAKE_REGIONS = 64 };

struct tsu_set {
    uint32_t width, height, region_count, page_count, stale_count;
    uint64_t id; // 0: the set's address
    uint64_t generation, texture_generation;
    uint32_t describe_calls, read_calls; // of tsu_set_describe(); of the other functions
    uint16_t *texels;
    tsu_region regions[FAKE_REGIONS];
    float *pages;
    uint32_t page_stride; // floats from page to page, at least 4096; more keeps pages apart
    uint64_t *page_generations;
};

// Makes a set of one region a 128 x 128 cell, or of one region when the texture is smaller.
// `width` or `page_count` may be 0. Everything has generation 1.
tsu_set *fake_set_create(uint32_t width, uint32_t height, uint32_t page_count, uint32_t page_stride,
                         uint32_t seed);
void fake_set_destroy(tsu_set *set);

// New content, all bit patterns, in a new generation.
void fake_set_touch_region(tsu_set *set, uint32_t region, uint32_t seed);
void fake_set_touch_page(tsu_set *set, uint32_t page, uint32_t seed);

// Another size: what was there keeps its texels and generation, what is new gets a new one.
void fake_set_grow(tsu_set *set, uint32_t width, uint32_t height, uint32_t seed);
void fake_set_grow_pages(tsu_set *set, uint32_t page_count, uint32_t seed);

#endif

// Places in the texture, alone: no two tables overlap, none leaves its cell, none ever moves.
#include "bake/atlas.h"
#include "watch.h"

#include <tsuya/set.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

struct rectangle {
    uint32_t x, y, width, height;
};

static int overlap(const struct rectangle *a, const struct rectangle *b)
{
    return a->x < b->x + b->width && b->x < a->x + a->width && a->y < b->y + b->height &&
           b->y < a->y + a->height;
}

static struct watch watch;

static void tables_of_all_sizes_never_overlap(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = {{128, 128}, {64, 64}, {128, 64}, {16, 16}, {32, 128}};
    enum { COUNT = 120 };
    static struct rectangle at[COUNT];
    memset(at, 0, sizeof at);
    tsu_context *context = watch_open(&watch);
    struct tsu_i_atlas atlas = {.context = context, .max_size = 2048};
    uint32_t random = 12345, taken = 0;
    for (int step = 0; step < 3000; step++) {
        random = random * 1664525u + 1013904223u;
        struct rectangle *slot = at + (random >> 8) % COUNT;
        if (slot->width) {
            tsu_i_atlas_give(&atlas, slot->x, slot->y);
            slot->width = 0;
            taken--;
            continue;
        }
        const uint32_t *size = sizes[(random >> 20) % 5];
        struct rectangle fresh = {0, 0, size[0], size[1]};
        assert_int_equal(tsu_i_atlas_take(&atlas, size[0], size[1], &fresh.x, &fresh.y), TSU_OK);
        assert_true(fresh.x + fresh.width <= atlas.width && fresh.y + fresh.height <= atlas.height);
        assert_int_equal(fresh.x / TSU_CELL, (fresh.x + fresh.width - 1) / TSU_CELL);
        assert_int_equal(fresh.y / TSU_CELL, (fresh.y + fresh.height - 1) / TSU_CELL);
        for (int i = 0; i < COUNT; i++)
            if (at[i].width)
                assert_false(overlap(&fresh, at + i));
        *slot = fresh;
        taken++;
    }
    assert_true(taken > 0);
    for (int i = 0; i < COUNT; i++)
        if (at[i].width)
            tsu_i_atlas_give(&atlas, at[i].x, at[i].y);
    for (uint32_t i = 0; i < atlas.cell_count; i++)
        assert_int_equal(atlas.cells[i].used, 0);
    tsu_i_atlas_free(&atlas);
    tsu_context_destroy(context);
    watch_close(&watch);
}

static void the_limit_holds_exactly_what_fits(void **state)
{
    (void)state;
    static const uint32_t limits[][2] = {{128, 1}, {255, 1}, {256, 4}, {300, 4}, {512, 16}};
    for (int i = 0; i < 5; i++) {
        tsu_context *context = watch_open(&watch);
        struct tsu_i_atlas atlas = {.context = context, .max_size = limits[i][0]};
        uint32_t x, y, fitted = 0;
        while (tsu_i_atlas_take(&atlas, TSU_CELL, TSU_CELL, &x, &y) == TSU_OK)
            fitted++;
        assert_int_equal(fitted, limits[i][1]);
        assert_true(atlas.width <= limits[i][0] && atlas.height <= limits[i][0]);
        assert_int_equal(tsu_i_atlas_take(&atlas, 16, 16, &x, &y), TSU_E_LIMIT);
        tsu_i_atlas_give(&atlas, 0, 0);
        assert_int_equal(tsu_i_atlas_take(&atlas, 16, 16, &x, &y), TSU_OK);
        assert_true(x == 0 && y == 0);
        tsu_i_atlas_free(&atlas);
        tsu_context_destroy(context);
        watch_close(&watch);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_of_all_sizes_never_overlap),
        cmocka_unit_test(the_limit_holds_exactly_what_fits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// The texture grows by doubling, up to its limit; records follow, texels stay.
#include "rig.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct rig r;

static float eta_of(uint32_t i)
{
    return 1.25f + 0.1f * (float)i;
}

static void growth_keeps_texels_and_moves_records(void **state)
{
    (void)state;
    enum { TABLES = 6 };
    uint16_t *truth[TABLES];
    tsu_region region[TABLES];
    rig_open(&r, 0, NULL);
    uint32_t side = 0;
    for (uint32_t i = 0; i < TABLES; i++) {
        truth[i] = rig_alone(eta_of(i), 0.3f);
        assert_int_equal(rig_add(&r, eta_of(i), 0.3f), i);
        // What was there lies where it lay and reads as it did, before and after the next bake.
        for (int bake = 0; bake < 2; bake++) {
            for (uint32_t k = 0; k < i + (uint32_t)bake; k++) {
                const tsu_region now = rig_region_of(&r, k);
                if (k < i)
                    assert_true(now.x == region[k].x && now.y == region[k].y &&
                                now.generation == region[k].generation);
                uint16_t *got = rig_texels(&r, now);
                assert_memory_equal(got, truth[k], RIG_TABLE_BYTES);
                free(got);
            }
            assert_int_equal(tsu_set_bake(r.set), TSU_OK);
        }
        region[i] = rig_region_of(&r, i);
        const tsu_set_info info = rig_describe(&r);
        const uint32_t area = info.width * info.height;
        assert_true(side == 0 || area == side || area == 2 * side);
        assert_true(area / (128 * 128) < 2 * (i + 1));
        side = area;
    }
    for (uint32_t i = 0; i < TABLES; i++)
        free(truth[i]);
    rig_close(&r);
}

// The shader finds its place by the page's header: texture size and its reciprocal.
static void page_headers_follow_the_texture(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    for (uint32_t i = 0; i < 6; i++) {
        rig_add(&r, eta_of(i), 0.3f);
        const tsu_set_info info = rig_describe(&r);
        const float *page = tsu_set_page(r.set, 0, NULL);
        assert_true(page[2] == (float)info.width && page[3] == (float)info.height);
        assert_true(page[0] == 1.0f / page[2] && page[1] == 1.0f / page[3]);
    }
    rig_close(&r);
}

static void the_limit_is_named_and_leaves_the_set_as_it_was(void **state)
{
    (void)state;
    static float page_before[TSU_PAGE_VEC4 * 4];
    rig_open(&r, 256, NULL);
    for (uint32_t i = 0; i < 4; i++)
        rig_add(&r, eta_of(i), 0.3f);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const tsu_set_info before = rig_describe(&r);
    memcpy(page_before, tsu_set_page(r.set, 0, NULL), sizeof page_before);
    tsu_marschner_params hair = rig_hair(1.77f, 0.3f);
    watch_quiet(&r.watch);
    uint32_t material = 77;
    assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &material), TSU_E_LIMIT);
    assert_int_equal(material, 0);
    assert_int_equal(r.watch.log_count, 1);
    assert_non_null(strstr(r.watch.log, "max_texture_size"));
    assert_non_null(strstr(r.watch.log, "256"));
    tsu_set_info after = rig_describe(&r);
    assert_memory_equal(&after, &before, sizeof after);
    assert_memory_equal(page_before, tsu_set_page(r.set, 0, NULL), sizeof page_before);

    // Still usable: a table that exists, a change of colour, and a place that becomes free.
    const uint32_t shared = rig_add(&r, eta_of(2), 0.3f);
    assert_int_equal(rig_describe(&r).table_count, 4);
    hair.eta = eta_of(2);
    hair.sigma_a[0] = 9.0f;
    assert_int_equal(tsu_set_update(r.set, shared, &hair, NULL), TSU_OK);
    assert_int_equal(tsu_set_remove(r.set, 1), TSU_OK);
    hair.eta = 1.77f;
    assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &material), TSU_OK);
    assert_int_equal(material, 1);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    uint16_t *got = rig_texels(&r, rig_region_of(&r, 1)), *truth = rig_alone(1.77f, 0.3f);
    assert_memory_equal(got, truth, RIG_TABLE_BYTES);
    free(got);
    free(truth);
    rig_close(&r);
}

static void the_limit_of_an_update(void **state)
{
    (void)state;
    rig_open(&r, 128, NULL);
    const uint32_t a = rig_add(&r, 1.5f, 0.3f);
    rig_add(&r, 1.5f, 0.3f); // a's table stays in use whatever becomes of a
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const tsu_set_info before = rig_describe(&r);
    const tsu_marschner_params hair = rig_hair(1.6f, 0.3f);
    int32_t baked_again = 9;
    assert_int_equal(tsu_set_update(r.set, a, &hair, &baked_again), TSU_E_LIMIT);
    assert_int_equal(baked_again, 0);
    const tsu_set_info after = rig_describe(&r);
    assert_memory_equal(&after, &before, sizeof after);
    const tsu_marschner_params *kept = tsu_set_params(r.set, a, NULL);
    assert_true(kept->eta == 1.5f);
    rig_close(&r);
}

static void the_limit_of_materials(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    tsu_set_desc desc;
    tsu_set_desc_init(&desc);
    desc.max_materials = 3;
    tsu_set *set;
    assert_int_equal(tsu_set_create(r.context, &desc, &set), TSU_OK);
    const tsu_marschner_params hair = rig_hair(1.5f, 0.3f);
    uint32_t m;
    for (uint32_t i = 0; i < 3; i++)
        assert_int_equal(tsu_set_add(set, tsu_marschner(), &hair, &m), TSU_OK);
    watch_quiet(&r.watch);
    assert_int_equal(tsu_set_add(set, tsu_marschner(), &hair, &m), TSU_E_LIMIT);
    assert_non_null(strstr(r.watch.log, "max_materials"));
    assert_non_null(strstr(r.watch.log, "3"));
    assert_int_equal(tsu_set_remove(set, 0), TSU_OK);
    assert_int_equal(tsu_set_add(set, tsu_marschner(), &hair, &m), TSU_OK);
    tsu_set_destroy(set);
    rig_close(&r);
}

static void a_thousand_materials_fill_eight_pages(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    for (uint32_t i = 0; i < 1000; i++) {
        tsu_marschner_params hair = rig_hair(eta_of(i % 4), 0.4f);
        hair.sigma_a[0] = (float)i;
        uint32_t m;
        assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &m), TSU_OK);
        assert_int_equal(m, i);
    }
    const tsu_set_info info = rig_describe(&r);
    assert_int_equal(info.material_count, 1000);
    assert_int_equal(info.page_count, 8);
    assert_int_equal(info.table_count, 4);
    assert_null(tsu_set_page(r.set, 8, NULL));
    for (uint32_t i = 0; i < 1000; i++) {
        const float *page = tsu_set_page(r.set, i / TSU_PAGE_MATERIALS, NULL);
        const float *record = page + (i % TSU_PAGE_MATERIALS + 1) * TSU_RECORD_VEC4 * 4;
        assert_ptr_equal(record, tsu_set_record(r.set, i));
        assert_true(record[16] == (float)i); // sigma_a, as eval.glsl reads it
        assert_true(record + TSU_RECORD_VEC4 * 4 <= page + TSU_PAGE_VEC4 * 4);
        const tsu_region mine = rig_region_of(&r, i), first = rig_region_of(&r, i % 4);
        assert_true(mine.x == first.x && mine.y == first.y);
    }
    rig_close(&r);
}

int growth_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(growth_keeps_texels_and_moves_records),
        cmocka_unit_test(page_headers_follow_the_texture),
        cmocka_unit_test(the_limit_is_named_and_leaves_the_set_as_it_was),
        cmocka_unit_test(the_limit_of_an_update),
        cmocka_unit_test(the_limit_of_materials),
        cmocka_unit_test(a_thousand_materials_fill_eight_pages),
    };
    return cmocka_run_group_tests_name("growth", tests, NULL, NULL);
}

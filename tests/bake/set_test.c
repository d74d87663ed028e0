// Tables are shared by what shapes them, and only that makes them stale.
#include "rig.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct rig r;

static void equal_tables_are_stored_once(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    tsu_marschner_params hair = rig_hair(1.55f, 0.17f);
    uint32_t a, b, c, d, e;
    assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &a), TSU_OK);
    hair.sigma_a[1] = 3.0f;
    hair.alpha_R = 0.05f;
    hair.beta_R = 0.2f;
    hair.scale_shifts = 1.0f;
    assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &b), TSU_OK);
    hair.eta = 1.5f;
    assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &c), TSU_OK);
    hair.eta = 1.55f;
    hair.beta_az = 0.18f;
    assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &d), TSU_OK);
    tsu_kajiya_kay_params plain;
    assert_int_equal(tsu_kajiya_kay_params_init(&plain), TSU_OK);
    assert_int_equal(tsu_set_add(r.set, tsu_kajiya_kay(), &plain, &e), TSU_OK);

    const tsu_set_info info = rig_describe(&r);
    assert_int_equal(info.material_count, 5);
    assert_int_equal(info.table_count, 3);
    assert_int_equal(info.stale_count, 3);
    const tsu_region ra = rig_region_of(&r, a), rb = rig_region_of(&r, b);
    const tsu_region rc = rig_region_of(&r, c), rd = rig_region_of(&r, d);
    assert_true(ra.x == rb.x && ra.y == rb.y);
    assert_false(ra.x == rc.x && ra.y == rc.y);
    assert_false(ra.x == rd.x && ra.y == rd.y);
    assert_false(rc.x == rd.x && rc.y == rd.y);
    assert_memory_not_equal(tsu_set_record(r.set, a), tsu_set_record(r.set, b), 128);
    rig_close(&r);
}

static void colour_shift_and_roughness_bake_nothing(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    const uint32_t material = rig_add(&r, 1.55f, 0.17f);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const tsu_region region = rig_region_of(&r, material);
    for (int change = 0; change < 4; change++) {
        tsu_marschner_params hair = rig_hair(1.55f, 0.17f);
        hair.sigma_a[change % 3] = 4.0f;
        hair.alpha_R = change >= 1 ? 0.1f : hair.alpha_R;
        hair.beta_R = change >= 2 ? 0.3f : hair.beta_R;
        hair.scale_shifts = change >= 3 ? 1.0f : 0.0f;
        const tsu_set_info before = rig_describe(&r);
        float record[32];
        memcpy(record, tsu_set_record(r.set, material), sizeof record);
        uint64_t page_before, page_after;
        tsu_set_page(r.set, 0, &page_before);
        int32_t baked_again = 9;
        assert_int_equal(tsu_set_update(r.set, material, &hair, &baked_again), TSU_OK);
        const tsu_set_info after = rig_describe(&r);
        tsu_set_page(r.set, 0, &page_after);
        assert_int_equal(baked_again, 0);
        assert_int_equal(after.stale_count, 0);
        assert_int_equal(after.texture_generation, before.texture_generation);
        assert_int_equal(rig_region_of(&r, material).generation, region.generation);
        assert_memory_not_equal(tsu_set_record(r.set, material), record, sizeof record);
        assert_true(page_after > page_before);
        assert_true(after.generation >= page_after);
    }
    rig_close(&r);
}

static void a_new_azimuth_makes_one_table_stale(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    const uint32_t material = rig_add(&r, 1.55f, 0.17f);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const tsu_marschner_params hair = rig_hair(1.6f, 0.17f);
    int32_t baked_again = 0;
    assert_int_equal(tsu_set_update(r.set, material, &hair, &baked_again), TSU_OK);
    assert_int_equal(baked_again, 1);
    assert_int_equal(rig_describe(&r).stale_count, 1);
    assert_int_equal(rig_describe(&r).table_count, 1);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    assert_int_equal(rig_describe(&r).stale_count, 0);
    uint16_t *got = rig_texels(&r, rig_region_of(&r, material)), *truth = rig_alone(1.6f, 0.17f);
    assert_memory_equal(got, truth, RIG_TABLE_BYTES);
    free(got);
    free(truth);
    rig_close(&r);
}

static void equal_parameters_change_nothing(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    const uint32_t material = rig_add(&r, 1.55f, 0.17f);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    const tsu_set_info before = rig_describe(&r);
    const tsu_marschner_params hair = rig_hair(1.55f, 0.17f);
    const long calls = r.watch.calls;
    int32_t baked_again = 9;
    assert_int_equal(tsu_set_update(r.set, material, &hair, &baked_again), TSU_OK);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    assert_int_equal(baked_again, 0);
    const tsu_set_info after = rig_describe(&r);
    assert_memory_equal(&after, &before, sizeof after);
    assert_int_equal(r.watch.calls, calls);
    rig_close(&r);
}

static void removal_gives_places_back(void **state)
{
    (void)state;
    rig_open(&r, 256, NULL); // room for four tables
    for (int round = 0; round < 3; round++) {
        uint32_t m[4];
        for (int i = 0; i < 4; i++)
            m[i] = rig_add(&r, 1.3f + 0.1f * (float)i + 0.01f * (float)round, 0.2f);
        assert_int_equal(rig_describe(&r).table_count, 4);
        for (int i = 0; i < 4; i++)
            assert_true(m[i] < 4);
        for (int i = 0; i < 4; i++)
            assert_int_equal(tsu_set_remove(r.set, m[i]), TSU_OK);
        const tsu_set_info info = rig_describe(&r);
        assert_int_equal(info.table_count, 0);
        assert_int_equal(info.stale_count, 0);
        assert_int_equal(info.material_count, 0);
        assert_null(tsu_set_record(r.set, m[0]));
        assert_null(tsu_set_params(r.set, m[0], NULL));
        assert_int_equal(tsu_set_remove(r.set, m[0]), TSU_E_PARAMETER);
        tsu_region region;
        for (uint32_t i = 0; tsu_set_region(r.set, i, &region); i++)
            assert_int_equal(region.width, 0);
    }
    rig_close(&r);
}

static void a_shared_table_lives_until_its_last_user(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    const uint32_t a = rig_add(&r, 1.55f, 0.17f), b = rig_add(&r, 1.55f, 0.17f);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    assert_int_equal(tsu_set_remove(r.set, a), TSU_OK);
    assert_int_equal(rig_describe(&r).table_count, 1);
    uint16_t *got = rig_texels(&r, rig_region_of(&r, b)), *truth = rig_alone(1.55f, 0.17f);
    assert_memory_equal(got, truth, RIG_TABLE_BYTES);
    free(got);
    free(truth);
    assert_int_equal(rig_add(&r, 1.55f, 0.17f), a); // the index is given out again
    assert_int_equal(rig_describe(&r).stale_count, 0);
    rig_close(&r);
}

// set.h: until a bake the texels of stale tables are zero, wherever they come to lie.
static void stale_texels_are_zero(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    const uint32_t a = rig_add(&r, 1.55f, 0.17f);
    uint16_t *zeros = calloc(1, RIG_TABLE_BYTES), *got = rig_texels(&r, rig_region_of(&r, a));
    assert_memory_equal(got, zeros, RIG_TABLE_BYTES);
    free(got);
    assert_int_equal(tsu_set_bake(r.set), TSU_OK);
    assert_int_equal(tsu_set_remove(r.set, a), TSU_OK);
    const uint32_t b = rig_add(&r, 1.4f, 0.3f);
    got = rig_texels(&r, rig_region_of(&r, b));
    const int equal = memcmp(got, zeros, RIG_TABLE_BYTES) == 0;
    free(got);
    free(zeros);
    rig_close(&r);
    assert_true(equal);
}

static void one_hair_material_takes_at_most_256_kib(void **state)
{
    (void)state;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        tsu_model_info model;
        tsu_model_info_init(&model);
        assert_int_equal(tsu_model_describe(tsu_model_at(m), &model), TSU_OK);
        uint32_t bytes = 0;
        for (uint32_t i = 0; i < model.table_count; i++) {
            tsu_table_info table;
            tsu_table_info_init(&table);
            assert_int_equal(tsu_model_table(tsu_model_at(m), i, &table), TSU_OK);
            assert_int_equal(table.bytes, table.width * table.height * 8);
            bytes += table.bytes;
        }
        assert_true(bytes <= 256 * 1024);
    }
    rig_open(&r, 0, NULL);
    rig_add(&r, 1.55f, 0.17f);
    const tsu_set_info info = rig_describe(&r);
    assert_true(info.width * info.height * 8 <= 256 * 1024);
    rig_close(&r);
}

int set_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_tables_are_stored_once),
        cmocka_unit_test(colour_shift_and_roughness_bake_nothing),
        cmocka_unit_test(a_new_azimuth_makes_one_table_stale),
        cmocka_unit_test(equal_parameters_change_nothing),
        cmocka_unit_test(removal_gives_places_back),
        cmocka_unit_test(a_shared_table_lives_until_its_last_user),
        cmocka_unit_test(stale_texels_are_zero),
        cmocka_unit_test(one_hair_material_takes_at_most_256_kib),
    };
    return cmocka_run_group_tests_name("set", tests, NULL, NULL);
}

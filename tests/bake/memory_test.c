// Memory that fails at every place in turn, and a set that is as it was.
#include "rig.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct rig r;

// What a host can see of a set.
struct view {
    tsu_set_info info;
    uint64_t texels, pages, regions;
};

static uint64_t mix(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *b = bytes;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ b[i]) * 1099511628211u;
    return hash;
}

static struct view look(void)
{
    struct view view;
    memset(&view, 0, sizeof view);
    view.info = rig_describe(&r);
    view.texels = mix(1, tsu_set_texels(r.set), (size_t)view.info.width * view.info.height * 8);
    for (uint32_t i = 0; i < view.info.page_count; i++)
        view.pages = mix(view.pages, tsu_set_page(r.set, i, NULL), TSU_PAGE_BYTES);
    tsu_region region;
    for (uint32_t i = 0; tsu_set_region(r.set, i, &region); i++)
        if (region.width)
            view.regions = mix(view.regions, &region, sizeof region);
    return view;
}

// Repeats a step, the n-th request for memory failing, until it succeeds. A failed step says
// TSU_E_MEMORY, logs, and leaves everything that can be seen as it was.
static long fail_everywhere(tsu_status (*step)(void))
{
    const struct view before = look();
    for (long n = 1;; n++) {
        watch_quiet(&r.watch);
        r.watch.fail_at = r.watch.calls + n;
        const tsu_status status = step();
        const int failed = r.watch.calls >= r.watch.fail_at;
        r.watch.fail_at = 0;
        assert_int_equal(r.watch.wrong_sizes, 0);
        if (!failed) {
            assert_int_equal(status, TSU_OK);
            return n - 1;
        }
        assert_int_equal(status, TSU_E_MEMORY);
        assert_true(r.watch.log_count > 0);
        const struct view after = look();
        if (memcmp(&after, &before, sizeof after) != 0)
            fail_msg("request %ld failed and the set changed: materials %u was %u, pages %u was "
                     "%u, tables %u was %u, stale %u was %u, generation %u was %u", n,
                     after.info.material_count, before.info.material_count, after.info.page_count,
                     before.info.page_count, after.info.table_count, before.info.table_count,
                     after.info.stale_count, before.info.stale_count,
                     (unsigned)after.info.generation, (unsigned)before.info.generation);
    }
}

static uint32_t added;
static float next_eta;

static tsu_status step_add(void)
{
    const tsu_marschner_params hair = rig_hair(next_eta, 0.4f);
    return tsu_set_add(r.set, tsu_marschner(), &hair, &added);
}

static tsu_status step_update(void)
{
    const tsu_marschner_params hair = rig_hair(next_eta, 0.4f);
    return tsu_set_update(r.set, 0, &hair, NULL);
}

static tsu_status step_bake(void)
{
    return tsu_set_bake(r.set);
}

static void the_first_material(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    next_eta = 1.3f;
    assert_true(fail_everywhere(step_add) >= 3);
    rig_close(&r);
}

static void growing_and_baking(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    next_eta = 1.3f;
    assert_int_equal(step_add(), TSU_OK);
    assert_true(fail_everywhere(step_bake) >= 1);
    for (uint32_t i = 1; i < 10; i++) { // past 8 tables, 4 cells twice
        next_eta = 1.3f + 0.05f * (float)i;
        fail_everywhere(step_add);
        assert_int_equal(added, i);
    }
    next_eta = 1.9f;
    assert_int_equal(step_update(), TSU_OK);
    assert_true(fail_everywhere(step_bake) >= 10 - 1);
    rig_close(&r);
}

static void an_update_that_grows_the_texture(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    next_eta = 1.3f;
    assert_int_equal(step_add(), TSU_OK);
    assert_int_equal(step_bake(), TSU_OK);
    next_eta = 1.4f;
    assert_true(fail_everywhere(step_update) >= 1);
    assert_int_equal(step_bake(), TSU_OK);
    uint16_t *got = rig_texels(&r, rig_region_of(&r, 0)), *truth = rig_alone(1.4f, 0.4f);
    assert_memory_equal(got, truth, RIG_TABLE_BYTES);
    free(got);
    free(truth);
    rig_close(&r);
}

static void the_second_page(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    next_eta = 1.3f;
    for (int i = 0; i < TSU_PAGE_MATERIALS; i++)
        assert_int_equal(step_add(), TSU_OK);
    assert_true(fail_everywhere(step_add) >= 1);
    assert_int_equal(added, TSU_PAGE_MATERIALS);
    rig_close(&r);
}

static void making_contexts_and_sets(void **state)
{
    (void)state;
    struct watch w;
    for (long n = 1; n < 3; n++) {
        watch_begin(&w);
        const tsu_context_desc desc = watch_desc(&w);
        w.fail_at = n;
        tsu_context *context = (tsu_context *)&w;
        const tsu_status made = tsu_context_create(&desc, &context);
        if (n == 1) {
            assert_int_equal(made, TSU_E_MEMORY);
            assert_null(context);
            watch_close(&w);
            continue;
        }
        assert_int_equal(made, TSU_OK);
        tsu_set_desc set_desc;
        tsu_set_desc_init(&set_desc);
        tsu_set *set = (tsu_set *)&w;
        assert_int_equal(tsu_set_create(context, &set_desc, &set), TSU_E_MEMORY);
        assert_null(set);
        tsu_context_destroy(context);
        watch_close(&w);
    }
}

// A set that fails to take a material for its parameters has no more pages or changes than before.
static void bad_parameters_leave_an_empty_set_empty(void **state)
{
    (void)state;
    rig_open(&r, 0, NULL);
    const struct view before = look();
    tsu_marschner_params hair = rig_hair(0.5f, 0.2f);
    uint32_t m = 7;
    assert_int_equal(tsu_set_add(r.set, tsu_marschner(), &hair, &m), TSU_E_PARAMETER);
    assert_int_equal(m, 0);
    const struct view after = look();
    rig_close(&r);
    assert_int_equal(after.info.page_count, before.info.page_count);
    assert_int_equal(after.info.generation, before.info.generation);
    assert_memory_equal(&after, &before, sizeof after);
}

int memory_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_material),
        cmocka_unit_test(growing_and_baking),
        cmocka_unit_test(an_update_that_grows_the_texture),
        cmocka_unit_test(the_second_page),
        cmocka_unit_test(making_contexts_and_sets),
        cmocka_unit_test(bad_parameters_leave_an_empty_set_empty),
    };
    return cmocka_run_group_tests_name("memory", tests, NULL, NULL);
}

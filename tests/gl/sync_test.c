// Uploading: what arrives and how little is sent.
#include "rig.h"
#include "tests.h"

#include <string.h>

// Shapes: cells and odd sizes, pages together and apart, no texture, no page.
static void everything_arrives(void **state)
{
    (void)state;
    static const uint32_t shapes[][4] = {
        {128, 128, 1, 4096}, {256, 128, 3, 4096}, {384, 256, 4, 4100},  {1, 1, 1, 4096},
        {13, 7, 2, 5000},    {0, 0, 2, 4096},     {2048, 256, 40, 4096}};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        const uint32_t *const s = shapes[i];
        tsu_set *const set = fake_set_create(s[0], s[1], s[2], s[3], (uint32_t)i);
        tsu_gl *const gl = rig_gl();
        rig_sync(gl, set);
        assert_int_equal(counted.texels, s[0] ? (uint64_t)s[0] * s[1] : 1);
        assert_int_equal(counted.bytes, (uint64_t)s[2] * TSU_PAGE_BYTES);
        rig_check(gl, set);
        rig_check_unchanged(gl, set);
        tsu_gl_destroy(gl);
        fake_set_destroy(set);
    }
}

// The same through the entry points of every older version.
static void every_version(void **state)
{
    (void)state;
    static const int versions[][2] = {{0, 33}, {0, 40}, {0, 41}, {0, 42}, {0, 43}, {0, 44},
                                      {0, 45}, {0, 46}, {1, 30}, {1, 31}, {1, 32}};
    unsigned seen = 0;
    for (size_t i = 0; i < sizeof versions / sizeof *versions; i++) {
        rig_reset(NULL);
        if (!rig_pretend(versions[i][0], versions[i][1]))
            continue;
        seen++;
        tsu_set *const set = fake_set_create(256, 256, 4, 4096, 11);
        tsu_gl *const gl = rig_gl();
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        rig_check(gl, set);
        fake_set_touch_region(set, 2, 12);
        fake_set_touch_page(set, 3, 12);
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        rig_check(gl, set);
        fake_set_grow(set, 512, 384, 13);
        fake_set_grow_pages(set, 9, 13);
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        rig_check(gl, set);
        const int immutable = versions[i][0] || versions[i][1] >= 42;
        const int direct = !versions[i][0] && versions[i][1] >= 45;
        assert_int_equal(counted_calls("glTexImage2D"), immutable ? 0 : 2);
        assert_int_equal(counted_calls("glTexStorage2D"), immutable && !direct ? 2 : 0);
        assert_int_equal(counted_calls("glTextureStorage2D"), direct ? 2 : 0);
        tsu_gl_destroy(gl);
        fake_set_destroy(set);
    }
    assert_true(seen > 0);
}

// Only what changed is sent.
static void little_is_sent(void **state)
{
    (void)state;
    tsu_set *const set = fake_set_create(512, 256, 6, 4096, 1);
    tsu_gl *const gl = rig_gl();
    rig_sync(gl, set);
    assert_int_equal(counted.uploads, 2); // the texture, and all pages at once

    fake_set_touch_region(set, 5, 2);
    rig_sync(gl, set);
    assert_int_equal(counted.uploads, 1);
    assert_int_equal(counted.texels, TSU_CELL * TSU_CELL);
    rig_check(gl, set);

    fake_set_touch_page(set, 4, 3);
    rig_sync(gl, set);
    assert_int_equal(counted_calls("glPixelStorei"), 0); // the texture is not looked at
    assert_int_equal(counted.uploads, 1);
    assert_int_equal(counted.bytes, TSU_PAGE_BYTES);
    rig_check(gl, set);

    // Several generations in one upload; neighbouring pages go together.
    fake_set_touch_region(set, 0, 4);
    fake_set_touch_region(set, 7, 5);
    fake_set_touch_page(set, 0, 6);
    fake_set_touch_page(set, 2, 7);
    fake_set_touch_page(set, 3, 8);
    rig_sync(gl, set);
    assert_int_equal(counted.uploads, 2 + 2);
    assert_int_equal(counted.texels, 2 * TSU_CELL * TSU_CELL);
    assert_int_equal(counted.bytes, 3 * TSU_PAGE_BYTES);
    rig_check(gl, set);
    rig_check_unchanged(gl, set);
    tsu_gl_destroy(gl);
    fake_set_destroy(set);
}

static void growth(void **state)
{
    (void)state;
    tsu_set *const set = fake_set_create(0, 0, 0, 4200, 1);
    tsu_gl *const gl = rig_gl();
    tsu_gl_bindings_info first = {.struct_size = sizeof first}, now = first;
    rig_sync(gl, set); // nothing yet
    assert_int_equal(counted.calls, 0);
    assert_int_equal(tsu_gl_bind(gl, 0, 0, 0), TSU_E_PARAMETER);
    fake_set_grow_pages(set, 1, 2);
    rig_sync(gl, set);
    rig_check(gl, set);
    assert_int_equal(tsu_gl_bindings(gl, 0, &first), TSU_OK);
    assert_int_not_equal(first.texture, 0);
    unsigned stores = 0;
    for (uint32_t i = 0; i < 6; i++) {
        fake_set_grow(set, 128 * (i + 1), 128 * (i / 2 + 1), 10 + i);
        fake_set_grow_pages(set, 2 * set->page_count + i % 2, 20 + i);
        rig_sync(gl, set);
        stores += counted_calls("glBufferData") + counted_calls("glNamedBufferData");
        assert_int_equal(counted_calls("glDeleteTextures"), 1);
        assert_int_equal(counted.texels, (uint64_t)set->width * set->height);
        rig_check(gl, set);
        rig_check_unchanged(gl, set);
        assert_int_equal(tsu_gl_bindings(gl, 0, &now), TSU_OK);
        assert_int_equal(now.buffer, first.buffer); // its name stays
    }
    assert_true(stores <= 6);
    // One page more after a doubling needs no new store.
    fake_set_grow_pages(set, set->page_count + 1, 30);
    rig_sync(gl, set);
    stores = counted_calls("glBufferData") + counted_calls("glNamedBufferData");
    fake_set_grow_pages(set, set->page_count + 1, 31);
    rig_sync(gl, set);
    stores += counted_calls("glBufferData") + counted_calls("glNamedBufferData");
    assert_int_equal(stores, 1);
    assert_int_equal(counted.bytes, TSU_PAGE_BYTES);
    rig_check(gl, set);
    tsu_gl_destroy(gl);
    fake_set_destroy(set);
}

// 10000 materials are 79 pages; 2000 pages are 254000 materials.
static void many_pages(void **state)
{
    (void)state;
    static const uint32_t counts[] = {(10000 + TSU_PAGE_MATERIALS - 1) / TSU_PAGE_MATERIALS, 2000};
    for (int i = 0; i < 2; i++) {
        tsu_set *const set = fake_set_create(1024, 512, counts[i], 4096, 9);
        tsu_gl *const gl = rig_gl();
        rig_sync(gl, set);
        assert_int_equal(counted.uploads, 2);
        rig_check(gl, set);
        for (int frame = 0; frame < 100; frame++)
            rig_check_unchanged(gl, set);
        fake_set_touch_page(set, counts[i] - 1, 10);
        rig_sync(gl, set);
        assert_int_equal(counted.bytes, TSU_PAGE_BYTES);
        assert_int_equal(counted.texels, 0);
        rig_check(gl, set);
        tsu_gl_destroy(gl);
        fake_set_destroy(set);
    }
}

int sync_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(everything_arrives, rig_reset),
        cmocka_unit_test_setup(every_version, rig_reset),
        cmocka_unit_test_setup(little_is_sent, rig_reset),
        cmocka_unit_test_setup(growth, rig_reset),
        cmocka_unit_test_setup(many_pages, rig_reset),
    };
    return cmocka_run_group_tests_name("sync", tests, NULL, NULL);
}

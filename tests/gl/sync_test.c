// Uploading: what arrives, how little is sent, and what a failure leaves.
#include "rig.h"
#include "tests.h"

#include <string.h>

static void sync(tsu_gl *gl, const tsu_set *set)
{
    counted_reset();
    rig.allocations = 0;
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    assert_int_equal(rig.allocations, 0);
    assert_int_equal(counted.gets, 0);
}

static void check_unchanged(tsu_gl *gl, tsu_set *set)
{
    set->describe_calls = set->read_calls = 0;
    sync(gl, set);
    assert_int_equal(counted.calls, 0);
    assert_int_equal(set->describe_calls, 1);
    assert_int_equal(set->read_calls, 0);
}

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
        sync(gl, set);
        assert_int_equal(counted.texels, s[0] ? (uint64_t)s[0] * s[1] : 1);
        assert_int_equal(counted.bytes, (uint64_t)s[2] * TSU_PAGE_BYTES);
        rig_check(gl, set);
        check_unchanged(gl, set);
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
    sync(gl, set);
    assert_int_equal(counted.uploads, 2); // the texture, and all pages at once

    fake_set_touch_region(set, 5, 2);
    sync(gl, set);
    assert_int_equal(counted.uploads, 1);
    assert_int_equal(counted.texels, TSU_CELL * TSU_CELL);
    rig_check(gl, set);

    fake_set_touch_page(set, 4, 3);
    sync(gl, set);
    assert_int_equal(counted.uploads, 1);
    assert_int_equal(counted.bytes, TSU_PAGE_BYTES);
    rig_check(gl, set);

    // Several generations in one upload; neighbouring pages go together.
    fake_set_touch_region(set, 0, 4);
    fake_set_touch_region(set, 7, 5);
    fake_set_touch_page(set, 0, 6);
    fake_set_touch_page(set, 2, 7);
    fake_set_touch_page(set, 3, 8);
    sync(gl, set);
    assert_int_equal(counted.uploads, 2 + 2);
    assert_int_equal(counted.texels, 2 * TSU_CELL * TSU_CELL);
    assert_int_equal(counted.bytes, 3 * TSU_PAGE_BYTES);
    rig_check(gl, set);
    check_unchanged(gl, set);
    tsu_gl_destroy(gl);
    fake_set_destroy(set);
}

static void growth(void **state)
{
    (void)state;
    tsu_set *const set = fake_set_create(0, 0, 0, 4200, 1);
    tsu_gl *const gl = rig_gl();
    tsu_gl_bindings_info first = {.struct_size = sizeof first}, now = first;
    sync(gl, set); // nothing yet
    assert_int_equal(counted.calls, 0);
    assert_int_equal(tsu_gl_bind(gl, 0, 0, 0), TSU_E_PARAMETER);
    fake_set_grow_pages(set, 1, 2);
    sync(gl, set);
    rig_check(gl, set);
    assert_int_equal(tsu_gl_bindings(gl, 0, &first), TSU_OK);
    assert_int_not_equal(first.texture, 0);
    unsigned stores = 0;
    for (uint32_t i = 0; i < 6; i++) {
        fake_set_grow(set, 128 * (i + 1), 128 * (i / 2 + 1), 10 + i);
        fake_set_grow_pages(set, 2 * set->page_count + i % 2, 20 + i);
        sync(gl, set);
        stores += counted_calls("glBufferData") + counted_calls("glNamedBufferData");
        assert_int_equal(counted_calls("glDeleteTextures"), 1);
        assert_int_equal(counted.texels, (uint64_t)set->width * set->height);
        rig_check(gl, set);
        check_unchanged(gl, set);
        assert_int_equal(tsu_gl_bindings(gl, 0, &now), TSU_OK);
        assert_int_equal(now.buffer, first.buffer); // its name stays
    }
    assert_true(stores <= 6);
    // One page more after a doubling needs no new store.
    fake_set_grow_pages(set, set->page_count + 1, 30);
    sync(gl, set);
    stores = counted_calls("glBufferData") + counted_calls("glNamedBufferData");
    fake_set_grow_pages(set, set->page_count + 1, 31);
    sync(gl, set);
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
        sync(gl, set);
        assert_int_equal(counted.uploads, 2);
        rig_check(gl, set);
        for (int frame = 0; frame < 100; frame++)
            check_unchanged(gl, set);
        fake_set_touch_page(set, counts[i] - 1, 10);
        sync(gl, set);
        assert_int_equal(counted.bytes, TSU_PAGE_BYTES);
        assert_int_equal(counted.texels, 0);
        rig_check(gl, set);
        tsu_gl_destroy(gl);
        fake_set_destroy(set);
    }
}

static void another_set(void **state)
{
    (void)state;
    tsu_set *const a = fake_set_create(256, 256, 3, 4096, 1);
    tsu_set *const b = fake_set_create(256, 256, 3, 4096, 2);
    tsu_set *const c = fake_set_create(128, 128, 2, 4096, 3);
    tsu_gl *const gl = rig_gl();
    const tsu_set *const order[] = {a, b, a, c, b};
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        sync(gl, order[i]);
        assert_int_equal(counted.texels, (uint64_t)order[i]->width * order[i]->height);
        assert_int_equal(counted.bytes, (uint64_t)order[i]->page_count * TSU_PAGE_BYTES);
        rig_check(gl, order[i]);
    }
    assert_int_equal(tsu_gl_bind(gl, 2, 0, 0), TSU_OK);
    sync(gl, c);
    assert_int_equal(tsu_gl_bind(gl, 2, 0, 0), TSU_E_PARAMETER);
    // A set whose generation went back is a new one at an old address.
    fake_set_touch_page(c, 1, 4);
    fake_set_touch_page(c, 0, 5);
    sync(gl, c);
    fake_set_touch_page(c, 0, 6);
    fake_set_touch_region(c, 0, 6);
    c->generation = c->texture_generation = c->regions[0].generation = 1;
    c->page_generations[0] = c->page_generations[1] = 1;
    sync(gl, c);
    rig_check(gl, c);
    tsu_gl_destroy(gl);
    fake_set_destroy(a);
    fake_set_destroy(b);
    fake_set_destroy(c);
}

// Each failure changes nothing: the old content stays bound and right, and the next sync works.
static void failures(void **state)
{
    (void)state;
    tsu_set *const set = fake_set_create(256, 128, 2, 4096, 1);
    tsu_set *const large = fake_set_create(384, 128, 5, 4096, 2);
    counted.max_texture_size = 256;
    tsu_gl *const gl = rig_gl();
    tsu_gl_bindings_info was = {.struct_size = sizeof was}, is = was;
    assert_int_equal(tsu_gl_sync(NULL, set), TSU_E_PARAMETER);
    assert_int_equal(tsu_gl_sync(gl, NULL), TSU_E_PARAMETER);
    set->stale_count = 3;
    assert_int_equal(tsu_gl_sync(gl, set), TSU_E_STATE);
    assert_int_equal(tsu_gl_bindings(gl, 0, &was), TSU_E_STATE);
    set->stale_count = 0;
    counted.no_buffers = 1;
    assert_int_equal(tsu_gl_sync(gl, set), TSU_E_MEMORY);
    counted.no_buffers = 0;
    counted.no_textures = 1;
    assert_int_equal(tsu_gl_sync(gl, set), TSU_E_MEMORY);
    assert_int_equal(tsu_gl_bindings(gl, 0, &was), TSU_E_STATE);
    counted.no_textures = 0;
    sync(gl, set);
    rig_check(gl, set);
    assert_int_equal(tsu_gl_bindings(gl, 1, &was), TSU_OK);

    counted_reset();
    large->stale_count = 3;
    assert_int_equal(tsu_gl_sync(gl, large), TSU_E_STATE);
    assert_string_equal(rig.last,
                        "[E0022] tsu_gl_sync: 3 tables are stale; call tsu_set_bake() first");
    large->stale_count = 0;
    assert_int_equal(tsu_gl_sync(gl, large), TSU_E_LIMIT);
    assert_non_null(strstr(rig.last, "384 x 128"));
    assert_non_null(strstr(rig.last, "GL_MAX_TEXTURE_SIZE = 256"));
    assert_int_equal(counted.calls, 0);
    fake_set_grow(large, 128, 384, 4);
    assert_int_equal(tsu_gl_sync(gl, large), TSU_E_LIMIT);
    assert_int_equal(counted.calls, 0);
    fake_set_grow(large, 128, 256, 5);
    counted.no_textures = 1;
    assert_int_equal(tsu_gl_sync(gl, large), TSU_E_MEMORY);
    assert_int_equal(counted.uploads, 0);
    counted.no_textures = 0;

    assert_int_equal(tsu_gl_bindings(gl, 1, &is), TSU_OK);
    assert_memory_equal(&is, &was, sizeof is);
    rig_check(gl, set);
    check_unchanged(gl, set);
    sync(gl, large);
    rig_check(gl, large);
    tsu_gl_destroy(gl);
    assert_int_equal(rig.live, 0);
    fake_set_destroy(set);
    fake_set_destroy(large);
}

// The host left our own texture and buffer bound while the texture grows into a new one.
static void growth_while_bound(void **state)
{
    (void)state;
    const struct gl_api *const api = &rig.fixture.gl;
    tsu_set *const set = fake_set_create(128, 128, 1, 4096, 1);
    tsu_gl *const gl = rig_gl();
    sync(gl, set);
    api->ActiveTexture(GL_TEXTURE0 + 2);
    assert_int_equal(tsu_gl_bind(gl, 0, 2, 1), TSU_OK);
    fake_set_grow(set, 256, 128, 2);
    fake_set_grow_pages(set, 4, 2);
    sync(gl, set);
    rig_check_error();
    GLint bound = -1;
    api->GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    assert_int_equal(bound, 0); // deleting it unbound it
    rig_check(gl, set);
    tsu_gl_destroy(gl);
    rig_check_error();
    fake_set_destroy(set);
}

int sync_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(everything_arrives, rig_reset),
        cmocka_unit_test_setup(every_version, rig_reset),
        cmocka_unit_test_setup(little_is_sent, rig_reset),
        cmocka_unit_test_setup(growth, rig_reset),
        cmocka_unit_test_setup(many_pages, rig_reset),
        cmocka_unit_test_setup(another_set, rig_reset),
        cmocka_unit_test_setup(failures, rig_reset),
        cmocka_unit_test_setup(growth_while_bound, rig_reset),
    };
    return cmocka_run_group_tests_name("sync", tests, NULL, NULL);
}

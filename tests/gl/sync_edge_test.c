// Uploading in odd circumstances: sets that change places, failures, our own names bound.
#include "rig.h"
#include "tests.h"

#include <string.h>

static void another_set(void **state)
{
    (void)state;
    tsu_set *const a = fake_set_create(256, 256, 3, 4096, 1);
    tsu_set *const b = fake_set_create(256, 256, 3, 4096, 2);
    tsu_set *const c = fake_set_create(128, 128, 2, 4096, 3);
    tsu_gl *const gl = rig_gl();
    const tsu_set *const order[] = {a, b, a, c, b};
    for (size_t i = 0; i < sizeof order / sizeof *order; i++) {
        rig_sync(gl, order[i]);
        assert_int_equal(counted.texels, (uint64_t)order[i]->width * order[i]->height);
        assert_int_equal(counted.bytes, (uint64_t)order[i]->page_count * TSU_PAGE_BYTES);
        rig_check(gl, order[i]);
    }
    assert_int_equal(tsu_gl_bind(gl, 2, 0, 0), TSU_OK);
    rig_sync(gl, c);
    assert_int_equal(tsu_gl_bind(gl, 2, 0, 0), TSU_E_PARAMETER);
    // A new set at an old set's address, with a generation of its own.
    fake_set_touch_page(c, 1, 4);
    fake_set_touch_page(c, 0, 5);
    rig_sync(gl, c);
    fake_set_touch_page(c, 0, 6);
    fake_set_touch_region(c, 0, 6);
    c->id = 1;
    c->generation = c->texture_generation = c->regions[0].generation = 1;
    c->page_generations[0] = c->page_generations[1] = 1;
    rig_sync(gl, c);
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
    rig_sync(gl, set);
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
    rig_check_unchanged(gl, set);
    rig_sync(gl, large);
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
    rig_sync(gl, set);
    api->ActiveTexture(GL_TEXTURE0 + 2);
    assert_int_equal(tsu_gl_bind(gl, 0, 2, 1), TSU_OK);
    fake_set_grow(set, 256, 128, 2);
    fake_set_grow_pages(set, 4, 2);
    rig_sync(gl, set);
    rig_check_error();
    GLint bound = -1;
    api->GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    assert_int_equal(bound, 0); // deleting it unbound it
    rig_check(gl, set);
    tsu_gl_destroy(gl);
    rig_check_error();
    fake_set_destroy(set);
}

int sync_edge_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(another_set, rig_reset),
        cmocka_unit_test_setup(failures, rig_reset),
        cmocka_unit_test_setup(growth_while_bound, rig_reset),
    };
    return cmocka_run_group_tests_name("sync edge", tests, NULL, NULL);
}

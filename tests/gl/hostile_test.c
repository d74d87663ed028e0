// The state contract: the ugliest legal state before each call, the same state after it, and the
// right data in GL all the same.
#include "rig.h"
#include "tests.h"

static void sync_amid(tsu_gl *gl, const tsu_set *set, const char *call)
{
    rig_hostile_begin();
    const tsu_status status = tsu_gl_sync(gl, set);
    rig_hostile_end(call, -1, -1, 0);
    assert_int_equal(status, TSU_OK);
    rig_check(gl, set);
}

static void bind_amid(tsu_gl *gl, int version, uint32_t unit, uint32_t binding)
{
    rig_hostile_begin();
    const tsu_status status = tsu_gl_bind(gl, 1, unit, binding);
    rig_hostile_end("bind", (int)unit, (int)binding, version < 44 || rig.fixture.gl.es);
    assert_int_equal(status, TSU_OK);
}

static void setup_amid(tsu_gl *gl, GLuint program, tsu_status wanted)
{
    rig_hostile_begin();
    const tsu_status status = tsu_gl_program_setup(gl, program, 2, 1);
    rig_hostile_end("program_setup", -1, -1, 0);
    assert_int_equal(status, wanted);
}

static void life(int version)
{
    tsu_gl *gl = NULL;
    tsu_gl_bindings_info info = {.struct_size = sizeof info};
    tsu_set *const set = fake_set_create(256, 128, 3, 4096, 1);
    tsu_set *const other = fake_set_create(130, 3, 2, 4099, 2);
    const GLuint program =
        rig_program("uniform sampler2D tsu_tables; out vec4 o;\n"
                    "layout(std140) uniform tsu_materials { vec4 tsu_page[1024]; };\n"
                    "void main() { o = texture(tsu_tables, vec2(0.5)) + tsu_page[7]; }\n");

    rig_hostile_begin();
    const tsu_status created = rig_create(0, &gl);
    rig_hostile_end("create", -1, -1, 0);
    assert_int_equal(created, TSU_OK);
    setup_amid(gl, program, TSU_OK);
    setup_amid(gl, 123456, TSU_E_PARAMETER);
    sync_amid(gl, set, "first sync");
    bind_amid(gl, version, 3, 5);
    bind_amid(gl, version, 7, 0);
    sync_amid(gl, set, "sync of nothing");
    fake_set_touch_region(set, 1, 3);
    sync_amid(gl, set, "sync of a region");
    fake_set_touch_page(set, 2, 4);
    sync_amid(gl, set, "sync of a page");
    fake_set_grow(set, 384, 256, 5);
    sync_amid(gl, set, "sync of a larger texture");
    fake_set_grow_pages(set, 8, 6);
    sync_amid(gl, set, "sync of more pages");
    sync_amid(gl, other, "sync of another set");
    other->stale_count = 1;
    rig_hostile_begin();
    tsu_status status = tsu_gl_sync(gl, other);
    rig_hostile_end("failing sync", -1, -1, 0);
    assert_int_equal(status, TSU_E_STATE);
    rig_hostile_begin();
    status = tsu_gl_bindings(gl, 0, &info);
    rig_hostile_end("bindings", -1, -1, 0);
    assert_int_equal(status, TSU_OK);
    rig_hostile_begin();
    tsu_gl_destroy(gl);
    rig_hostile_end("destroy", -1, -1, 0);
    assert_int_equal(rig.live, 0);
    rig.fixture.gl.DeleteProgram(program);
    fake_set_destroy(set);
    fake_set_destroy(other);
}

static void hostile_host(void **state)
{
    (void)state;
    static const int versions[][2] = {{0, 33}, {0, 41}, {0, 42}, {0, 44},
                                      {0, 45}, {1, 30}, {1, 31}, {1, 32}};
    unsigned seen = 0;
    for (size_t i = 0; i < sizeof versions / sizeof *versions; i++) {
        rig_reset(NULL);
        if (rig_pretend(versions[i][0], versions[i][1])) {
            life(versions[i][1]);
            seen++;
        }
    }
    assert_true(seen > 0);
}

int hostile_tests(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_setup(hostile_host, rig_reset)};
    return cmocka_run_group_tests_name("hostile", tests, NULL, NULL);
}

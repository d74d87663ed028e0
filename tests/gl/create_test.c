// Making a tsu_gl: descriptors, missing entry points, old contexts, no memory, TSU_GL_CHECK.
#include "rig.h"
#include "tests.h"

#include <stdio.h>
#include <string.h>

// A failed create leaves nothing behind and a following one works.
static void check_failed(tsu_status status, tsu_status wanted, tsu_gl *const *gl)
{
    assert_int_equal(status, wanted);
    assert_null(*gl);
    assert_int_equal(rig.live, 0);
    rig_check_error();
    rig_reset(NULL);
    tsu_gl_destroy(rig_gl());
    assert_int_equal(rig.live, 0);
}

static void descriptors(void **state)
{
    (void)state;
    struct {
        tsu_gl_desc desc;
        uint64_t more;
    } large;
    tsu_gl_desc desc;
    tsu_gl *gl = (tsu_gl *)&desc;
    assert_int_equal(tsu_gl_desc_init_sized(NULL, sizeof desc), TSU_E_STRUCT);
    assert_int_equal(tsu_gl_desc_init_sized(&desc, sizeof desc - 1), TSU_E_STRUCT);
    memset(&desc, 0xFF, sizeof desc);
    assert_int_equal(tsu_gl_desc_init(&desc), TSU_OK);
    assert_int_equal(desc.struct_size, sizeof desc);
    assert_int_equal(desc.flags, 0);

    check_failed(tsu_gl_create(rig.context, &desc, &gl), TSU_E_PARAMETER, &gl); // no loader
    desc.get_proc_address = counted_proc;
    desc.flags = 2;
    check_failed(tsu_gl_create(rig.context, &desc, &gl), TSU_E_PARAMETER, &gl);
    desc.flags = 0;
    desc.struct_size = 0;
    check_failed(tsu_gl_create(rig.context, &desc, &gl), TSU_E_STRUCT, &gl);
    check_failed(tsu_gl_create(rig.context, NULL, &gl), TSU_E_STRUCT, &gl);
    tsu_gl_desc_init(&desc);
    desc.get_proc_address = counted_proc;
    assert_int_equal(tsu_gl_create(rig.context, &desc, NULL), TSU_E_PARAMETER);
    gl = (tsu_gl *)&desc;
    assert_int_equal(tsu_gl_create(NULL, &desc, &gl), TSU_E_PARAMETER);
    assert_null(gl);

    assert_int_equal(tsu_gl_desc_init_sized(&large.desc, sizeof large), TSU_OK);
    large.desc.get_proc_address = counted_proc;
    assert_int_equal(tsu_gl_create(rig.context, &large.desc, &gl), TSU_OK);
    tsu_gl_destroy(gl);
    large.more = 1;
    check_failed(tsu_gl_create(rig.context, &large.desc, &gl), TSU_E_STRUCT, &gl);
    tsu_gl_destroy(NULL);
    tsu_gl_abandon(NULL);
}

static void failures_are_named(void **state)
{
    (void)state;
    tsu_gl_desc desc;
    tsu_gl *gl;
    tsu_gl_desc_init(&desc);
    tsu_gl_create(rig.context, &desc, &gl);
    assert_string_equal(rig.last, "[E0005] tsu_gl_desc.get_proc_address is NULL");
    desc.get_proc_address = counted_proc;
    desc.flags = 6;
    tsu_gl_create(rig.context, &desc, &gl);
    assert_string_equal(rig.last, "[E0004] tsu_gl_desc.flags = 6, expected TSU_GL_* bits");
    desc.struct_size = 0;
    tsu_gl_create(rig.context, &desc, &gl);
    assert_non_null(strstr(rig.last, "tsu_gl_desc_init()"));
}

// All names in one line that is not cut: the last required name is there with its end.
static void loader_knows_nothing(void **state)
{
    (void)state;
    tsu_gl *gl = NULL;
    const char *name;
    int required;
    counted.nothing = 1;
    assert_int_equal(rig_create(0, &gl), TSU_E_UNSUPPORTED);
    assert_null(gl);
    assert_int_equal(rig.lines, 1);
    for (size_t i = 0; (name = counted_name(i, &required)) != NULL; i++)
        if ((strstr(rig.last, name) != NULL) < required)
            fail_msg("%s is not in \"%s\"", name, rig.last);
    assert_int_equal(counted.calls, 0);
    check_failed(TSU_E_UNSUPPORTED, TSU_E_UNSUPPORTED, &gl);
}

static void one_entry_point_is_missing(void **state)
{
    (void)state;
    const char *name;
    int required;
    unsigned seen = 0;
    for (size_t i = 0; (name = counted_name(i, &required)) != NULL; i++) {
        char line[128];
        tsu_gl *gl = NULL;
        if (!required)
            continue;
        seen++;
        rig_reset(NULL);
        counted.hide = name;
        const tsu_status status = rig_create(0, &gl);
        snprintf(line, sizeof line, "[E0040] missing from GL: %s", name);
        assert_int_equal(status, TSU_E_UNSUPPORTED);
        assert_int_equal(rig.lines, 1);
        assert_string_equal(rig.last, line);
        check_failed(status, TSU_E_UNSUPPORTED, &gl);
    }
    assert_int_equal(seen, 25);
}

// Without any single one of the others everything works, by another way.
static void one_luxury_is_missing(void **state)
{
    (void)state;
    const char *name;
    int required;
    tsu_set *const set = fake_set_create(256, 128, 3, 4096, 7);
    for (size_t i = 0; (name = counted_name(i, &required)) != NULL; i++) {
        if (required)
            continue;
        rig_reset(NULL);
        counted.hide = name;
        tsu_gl *const gl = rig_gl();
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        rig_check(gl, set);
        assert_int_equal(counted_calls(name), 0);
        tsu_gl_destroy(gl);
        assert_int_equal(rig.live, 0);
    }
    fake_set_destroy(set);
}

static void context_is_old(void **state)
{
    (void)state;
    static const char *const versions[] = {
        "3.2 (Core Profile) Mesa", "3.0", "2.1 Mesa", "1.4",       "OpenGL ES 2.0 Mesa",
        "OpenGL ES-CM 1.1",        "",    "Mesa",     "OpenGL ES", NULL,
    };
    for (size_t i = 0; i < sizeof versions / sizeof *versions; i++) {
        tsu_gl *gl = NULL;
        rig_reset(NULL);
        counted.fake_version = 1;
        counted.version = versions[i];
        const tsu_status status = rig_create(0, &gl);
        assert_int_equal(rig.lines, 1);
        assert_int_equal(rig.code, 41);
        assert_int_equal(counted.calls, 1); // nothing but the version was asked
        if (versions[i])
            assert_non_null(strstr(rig.last, versions[i]));
        check_failed(status, TSU_E_UNSUPPORTED, &gl);
    }
}

static void versions_are_read(void **state)
{
    (void)state;
    static const char *const desktop[] = {"3.3", "3.3.0 NVIDIA 1", "4.6 (Core)", "4.10", "10.0"};
    static const char *const es[] = {"OpenGL ES 3.0", "OpenGL ES 3.2 v1.r32", "OpenGL ES 3.10"};
    const char *const *const all = rig.fixture.gl.es ? es : desktop;
    const size_t count =
        rig.fixture.gl.es ? sizeof es / sizeof *es : sizeof desktop / sizeof *desktop;
    for (size_t i = 0; i < count; i++) {
        rig_reset(NULL);
        counted.fake_version = 1;
        counted.version = all[i];
        tsu_gl_destroy(rig_gl());
        assert_int_equal(rig.lines, 0);
    }
}

static void creating_makes_no_object(void **state)
{
    (void)state;
    tsu_gl *const gl = rig_gl();
    assert_int_equal(counted_calls("glGetString"), 1);
    assert_int_equal(counted_calls("glGetIntegerv"), 3);
    assert_int_equal(counted.calls, 4);
    assert_int_equal(rig.allocations, 1);
    const unsigned resolved = counted.resolved;
    tsu_gl_abandon(gl);
    assert_int_equal(counted.calls, 4);
    assert_int_equal(counted.resolved, resolved);
    assert_int_equal(rig.live, 0);
}

// The n-th allocation fails, for every n until all works.
static void no_memory(void **state)
{
    (void)state;
    tsu_set *const set = fake_set_create(128, 128, 2, 4096, 3);
    for (unsigned n = 1;; n++) {
        tsu_gl *gl = NULL;
        rig_reset(NULL);
        rig.fail_at = n;
        const tsu_status status = rig_create(0, &gl);
        if (status) {
            check_failed(status, TSU_E_MEMORY, &gl);
            continue;
        }
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        fake_set_grow(set, 256, 256, n);
        fake_set_grow_pages(set, 5, n);
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        rig_check(gl, set);
        const unsigned used = rig.allocations;
        tsu_gl_destroy(gl);
        assert_int_equal(rig.live, 0);
        assert_int_equal(used, 1);
        assert_int_equal(n, 2);
        break;
    }
    fake_set_destroy(set);
}

int create_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(descriptors, rig_reset),
        cmocka_unit_test_setup(failures_are_named, rig_reset),
        cmocka_unit_test_setup(loader_knows_nothing, rig_reset),
        cmocka_unit_test_setup(one_entry_point_is_missing, rig_reset),
        cmocka_unit_test_setup(one_luxury_is_missing, rig_reset),
        cmocka_unit_test_setup(context_is_old, rig_reset),
        cmocka_unit_test_setup(versions_are_read, rig_reset),
        cmocka_unit_test_setup(creating_makes_no_object, rig_reset),
        cmocka_unit_test_setup(no_memory, rig_reset),
    };
    return cmocka_run_group_tests_name("create", tests, NULL, NULL);
}

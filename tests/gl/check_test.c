// Errors of GL: left alone, or with TSU_GL_CHECK drained and told apart.
#include "rig.h"
#include "tests.h"

#include <string.h>

static void check_finds_errors(void **state)
{
    (void)state;
    const struct gl_api *const api = &rig.fixture.gl;
    tsu_set *const set = fake_set_create(128, 128, 1, 4096, 1);
    tsu_gl *gl = NULL;
    api->Enable(0xBAD);
    assert_int_equal(rig_create(TSU_GL_CHECK, &gl), TSU_OK);
    assert_string_equal(rig.last, "[E0044] tsu_gl_create: GL errors of the host, pending on entry: "
                                  "1, first GL_INVALID_ENUM");
    assert_int_equal(rig.lines, 1);
    rig_check_error();
    api->Enable(0xBAD);
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    assert_non_null(strstr(rig.last, "tsu_gl_sync: GL errors of the host"));
    assert_int_equal(rig.lines, 2);
    api->Viewport(0, 0, -1, -1);
    assert_int_equal(tsu_gl_bind(gl, 0, 0, 0), TSU_OK);
    assert_non_null(strstr(rig.last, "tsu_gl_bind: GL errors of the host"));
    assert_non_null(strstr(rig.last, "GL_INVALID_VALUE"));
    assert_int_equal(rig.lines, 3);
    rig_check_error();
    rig_check(gl, set);
    assert_int_equal(rig.lines, 3);

    // An error that only our own call can have raised.
    counted.bad_unit = 1;
    assert_int_equal(tsu_gl_bind(gl, 0, 0, 0), TSU_OK);
    counted.bad_unit = 0;
    assert_int_equal(rig.lines, 4);
    assert_string_equal(rig.last, "[E0044] tsu_gl_bind: GL errors of the library: 1, first "
                                  "GL_INVALID_VALUE");
    rig_check_error();

    // A lost context answers with an error for ever: bounded.
    counted_reset();
    counted.stuck = 0x507;
    assert_int_equal(tsu_gl_bind(gl, 0, 0, 0), TSU_OK);
    assert_int_equal(counted.gets, 64);
    assert_int_equal(rig.lines, 6);
    assert_non_null(strstr(rig.last, "32, first GL_CONTEXT_LOST"));
    counted.stuck = 0;
    while (api->GetError() != GL_NO_ERROR)
        continue;
    tsu_gl_destroy(gl);
    fake_set_destroy(set);
}

// Without the flag the host's error stays for the host.
static void no_check_keeps_errors(void **state)
{
    (void)state;
    const struct gl_api *const api = &rig.fixture.gl;
    tsu_set *const set = fake_set_create(128, 128, 1, 4096, 1);
    api->Enable(0xBAD);
    tsu_gl *const gl = rig_gl();
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    assert_int_equal(tsu_gl_bind(gl, 0, 0, 0), TSU_OK);
    tsu_gl_destroy(gl);
    assert_int_equal(counted.gets, 0);
    assert_int_equal(rig.lines, 0);
    assert_int_equal(api->GetError(), GL_INVALID_ENUM);
    fake_set_destroy(set);
}

int check_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(check_finds_errors, rig_reset),
        cmocka_unit_test_setup(no_check_keeps_errors, rig_reset),
    };
    return cmocka_run_group_tests_name("check", tests, NULL, NULL);
}

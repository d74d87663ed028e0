// Binding: what is bound, with how many calls, within which limits; programs.
#include "rig.h"
#include "tests.h"

#include <stdio.h>
#include <string.h>

static int version_of(const struct gl_api *api)
{
    return 10 * api->major + api->minor;
}

static void calls_of_bind(void **state)
{
    (void)state;
    static const int versions[][3] = {{0, 33, 6}, {0, 41, 6}, {0, 44, 6}, {0, 45, 3},
                                      {1, 30, 6}, {1, 31, 6}, {1, 32, 6}};
    tsu_set *const set = fake_set_create(128, 128, 3, 4096, 1);
    for (size_t i = 0; i < sizeof versions / sizeof *versions; i++) {
        rig_reset(NULL);
        if (!rig_pretend(versions[i][0], versions[i][1]))
            continue;
        tsu_gl *const gl = rig_gl();
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        counted_reset();
        rig.allocations = 0;
        assert_int_equal(tsu_gl_bind(gl, 1, 2, 4), TSU_OK);
        if (versions[i][1] == version_of(&rig.fixture.gl))
            printf("# tsu_gl_bind on %d.%d: %u calls\n", rig.fixture.gl.major, rig.fixture.gl.minor,
                   counted.calls);
        assert_int_equal(counted.calls, (unsigned)versions[i][2]);
        assert_int_equal(counted.gets, 0);
        assert_int_equal(rig.allocations, 0);
        tsu_gl_bindings_info info = {.struct_size = sizeof info};
        counted_reset();
        assert_int_equal(tsu_gl_bindings(gl, 1, &info), TSU_OK);
        assert_int_equal(counted.calls, 0);
        tsu_gl_destroy(gl);
    }
    fake_set_destroy(set);
}

// Of the texture bound on the active unit.
static void check_parameters(const struct gl_api *api)
{
    static const GLenum wanted[][2] = {
        {GL_TEXTURE_MIN_FILTER, GL_LINEAR},
        {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
        {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE},
        {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE},
        {GL_TEXTURE_BASE_LEVEL, 0},
        {GL_TEXTURE_MAX_LEVEL, 0},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        GLint value = -1;
        api->GetTexParameteriv(GL_TEXTURE_2D, wanted[i][0], &value);
        assert_int_equal(value, wanted[i][1]);
    }
}

// What bind leaves is what bindings says, and the sampler object is gone.
static void what_is_bound(void **state)
{
    (void)state;
    const struct gl_api *const api = &rig.fixture.gl;
    tsu_set *const set = fake_set_create(128, 128, 3, 4096, 1);
    tsu_gl *const gl = rig_gl();
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    GLuint sampler;
    api->GenSamplers(1, &sampler);
    for (GLuint unit = 0; unit < 4; unit++) {
        GLint texture = 0, object = -1, buffer = 0, active = 0;
        GLint64 offset = 0, size = 0;
        tsu_gl_bindings_info info = {.struct_size = sizeof info};
        const uint32_t page = unit % 3;
        api->BindSampler(unit, sampler);
        api->ActiveTexture(GL_TEXTURE0 + 6);
        assert_int_equal(tsu_gl_bind(gl, page, unit, unit + 3), TSU_OK);
        api->GetIntegerv(GL_ACTIVE_TEXTURE, &active);
        assert_int_equal(active, GL_TEXTURE0 + 6);
        api->ActiveTexture(GL_TEXTURE0 + unit);
        api->GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
        api->GetIntegerv(GL_SAMPLER_BINDING, &object);
        api->GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, unit + 3, &buffer);
        api->GetInteger64i_v(GL_UNIFORM_BUFFER_START, unit + 3, &offset);
        api->GetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, unit + 3, &size);
        assert_int_equal(tsu_gl_bindings(gl, page, &info), TSU_OK);
        assert_int_equal(info.texture, texture);
        assert_int_equal(info.buffer, buffer);
        assert_int_equal(info.offset, offset);
        assert_int_equal(info.size, size);
        assert_int_equal(object, 0);
        assert_int_not_equal(texture, 0);
        assert_int_equal(offset, page * TSU_PAGE_BYTES);
    }
    api->DeleteSamplers(1, &sampler);
    check_parameters(api);
    tsu_gl_bindings_info info = {.struct_size = sizeof info};
    assert_int_equal(tsu_gl_bindings(gl, 0, &info), TSU_OK);
    assert_true(api->IsTexture(info.texture));
    assert_true(api->IsBuffer(info.buffer));
    tsu_gl_destroy(gl);
    assert_false(api->IsTexture(info.texture));
    assert_false(api->IsBuffer(info.buffer));
    rig_check_error();
    fake_set_destroy(set);
}

// Linear between texels, clamped at the edge, one level.
static void filter(void **state)
{
    (void)state;
    static const uint16_t texels[2][4] = {{0x3C00, 0x4400, 0xC000, 0x0000},  // 1 4 -2 0
                                          {0x4200, 0x4800, 0x4000, 0x3C00}}; // 3 8 2 1
    static const float places[4] = {-3.0F, 0.375F, 0.5F, 9.0F};
    static const float wanted[4][4] = {
        {1, 4, -2, 0}, {1.5F, 5, -1, 0.25F}, {2, 6, 0, 0.5F}, {3, 8, 2, 1}};
    tsu_set *const set = fake_set_create(2, 1, 1, 4096, 1);
    memcpy(set->texels, texels, sizeof texels);
    tsu_gl *const gl = rig_gl();
    const GLuint program = rig_program(
        "uniform sampler2D tsu_tables; uniform float place; out vec4 o;\n"
        "void main() { o = texture(tsu_tables, vec2(place, gl_FragCoord.y * 5.0 - 7.0)); }\n");
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    assert_int_equal(tsu_gl_program_setup(gl, program, RIG_UNIT, RIG_BINDING), TSU_OK);
    for (int i = 0; i < 4; i++) {
        struct fixture_target target;
        float seen[4 * 4 * 4];
        assert_int_equal(tsu_gl_bind(gl, 0, RIG_UNIT, RIG_BINDING), TSU_OK);
        rig.fixture.gl.ActiveTexture(GL_TEXTURE0); // where the target's texture is made
        rig.fixture.gl.UseProgram(program);
        rig.fixture.gl.Uniform1f(rig.fixture.gl.GetUniformLocation(program, "place"), places[i]);
        assert_true(fixture_target_create(&rig.fixture, &target, 4, 4));
        fixture_draw(&rig.fixture, program, &target);
        fixture_read(&rig.fixture, &target, seen);
        fixture_target_destroy(&rig.fixture, &target);
        // GL promises no weights exactly; 8 bits is the least in use.
        for (int k = 0; k < 4 * 4 * 4; k++)
            assert_float_equal(seen[k], wanted[i][k % 4], 4.0F / 256.0F);
    }
    rig.fixture.gl.UseProgram(0);
    rig.fixture.gl.DeleteProgram(program);
    tsu_gl_destroy(gl);
    rig_check_error();
    fake_set_destroy(set);
}

static void limits(void **state)
{
    (void)state;
    GLint units = 0, bindings = 0;
    char text[128];
    rig.fixture.gl.GetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    rig.fixture.gl.GetIntegerv(GL_MAX_UNIFORM_BUFFER_BINDINGS, &bindings);
    const uint32_t u = (uint32_t)units, b = (uint32_t)bindings;
    tsu_set *const set = fake_set_create(128, 128, 3, 4096, 1);
    tsu_gl *const gl = rig_gl();
    const tsu_gl_bindings_info zero = {.struct_size = sizeof zero};
    tsu_gl_bindings_info info;
    memset(&info, 0xFF, sizeof info);
    info.struct_size = sizeof info;
    counted_reset();
    assert_int_equal(tsu_gl_bind(gl, 0, 0, 0), TSU_E_STATE);
    assert_int_equal(rig.code, 43);
    assert_int_equal(tsu_gl_bindings(gl, 0, &info), TSU_E_STATE);
    assert_memory_equal(&info, &zero, sizeof info);
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    counted_reset();
    assert_int_equal(tsu_gl_bind(NULL, 0, 0, 0), TSU_E_PARAMETER);
    assert_int_equal(tsu_gl_bind(gl, 3, 0, 0), TSU_E_PARAMETER);
    assert_int_equal(tsu_gl_bind(gl, UINT32_MAX, 0, 0), TSU_E_PARAMETER);
    assert_non_null(strstr(rig.last, "page = 4294967295, expected less than the 3 pages"));
    assert_int_equal(tsu_gl_bind(gl, 2, u, 0), TSU_E_LIMIT);
    snprintf(text, sizeof text, "GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS = %d", units);
    assert_non_null(strstr(rig.last, text));
    assert_int_equal(tsu_gl_bind(gl, 2, 0, b), TSU_E_LIMIT);
    snprintf(text, sizeof text, "GL_MAX_UNIFORM_BUFFER_BINDINGS = %d", bindings);
    assert_non_null(strstr(rig.last, text));
    assert_int_equal(tsu_gl_bind(gl, 2, UINT32_MAX, UINT32_MAX), TSU_E_LIMIT);
    assert_int_equal(tsu_gl_program_setup(gl, 1, u, 0), TSU_E_LIMIT);
    assert_int_equal(tsu_gl_program_setup(gl, 1, 0, b), TSU_E_LIMIT);
    assert_int_equal(tsu_gl_program_setup(NULL, 1, 0, 0), TSU_E_PARAMETER);
    memset(&info, 0xFF, sizeof info);
    info.struct_size = sizeof info;
    assert_int_equal(tsu_gl_bindings(gl, 3, &info), TSU_E_PARAMETER);
    assert_memory_equal(&info, &zero, sizeof info);
    info.struct_size = 0;
    assert_int_equal(tsu_gl_bindings(gl, 0, &info), TSU_E_STRUCT);
    assert_int_equal(tsu_gl_bindings(gl, 0, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_gl_bindings(NULL, 0, &info), TSU_E_PARAMETER);
    assert_int_equal(counted.calls, 0);
    assert_int_equal(tsu_gl_bind(gl, 2, u - 1, b - 1), TSU_OK);
    rig_check(gl, set);
    tsu_gl_destroy(gl);
    fake_set_destroy(set);
}

static void programs(void **state)
{
    (void)state;
    const struct gl_api *const api = &rig.fixture.gl;
    const GLuint full =
        rig_program("uniform sampler2D tsu_tables; out vec4 o;\n"
                    "layout(std140) uniform tsu_materials { vec4 tsu_page[1024]; };\n"
                    "void main() { o = texture(tsu_tables, vec2(0.5)) + tsu_page[7]; }\n");
    const GLuint bare = rig_program("out vec4 o; void main() { o = vec4(1.0); }\n");
    const GLuint unlinked = api->CreateProgram();
    const GLuint current[] = {0, bare, full};
    for (size_t i = 0; i < sizeof current / sizeof *current; i++) {
        tsu_gl *const gl = rig_gl();
        GLint now = -1, unit = -1, binding = -1;
        api->UseProgram(current[i]);
        assert_int_equal(tsu_gl_program_setup(gl, full, 9 + (uint32_t)i, 4 + (uint32_t)i), TSU_OK);
        api->GetUniformiv(full, api->GetUniformLocation(full, "tsu_tables"), &unit);
        api->GetActiveUniformBlockiv(full, api->GetUniformBlockIndex(full, "tsu_materials"),
                                     GL_UNIFORM_BLOCK_BINDING, &binding);
        assert_int_equal(unit, 9 + i);
        assert_int_equal(binding, 4 + i);
        counted_reset();
        assert_int_equal(tsu_gl_program_setup(gl, bare, 1, 1), TSU_OK);
        assert_int_equal(counted.calls, 4); // four questions, nothing set
        assert_int_equal(tsu_gl_program_setup(gl, 0, 1, 1), TSU_E_PARAMETER);
        assert_int_equal(tsu_gl_program_setup(gl, 123456, 1, 1), TSU_E_PARAMETER);
        assert_int_equal(tsu_gl_program_setup(gl, unlinked, 1, 1), TSU_E_PARAMETER);
        api->GetIntegerv(GL_CURRENT_PROGRAM, &now);
        assert_int_equal(now, current[i]);
        rig_check_error();
        tsu_gl_destroy(gl);
    }
    api->UseProgram(0);
    api->DeleteProgram(full);
    api->DeleteProgram(bare);
    api->DeleteProgram(unlinked);
}

int bind_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(calls_of_bind, rig_reset),
        cmocka_unit_test_setup(what_is_bound, rig_reset),
        cmocka_unit_test_setup(filter, rig_reset),
        cmocka_unit_test_setup(limits, rig_reset),
        cmocka_unit_test_setup(programs, rig_reset),
    };
    return cmocka_run_group_tests_name("bind", tests, NULL, NULL);
}

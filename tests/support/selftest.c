// The fixture draws and reads on every rung, and the witness of the hostile host notices changes.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "fixture.h"
#include "hostile.h"

#include <stdio.h>
#include <string.h>

static struct fixture fixture;
static struct hostile host;

static GLuint program_of(const char *body)
{
    char source[2048];
    snprintf(source, sizeof source, "%s%s", fixture.version, body);
    const GLuint program = fixture_program(&fixture, NULL, source);
    assert_int_not_equal(program, 0);
    return program;
}

static void check_colour(void)
{
    float rgba[5 * 3 * 4];
    struct fixture_target target;
    const GLuint program =
        program_of("in vec2 uv;\n"
                   "out vec4 o;\n"
                   "void main() { o = vec4(uv * vec2(5.0, 3.0), -7.25, 1.0); }\n");
    assert_true(fixture_target_create(&fixture, &target, 5, 3));
    fixture_draw(&fixture, program, &target);
    fixture_read(&fixture, &target, rgba);
    for (int y = 0; y < 3; y++) {
        for (int x = 0; x < 5; x++) {
            const float *p = rgba + 4 * (5 * y + x);
            assert_float_equal(p[0], (float)x + 0.5F, 1e-5);
            assert_float_equal(p[1], (float)y + 0.5F, 1e-5);
            assert_float_equal(p[2], -7.25F, 0);
            assert_float_equal(p[3], 1, 0);
        }
    }
    fixture_target_destroy(&fixture, &target);
    fixture.gl.DeleteProgram(program);
}

static void draws_and_reads(void **state)
{
    (void)state;
    check_colour();
    assert_int_equal(fixture.gl.GetError(), GL_NO_ERROR);
}

static void draws_and_reads_amid_hostility(void **state)
{
    (void)state;
    assert_true(hostile_set(&fixture.gl, &host));
    check_colour();
    hostile_clear(&fixture.gl, &host);
    assert_int_equal(fixture.gl.GetError(), GL_NO_ERROR);
}

// The witness sees nothing where nothing changed; hostile differs from initial; clear undoes set.
static void set_and_clear(void **state)
{
    (void)state;
    static struct hostile_state initial, ugly, again, cleared;
    const struct gl_api *gl = &fixture.gl;
    char why[200];
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    gl->Viewport(0, 0, 8, 8);
    hostile_snapshot(gl, &initial);
    assert_true(hostile_set(gl, &host));
    hostile_snapshot(gl, &ugly);
    hostile_snapshot(gl, &again);
    assert_true(hostile_compare(&ugly, &again, why, sizeof why));
    assert_string_equal(why, "");
    assert_false(hostile_compare(&initial, &ugly, why, sizeof why));
    hostile_clear(gl, &host);
    hostile_snapshot(gl, &cleared);
    if (!hostile_compare(&initial, &cleared, why, sizeof why)) {
        fail_msg("%s", why);
    }
    assert_in_range(initial.count, 300, HOSTILE_VALUES - 1);
}

static void change_unit(const struct gl_api *gl)
{
    gl->ActiveTexture(GL_TEXTURE0);
}

static void change_unpack_buffer(const struct gl_api *gl)
{
    gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

static void change_alignment(const struct gl_api *gl)
{
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

static void change_texture(const struct gl_api *gl)
{
    gl->ActiveTexture(GL_TEXTURE3);
    gl->BindTexture(GL_TEXTURE_3D, 0);
    gl->ActiveTexture(GL_TEXTURE7);
}

static void change_sampler(const struct gl_api *gl)
{
    gl->BindSampler(31, 0);
}

static void change_parameter(const struct gl_api *gl)
{
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 3);
}

static void change_program(const struct gl_api *gl)
{
    gl->UseProgram(0);
}

static void change_uniform_range(const struct gl_api *gl)
{
    GLint generic = 0, indexed = 0;
    gl->GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &generic);
    gl->GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 5, &indexed);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, 5, (GLuint)indexed);
    gl->BindBuffer(GL_UNIFORM_BUFFER, (GLuint)generic);
}

static void change_attribute(const struct gl_api *gl)
{
    gl->VertexAttribDivisor(1, 0);
}

static void change_buffer_size(const struct gl_api *gl)
{
    gl->BufferData(GL_COPY_WRITE_BUFFER, 64, NULL, GL_STATIC_DRAW);
}

static void change_framebuffer(const struct gl_api *gl)
{
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

static void change_draw_buffers(const struct gl_api *gl)
{
    static const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl->DrawBuffers(2, both);
}

static void change_blend(const struct gl_api *gl)
{
    gl->Disable(GL_BLEND);
}

static void change_colour_mask(const struct gl_api *gl)
{
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

static void change_viewport(const struct gl_api *gl)
{
    gl->Viewport(1, 2, 3, 5);
}

static void leave_error(const struct gl_api *gl)
{
    gl->Enable(GL_TEXTURE_2D_ARRAY);
}

static void notices_changes(void **state)
{
    (void)state;
    static const struct {
        void (*change)(const struct gl_api *gl);
        const char *name;
    } cases[] = {
        {change_unit, "GL_ACTIVE_TEXTURE was"},
        {change_unpack_buffer, "GL_PIXEL_UNPACK_BUFFER_BINDING was"},
        {change_alignment, "GL_UNPACK_ALIGNMENT was 8 0 0 0 and is 1 0 0 0"},
        {change_texture, "GL_TEXTURE_BINDING_3D of 3 was"},
        {change_sampler, "GL_SAMPLER_BINDING of 31 was"},
        {change_parameter, "GL_TEXTURE_MAX_LEVEL of 1 was 7 0 0 0 and is 3 0 0 0"},
        {change_program, "GL_CURRENT_PROGRAM was"},
        {change_uniform_range, "GL_UNIFORM_BUFFER_BINDING of 5 was"},
        {change_attribute, "GL_VERTEX_ATTRIB_ARRAY_DIVISOR of 1 was"},
        {change_buffer_size, "GL_BUFFER_SIZE of GL_COPY_WRITE_BUFFER was"},
        {change_framebuffer, "GL_READ_FRAMEBUFFER_BINDING was"},
        {change_draw_buffers, "GL_DRAW_BUFFER0 was"},
        {change_blend, "GL_BLEND was 1 0 0 0 and is 0 0 0 0"},
        {change_colour_mask, "GL_COLOR_WRITEMASK was 0 1 0 1 and is 1 1 1 1"},
        {change_viewport, "GL_VIEWPORT was 1 2 3 4 and is 1 2 3 5"},
        {leave_error, "glGetError was 0 0 0 0 and is 1280 0 0 0"},
    };
    static struct hostile_state before, after;
    char why[200];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_true(hostile_set(&fixture.gl, &host));
        hostile_snapshot(&fixture.gl, &before);
        cases[i].change(&fixture.gl);
        hostile_snapshot(&fixture.gl, &after);
        const int same = hostile_compare(&before, &after, why, sizeof why);
        hostile_clear(&fixture.gl, &host);
        if (same || strncmp(why, cases[i].name, strlen(cases[i].name)) != 0) {
            fail_msg("expected \"%s\", the witness said \"%s\"", cases[i].name, why);
        }
    }
    assert_int_equal(fixture.gl.GetError(), GL_NO_ERROR);
}

static void bad_shader_is_refused(void **state)
{
    (void)state;
    assert_int_equal(fixture_program(&fixture, NULL, "no shader at all\n"), 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(draws_and_reads),
        cmocka_unit_test(draws_and_reads_amid_hostility),
        cmocka_unit_test(set_and_clear),
        cmocka_unit_test(notices_changes),
        cmocka_unit_test(bad_shader_is_refused),
    };
    if (!fixture_open(&fixture, argc, argv)) {
        return 1;
    }
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    return !fixture_close(&fixture) || failed != 0;
}

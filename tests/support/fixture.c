#define _POSIX_C_SOURCE 200809L // setenv
#include "fixture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct rung {
    const char *name;
    offscreen_desc desc;
    int only_33;
    const char *version;
};

static const char es_version[] = "#version 300 es\n"
                                 "precision highp float;\n"
                                 "precision highp int;\n"
                                 "precision highp sampler2D;\n"
                                 "precision highp sampler2DArray;\n"
                                 "precision highp sampler3D;\n";

static const struct rung rungs[] = {
    {"gl45-egl", {OFFSCREEN_EGL, OFFSCREEN_GL, 4, 5}, 0, "#version 450 core\n"},
    {"gl33-egl", {OFFSCREEN_EGL, OFFSCREEN_GL, 3, 3}, 1, "#version 330 core\n"},
    {"es3-egl", {OFFSCREEN_EGL, OFFSCREEN_ES, 3, 0}, 0, es_version},
    {"gl45-osmesa", {OFFSCREEN_OSMESA, OFFSCREEN_GL, 4, 5}, 0, "#version 450 core\n"},
    {"gl33-osmesa", {OFFSCREEN_OSMESA, OFFSCREEN_GL, 3, 3}, 1, "#version 330 core\n"},
};

static const struct rung *find_rung(const char *name)
{
    for (size_t i = 0; name && i < sizeof rungs / sizeof *rungs; i++) {
        if (strcmp(rungs[i].name, name) == 0) {
            return &rungs[i];
        }
    }
    fprintf(stderr, "fixture: the first argument names the context, one of");
    for (size_t i = 0; i < sizeof rungs / sizeof *rungs; i++) {
        fprintf(stderr, " %s", rungs[i].name);
    }
    fprintf(stderr, "; it is %s.\n", name ? name : "not there");
    return NULL;
}

int fixture_open(struct fixture *f, int argc, char **argv)
{
    char error[512];
    const char *missing = NULL;
    memset(f, 0, sizeof *f);
    const struct rung *rung = find_rung(argc > 1 ? argv[1] : getenv("TSUYA_TEST_RUNG"));
    if (!rung) {
        return 0;
    }
    // Before the driver is loaded: it reads these once. Unset otherwise, so that a rung means the
    // same whatever the caller's environment.
    if (rung->only_33) {
        setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
        setenv("MESA_GLSL_VERSION_OVERRIDE", "330", 1);
    } else {
        unsetenv("MESA_GL_VERSION_OVERRIDE");
        unsetenv("MESA_GLSL_VERSION_OVERRIDE");
    }
    if (!offscreen_create(&rung->desc, &f->context, error, sizeof error)) {
        fprintf(stderr, "fixture: no context for %s: %s\n", rung->name, error);
        return 0;
    }
    if (!gl_load(&f->gl, offscreen_proc, f->context, &missing)) {
        fprintf(stderr, "fixture: %s lacks %s.\n", rung->name, missing);
    } else if (rung->only_33 && (f->gl.major != 3 || f->gl.minor != 3)) {
        fprintf(stderr, "fixture: %s is version %d.%d and does not test 3.3.\n", rung->name,
                f->gl.major, f->gl.minor);
    } else {
        f->rung = rung->name;
        f->version = rung->version;
        f->gl.GenVertexArrays(1, &f->vertex_array);
        printf("# %s: %s\n", rung->name, offscreen_description(f->context));
        return 1;
    }
    offscreen_destroy(f->context);
    memset(f, 0, sizeof *f);
    return 0;
}

int fixture_close(struct fixture *f)
{
    if (!f->context) {
        return 1;
    }
    f->gl.DeleteVertexArrays(1, &f->vertex_array);
    const GLenum error = f->gl.GetError();
    if (error != GL_NO_ERROR) {
        fprintf(stderr, "fixture: OpenGL error 0x%x was left behind.\n", error);
    }
    offscreen_destroy(f->context);
    memset(f, 0, sizeof *f);
    return error == GL_NO_ERROR;
}

static void print_numbered(const char *source)
{
    for (int line = 1; *source; line++) {
        const int length = (int)strcspn(source, "\n");
        fprintf(stderr, "%4d  %.*s\n", line, length, source);
        source += length + (source[length] == '\n');
    }
}

static GLuint compile(struct fixture *f, GLenum stage, const char *source)
{
    const struct gl_api *gl = &f->gl;
    const GLuint shader = gl->CreateShader(stage);
    GLint good = 0;
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[4096];
        gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
        fprintf(stderr, "fixture: %s: the %s shader does not compile:\n%s\n", f->rung,
                stage == GL_VERTEX_SHADER ? "vertex" : "fragment", log);
        print_numbered(source);
        gl->DeleteShader(shader);
        return 0;
    }
    return shader;
}

GLuint fixture_program(struct fixture *f, const char *vertex, const char *fragment)
{
    static const char triangle[] =
        "out vec2 uv;\n"
        "void main()\n"
        "{\n"
        "    uv = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));\n"
        "    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);\n"
        "}\n";
    const struct gl_api *gl = &f->gl;
    char own[sizeof es_version + sizeof triangle];
    if (!vertex) {
        snprintf(own, sizeof own, "%s%s", f->version, triangle);
        vertex = own;
    }
    const GLuint vs = compile(f, GL_VERTEX_SHADER, vertex);
    const GLuint fs = vs ? compile(f, GL_FRAGMENT_SHADER, fragment) : 0;
    GLuint program = 0;
    if (fs) {
        GLint good = 0;
        program = gl->CreateProgram();
        gl->AttachShader(program, vs);
        gl->AttachShader(program, fs);
        gl->LinkProgram(program);
        gl->GetProgramiv(program, GL_LINK_STATUS, &good);
        if (!good) {
            char log[4096];
            gl->GetProgramInfoLog(program, sizeof log, NULL, log);
            fprintf(stderr, "fixture: %s: the program does not link:\n%s\n", f->rung, log);
            gl->DeleteProgram(program);
            program = 0;
        }
    }
    gl->DeleteShader(vs);
    gl->DeleteShader(fs);
    return program;
}

int fixture_target_create(struct fixture *f, struct fixture_target *target, int width, int height)
{
    const struct gl_api *gl = &f->gl;
    const float zero[4] = {0, 0, 0, 0};
    *target = (struct fixture_target){.width = width, .height = height};
    gl->GenTextures(1, &target->texture);
    gl->BindTexture(GL_TEXTURE_2D, target->texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    // With an unpack buffer bound, NULL would mean its first byte.
    gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->GenFramebuffers(1, &target->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->texture,
                             0);
    const GLenum status = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        fprintf(stderr, "fixture: %s: a %d x %d RGBA32F target is incomplete (0x%x).\n", f->rung,
                width, height, status);
        fixture_target_destroy(f, target);
        return 0;
    }
    gl->Disable(GL_SCISSOR_TEST);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->ClearBufferfv(GL_COLOR, 0, zero);
    return 1;
}

void fixture_target_destroy(struct fixture *f, struct fixture_target *target)
{
    f->gl.DeleteFramebuffers(1, &target->framebuffer);
    f->gl.DeleteTextures(1, &target->texture);
    memset(target, 0, sizeof *target);
}

void fixture_draw(struct fixture *f, GLuint program, const struct fixture_target *target)
{
    static const GLenum switches[] = {GL_BLEND,        GL_CULL_FACE,          GL_DEPTH_TEST,
                                      GL_SCISSOR_TEST, GL_STENCIL_TEST,       GL_RASTERIZER_DISCARD,
                                      GL_DITHER,       GL_SAMPLE_COVERAGE,
                                      GL_SAMPLE_ALPHA_TO_COVERAGE};
    static const GLenum desktop[] = {GL_FRAMEBUFFER_SRGB, GL_COLOR_LOGIC_OP};
    const struct gl_api *gl = &f->gl;
    for (size_t i = 0; i < sizeof switches / sizeof *switches; i++) {
        gl->Disable(switches[i]);
    }
    for (size_t i = 0; !gl->es && i < sizeof desktop / sizeof *desktop; i++) {
        gl->Disable(desktop[i]);
    }
    if (!gl->es) {
        gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    if (gl_at_least(gl, 0, 4, 5)) {
        gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    gl->Viewport(0, 0, target->width, target->height);
    gl->UseProgram(program);
    gl->BindVertexArray(f->vertex_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

void fixture_read(struct fixture *f, const struct fixture_target *target, float *rgba)
{
    const struct gl_api *gl = &f->gl;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->PixelStorei(GL_PACK_ROW_LENGTH, 0);
    gl->PixelStorei(GL_PACK_SKIP_ROWS, 0);
    gl->PixelStorei(GL_PACK_SKIP_PIXELS, 0);
    if (!gl->es) {
        gl->PixelStorei(GL_PACK_SWAP_BYTES, GL_FALSE);
    }
    gl->ReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, rgba);
}

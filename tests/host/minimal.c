// The smallest host: one material, one quad, one pixel, and a look whether it is the right one.
//
// What lies between the two marked lines is all that a host adds to itself; the README shows it.
#include "gl.h"
#include "offscreen.h"

#include <tsuya/tsuya.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char vertex[] = "#version 330 core\n"
                             "void main()\n"
                             "{\n"
                             "    vec2 at = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
                             "    gl_Position = vec4(4.0 * at - 1.0, 0.0, 1.0);\n"
                             "}\n";

// A fibre along z, light inclined by 0.2, view by -0.1, 0.5 between their azimuths.
static const char fragment[] =
    "out vec4 color;\n"
    "void main()\n"
    "{\n"
    "    vec3 l = vec3(cos(0.2), 0.0, sin(0.2));\n"
    "    vec3 v = vec3(cos(0.1) * cos(0.5), cos(0.1) * sin(0.5), -sin(0.1));\n"
    "    tsu_marschner_lobes lobes =\n"
    "        tsu_marschner_eval(0, vec3(0.0, 0.0, 1.0), l, v, tsu_marschner_sigma_a(0));\n"
    "    color = vec4(tsu_marschner_sum(lobes), 1.0);\n"
    "}\n";

static GLuint shader(const struct gl_api *gl, GLenum stage, const char *a, const char *b,
                     const char *c)
{
    const char *parts[3] = {a, b, c};
    const GLuint name = gl->CreateShader(stage);
    GLint good;
    gl->ShaderSource(name, 3, parts, NULL);
    gl->CompileShader(name);
    gl->GetShaderiv(name, GL_COMPILE_STATUS, &good);
    return good ? name : 0;
}

static GLuint link(const struct gl_api *gl, const char *text)
{
    const GLuint program = gl->CreateProgram();
    GLint good;
    gl->AttachShader(program, shader(gl, GL_VERTEX_SHADER, vertex, "", ""));
    gl->AttachShader(program,
                     shader(gl, GL_FRAGMENT_SHADER, "#version 330 core\n", text, fragment));
    gl->LinkProgram(program);
    gl->GetProgramiv(program, GL_LINK_STATUS, &good);
    return good ? program : 0;
}

static void target(const struct gl_api *gl)
{
    GLuint texture, framebuffer, vertices;
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 4, 4, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl->GenVertexArrays(1, &vertices);
    gl->BindVertexArray(vertices);
    gl->Viewport(0, 0, 4, 4);
}

// The reference in double precision at the same directions and this absorption.
static double reference(tsu_context *context, double sigma_a)
{
    tsu_function_info function;
    double in[TSU_FUNCTION_INPUTS], out[TSU_FUNCTION_OUTPUTS];
    tsu_function_info_init(&function);
    if (tsu_model_function(tsu_marschner(), 0, &function) != TSU_OK)
        return NAN;
    for (uint32_t i = 0; i < function.input_count; i++) {
        tsu_value_info input;
        tsu_value_info_init(&input);
        tsu_function_input(tsu_marschner(), 0, i, &input);
        in[i] = strcmp(input.name, "theta_i") == 0   ? 0.2
                : strcmp(input.name, "theta_r") == 0 ? -0.1
                : strcmp(input.name, "phi") == 0     ? 0.5
                : strcmp(input.name, "sigma_a") == 0 ? sigma_a
                                                     : input.default_value;
    }
    if (tsu_function_reference(context, tsu_marschner(), 0, in, out) != TSU_OK)
        return NAN;
    return out[function.output_count - 1]; // "total"
}

static void print_line(void *user, int32_t level, int32_t code, const char *text)
{
    (void)user;
    (void)level;
    (void)code;
    fprintf(stderr, "%s\n", text);
}

int main(void)
{
    const offscreen_desc wanted = {OFFSCREEN_ANY, OFFSCREEN_GL, 3, 3};
    offscreen *window;
    struct gl_api api, *gl = &api;
    char error[512];
    if (!offscreen_create(&wanted, &window, error, sizeof error) ||
        !gl_load(gl, offscreen_proc, window, NULL)) {
        fprintf(stderr, "no OpenGL 3.3: %s\n", error);
        return 1;
    }
    target(gl);

    tsu_context_desc context_desc;
    tsu_set_desc set_desc;
    tsu_gl_desc gl_desc;
    tsu_shader_desc shader_desc;
    tsu_marschner_params hair;
    tsu_context *context;
    tsu_set *set;
    tsu_gl *tsu;
    tsu_shader *text;
    uint32_t material;
    const tsu_model *model = tsu_marschner();
    tsu_context_desc_init(&context_desc);
    tsu_set_desc_init(&set_desc);
    tsu_gl_desc_init(&gl_desc);
    tsu_shader_desc_init(&shader_desc);
    tsu_marschner_params_init(&hair);
    context_desc.log = print_line;
    gl_desc.get_proc_address = offscreen_proc;
    gl_desc.user = window;
    shader_desc.models = &model;
    shader_desc.model_count = 1;

    int failed = 0;
    // integration: begin
    failed |= tsu_context_create(&context_desc, &context);
    failed |= tsu_set_create(context, &set_desc, &set);
    failed |= tsu_set_add(set, model, &hair, &material);            // once a material
    failed |= tsu_set_bake(set);                                    // when eta or beta_az changed
    failed |= tsu_shader_create(context, &shader_desc, &text);      // functions for your own shader
    const GLuint program = link(gl, tsu_shader_text(text, NULL));
    failed |= tsu_gl_create(context, &gl_desc, &tsu);
    failed |= tsu_gl_program_setup(tsu, program, 5, 3);             // texture unit, block binding
    failed |= tsu_gl_sync(tsu, set);                                // once a frame
    failed |= tsu_gl_bind(tsu, material / TSU_PAGE_MATERIALS, 5, 3); // before the draw
    // integration: end
    if (failed || !program)
        return 1;

    gl->UseProgram(program);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    float pixel[4] = {NAN, NAN, NAN, NAN};
    gl->ReadPixels(2, 2, 1, 1, GL_RGBA, GL_FLOAT, pixel);
    failed |= gl->GetError() != GL_NO_ERROR;
    for (int k = 0; k < 3; k++) {
        const double expected = reference(context, (double)hair.sigma_a[k]), got = (double)pixel[k];
        printf("%.6f, reference %.6f\n", got, expected);
        failed |= !(isfinite(got) && got > 0 && fabs(got - expected) <= 0.01 * expected);
    }
    tsu_gl_destroy(tsu);
    tsu_shader_destroy(text);
    tsu_set_destroy(set);
    tsu_context_destroy(context);
    gl->DeleteProgram(program);
    offscreen_destroy(window);
    return failed;
}

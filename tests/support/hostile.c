#include "hostile.h"

#include <string.h>

enum { ALL, DESKTOP };

// A switch or a pixel-store value: what OpenGL starts with and what this host sets.
struct setting {
    GLenum name;
    int where, initial, ugly;
};

static const struct setting switches[] = {
    {GL_BLEND, ALL, 0, 1},
    {GL_CULL_FACE, ALL, 0, 1},
    {GL_DEPTH_TEST, ALL, 0, 1},
    {GL_DITHER, ALL, 1, 0},
    {GL_POLYGON_OFFSET_FILL, ALL, 0, 1},
    {GL_RASTERIZER_DISCARD, ALL, 0, 1},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, ALL, 0, 1},
    {GL_SAMPLE_COVERAGE, ALL, 0, 1},
    {GL_SCISSOR_TEST, ALL, 0, 1},
    {GL_STENCIL_TEST, ALL, 0, 1},
    {GL_COLOR_LOGIC_OP, DESKTOP, 0, 1},
    {GL_DEPTH_CLAMP, DESKTOP, 0, 1},
    {GL_FRAMEBUFFER_SRGB, DESKTOP, 0, 1},
    {GL_MULTISAMPLE, DESKTOP, 1, 0},
    {GL_PRIMITIVE_RESTART, DESKTOP, 0, 1},
    {GL_PROGRAM_POINT_SIZE, DESKTOP, 0, 1},
    {GL_TEXTURE_CUBE_MAP_SEAMLESS, DESKTOP, 0, 1},
};

static const struct setting stores[] = {
    {GL_UNPACK_ALIGNMENT, ALL, 4, 8},       {GL_UNPACK_ROW_LENGTH, ALL, 0, 13},
    {GL_UNPACK_SKIP_PIXELS, ALL, 0, 3},     {GL_UNPACK_SKIP_ROWS, ALL, 0, 2},
    {GL_UNPACK_IMAGE_HEIGHT, ALL, 0, 11},   {GL_UNPACK_SKIP_IMAGES, ALL, 0, 1},
    {GL_UNPACK_SWAP_BYTES, DESKTOP, 0, 1},  {GL_UNPACK_LSB_FIRST, DESKTOP, 0, 1},
    {GL_PACK_ALIGNMENT, ALL, 4, 8},         {GL_PACK_ROW_LENGTH, ALL, 0, 17},
    {GL_PACK_SKIP_PIXELS, ALL, 0, 5},       {GL_PACK_SKIP_ROWS, ALL, 0, 4},
    {GL_PACK_IMAGE_HEIGHT, DESKTOP, 0, 19}, {GL_PACK_SKIP_IMAGES, DESKTOP, 0, 2},
    {GL_PACK_SWAP_BYTES, DESKTOP, 0, 1},    {GL_PACK_LSB_FIRST, DESKTOP, 0, 1},
};

static const GLenum texture_targets[] = {GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_3D};

// The first seven of hostile.buffers, in this order; the eighth holds vertices and indices.
static const GLenum buffer_targets[] = {GL_ARRAY_BUFFER,        GL_COPY_READ_BUFFER,
                                        GL_COPY_WRITE_BUFFER,   GL_PIXEL_PACK_BUFFER,
                                        GL_PIXEL_UNPACK_BUFFER, GL_UNIFORM_BUFFER,
                                        GL_TRANSFORM_FEEDBACK_BUFFER};

// Everything that needs no object, ugly or as OpenGL starts.
static void set_values(const struct gl_api *gl, int ugly)
{
    for (size_t i = 0; i < sizeof switches / sizeof *switches; i++) {
        if (switches[i].where == ALL || !gl->es) {
            const int on = ugly ? switches[i].ugly : switches[i].initial;
            (on ? gl->Enable : gl->Disable)(switches[i].name);
        }
    }
    for (size_t i = 0; i < sizeof stores / sizeof *stores; i++) {
        if (stores[i].where == ALL || !gl->es) {
            gl->PixelStorei(stores[i].name, ugly ? stores[i].ugly : stores[i].initial);
        }
    }
    const GLboolean on = ugly ? GL_FALSE : GL_TRUE;
    gl->ColorMask(on, GL_TRUE, on, GL_TRUE);
    gl->DepthMask(on);
    gl->ClearColor(ugly ? 0.3F : 0, ugly ? 0.1F : 0, ugly ? 0.7F : 0, ugly ? 0.9F : 0);
    gl->ClearStencil(ugly ? 5 : 0);
    gl->DepthFunc(ugly ? GL_GREATER : GL_LESS);
    gl->CullFace(ugly ? GL_FRONT : GL_BACK);
    gl->FrontFace(ugly ? GL_CW : GL_CCW);
    gl->PolygonOffset(ugly ? 2.0F : 0, ugly ? 3.0F : 0);
    gl->SampleCoverage(ugly ? 0.5F : 1, ugly ? GL_TRUE : GL_FALSE);
    gl->BlendColor(ugly ? 0.2F : 0, ugly ? 0.4F : 0, ugly ? 0.6F : 0, ugly ? 0.8F : 0);
    if (ugly) {
        gl->BlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
        gl->BlendFuncSeparate(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_CONSTANT_COLOR,
                              GL_SRC_COLOR);
        gl->StencilFuncSeparate(GL_FRONT, GL_NOTEQUAL, 3, 0x5A);
        gl->StencilFuncSeparate(GL_BACK, GL_NEVER, 4, 0xA5);
        gl->StencilOpSeparate(GL_FRONT, GL_INCR, GL_DECR, GL_INVERT);
        gl->StencilOpSeparate(GL_BACK, GL_ZERO, GL_REPLACE, GL_INCR_WRAP);
        gl->StencilMaskSeparate(GL_FRONT, 0x33);
        gl->StencilMaskSeparate(GL_BACK, 0xCC);
    } else {
        gl->BlendEquation(GL_FUNC_ADD);
        gl->BlendFunc(GL_ONE, GL_ZERO);
        gl->StencilFunc(GL_ALWAYS, 0, ~0U);
        gl->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        gl->StencilMask(~0U);
    }
    if (!gl->es) {
        gl->ClearDepth(ugly ? 0.25 : 1);
        gl->DepthRange(ugly ? 0.75 : 0, ugly ? 0.125 : 1);
        gl->LogicOp(ugly ? GL_XOR : GL_COPY);
        gl->PointSize(ugly ? 3.0F : 1);
        gl->PolygonMode(GL_FRONT_AND_BACK, ugly ? GL_LINE : GL_FILL);
        gl->PrimitiveRestartIndex(ugly ? 77 : 0);
        gl->ProvokingVertex(ugly ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
    } else {
        gl->ClearDepthf(ugly ? 0.25F : 1);
        gl->DepthRangef(ugly ? 0.75F : 0, ugly ? 0.125F : 1);
    }
    if (gl_at_least(gl, 0, 4, 5)) {
        gl->ClipControl(ugly ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                        ugly ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    }
}

static void set_textures(const struct gl_api *gl, struct hostile *host)
{
    gl->GenTextures(3, host->textures);
    gl->GenSamplers(1, &host->sampler);
    gl->SamplerParameteri(host->sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    gl->SamplerParameteri(host->sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->SamplerParameteri(host->sampler, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    for (int unit = 0; unit < HOSTILE_UNITS; unit++) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        gl->BindSampler((GLuint)unit, host->sampler);
        for (int i = 0; i < 3; i++) {
            gl->BindTexture(texture_targets[i], host->textures[i]);
        }
    }
    // The size tells, when another texture is defined in place of the host's.
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 3, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    gl->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, 3, 5, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    gl->TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 3, 5, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    for (int i = 0; i < 3; i++) {
        gl->TexParameteri(texture_targets[i], GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
        gl->TexParameteri(texture_targets[i], GL_TEXTURE_MAX_LEVEL, 7);
    }
    gl->ActiveTexture(GL_TEXTURE7);
}

static void set_framebuffers(const struct gl_api *gl, struct hostile *host)
{
    static const GLenum formats[] = {GL_RGBA8, GL_RGBA8, GL_DEPTH24_STENCIL8};
    static const GLenum points[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                    GL_DEPTH_STENCIL_ATTACHMENT};
    static const GLenum draws[] = {GL_NONE, GL_COLOR_ATTACHMENT1};
    gl->GenFramebuffers(2, host->framebuffers);
    gl->GenRenderbuffers(3, host->renderbuffers);
    for (int i = 0; i < 3; i++) {
        gl->BindRenderbuffer(GL_RENDERBUFFER, host->renderbuffers[i]);
        gl->RenderbufferStorage(GL_RENDERBUFFER, formats[i], 9, 6);
    }
    for (int k = 0; k < 2; k++) {
        gl->BindFramebuffer(GL_FRAMEBUFFER, host->framebuffers[k]);
        for (int i = 0; i < 3; i++) {
            gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, points[i], GL_RENDERBUFFER,
                                        host->renderbuffers[i]);
        }
        gl->DrawBuffers(2, draws);
        gl->ReadBuffer(GL_COLOR_ATTACHMENT1);
    }
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, host->framebuffers[0]);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, host->framebuffers[1]);
}

static void set_buffers(const struct gl_api *gl, struct hostile *host)
{
    gl->GenVertexArrays(1, &host->vertex_array);
    gl->BindVertexArray(host->vertex_array);
    gl->GenBuffers(8, host->buffers);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, host->buffers[7]);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, 4096, NULL, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, host->buffers[7]);
    for (GLuint i = 0; i < 2; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 28, (const void *)(size_t)(4 * i));
        gl->VertexAttribDivisor(i, 3);
    }
    for (size_t i = 0; i < sizeof buffer_targets / sizeof *buffer_targets; i++) {
        gl->BindBuffer(buffer_targets[i], host->buffers[i]);
        gl->BufferData(buffer_targets[i], 4096 + 256 * (GLsizeiptr)i, NULL, GL_STATIC_DRAW);
    }
    for (GLuint i = 0; i < 16; i++) {
        gl->BindBufferRange(GL_UNIFORM_BUFFER, i, host->buffers[1], 256 * (GLintptr)i, 256);
    }
    gl->BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 1, host->buffers[2], 128, 64);
    // An indexed binding moves the generic one along; these two differ again.
    gl->BindBuffer(GL_UNIFORM_BUFFER, host->buffers[5]);
    gl->BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, host->buffers[6]);
}

static void set_program(const struct gl_api *gl, struct hostile *host)
{
    const char *version =
        gl->es ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n";
    const char *vertex[] = {version, "void main() { gl_Position = vec4(0.0); }\n"};
    const char *fragment[] = {version, "out vec4 o; void main() { o = vec4(1.0); }\n"};
    host->program = gl->CreateProgram();
    for (int i = 0; i < 2; i++) {
        const GLuint shader = gl->CreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        gl->ShaderSource(shader, 2, i ? fragment : vertex, NULL);
        gl->CompileShader(shader);
        gl->AttachShader(host->program, shader);
        gl->DeleteShader(shader);
    }
    gl->LinkProgram(host->program);
    gl->UseProgram(host->program);
}

int hostile_set(const struct gl_api *gl, struct hostile *host)
{
    memset(host, 0, sizeof *host);
    gl->GetIntegerv(GL_VIEWPORT, host->viewport);
    gl->GetIntegerv(GL_SCISSOR_BOX, host->scissor);
    set_values(gl, 0);
    gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    set_textures(gl, host);
    set_framebuffers(gl, host);
    set_buffers(gl, host);
    set_program(gl, host);
    gl->GenQueries(1, &host->query);
    gl->BeginQuery(GL_ANY_SAMPLES_PASSED, host->query);
    gl->Viewport(1, 2, 3, 4);
    gl->Scissor(5, 6, 7, 8);
    set_values(gl, 1);
    return gl->GetError() == GL_NO_ERROR;
}

void hostile_clear(const struct gl_api *gl, struct hostile *host)
{
    gl->EndQuery(GL_ANY_SAMPLES_PASSED);
    gl->DeleteQueries(1, &host->query);
    set_values(gl, 0);
    gl->Viewport(host->viewport[0], host->viewport[1], host->viewport[2], host->viewport[3]);
    gl->Scissor(host->scissor[0], host->scissor[1], host->scissor[2], host->scissor[3]);
    gl->UseProgram(0);
    gl->DeleteProgram(host->program);
    gl->BindVertexArray(0);
    gl->DeleteVertexArrays(1, &host->vertex_array);
    // Deleting an object that is bound in this context unbinds it.
    gl->DeleteTextures(3, host->textures);
    gl->DeleteSamplers(1, &host->sampler);
    gl->DeleteBuffers(8, host->buffers);
    gl->DeleteFramebuffers(2, host->framebuffers);
    gl->DeleteRenderbuffers(3, host->renderbuffers);
    gl->ActiveTexture(GL_TEXTURE0);
    memset(host, 0, sizeof *host);
}

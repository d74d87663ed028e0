// Draws a harness fragment shader with plain OpenGL 3.3: one point, one pixel, for each vertex.
#ifndef TSUYA_TESTS_DEMO_FOREIGN_DRAW_H
#define TSUYA_TESTS_DEMO_FOREIGN_DRAW_H

#include "gl.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace foreign {

struct Vertex {
    float t[3], l[3], v[3], sigma_a[3];
};

// A compiled stage. Throws std::runtime_error with the driver's log, as everything here.
inline GLuint stage(const gl_api &gl, GLenum kind, const std::string &text)
{
    const GLuint shader = gl.CreateShader(kind);
    const char *const source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint good = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[2048] = "";
        gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
        throw std::runtime_error(std::string("the shader does not compile: ") + log);
    }
    return shader;
}

// The harness as the program in use: vertex i of `count` is a point on pixel i, of material 0.
inline GLuint use_program(const gl_api &gl, const std::string &fragment, std::size_t count)
{
    const std::string vertex = "#version 330 core\n"
                               "layout(location = 0) in vec3 in_t;\n"
                               "layout(location = 1) in vec3 in_l;\n"
                               "layout(location = 2) in vec3 in_v;\n"
                               "layout(location = 3) in vec3 in_sigma_a;\n"
                               "uniform float count;\n"
                               "out vec3 t, l, v, sigma_a;\n"
                               "flat out int material;\n"
                               "void main()\n"
                               "{\n"
                               "    t = in_t;\n"
                               "    l = in_l;\n"
                               "    v = in_v;\n"
                               "    sigma_a = in_sigma_a;\n"
                               "    material = 0;\n"
                               "    float x = (float(gl_VertexID) + 0.5) / count;\n"
                               "    gl_Position = vec4(2.0 * x - 1.0, 0.0, 0.0, 1.0);\n"
                               "}\n";
    const GLuint program = gl.CreateProgram();
    gl.AttachShader(program, stage(gl, GL_VERTEX_SHADER, vertex));
    gl.AttachShader(program, stage(gl, GL_FRAGMENT_SHADER, fragment));
    gl.LinkProgram(program);
    GLint good = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) {
        throw std::runtime_error("the harness does not link");
    }
    gl.UseProgram(program);
    gl.Uniform1f(gl.GetUniformLocation(program, "count"), float(count));
    const GLint sampler = gl.GetUniformLocation(program, "tsu_tables");
    if (sampler >= 0) {
        gl.Uniform1i(sampler, 0);
    }
    gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "tsu_materials"), 0);
    return program;
}

// The bytes of the two files as texture unit 0 and uniform buffer 0.
inline void upload(const gl_api &gl, const std::string &texture, const std::string &block)
{
    std::uint32_t header[6] = {};
    for (int i = 0; i < 24 && texture.size() >= 32; i++) {
        header[i / 4] |= std::uint32_t(static_cast<unsigned char>(texture[std::size_t(8 + i)]))
                         << 8 * (i % 4);
    }
    const std::size_t texels = std::size_t(header[2]) * header[3] * 8;
    if (texture.compare(0, 8, "TSUYATEX") != 0 || texture.size() != header[1] + texels) {
        throw std::runtime_error("the texture file is not what the help describes");
    }
    if (block.size() != 16384) {
        throw std::runtime_error("the block file has not 16384 bytes");
    }
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, GLsizei(header[2]), GLsizei(header[3]), 0, GL_RGBA,
                  GL_HALF_FLOAT, texture.data() + header[1]);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.GenBuffers(1, &name);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, name);
    gl.BufferData(GL_UNIFORM_BUFFER, GLsizeiptr(block.size()), block.data(), GL_STATIC_DRAW);
}

// Four floats a vertex, drawn into a line of pixels.
inline std::vector<float> drawn(const gl_api &gl, const std::vector<Vertex> &vertices)
{
    const GLsizei count = GLsizei(vertices.size());
    GLuint name = 0;
    gl.GenVertexArrays(1, &name);
    gl.BindVertexArray(name);
    gl.GenBuffers(1, &name);
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STATIC_DRAW);
    for (GLuint i = 0; i < 4; i++) {
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                               reinterpret_cast<const void *>(std::uintptr_t(12 * i)));
    }
    GLuint target = 0;
    gl.GenRenderbuffers(1, &target);
    gl.BindRenderbuffer(GL_RENDERBUFFER, target);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, count, 1);
    gl.GenFramebuffers(1, &name);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("no RGBA32F render target");
    }
    gl.Viewport(0, 0, count, 1);
    gl.DrawArrays(GL_POINTS, 0, count);
    std::vector<float> pixels(4 * vertices.size());
    gl.ReadPixels(0, 0, count, 1, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

} // namespace foreign

#endif

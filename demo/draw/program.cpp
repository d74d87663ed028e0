#include "draw/program.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace tsuya::draw {

namespace {

Expected<GLuint> compile(const gl_api &gl, GLenum stage, const std::vector<std::string> &texts)
{
    const std::string head = gl.es ? "#version 300 es\nprecision highp float;\n"
                                     "precision highp int;\nprecision highp sampler2D;\n"
                                     "precision highp sampler3D;\n"
                                   : "#version 330 core\n";
    std::vector<const char *> pieces = {head.c_str()};
    for (const std::string &text : texts) {
        pieces.push_back(text.c_str());
    }
    const GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, GLsizei(pieces.size()), pieces.data(), nullptr);
    gl.CompileShader(shader);
    GLint good = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) {
        return shader;
    }
    char log[2048] = "";
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    gl.DeleteShader(shader);
    return Error{std::string(stage == GL_VERTEX_SHADER ? "vertex" : "fragment") +
                 " shader does not compile: " + log};
}

} // namespace

std::string source(const std::string &folder, const char *name)
{
    if (!folder.empty()) {
        std::ifstream file(folder + "/" + name, std::ios::binary);
        if (file) {
            return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        }
    }
    for (const Source *s = embedded_sources; s->name; s++) {
        if (!std::strcmp(s->name, name)) {
            return s->text;
        }
    }
    return {};
}

Program::Program(Program &&other) noexcept
    : gl_(std::exchange(other.gl_, nullptr)), id_(std::exchange(other.id_, 0))
{
}

Program &Program::operator=(Program &&other) noexcept
{
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
}

Program::~Program()
{
    if (id_) {
        gl_->DeleteProgram(id_);
    }
}

void Program::set(const char *name, int value) const
{
    gl_->Uniform1i(gl_->GetUniformLocation(id_, name), value);
}

void Program::set(const char *name, float value) const
{
    gl_->Uniform1f(gl_->GetUniformLocation(id_, name), value);
}

void Program::set(const char *name, float x, float y) const
{
    gl_->Uniform2f(gl_->GetUniformLocation(id_, name), x, y);
}

void Program::set(const char *name, const glm::vec3 &value) const
{
    gl_->Uniform3fv(gl_->GetUniformLocation(id_, name), 1, &value.x);
}

void Program::set(const char *name, const glm::vec4 &value) const
{
    gl_->Uniform4f(gl_->GetUniformLocation(id_, name), value.x, value.y, value.z, value.w);
}

void Program::set(const char *name, const glm::mat4 &value) const
{
    gl_->UniformMatrix4fv(gl_->GetUniformLocation(id_, name), 1, GL_FALSE, &value[0].x);
}

void Program::set(const char *name, const std::vector<glm::vec3> &values) const
{
    if (!values.empty()) {
        gl_->Uniform3fv(gl_->GetUniformLocation(id_, name), GLsizei(values.size()), &values[0].x);
    }
}

Expected<Program> link(const gl_api &gl, const std::vector<std::string> &vertex,
                       const std::vector<std::string> &fragment)
{
    Expected<GLuint> first = compile(gl, GL_VERTEX_SHADER, vertex);
    if (!first) {
        return Error{first.error()};
    }
    Expected<GLuint> second = compile(gl, GL_FRAGMENT_SHADER, fragment);
    if (!second) {
        gl.DeleteShader(*first);
        return Error{second.error()};
    }
    Program program(&gl, gl.CreateProgram());
    gl.AttachShader(program.id(), *first);
    gl.AttachShader(program.id(), *second);
    gl.LinkProgram(program.id());
    gl.DeleteShader(*first);
    gl.DeleteShader(*second);
    GLint good = 0;
    gl.GetProgramiv(program.id(), GL_LINK_STATUS, &good);
    if (!good) {
        char log[2048] = "";
        gl.GetProgramInfoLog(program.id(), sizeof log, nullptr, log);
        return Error{std::string("program does not link: ") + log};
    }
    return Expected<Program>(std::move(program));
}

} // namespace tsuya::draw

#include "probe.h"

#include <algorithm>

namespace tsuya::command {

namespace {

// Rows of a draw lie in a rectangle of fragments; each has five texels of input side by side: 16
// numbers, then the material.
constexpr std::size_t across = 128, down = 512, chunk = across * down;
constexpr std::size_t texels = 5, floats = 4 * texels;
constexpr std::uint32_t tables_unit = 0, rows_unit = 1, block = 0;

const char vertex_main[] = "void main()\n"
                           "{\n"
                           "    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
                           "    gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);\n"
                           "}\n";

const char fragment_main[] =
    "uniform sampler2D probe_rows;\n"
    "layout(location = 0) out vec4 probe_low;\n"
    "layout(location = 1) out vec4 probe_high;\n"
    "void main()\n"
    "{\n"
    "    ivec2 at = ivec2(int(gl_FragCoord.x) * 5, int(gl_FragCoord.y));\n"
    "    float x[16];\n"
    "    for (int i = 0; i < 4; i++) {\n"
    "        vec4 four = texelFetch(probe_rows, at + ivec2(i, 0), 0);\n"
    "        x[4 * i] = four.x;\n"
    "        x[4 * i + 1] = four.y;\n"
    "        x[4 * i + 2] = four.z;\n"
    "        x[4 * i + 3] = four.w;\n"
    "    }\n"
    "    int material = int(texelFetch(probe_rows, at + ivec2(4, 0), 0).x);\n"
    "    float y[8];\n"
    "    tsu_probe(material, x, y);\n"
    "    probe_low = vec4(y[0], y[1], y[2], y[3]);\n"
    "    probe_high = vec4(y[4], y[5], y[6], y[7]);\n"
    "}\n";

tsu_target target_of(const gl_api &gl)
{
    return gl_at_least(&gl, 0, 4, 5)   ? TSU_TARGET_450
           : gl_at_least(&gl, 0, 4, 1) ? TSU_TARGET_410
                                       : TSU_TARGET_330;
}

} // namespace

Probe::Probe(Host &host, const Function &function) : host_(host), function_(function)
{
}

Probe::~Probe()
{
    tsu_gl_destroy(guest_);
    offscreen_destroy(context_); // and with it every object
}

std::unique_ptr<Probe> Probe::create(Host &host, const Function &function, std::string &error)
{
    std::unique_ptr<Probe> probe(new Probe(host, function));
    if (!probe->open(error) || !probe->compile(error) || !probe->make_targets(error)) {
        return nullptr;
    }
    return probe;
}

bool Probe::open(std::string &error)
{
    const int versions[][2] = {{4, 5}, {4, 1}, {3, 3}};
    std::string reasons;
    for (const offscreen_backend backend : {OFFSCREEN_EGL, OFFSCREEN_OSMESA}) {
        char reason[512] = "";
        for (const auto &version : versions) {
            const offscreen_desc desc = {backend, OFFSCREEN_GL, version[0], version[1]};
            if (!context_ && !offscreen_create(&desc, &context_, reason, sizeof reason)) {
                context_ = nullptr;
            }
        }
        reasons += context_ ? "" : std::string(reasons.empty() ? "" : "; ") + reason;
    }
    if (!context_) {
        error = "no OpenGL 3.3 without a window on this machine: " + reasons;
        return false;
    }
    const char *missing = nullptr;
    if (!gl_load(&gl_, offscreen_proc, context_, &missing)) {
        error = std::string("OpenGL lacks ") + (missing ? missing : "a function") + ".";
        return false;
    }
    tsu_gl_desc desc;
    tsu_gl_desc_init(&desc);
    desc.get_proc_address = offscreen_proc;
    desc.user = context_;
    const tsu_status status = tsu_gl_create(host_.context(), &desc, &guest_);
    error = status == TSU_OK ? "" : host_.why(status);
    return status == TSU_OK;
}

std::string Probe::message(const tsu_shader *shader, std::uint32_t object) const
{
    std::string log(4096, '\0');
    GLsizei size = 0;
    gl_.GetShaderInfoLog(object, GLsizei(log.size()), &size, &log[0]);
    log.resize(std::size_t(size));
    std::string sources;
    for (std::uint32_t i = 0; const char *source = tsu_shader_source(shader, i); i++) {
        sources += (i ? ", " : " (sources: ") + std::to_string(i) + " " + source;
    }
    return "the driver refuses the shader" + sources + (sources.empty() ? "" : ")") + ": " + log;
}

bool Probe::compile(std::string &error)
{
    tsu_shader_desc desc;
    tsu_shader_desc_init(&desc);
    desc.flags = TSU_SHADER_PROBE;
    desc.target = target_of(gl_);
    desc.model_count = 1;
    desc.models = &function_.model;
    desc.function = function_.index;
    tsu_shader *shader = nullptr;
    const tsu_status status = tsu_shader_create(host_.context(), &desc, &shader);
    if (status != TSU_OK) {
        error = host_.why(status);
        return false;
    }
    const char *const version = tsu_target_version(desc.target);
    const char *const texts[2][3] = {{version, vertex_main, ""},
                                     {version, tsu_shader_text(shader, nullptr), fragment_main}};
    const GLenum stages[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    program_ = gl_.CreateProgram();
    GLint good = 1;
    for (int i = 0; i < 2 && good; i++) {
        const GLuint stage = gl_.CreateShader(stages[i]);
        gl_.ShaderSource(stage, 3, texts[i], nullptr);
        gl_.CompileShader(stage);
        gl_.GetShaderiv(stage, GL_COMPILE_STATUS, &good);
        if (!good) {
            error = message(shader, stage);
        }
        gl_.AttachShader(program_, stage);
        gl_.DeleteShader(stage);
    }
    tsu_shader_destroy(shader);
    if (!good) {
        return false;
    }
    gl_.LinkProgram(program_);
    gl_.GetProgramiv(program_, GL_LINK_STATUS, &good);
    if (!good) {
        char log[1024] = "";
        gl_.GetProgramInfoLog(program_, sizeof log, nullptr, log);
        error = std::string("the driver cannot link the shader: ") + log;
        return false;
    }
    const tsu_status setup = tsu_gl_program_setup(guest_, program_, tables_unit, block);
    error = setup == TSU_OK ? "" : host_.why(setup);
    return setup == TSU_OK;
}

bool Probe::make_targets(std::string &error)
{
    const auto texture = [&](std::size_t width) {
        GLuint name = 0;
        gl_.GenTextures(1, &name);
        gl_.BindTexture(GL_TEXTURE_2D, name);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, GLsizei(width), GLsizei(down), 0, GL_RGBA,
                       GL_FLOAT, nullptr);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        return name;
    };
    gl_.GenVertexArrays(1, &vertices_);
    gl_.BindVertexArray(vertices_);
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const GLenum attachments[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl_.ActiveTexture(GL_TEXTURE0 + rows_unit);
    for (int i = 0; i < 2; i++) {
        targets_[i] = texture(across);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachments[i], GL_TEXTURE_2D, targets_[i], 0);
        results_[i].resize(chunk * 4);
    }
    gl_.DrawBuffers(2, attachments);
    rows_texture_ = texture(across * texels);
    upload_.resize(chunk * floats);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        error = "the driver cannot draw into RGBA32F textures.";
        return false;
    }
    gl_.UseProgram(program_);
    gl_.Uniform1i(gl_.GetUniformLocation(program_, "probe_rows"), GLint(rows_unit));
    return true;
}

bool Probe::sync(const tsu_set *set, std::string &error)
{
    const tsu_status status = tsu_gl_sync(guest_, set);
    error = status == TSU_OK ? "" : host_.why(status);
    return status == TSU_OK;
}

void Probe::draw(std::size_t rows)
{
    const GLsizei height = GLsizei((rows + across - 1) / across);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, GLsizei(across * texels), height, GL_RGBA, GL_FLOAT,
                      upload_.data());
    gl_.Viewport(0, 0, GLsizei(across), height);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    for (int i = 0; i < (function_.outputs.size() > 4 ? 2 : 1); i++) {
        gl_.ReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + i));
        gl_.ReadPixels(0, 0, GLsizei(across), height, GL_RGBA, GL_FLOAT, results_[i].data());
    }
}

bool Probe::ask(std::uint32_t page, const std::vector<Row> &rows, const std::vector<double> &in,
                std::vector<double> &out, std::string &error)
{
    const tsu_status status = tsu_gl_bind(guest_, page, tables_unit, block);
    if (status != TSU_OK) {
        error = host_.why(status);
        return false;
    }
    const std::size_t inputs = function_.inputs.size(), outputs = function_.outputs.size();
    for (std::size_t from = 0; from < rows.size(); from += chunk) {
        const std::size_t count = std::min(chunk, rows.size() - from);
        // The last line of the rectangle may hold fewer rows; the rest repeats the first row, so
        // that no fragment computes with what an earlier draw left.
        const std::size_t filled = (count + across - 1) / across * across;
        for (std::size_t i = 0; i < filled; i++) {
            const Row &row = rows[from + (i < count ? i : 0)];
            float *const to = &upload_[i * floats];
            for (std::size_t k = 0; k < inputs; k++) {
                to[k] = float(in[row.row * inputs + k]);
            }
            to[16] = float(row.material);
        }
        draw(count);
        for (std::size_t i = 0; i < count; i++) {
            for (std::size_t k = 0; k < outputs; k++) {
                out[rows[from + i].row * outputs + k] = double(results_[k / 4][4 * i + k % 4]);
            }
        }
    }
    const GLenum code = gl_.GetError();
    if (code != GL_NO_ERROR) {
        error = "OpenGL error " + std::to_string(code) + " while drawing.";
    }
    return code == GL_NO_ERROR;
}

} // namespace tsuya::command

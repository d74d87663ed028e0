#include "bench/stage.h"

#include <tsuya/tsuya.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace tsuya::bench
{

namespace
{

constexpr std::uint32_t unit = 0, page_block = 0, baseline_block = 1;

// Cells along a side: enough that directions between corners stay nearly unit vectors.
constexpr int cells = 4;

// Strips of triangles, one an instance. Light and viewer go around the fibre; as a normal, t sees
// both on either side. u runs with x, w with y.
const char vertex_text[] = R"(
out vec3 t, l, v, sigma_a;
flat out int material;
out float front, behind, direct, transmittance, pigment, thickness;
uniform int chosen;

vec3 direction(float theta, float phi)
{
    return vec3(cos(theta) * cos(phi), cos(theta) * sin(phi), sin(theta));
}

void main()
{
    float u = float(gl_VertexID / 2) / 4.0;
    float w = float(gl_InstanceID + gl_VertexID % 2) / 4.0;
    t = normalize(vec3(0.2 * u, 0.1 * w, 1.0));
    l = direction(1.2 * sin(4.0 * w + u), 0.3 + 2.0 * u);
    v = direction(2.2 * w - 1.1, 0.4 - 0.8 * u);
    sigma_a = mix(vec3(0.05, 0.15, 0.4), vec3(1.2, 0.5, 0.1), vec3(u, w, 1.0 - u));
    front = 6.0 * u * w;
    behind = 8.0 * (1.0 - w);
    direct = exp(-front);
    transmittance = direct;
    pigment = 0.3 + 1.4 * u;
    thickness = 0.6 + 1.2 * w;
    material = chosen;
    gl_Position = vec4(2.0 * u - 1.0, 2.0 * w - 1.0, 0.0, 1.0);
}
)";

void require(tsu_status status, const char *what)
{
    if (status != TSU_OK) {
        throw std::runtime_error(std::string(what) + ": " + tsu_status_text(status));
    }
}

} // namespace

Context::Context()
{
    const int versions[][2] = {{4, 5}, {4, 1}, {3, 3}};
    char reason[512] = "";
    for (const auto &version : versions) {
        const offscreen_desc desc = {OFFSCREEN_ANY, OFFSCREEN_GL, version[0], version[1]};
        if (!context_ && !offscreen_create(&desc, &context_, reason, sizeof reason)) {
            context_ = nullptr;
        }
    }
    if (!context_) {
        throw std::runtime_error(std::string("no OpenGL 3.3 without a window: ") + reason);
    }
    const char *missing = nullptr;
    if (!gl_load(&gl_, offscreen_proc, context_, &missing)) {
        offscreen_destroy(context_);
        throw std::runtime_error(std::string("OpenGL lacks ") + (missing ? missing : "a function"));
    }
}

Context::~Context()
{
    offscreen_destroy(context_);
}

std::string Context::description() const
{
    return offscreen_description(context_);
}

std::string Context::driver() const
{
    const std::string name = reinterpret_cast<const char *>(gl_.GetString(GL_RENDERER));
    std::string word = name.substr(0, name.find(' '));
    std::transform(word.begin(), word.end(), word.begin(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c))
                   ? char(std::tolower(static_cast<unsigned char>(c)))
                   : '_';
    });
    return word;
}

bool Context::software() const
{
    const std::string word = driver();
    return word == "llvmpipe" || word == "softpipe" || word == "swr" || word == "software";
}

Stage::Stage(const Context &context, tsu_context *library, int size)
    : gl_(context.gl()), library_(library), size_(size)
{
    tsu_set_desc set_desc;
    tsu_set_desc_init(&set_desc);
    require(tsu_set_create(library, &set_desc, &set_), "making a set");
    for (const Tier &tier : tiers()) {
        const auto kind = std::make_pair(tier.model, params_flags(tier));
        if (std::find(kinds_.begin(), kinds_.end(), kind) == kinds_.end()) {
            std::uint32_t material = 0;
            require(tsu_set_add(set_, tier.model, parameters(tier).data(), &material), tier.name);
            kinds_.push_back(kind);
        }
    }
    require(tsu_set_bake(set_), "baking");
    tsu_gl_desc desc;
    tsu_gl_desc_init(&desc);
    desc.get_proc_address = offscreen_proc;
    desc.user = context.user();
    require(tsu_gl_create(library, &desc, &guest_), "tsu_gl_create");
    require(tsu_gl_sync(guest_, set_), "tsu_gl_sync");
    require(tsu_gl_bind(guest_, 0, unit, page_block), "tsu_gl_bind");
    open();
}

Stage::~Stage()
{
    gl_.DeleteVertexArrays(1, &vertices_);
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteTextures(1, &target_);
    gl_.DeleteBuffers(1, &block_);
    tsu_gl_destroy(guest_);
    tsu_set_destroy(set_);
}

void Stage::open()
{
    gl_.GenVertexArrays(1, &vertices_);
    gl_.BindVertexArray(vertices_);
    gl_.GenTextures(1, &target_);
    gl_.ActiveTexture(GL_TEXTURE0 + unit + 1);
    gl_.BindTexture(GL_TEXTURE_2D, target_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, size_, size_, 0, GL_RGBA, GL_FLOAT, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_, 0);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("the driver cannot draw into RGBA16F textures");
    }
    gl_.Viewport(0, 0, size_, size_);
    gl_.GenBuffers(1, &block_);
    gl_.BindBuffer(GL_UNIFORM_BUFFER, block_);
    // Of GGX, reflectance and roughness; of Kajiya-Kay, colour and exponent.
    const float surface[4] = {0.04f, 0.04f, 0.04f, 0.3f};
    gl_.BufferData(GL_UNIFORM_BUFFER, sizeof surface, surface, GL_STATIC_DRAW);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, baseline_block, block_);
}

draw::Program Stage::link(const std::string &fragment) const
{
    draw::Expected<draw::Program> program = draw::link(gl_, {vertex_text}, {fragment});
    if (!program) {
        throw std::runtime_error(program.error());
    }
    gl_.UseProgram(program->id());
    return std::move(*program);
}

draw::Program Stage::tier(const Tier &tier)
{
    draw::Program program = link(fragment(library_, tier));
    require(tsu_gl_program_setup(guest_, program.id(), unit, page_block), "tsu_gl_program_setup");
    const auto at =
        std::find(kinds_.begin(), kinds_.end(), std::make_pair(tier.model, params_flags(tier))) -
        kinds_.begin();
    program.set("chosen", int(at));
    const GLint numbers = gl_.GetUniformLocation(program.id(), "numbers");
    if (numbers >= 0) {
        float values[72];
        require(tsu_leaf_body_uniform(set_, std::uint32_t(at), 1.0f, 1.0f, values),
                "tsu_leaf_body_uniform");
        gl_.UniformMatrix3x4fv(numbers, 6, GL_FALSE, values);
    }
    return program;
}

draw::Program Stage::baseline(const std::string &name)
{
    draw::Program program = link(bench::baseline(name));
    for (const char *block : {"surface_block", "fibre_block"}) {
        const GLuint index = gl_.GetUniformBlockIndex(program.id(), block);
        if (index != GL_INVALID_INDEX) {
            gl_.UniformBlockBinding(program.id(), index, baseline_block);
        }
    }
    return program;
}

void Stage::draw(const draw::Program &program)
{
    gl_.UseProgram(program.id());
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (cells + 1), cells);
}

std::vector<float> Stage::pixels() const
{
    std::vector<float> values(std::size_t(size_) * std::size_t(size_) * 4);
    gl_.ReadPixels(0, 0, size_, size_, GL_RGBA, GL_FLOAT, values.data());
    return values;
}

} // namespace tsuya::bench

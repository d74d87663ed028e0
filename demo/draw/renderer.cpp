#include "draw/renderer.h"

#include <tsuya/models/deep_opacity.h>
#include <tsuya/models/opacity_shadow.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <utility>

namespace tsuya::draw {

namespace {

int groups(const std::vector<Light> &lights)
{
    return (int(lights.size()) + 3) / 4;
}

// Lights, then the sky, each filled up to a multiple of four with lights of no colour.
std::vector<Light> grouped(const Frame &frame)
{
    const Light none = {glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f)};
    std::vector<Light> all = frame.lights;
    all.resize(std::size_t(4 * groups(frame.lights)), none);
    all.insert(all.end(), frame.sky.begin(), frame.sky.end());
    all.resize(std::size_t(4 * (groups(frame.lights) + groups(frame.sky))), none);
    return all;
}

// Share of light that a fibre takes, of all channels; not 0, which powers could not be taken of.
float opacity(const Frame &frame)
{
    return std::max((frame.loss.x + frame.loss.y + frame.loss.z) / 3.0f, 1e-3f);
}

} // namespace

Expected<std::unique_ptr<Renderer>> Renderer::create(tsu_gl_proc_fn proc, void *user,
                                                     const Folders &folders)
{
    std::unique_ptr<Renderer> self(new Renderer);
    const char *missing = nullptr;
    if (!gl_load(&self->gl_, proc, user, &missing)) {
        return Error{std::string("OpenGL is not complete: ") + (missing ? missing : "unknown")};
    }
    Expected<std::unique_ptr<Shading>> shading = Shading::create(self->gl_, proc, user, folders);
    if (!shading) {
        return Error{shading.error()};
    }
    self->shading_ = std::move(*shading);
    self->strands_ = std::make_unique<Strands>(&self->gl_);
    self->maps_ = std::make_unique<Maps>(&self->gl_);
    self->sky_ = std::make_unique<Target>(&self->gl_);
    self->samples_ = std::make_unique<Target>(&self->gl_);
    self->resolved_ = std::make_unique<Target>(&self->gl_);
    self->shown_ = std::make_unique<Target>(&self->gl_);
    Expected<bool> built = self->build();
    if (!built) {
        return Error{built.error()};
    }
    self->gl_.GenVertexArrays(1, &self->empty_);
    self->gl_.GenTextures(1, &self->fibres_);
    self->gl_.GenTextures(1, &self->beyond_);
    self->gl_.GenVertexArrays(1, &self->head_array_);
    self->gl_.GenBuffers(1, &self->head_vertices_);
    self->gl_.GenBuffers(1, &self->head_elements_);
    return Expected<std::unique_ptr<Renderer>>(std::move(self));
}

Renderer::~Renderer()
{
    gl_.DeleteVertexArrays(1, &empty_);
    gl_.DeleteTextures(1, &fibres_);
    gl_.DeleteTextures(1, &beyond_);
    gl_.DeleteVertexArrays(1, &head_array_);
    gl_.DeleteBuffers(1, &head_vertices_);
    gl_.DeleteBuffers(1, &head_elements_);
}

Expected<bool> Renderer::build()
{
    const auto text = [&](const char *name) { return source(shading_->folders().demo, name); };
    Expected<Program> head = link(gl_, {text("head.vert.glsl")},
                                  {text("light.glsl"), text("head.frag.glsl")});
    Expected<Program> resolve = link(gl_, {text("screen.vert.glsl")}, {text("resolve.frag.glsl")});
    Expected<Program> display = link(gl_, {text("screen.vert.glsl")}, {text("display.frag.glsl")});
    Expected<Program> identity = link(gl_, {text("strand.vert.glsl")},
                                      {text("coverage.glsl"), text("identity.frag.glsl")});
    for (const Expected<Program> *program : {&head, &resolve, &display, &identity}) {
        if (!*program) {
            return Error{program->error()};
        }
    }
    head_program_ = std::move(*head);
    resolve_ = std::move(*resolve);
    display_ = std::move(*display);
    identity_ = std::move(*identity);
    return true;
}

Expected<bool> Renderer::reload()
{
    Expected<bool> built = build();
    return built ? shading_->reload() : std::move(built);
}

Expected<bool> Renderer::material(const tsu_model *model, const void *params)
{
    return shading_->set(model, params);
}

Expected<bool> Renderer::load(const groom::Groom &groom, const groom::Mesh &head,
                              const Solid &solid)
{
    if (!strands_->load(groom)) {
        return Error{"the groom has " + std::to_string(groom.points.size()) +
                     " points, more than this context's textures hold"};
    }
    groom_ = groom;
    solid_ = solid;
    maps_->load(groom);
    grid_scale_ = 0.0f;
    swept_.clear();

    std::vector<glm::vec3> vertices;
    for (std::size_t i = 0; i < head.positions.size(); i++) {
        vertices.push_back(head.positions[i]);
        vertices.push_back(head.normals[i]);
    }
    gl_.BindVertexArray(head_array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, head_vertices_);
    gl_.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof vertices[0]),
                   vertices.data(), GL_STATIC_DRAW);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, head_elements_);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(head.indices.size() * 4),
                   head.indices.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; i++) {
        const std::size_t offset = i * sizeof(glm::vec3);
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3),
                                reinterpret_cast<const void *>(offset));
    }
    head_count_ = GLsizei(head.indices.size());
    return true;
}

// Sweeps towards all lights, or away from them with sign -1, as one texture.
void Renderer::sweep(const std::vector<glm::vec3> &directions, GLuint texture, float sign)
{
    const glm::ivec3 size = grid_.size();
    const std::size_t cells = grid_.density().size();
    const std::size_t slabs = (directions.size() + 3) / 4;
    std::vector<float> texels(cells * slabs * 4, 0.0f);
    for (std::size_t i = 0; i < directions.size(); i++) {
        const std::vector<float> fibres = grid_.sweep(sign * directions[i]);
        float *slab = texels.data() + (i / 4) * cells * 4 + i % 4;
        for (std::size_t c = 0; c < cells; c++) {
            slab[4 * c] = std::min(fibres[c], 1000.0f);
        }
    }
    gl_.ActiveTexture(GL_TEXTURE3);
    gl_.BindTexture(GL_TEXTURE_3D, texture);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA16F, size.x, size.y, GLsizei(size.z * int(slabs)), 0,
                   GL_RGBA, GL_FLOAT, texels.data());
    for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        gl_.TexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
    }
    gl_.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
}

// The grid's shadows, again only when a light has turned against the groom.
void Renderer::shadows(const Frame &frame)
{
    map_shadows(frame);
    if (frame.shadow == Shadow::none) {
        return;
    }
    if (grid_scale_ != frame.width_scale) {
        grid_.fill(groom_, solid_, frame.width_scale);
        grid_scale_ = frame.width_scale;
        swept_.clear();
    }
    const glm::mat3 back = glm::transpose(glm::mat3(frame.model));
    std::vector<glm::vec3> directions;
    for (const Light &light : grouped(frame)) {
        directions.push_back(glm::normalize(back * light.direction));
    }
    const bool beyond = shading_->beyond();
    if (directions != swept_) {
        sweep(directions, fibres_, 1.0f);
    }
    if (beyond && (directions != swept_ || !swept_beyond_)) {
        sweep(directions, beyond_, -1.0f);
    }
    swept_beyond_ = beyond && !directions.empty();
    swept_ = directions;
}

// Maps of the first lights, when they are asked for and the context can draw them.
void Renderer::map_shadows(const Frame &frame)
{
    mapped_ = false;
    note_.clear();
    if (frame.shadow != Shadow::deep_opacity && frame.shadow != Shadow::opacity_shadow) {
        return;
    }
    MapsAsked asked;
    asked.technique = frame.shadow == Shadow::deep_opacity ? tsu_deep_opacity()
                                                           : tsu_opacity_shadow();
    asked.layers = frame.shadow_layers;
    asked.size = frame.shadow_size;
    asked.opacity = opacity(frame);
    asked.width_scale = frame.width_scale;
    asked.taper = frame.taper;
    asked.model = frame.model;
    for (const Light &light : frame.lights) {
        if (int(asked.directions.size()) < maps_most) {
            asked.directions.push_back(light.direction);
        }
    }
    if (asked.directions.empty()) {
        return;
    }
    const Expected<const Shading::MapPrograms *> programs = shading_->maps(asked.technique);
    if (!programs) {
        note_ = "shadow from the grid: " + programs.error();
        return;
    }
    mapped_ = maps_->draw(shading_->context(), asked, (*programs)->front, (*programs)->layers,
                          *strands_);
    if (!mapped_) {
        note_ = "shadow from the grid: " + maps_->why();
    } else if (frame.lights.size() > asked.directions.size()) {
        note_ = "lights past the first " + std::to_string(maps_most) + " have the grid's shadow";
    }
}

void Renderer::lights(const Program &program, const Frame &frame, Which which) const
{
    std::vector<glm::vec3> directions, colors;
    for (const Light &light : grouped(frame)) {
        directions.push_back(light.direction);
        colors.push_back(light.irradiance);
    }
    const int middle = groups(frame.lights), end = middle + groups(frame.sky);
    program.set("u_groups_begin", which == Which::sky ? middle : 0);
    program.set("u_groups_end", which == Which::lights ? middle : end);
    program.set("u_light_direction", directions);
    program.set("u_light_color", colors);
    program.set("u_loss", frame.loss);
    program.set("u_fibres", 3);
    program.set("u_slab", frame.shadow != Shadow::none && !directions.empty() ? float(grid_.size().z) : 0.0f);
    const glm::vec3 extent = glm::vec3(grid_.size()) * grid_.cell();
    program.set("u_to_grid", glm::scale(glm::mat4(1.0f), 1.0f / glm::max(extent, 1e-9f)) *
                                 glm::translate(glm::mat4(1.0f), -grid_.corner()) *
                                 glm::inverse(frame.model));
    gl_.ActiveTexture(GL_TEXTURE3);
    gl_.BindTexture(GL_TEXTURE_3D, fibres_);
    program.set("u_beyond", 8);
    gl_.ActiveTexture(GL_TEXTURE8);
    gl_.BindTexture(GL_TEXTURE_3D, beyond_);
    program.set("u_opacity", opacity(frame));
    program.set("u_to_solid", to_solid(frame));
    maps_->bind(program, 5, mapped_ && which == Which::lights);
}

// World to the space where the head is the unit sphere; all 0 without one.
glm::mat4 Renderer::to_solid(const Frame &frame) const
{
    if (solid_.semi_axes == glm::vec3(0.0f)) {
        return glm::mat4(0.0f);
    }
    // Well inside the surface, or hair that lies on it would be in its shadow, as in the grid.
    const glm::vec3 axes = 0.92f * solid_.semi_axes;
    return glm::scale(glm::mat4(1.0f), 1.0f / axes) *
           glm::translate(glm::mat4(1.0f), -solid_.centre) * glm::inverse(frame.model);
}

void Renderer::sky(const Frame &frame)
{
    sky_->bind();
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_DEPTH_TEST);
    const Program &program = shading_->bind_sky();
    lights(program, frame, Which::sky);
    program.set("u_points", 1);
    program.set("u_strands", 2);
    program.set("u_model", frame.model);
    program.set("u_eye", frame.eye);
    program.set("u_sigma_a", frame.sigma_a);
    program.set("u_variation", frame.variation);
    program.set("u_samples", frame.sky_samples);
    program.set("u_sky_lights", float(frame.sky.size()));
    strands_->bind();
    gl_.BindVertexArray(empty_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::strands(const Program &program, const Frame &frame, int width, int height) const
{
    program.set("u_points", 1);
    program.set("u_strands", 2);
    program.set("u_sky", 4);
    gl_.ActiveTexture(GL_TEXTURE4);
    gl_.BindTexture(GL_TEXTURE_2D, sky_->texture());
    program.set("u_model", frame.model);
    program.set("u_view_projection", frame.projection * frame.view);
    program.set("u_half_size", 0.5f * float(width), 0.5f * float(height));
    const float scale = glm::length(glm::vec3(frame.model[0]));
    program.set("u_pixel_scale", frame.projection[1].y * 0.5f * float(height) * scale);
    program.set("u_width_scale", frame.width_scale);
    program.set("u_taper", frame.taper);
    strands_->draw();
}

void Renderer::head(const Frame &frame)
{
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
    if (!frame.head || head_count_ == 0) {
        return;
    }
    gl_.UseProgram(head_program_.id());
    lights(head_program_, frame, Which::both);
    head_program_.set("u_model", frame.model);
    head_program_.set("u_view_projection", frame.projection * frame.view);
    head_program_.set("u_albedo", frame.skin);
    head_program_.set("u_lift", 1.5f * grid_.cell());
    gl_.BindVertexArray(head_array_);
    gl_.DrawElements(GL_TRIANGLES, head_count_, GL_UNSIGNED_INT, nullptr);
}

} // namespace tsuya::draw

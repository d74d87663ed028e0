#include "draw/renderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <utility>

namespace tsuya::draw {

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
    self->screen_ = std::make_unique<Screen>(&self->gl_);
    Expected<bool> built = self->build();
    if (!built) {
        return Error{built.error()};
    }
    self->gl_.GenTextures(1, &self->fibres_);
    self->gl_.GenTextures(1, &self->beyond_);
    self->gl_.GenVertexArrays(1, &self->head_array_);
    self->gl_.GenBuffers(1, &self->head_vertices_);
    self->gl_.GenBuffers(1, &self->head_elements_);
    return Expected<std::unique_ptr<Renderer>>(std::move(self));
}

Renderer::~Renderer()
{
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
                                  {text("light.glsl"), text("area_light.glsl"),
                                   text("head.frag.glsl")});
    Expected<Program> identity = link(gl_, {text("strand.vert.glsl")},
                                      {text("coverage.glsl"), text("identity.frag.glsl")});
    for (const Expected<Program> *program : {&head, &identity}) {
        if (!*program) {
            return Error{program->error()};
        }
    }
    Expected<bool> screen = screen_->build(shading_->folders().demo);
    if (!screen) {
        return screen;
    }
    head_program_ = std::move(*head);
    identity_ = std::move(*identity);
    return true;
}

Expected<bool> Renderer::reload()
{
    Expected<bool> built = build();
    return built ? shading_->reload() : std::move(built);
}

Expected<bool> Renderer::material(const tsu_model *model, const void *params,
                                 const std::string &variant)
{
    return shading_->set(model, params, variant);
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
    gl_.Uniform4fv(gl_.GetUniformLocation(program.id(), "u_surroundings"), 9,
                   frame.surroundings.data());
    strands_->bind();
    gl_.BindVertexArray(screen_->empty());
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
    // Two halves of an opaque joint that cover this much lose less than 1 part in 16 of one pixel.
    program.set("u_thin", 0.25f);
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

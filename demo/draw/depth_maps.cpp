#include "draw/depth_maps.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace tsuya::draw {

DepthMaps::~DepthMaps()
{
    gl_->DeleteFramebuffers(2, framebuffers_);
    gl_->DeleteTextures(2, textures_);
}

bool DepthMaps::target(int size)
{
    if (size == size_) {
        return true;
    }
    if (!textures_[0]) {
        gl_->GenTextures(2, textures_);
        gl_->GenFramebuffers(2, framebuffers_);
    }
    size_ = size;
    for (int i = 0; i < 2; i++) {
        gl_->ActiveTexture(GL_TEXTURE1);
        gl_->BindTexture(GL_TEXTURE_2D, textures_[i]);
        gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT,
                        GL_UNSIGNED_INT, nullptr);
        gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[i]);
        gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, textures_[i],
                                  0);
        const GLenum none = GL_NONE;
        gl_->DrawBuffers(1, &none);
        gl_->ReadBuffer(GL_NONE);
        if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            size_ = 0;
        }
    }
    return size_ > 0;
}

bool DepthMaps::draw(const Program &depth, const Program &second, const Plant &plant,
                     const View &view, const glm::vec3 &centre, float radius, int size)
{
    to_map_.clear();
    cameras_.clear();
    if (size == 0 || view.lights.empty()) {
        return true;
    }
    if (!target(2 * size)) {
        return false;
    }
    texel_ = 2.0f * radius / float(size);
    const std::size_t count = std::min(view.lights.size(), std::size_t(depth_maps_most));
    for (std::size_t i = 0; i < count; i++) {
        const glm::vec3 l = view.lights[i].direction;
        const glm::vec3 up =
            std::abs(l.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
        const glm::mat4 look = glm::lookAt(centre + 2.0f * radius * l, centre, up);
        const glm::mat4 box = glm::ortho(-radius, radius, -radius, radius, radius, 3.0f * radius);
        cameras_.push_back(box * look);
        const glm::mat4 to_tile =
            glm::scale(glm::translate(glm::mat4(1.0f), {0.5f, 0.5f, 0.5f}), glm::vec3(0.5f));
        to_map_.push_back(to_tile * box * look);
    }
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    gl_->DepthMask(GL_TRUE);
    gl_->Disable(GL_CULL_FACE);
    gl_->Disable(GL_SCISSOR_TEST);
    pass(depth, plant, view, 0);
    gl_->UseProgram(second.id());
    gl_->ActiveTexture(GL_TEXTURE3);
    gl_->BindTexture(GL_TEXTURE_2D, textures_[0]);
    second.set("u_first", 3);
    // Two texels deep in a depth of two radii: the same leaf.
    second.set("u_same", 2.0f * texel_ / (2.0f * radius));
    pass(second, plant, view, 1);
    return true;
}

void DepthMaps::pass(const Program &program, const Plant &plant, const View &view, int layer) const
{
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[layer]);
    gl_->Clear(GL_DEPTH_BUFFER_BIT);
    gl_->UseProgram(program.id());
    program.set("u_model", view.model);
    const int size = size_ / 2;
    for (int i = 0; i < int(cameras_.size()); i++) {
        gl_->Viewport(i % 2 * size, i / 2 * size, size, size);
        program.set("u_view_projection", cameras_[std::size_t(i)]);
        program.set("u_opaque", 0);
        plant.blades();
        program.set("u_opaque", 1);
        plant.wood();
    }
}

void DepthMaps::bind(const Program &program, int unit) const
{
    static const char *const names[] = {"u_depths", "u_depths_second"};
    for (int i = 0; i < 2; i++) {
        gl_->ActiveTexture(GLenum(GL_TEXTURE0 + unit + i));
        gl_->BindTexture(GL_TEXTURE_2D, textures_[i]);
        program.set(names[i], unit + i);
    }
    program.set("u_depth_maps", int(to_map_.size()));
    program.set("u_depth_texel", texel_);
    if (!to_map_.empty()) {
        gl_->UniformMatrix4fv(gl_->GetUniformLocation(program.id(), "u_to_depth"),
                              GLsizei(to_map_.size()), GL_FALSE, &to_map_[0][0].x);
    }
}

} // namespace tsuya::draw

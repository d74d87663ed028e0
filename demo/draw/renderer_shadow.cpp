// The renderer's lights and what dims them.
#include "draw/renderer.h"

#include <tsuya/models/deep_opacity.h>
#include <tsuya/models/opacity_shadow.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>

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

// Sweeps towards all lights, or beyond, away from them, as one texture.
void Renderer::sweep(const std::vector<glm::vec3> &directions, GLuint texture, bool beyond)
{
    const glm::ivec3 size = grid_.size();
    const std::size_t cells = grid_.density().size();
    const std::size_t slabs = (directions.size() + 3) / 4;
    std::vector<float> texels(cells * slabs * 4, 0.0f);
    for (std::size_t i = 0; i < directions.size(); i++) {
        const std::vector<float> fibres =
            beyond ? grid_.beyond(directions[i]) : grid_.sweep(directions[i]);
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
    if (grid_scale_ != frame.width_scale || grid_head_ != frame.head) {
        grid_.fill(groom_, solid_, !frame.head, frame.width_scale);
        grid_scale_ = frame.width_scale;
        grid_head_ = frame.head;
        swept_.clear();
    }
    const glm::mat3 back = glm::transpose(glm::mat3(frame.model));
    std::vector<glm::vec3> directions;
    for (const Light &light : grouped(frame)) {
        directions.push_back(glm::normalize(back * light.direction));
    }
    const bool beyond = shading_->beyond();
    if (directions != swept_) {
        sweep(directions, fibres_, false);
    }
    if (beyond && (directions != swept_ || !swept_beyond_)) {
        sweep(directions, beyond_, true);
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
    asked.technique =
        frame.shadow == Shadow::deep_opacity ? tsu_deep_opacity() : tsu_opacity_shadow();
    asked.layers = frame.shadow_layers;
    asked.size = frame.shadow_size;
    asked.opacity = opacity(frame);
    asked.width_scale = frame.width_scale;
    asked.taper = frame.taper;
    asked.model = frame.model;
    asked.to_solid = frame.head ? to_solid(frame) : glm::mat4(0.0f);
    asked.neck = neck(frame);
    asked.neck_span = neck_span(frame);
    for (const Light &light : frame.lights) {
        if (int(asked.lights.size()) < maps_most) {
            asked.lights.push_back(light.placed() ? glm::vec4(light.record[0], light.record[1],
                                                              light.record[2], 1.0f)
                                                  : glm::vec4(light.direction, 0.0f));
        }
    }
    if (asked.lights.empty()) {
        return;
    }
    const Expected<const Shading::MapPrograms *> programs = shading_->maps(asked.technique);
    if (!programs) {
        note_ = "shadow from the grid: " + programs.error();
        return;
    }
    mapped_ =
        maps_->draw(shading_->context(), asked, (*programs)->front, (*programs)->layers, *strands_);
    if (!mapped_) {
        note_ = "shadow from the grid: " + maps_->why();
    } else if (frame.lights.size() > asked.lights.size()) {
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
    std::vector<float> records;
    const std::size_t areas = std::min(frame.lights.size(), std::size_t(areas_most));
    for (std::size_t i = 0; i < areas && which != Which::sky; i++) {
        const std::array<float, 16> &record = frame.lights[i].record;
        records.insert(records.end(), record.begin(), record.end());
    }
    program.set("u_areas", int(records.size() / 16));
    if (!records.empty()) {
        gl_.Uniform4fv(gl_.GetUniformLocation(program.id(), "u_area"), GLsizei(records.size() / 4),
                       records.data());
    }
    program.set("u_loss", frame.loss);
    program.set("u_fibres", 3);
    const bool dimmed = frame.shadow != Shadow::none && !directions.empty();
    program.set("u_slab", dimmed ? float(grid_.size().z) : 0.0f);
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
    program.set("u_neck", neck(frame));
    program.set("u_neck_span", neck_span(frame).x, neck_span(frame).y);
    maps_->bind(program, 5, mapped_ && which == Which::lights);
}

// The head is drawn so much smaller: head.vert.glsl.
constexpr float inset = 0.0015f;

// World to the space where the head is the unit sphere; all 0 without one, and without shadow.
glm::mat4 Renderer::to_solid(const Frame &frame) const
{
    if (solid_.semi_axes == glm::vec3(0.0f) || frame.shadow == Shadow::none) {
        return glm::mat4(0.0f);
    }
    const glm::vec3 axes = solid_.semi_axes - inset;
    return glm::scale(glm::mat4(1.0f), 1.0f / axes) *
           glm::translate(glm::mat4(1.0f), -solid_.centre) * glm::inverse(frame.model);
}

// The neck in that space; all 0 without one: hair that fills the place of a head
// does not fill that of a neck.
glm::vec4 Renderer::neck(const Frame &frame) const
{
    const glm::vec2 axes = glm::vec2(solid_.semi_axes.x, solid_.semi_axes.z) - inset;
    if (!frame.head || solid_.neck_axes.x <= 0.0f) {
        return glm::vec4(0.0f);
    }
    const glm::vec2 centre =
        (solid_.neck_centre - glm::vec2(solid_.centre.x, solid_.centre.z)) / axes;
    return {centre, axes / (solid_.neck_axes - inset)};
}

glm::vec2 Renderer::neck_span(const Frame &frame) const
{
    return frame.head && solid_.neck_axes.x > 0.0f
               ? (solid_.neck_span - solid_.centre.y) / (solid_.semi_axes.y - inset)
               : glm::vec2(0.0f);
}

} // namespace tsuya::draw

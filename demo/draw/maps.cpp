#include "draw/maps.h"

#include <tsuya/models/deep_opacity.h>
#include <tsuya/models/opacity_shadow.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::draw {

bool MapsAsked::operator==(const MapsAsked &other) const
{
    return technique == other.technique && layers == other.layers && size == other.size &&
           opacity == other.opacity && format == other.format && width_scale == other.width_scale &&
           taper == other.taper && model == other.model && to_solid == other.to_solid &&
           neck == other.neck && neck_span == other.neck_span && lights == other.lights;
}

Maps::~Maps()
{
    clear();
}

void Maps::clear()
{
    gl_->DeleteTextures(3, textures_);
    gl_->DeleteFramebuffers(2, framebuffers_);
    std::fill(textures_, textures_ + 3, 0u);
    std::fill(framebuffers_, framebuffers_ + 2, 0u);
    width_ = height_ = 0;
}

void Maps::load(const groom::Groom &groom)
{
    glm::vec3 lower = groom.points.front(), upper = lower;
    for (const glm::vec3 &p : groom.points) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    centre_ = 0.5f * (lower + upper);
    double length = 0.0, area = 0.0;
    radius_ = 1e-6f;
    for (std::size_t s = 0; s < groom.strands(); s++) {
        for (std::uint32_t i = groom.first[s]; i < groom.first[s + 1]; i++) {
            radius_ = std::max(radius_, glm::distance(groom.points[i], centre_));
            if (i > groom.first[s]) {
                const double part = double(glm::distance(groom.points[i - 1], groom.points[i]));
                length += part;
                area += 2.0 * part *
                        double(groom.radius.empty() ? groom.constant_radius : groom.radius[i]);
            }
        }
    }
    length_ = float(length);
    diameter_ = float(area / std::max(length, 1e-30));
    drawn_ = {};
    plans_.clear();
}

bool Maps::plan(tsu_context *context, const MapsAsked &asked)
{
    tsu_hair_shadow_desc desc;
    tsu_hair_shadow_desc_init(&desc);
    // The demo's techniques have the same parameters.
    tsu_deep_opacity_params params;
    tsu_model_params_init(asked.technique, &params, sizeof params);
    params.opacity = asked.opacity;
    params.layers = float(asked.layers);
    const float scale = glm::length(glm::vec3(asked.model[0]));
    const glm::vec3 centre = glm::vec3(asked.model * glm::vec4(centre_, 1.0f));
    GLint most = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    columns_ = int(std::ceil(std::sqrt(double(asked.lights.size()))));
    const bool half = asked.format ? asked.format == TSU_FORMAT_RGBA16F : gl_->es != 0;
    uint32_t blends = 0;
    if (asked.format != TSU_FORMAT_RGBA8) {
        blends = half ? TSU_HAIR_SHADOW_BLEND_16F : TSU_HAIR_SHADOW_BLEND_32F;
    }
    desc.model = asked.technique;
    desc.params = &params;
    desc.radius = radius_ * scale;
    desc.length = length_ * scale;
    desc.width = diameter_ * scale * asked.width_scale;
    desc.size = uint32_t(asked.size);
    desc.most_size = std::min(desc.most_size, uint32_t(most / columns_));
    // Twice for more than one: a tile is as large as the largest map, which depends on the lights.
    tile_ = 0;
    for (int pass = 0; pass < std::min(columns_, 2); pass++) {
        plans_.clear();
        for (std::size_t i = 0; i < asked.lights.size(); i++) {
            tsu_hair_shadow_plan plan;
            tsu_hair_shadow_plan_init(&plan);
            for (int k = 0; k < 3; k++) {
                desc.centre[k] = centre[k];
                desc.light[k] = asked.lights[i][k];
            }
            desc.flags = blends;
            if (asked.lights[i].w > 0.0f) {
                desc.flags |= TSU_HAIR_SHADOW_POINT;
            }
            desc.tile_x = uint32_t(i % std::size_t(columns_)) * tile_;
            desc.tile_y = uint32_t(i / std::size_t(columns_)) * tile_;
            const tsu_status status = tsu_hair_shadow_make(context, &desc, &plan);
            if (status != TSU_OK) {
                why_ = std::string("no plan: ") + tsu_status_text(status);
                return false;
            }
            plans_.push_back(plan);
        }
        for (const tsu_hair_shadow_plan &plan : plans_) {
            tile_ = std::max(tile_, plan.size);
        }
    }
    return true;
}

bool Maps::targets(int width, int height, tsu_format format)
{
    if (width == width_ && height == height_ && format == format_) {
        return true;
    }
    clear();
    const GLint colors[] = {0, 0, GL_RGBA32F, GL_RGBA16F, GL_RGBA8};
    gl_->GenTextures(3, textures_);
    gl_->GenFramebuffers(2, framebuffers_);
    gl_->ActiveTexture(GL_TEXTURE5);
    for (int i = 0; i < 3; i++) {
        gl_->BindTexture(GL_TEXTURE_2D, textures_[i]);
        gl_->TexImage2D(GL_TEXTURE_2D, 0, i == 0 ? GL_DEPTH_COMPONENT24 : colors[format], width,
                        height, 0, i == 0 ? GL_DEPTH_COMPONENT : GL_RGBA,
                        i == 0                       ? GL_UNSIGNED_INT
                        : format == TSU_FORMAT_RGBA8 ? GL_UNSIGNED_BYTE
                                                     : GL_FLOAT,
                        nullptr);
        for (GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
            gl_->TexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
        }
        gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    }
    const GLenum none = GL_NONE, both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, textures_[0], 0);
    gl_->DrawBuffers(1, &none);
    gl_->ReadBuffer(GL_NONE);
    bool good = gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
    for (GLuint i = 0; i < 2; i++) {
        gl_->FramebufferTexture2D(GL_FRAMEBUFFER, both[i], GL_TEXTURE_2D, textures_[i + 1], 0);
    }
    gl_->DrawBuffers(2, both);
    good = good && gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (!good) {
        clear();
        why_ = "this context cannot draw float targets of " + std::to_string(width) + "x" +
               std::to_string(height);
        return false;
    }
    width_ = width;
    height_ = height;
    format_ = format;
    return true;
}

void Maps::pass(const Program &program, const MapsAsked &asked, const Strands &strands) const
{
    gl_->UseProgram(program.id());
    program.set("u_points", 1);
    program.set("u_strands", 2);
    program.set("u_map_front", 5);
    program.set("u_model", asked.model);
    program.set("u_width_scale", asked.width_scale);
    program.set("u_taper", asked.taper);
    // Every segment ends by itself: sums must be width times length, joints need not look closed.
    program.set("u_thin", 1e9f);
    program.set("u_to_solid", asked.to_solid);
    program.set("u_neck", asked.neck);
    program.set("u_neck_span", asked.neck_span.x, asked.neck_span.y);
    for (std::size_t i = 0; i < plans_.size(); i++) {
        const tsu_hair_shadow_plan &plan = plans_[i];
        const GLsizei size = GLsizei(plan.size);
        gl_->Viewport(GLint(plan.record[36]), GLint(plan.record[37]), size, size);
        // A ribbon that reaches past its tile belongs to no other light.
        gl_->Scissor(GLint(plan.record[36]), GLint(plan.record[37]), size, size);
        program.set("u_half_size", 0.5f * float(size), 0.5f * float(size));
        const glm::mat4 to_light = glm::make_mat4(plan.to_light);
        const glm::vec3 across(to_light[0].x, to_light[1].x, to_light[2].x);
        program.set("u_pixel_scale", glm::length(glm::vec3(asked.model[0])) * glm::length(across) *
                                         0.5f * float(size));
        program.set("u_view_projection", to_light);
        program.set("u_light", asked.lights[i]);
        gl_->Uniform4fv(gl_->GetUniformLocation(program.id(), "u_record"),
                        TSU_HAIR_SHADOW_RECORD_VEC4, plan.record);
        strands.draw();
    }
}

bool Maps::draw(tsu_context *context, const MapsAsked &asked, const Program &front,
                const Program &layers, Strands &strands)
{
    if (asked == drawn_) {
        return true;
    }
    drawn_ = {};
    if (!plan(context, asked)) {
        return false;
    }
    const int rows = (int(plans_.size()) + columns_ - 1) / columns_;
    if (!targets(columns_ * int(tile_), rows * int(tile_), plans_[0].color)) {
        plans_.clear();
        return false;
    }
    strands.all();
    gl_->ActiveTexture(GL_TEXTURE5);
    gl_->BindTexture(GL_TEXTURE_2D, 0);
    gl_->Disable(GL_CULL_FACE);
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->DepthMask(GL_TRUE);
    gl_->Disable(GL_BLEND);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
    gl_->Clear(GL_DEPTH_BUFFER_BIT);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    if (plans_[0].pass_count == 2) {
        gl_->Enable(GL_SCISSOR_TEST);
        pass(front, asked, strands);
        gl_->Disable(GL_SCISSOR_TEST);
    }
    gl_->Disable(GL_DEPTH_TEST);
    gl_->DepthMask(GL_FALSE);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
    gl_->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl_->Clear(GL_COLOR_BUFFER_BIT);
    gl_->Enable(GL_BLEND);
    gl_->BlendEquation(GL_FUNC_ADD);
    gl_->BlendFunc(GL_ONE, GL_ONE);
    gl_->ActiveTexture(GL_TEXTURE5);
    gl_->BindTexture(GL_TEXTURE_2D, textures_[0]);
    gl_->Enable(GL_SCISSOR_TEST);
    pass(layers, asked, strands);
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_BLEND);
    drawn_ = asked;
    return true;
}

void Maps::bind(const Program &program, int unit, bool on) const
{
    static const char *const names[3] = {"u_map_front", "u_map_layers", "u_map_deeper"};
    for (int i = 0; i < 3; i++) {
        gl_->ActiveTexture(GLenum(GL_TEXTURE0 + unit + i));
        gl_->BindTexture(GL_TEXTURE_2D, on ? textures_[i] : 0);
        program.set(names[i], unit + i);
    }
    program.set("u_maps", on ? int(plans_.size()) : 0);
    program.set("u_fixed_layers", on && drawn_.technique == tsu_opacity_shadow() ? 1 : 0);
    if (!on) {
        return;
    }
    std::vector<float> records;
    for (const tsu_hair_shadow_plan &plan : plans_) {
        records.insert(records.end(), plan.record, plan.record + 48);
    }
    gl_->Uniform4fv(gl_->GetUniformLocation(program.id(), "u_shadow"), GLsizei(records.size() / 4),
                    records.data());
}

} // namespace tsuya::draw

#include "draw/renderer.h"

#include <algorithm>
#include <string>

namespace tsuya::draw {

Expected<bool> Renderer::draw(const Frame &frame)
{
    if (frame.lights.size() > std::size_t(lights_most) ||
        frame.sky.size() > std::size_t(sky_most)) {
        return Error{"a frame must have at most " + std::to_string(lights_most) +
                     " lights and as many for the sky"};
    }
    bool areas = false;
    for (std::size_t i = 0; i < frame.lights.size(); i++) {
        const bool area = frame.lights[i].record[3] > 0.0f;
        if (area && i >= std::size_t(areas_most)) {
            return Error{"lights with a place or a size must be among the first " +
                         std::to_string(areas_most) + " of a frame"};
        }
        areas = areas || area;
    }
    const Expected<bool> ready = shading_->light(areas, frame.surrounded);
    if (!ready) {
        return Error{ready.error()};
    }
    const int width = frame.width * frame.supersample, height = frame.height * frame.supersample;
    GLint most = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width > most || height > most) {
        return Error{"size times supersample is " + std::to_string(width) + "x" +
                     std::to_string(height) + " but this context draws at most " +
                     std::to_string(most) + " pixels along a side"};
    }
    constexpr double samples_most = 1e8; // 2 GB
    if (double(width) * double(height) > samples_most) {
        return Error{"size times supersample is " + std::to_string(width) + "x" +
                     std::to_string(height) + " but must be at most 100000000 samples in all"};
    }
    if (!samples_->resize(width, height, true) ||
        !sky_->resize(Strands::row_points, strands_->rows(), false) ||
        !resolved_->resize(frame.width, frame.height, false)) {
        return Error{"this context cannot draw into a float picture of " + std::to_string(width) +
                     "x" + std::to_string(height)};
    }
    shadows(frame);
    strands_->sort(frame.view * frame.model, frame.near);

    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    sky(frame);
    samples_->bind();
    gl_.DepthMask(GL_TRUE);
    gl_.ClearColor(frame.background.x, frame.background.y, frame.background.z, 0.0f);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    head(frame);

    gl_.DepthMask(GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    const Program &program = shading_->bind_strand();
    lights(program, frame, Which::lights);
    program.set("u_eye", frame.eye);
    program.set("u_sigma_a", frame.sigma_a);
    program.set("u_variation", frame.variation);
    strands(program, frame, width, height);

    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_DEPTH_TEST);
    resolved_->bind();
    gl_.UseProgram(resolve_.id());
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, samples_->texture());
    resolve_.set("u_picture", 1);
    resolve_.set("u_samples", frame.supersample);
    gl_.BindVertexArray(empty_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    return true;
}

Picture Renderer::picture() const
{
    return {resolved_->width(), resolved_->height(), resolved_->read()};
}

namespace {

void display(const gl_api &gl, const Program &program, GLuint texture, GLuint array,
             float exposure, bool filmic, bool encode)
{
    gl.Disable(GL_BLEND);
    gl.Disable(GL_DEPTH_TEST);
    gl.UseProgram(program.id());
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    program.set("u_picture", 1);
    program.set("u_exposure", exposure);
    program.set("u_filmic", filmic ? 1 : 0);
    program.set("u_encode", encode ? 1 : 0);
    gl.BindVertexArray(array);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace

Picture Renderer::shown(float exposure, bool filmic)
{
    shown_->resize(resolved_->width(), resolved_->height(), false);
    shown_->bind();
    display(gl_, display_, resolved_->texture(), empty_, exposure, filmic, false);
    return {shown_->width(), shown_->height(), shown_->read()};
}

void Renderer::finish() const
{
    gl_.Finish();
}

void Renderer::present(float exposure, bool filmic)
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.Viewport(0, 0, resolved_->width(), resolved_->height());
    display(gl_, display_, resolved_->texture(), empty_, exposure, filmic, true);
}

std::size_t Renderer::reached(const Frame &frame)
{
    Target target(&gl_);
    if (!target.resize(frame.width, frame.height, true, Target::Kind::number)) {
        return 0;
    }
    shadows(frame);
    std::vector<char> missing(strands_->strands(), 1);
    std::size_t found = 0, more = missing.size();
    for (int pass = 0; pass < 12 && more * 1000 >= missing.size() && more > 0; pass++) {
        strands_->choose(missing, frame.view * frame.model, frame.near);
        target.bind();
        gl_.Disable(GL_SCISSOR_TEST);
        gl_.Disable(GL_CULL_FACE);
        gl_.DepthMask(GL_TRUE);
        gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        head(frame);
        gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl_.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        gl_.Clear(GL_COLOR_BUFFER_BIT);
        gl_.DepthMask(GL_FALSE);
        gl_.UseProgram(identity_.id());
        strands(identity_, frame, frame.width, frame.height);

        const std::vector<unsigned char> bytes = target.read_bytes();
        more = 0;
        for (std::size_t i = 0; i < bytes.size(); i += 4) {
            const std::size_t number = std::size_t(bytes[i]) | std::size_t(bytes[i + 1]) << 8 |
                                       std::size_t(bytes[i + 2]) << 16 |
                                       std::size_t(bytes[i + 3]) << 24;
            if (number > 0 && number <= missing.size() && missing[number - 1]) {
                missing[number - 1] = 0;
                more++;
            }
        }
        found += more;
    }
    return found;
}

} // namespace tsuya::draw

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
    Expected<bool> sized = screen_->resize(frame.width, frame.height, frame.supersample);
    if (!sized) {
        return sized;
    }
    if (!sky_->resize(Strands::row_points, strands_->rows(), false)) {
        return Error{"this context cannot draw into a float picture of " +
                     std::to_string(Strands::row_points) + "x" + std::to_string(strands_->rows())};
    }
    shadows(frame);
    strands_->sort(frame.view * frame.model, frame.near);

    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    sky(frame);
    screen_->begin();
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
    program.set("u_gain", frame.gain);
    strands(program, frame, frame.width * frame.supersample, frame.height * frame.supersample);
    screen_->resolve();
    return true;
}

void Renderer::finish() const
{
    gl_.Finish();
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

#include "draw/screen.h"

#include <utility>

namespace tsuya::draw {

Screen::Screen(const gl_api *gl) : gl_(gl), samples_(gl), resolved_(gl), shown_(gl)
{
    gl_->GenVertexArrays(1, &empty_);
}

Screen::~Screen()
{
    gl_->DeleteVertexArrays(1, &empty_);
}

Expected<bool> Screen::build(const std::string &folder)
{
    const auto text = [&](const char *name) { return source(folder, name); };
    Expected<Program> resolve = link(*gl_, {text("screen.vert.glsl")}, {text("resolve.frag.glsl")});
    Expected<Program> display = link(*gl_, {text("screen.vert.glsl")}, {text("display.frag.glsl")});
    for (const Expected<Program> *program : {&resolve, &display}) {
        if (!*program) {
            return Error{program->error()};
        }
    }
    resolve_ = std::move(*resolve);
    display_ = std::move(*display);
    return true;
}

Expected<bool> Screen::resize(int width, int height, int supersample)
{
    const int across = width * supersample, down = height * supersample;
    GLint most = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::string asked =
        "size times supersample is " + std::to_string(across) + "x" + std::to_string(down);
    if (across > most || down > most) {
        return Error{asked + " but this context draws at most " + std::to_string(most) +
                     " pixels along a side"};
    }
    constexpr double samples_most = 1e8; // 2 GB
    if (double(across) * double(down) > samples_most) {
        return Error{asked + " but must be at most 100000000 samples in all"};
    }
    if (!samples_.resize(across, down, true) || !resolved_.resize(width, height, false)) {
        return Error{"this context cannot draw into a float picture of " + std::to_string(across) +
                     "x" + std::to_string(down)};
    }
    supersample_ = supersample;
    return true;
}

void Screen::resolve()
{
    gl_->Disable(GL_BLEND);
    gl_->Disable(GL_DEPTH_TEST);
    resolved_.bind();
    gl_->UseProgram(resolve_.id());
    gl_->ActiveTexture(GL_TEXTURE1);
    gl_->BindTexture(GL_TEXTURE_2D, samples_.texture());
    resolve_.set("u_picture", 1);
    resolve_.set("u_samples", supersample_);
    gl_->BindVertexArray(empty_);
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

Picture Screen::picture() const
{
    return {resolved_.width(), resolved_.height(), resolved_.read()};
}

void Screen::display(float exposure, bool filmic, bool encode) const
{
    gl_->Disable(GL_BLEND);
    gl_->Disable(GL_DEPTH_TEST);
    gl_->UseProgram(display_.id());
    gl_->ActiveTexture(GL_TEXTURE1);
    gl_->BindTexture(GL_TEXTURE_2D, resolved_.texture());
    display_.set("u_picture", 1);
    display_.set("u_exposure", exposure);
    display_.set("u_filmic", filmic ? 1 : 0);
    display_.set("u_encode", encode ? 1 : 0);
    gl_->BindVertexArray(empty_);
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

Picture Screen::shown(float exposure, bool filmic)
{
    shown_.resize(resolved_.width(), resolved_.height(), false);
    shown_.bind();
    display(exposure, filmic, false);
    return {shown_.width(), shown_.height(), shown_.read()};
}

void Screen::present(float exposure, bool filmic)
{
    gl_->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_->Viewport(0, 0, resolved_.width(), resolved_.height());
    display(exposure, filmic, true);
}

} // namespace tsuya::draw

#include "draw/target.h"

#include <algorithm>
#include <cstddef>

namespace tsuya::draw {

Target::~Target()
{
    clear();
}

void Target::clear()
{
    gl_->DeleteFramebuffers(1, &framebuffer_);
    gl_->DeleteTextures(1, &color_);
    gl_->DeleteRenderbuffers(1, &depth_);
    framebuffer_ = color_ = depth_ = 0;
    width_ = height_ = 0;
}

bool Target::resize(int width, int height, bool depth, Kind kind)
{
    if (width == width_ && height == height_ && depth == has_depth_) {
        return true;
    }
    clear();
    gl_->GenFramebuffers(1, &framebuffer_);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_->GenTextures(1, &color_);
    gl_->BindTexture(GL_TEXTURE_2D, color_);
    const bool light = kind == Kind::light;
    const GLint format = light ? (gl_->es ? GL_RGBA16F : GL_RGBA32F) : GL_RGBA8;
    gl_->TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA,
                    light ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
    if (depth) {
        gl_->GenRenderbuffers(1, &depth_);
        gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_);
        gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    }
    if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        clear();
        return false;
    }
    width_ = width;
    height_ = height;
    has_depth_ = depth;
    return true;
}

void Target::bind() const
{
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_->Viewport(0, 0, width_, height_);
}

std::vector<float> Target::read() const
{
    const std::size_t row = std::size_t(width_) * 4;
    std::vector<float> pixels(row * std::size_t(height_));
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
    for (std::size_t y = 0; y < std::size_t(height_) / 2; y++) {
        std::swap_ranges(pixels.begin() + std::ptrdiff_t(y * row),
                         pixels.begin() + std::ptrdiff_t((y + 1) * row),
                         pixels.end() - std::ptrdiff_t((y + 1) * row));
    }
    return pixels;
}

std::vector<unsigned char> Target::read_bytes() const
{
    std::vector<unsigned char> bytes(std::size_t(width_) * std::size_t(height_) * 4);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
}

} // namespace tsuya::draw

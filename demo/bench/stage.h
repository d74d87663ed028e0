// Where shaders are timed: a context without a window, one set with a material of every model, a
// target, and a frame whose varyings run over all they may be.
#ifndef TSUYA_DEMO_BENCH_STAGE_H
#define TSUYA_DEMO_BENCH_STAGE_H

#include "bench/tiers.h"
#include "draw/program.h"
#include "gpu/offscreen.h"

#include <tsuya/gl.h>

#include <cstdint>
#include <string>
#include <utility>

namespace tsuya::bench
{

// A context of GL 4.5 or the next best one down to 3.3, current on the calling thread.
class Context
{
  public:
    // Throws std::runtime_error when the machine has none.
    Context();
    ~Context();
    Context(const Context &) = delete;
    Context &operator=(const Context &) = delete;

    const gl_api &gl() const
    {
        return gl_;
    }
    // For offscreen_proc().
    void *user() const
    {
        return context_;
    }
    // Back-end, vendor, renderer and version.
    std::string description() const;
    // "llvmpipe", "softpipe", or the first word of the renderer's name in small letters.
    std::string driver() const;
    // Draws on a CPU, where timer queries mean nothing.
    bool software() const;

  private:
    offscreen *context_ = nullptr;
    gl_api gl_ = {};
};

class Stage
{
  public:
    // Bakes one material of each model. `size`: pixels along a side of the target.
    // Throws std::runtime_error.
    Stage(const Context &context, tsu_context *library, int size);
    ~Stage();
    Stage(const Stage &) = delete;
    Stage &operator=(const Stage &) = delete;

    // A program of a tier or of a baseline, ready to draw. Throws std::runtime_error with the
    // driver's message.
    draw::Program tier(const Tier &tier);
    draw::Program baseline(const std::string &name);
    // Fills the target once. The program stays current.
    void draw(const draw::Program &program);
    // Pixels of the last draw, RGBA, rows bottom-up.
    std::vector<float> pixels() const;
    int size() const
    {
        return size_;
    }

  private:
    draw::Program link(const std::string &fragment) const;
    void open();

    const gl_api &gl_;
    tsu_context *library_;
    int size_;
    tsu_set *set_ = nullptr;
    tsu_gl *guest_ = nullptr;
    std::vector<std::pair<const tsu_model *, std::uint32_t>> kinds_; // model, flags; by material
    GLuint vertices_ = 0, framebuffer_ = 0, target_ = 0, block_ = 0;
};

} // namespace tsuya::bench

#endif

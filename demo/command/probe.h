// A function of a model asked on the GPU: one fragment a row.
#ifndef TSUYA_DEMO_COMMAND_PROBE_H
#define TSUYA_DEMO_COMMAND_PROBE_H

#include "../gpu/gl.h"
#include "../gpu/offscreen.h"
#include "function.h"
#include "host.h"

#include <tsuya/gl.h>
#include <tsuya/shader.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tsuya::command {

class Probe
{
  public:
    // Where a row lies in the table of all rows, and its material's index in the page.
    struct Row {
        std::size_t row;
        std::uint32_t material;
    };

    // Opens an offscreen context (EGL, then OSMesa; OpenGL 4.5, 4.1, then 3.3), compiles the text
    // of tsu_shader_create() for its version and keeps both. NULL with an error when the machine
    // has no such OpenGL.
    static std::unique_ptr<Probe> create(Host &host, const Function &function, std::string &error);
    ~Probe();
    Probe(const Probe &) = delete;
    Probe &operator=(const Probe &) = delete;

    // Uploads what changed in the set since the last call.
    bool sync(const tsu_set *set, std::string &error);

    // Answers `rows`, whose materials are all in `page`; `in` and `out` as evaluate.h has them.
    bool ask(std::uint32_t page, const std::vector<Row> &rows, const std::vector<double> &in,
             std::vector<double> &out, std::string &error);

  private:
    Probe(Host &host, const Function &function);

    bool open(std::string &error);
    bool compile(std::string &error);
    bool make_targets(std::string &error);
    std::string message(const tsu_shader *shader, std::uint32_t object) const;
    void draw(std::size_t rows);

    Host &host_;
    Function function_;
    offscreen *context_ = nullptr;
    gl_api gl_ = {};
    tsu_gl *guest_ = nullptr;
    std::uint32_t program_ = 0, rows_texture_ = 0, targets_[2] = {0, 0};
    std::uint32_t framebuffer_ = 0, vertices_ = 0;
    std::vector<float> upload_, results_[2];
};

} // namespace tsuya::command

#endif

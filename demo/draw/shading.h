// One material of one model: the library's guest in this renderer, and the program around it.
#ifndef TSUYA_DRAW_SHADING_H
#define TSUYA_DRAW_SHADING_H

#include "draw/program.h"

#include <tsuya/gl.h>
#include <tsuya/model.h>
#include <tsuya/shader.h>

#include <memory>
#include <string>
#include <vector>

namespace tsuya::draw {

// Where GLSL is read from again at each build of a program; empty: what is built in.
struct Folders {
    std::string library; // the checkout's glsl
    std::string demo;    // the checkout's demo/draw
};

class Shading
{
  public:
    // Errors: what the library says about the context.
    static Expected<std::unique_ptr<Shading>> create(const gl_api &gl, tsu_gl_proc_fn proc,
                                                     void *user, const Folders &folders);
    ~Shading();
    Shading(const Shading &) = delete;
    Shading &operator=(const Shading &) = delete;

    // Shade with this model and these typed parameters from now on. Tables are baked and a program
    // is built only when they have to be.
    // Errors: a parameter out of range; a model with an input that hair drawn here does not have;
    //         a shader that does not compile. The state is then as before.
    //   variant  entry point of the model; "": the one that takes most of what hair here has
    Expected<bool> set(const tsu_model *model, const void *params,
                       const std::string &variant = {});

    // Programs for frames whose lights have places or sizes, and for frames with surroundings: both
    // cost time where they are not needed. Built when this changes.
    // Errors: a shader that does not compile; the state is then as before.
    Expected<bool> light(bool areas, bool surrounded);

    // Read all GLSL again. Errors: it does not compile; the old program stays.
    Expected<bool> reload();

    // Bind a program, table and record: unit 0, block 0.
    const Program &bind_strand(); // strand.vert.glsl and strand.frag.glsl
    const Program &bind_sky();    // screen.vert.glsl and sky.frag.glsl

    // Does the model ask how much hair is behind a fibre?
    bool beyond() const
    {
        return programs_.beyond;
    }

    // Programs that draw the maps of a technique of self-shadow: strand.vert.glsl with
    // front.frag.glsl and with layers.frag.glsl. Built when the technique changes.
    // Errors: a shader that does not compile.
    struct MapPrograms {
        Program front, layers;
    };
    Expected<const MapPrograms *> maps(const tsu_model *technique);

    tsu_context *context() const
    {
        return context_;
    }
    const tsu_model *model() const
    {
        return model_;
    }
    const Folders &folders() const
    {
        return folders_;
    }

  private:
    Shading(const gl_api &gl, const Folders &folders) : gl_(gl), folders_(folders)
    {
    }
    // The programs that call the model's entry.
    struct Programs {
        Program strand, sky;
        bool beyond = false; // the model has the input `behind`
    };
    Expected<std::string> library(const std::vector<const tsu_model *> &models);
    Expected<MapPrograms> build_maps(const tsu_model *technique);
    Expected<Programs> build(const tsu_model *model, const std::string &variant);
    const Program &bind(const Program &program);
    Expected<bool> rebuild();
    void read_lobe(const tsu_model *model, const void *params);
    static void log(void *user, int32_t level, int32_t code, const char *text);
    static int32_t read(void *user, const char *name, const char **text, size_t *size);
    Error failed(const char *what, tsu_status status) const;

    const gl_api &gl_;
    Folders folders_;
    tsu_context *context_ = nullptr;
    tsu_set *set_ = nullptr;
    tsu_gl *guest_ = nullptr;
    const tsu_model *model_ = nullptr;
    std::string variant_;
    uint32_t material_ = 0;
    bool areas_ = false, surrounded_ = false;
    float alpha_R_ = 0.0f, beta_R_ = 0.1f; // of the material
    Programs programs_;
    const tsu_model *technique_ = nullptr;
    MapPrograms map_programs_;
    std::string message_; // last error that the library logged
    std::string text_;    // last file that it read
};

} // namespace tsuya::draw

#endif

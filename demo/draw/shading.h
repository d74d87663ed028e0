// One material of hair, and the programs around it.
#ifndef TSUYA_DRAW_SHADING_H
#define TSUYA_DRAW_SHADING_H

#include "draw/guest.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tsuya::draw {

class Shading
{
  public:
    // Errors: what the library says about the context.
    static Expected<std::unique_ptr<Shading>> create(const gl_api &gl, tsu_gl_proc_fn proc,
                                                     void *user, const Folders &folders);

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
        return guest_->context();
    }
    const tsu_model *model() const
    {
        return guest_->model();
    }
    const Folders &folders() const
    {
        return guest_->folders();
    }

  private:
    Shading(const gl_api &gl, std::unique_ptr<Guest> guest) : gl_(gl), guest_(std::move(guest))
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

    const gl_api &gl_;
    std::unique_ptr<Guest> guest_;
    std::string variant_;
    bool areas_ = false, surrounded_ = false;
    float alpha_R_ = 0.0f, beta_R_ = 0.1f; // of the material
    Programs programs_;
    const tsu_model *technique_ = nullptr;
    MapPrograms map_programs_;
};

} // namespace tsuya::draw

#endif

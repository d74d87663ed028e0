// The shading library as a guest of this program: one material, its tables, its text.
#ifndef TSUYA_DRAW_GUEST_H
#define TSUYA_DRAW_GUEST_H

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

class Guest
{
  public:
    // Errors: what the library says about the context.
    static Expected<std::unique_ptr<Guest>> create(const gl_api &gl, tsu_gl_proc_fn proc,
                                                   void *user, const Folders &folders);
    ~Guest();
    Guest(const Guest &) = delete;
    Guest &operator=(const Guest &) = delete;

    // GLSL of some models for this context. Errors: the library's.
    //   flags  TSU_SHADER_...
    Expected<std::string> text(const std::vector<const tsu_model *> &models, uint32_t flags);

    // Errors: a parameter out of range.
    Expected<bool> check(const tsu_model *model, const void *params);
    // Take a material in place of the last one, bake what has to be and bring it to the GPU.
    // Errors: the library's.
    Expected<bool> material(const tsu_model *model, const void *params);

    // Once for a program that has the text. Errors: the library's.
    Expected<bool> setup(const Program &program);
    // Make a program current, with table and record: unit 0, block 0. The material is the first of
    // its page.
    void bind(const Program &program) const;

    tsu_context *context() const
    {
        return context_;
    }
    // The material's model; NULL: none was taken.
    const tsu_model *model() const
    {
        return model_;
    }
    const Folders &folders() const
    {
        return folders_;
    }

  private:
    Guest(const gl_api &gl, const Folders &folders) : gl_(gl), folders_(folders)
    {
    }
    static void log(void *user, int32_t level, int32_t code, const char *text);
    static int32_t read(void *user, const char *name, const char **text, size_t *size);
    Error failed(const char *what, tsu_status status) const;

    const gl_api &gl_;
    Folders folders_;
    tsu_context *context_ = nullptr;
    tsu_set *set_ = nullptr;
    tsu_gl *guest_ = nullptr;
    const tsu_model *model_ = nullptr;
    uint32_t material_ = 0;
    std::string message_; // last error that the library logged
    std::string text_;    // last file that it read
};

} // namespace tsuya::draw

#endif

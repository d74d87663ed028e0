#include "draw/shading.h"

#include <tsuya/set.h>

#include <fstream>
#include <iterator>
#include <utility>

namespace tsuya::draw {

namespace {

constexpr uint32_t unit = 0;
constexpr uint32_t block = 0;

} // namespace

void Shading::log(void *user, int32_t level, int32_t, const char *text)
{
    if (level == TSU_LOG_ERROR) {
        static_cast<Shading *>(user)->message_ = text;
    }
}

int32_t Shading::read(void *user, const char *name, const char **text, size_t *size)
{
    Shading *self = static_cast<Shading *>(user);
    if (self->folders_.library.empty()) {
        return 0;
    }
    std::ifstream file(self->folders_.library + "/" + name, std::ios::binary);
    if (!file) {
        return 0;
    }
    self->text_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    *text = self->text_.data();
    *size = self->text_.size();
    return 1;
}

Error Shading::failed(const char *what, tsu_status status) const
{
    return Error{std::string(what) + ": " +
                 (message_.empty() ? tsu_status_text(status) : message_.c_str())};
}

Expected<std::unique_ptr<Shading>> Shading::create(const gl_api &gl, tsu_gl_proc_fn proc,
                                                   void *user, const Folders &folders)
{
    std::unique_ptr<Shading> self(new Shading(gl, folders));
    tsu_context_desc context;
    tsu_context_desc_init(&context);
    context.log = log;
    context.log_user = self.get();
    context.read = read;
    context.read_user = self.get();
    tsu_status status = tsu_context_create(&context, &self->context_);
    if (status == TSU_OK) {
        tsu_set_desc set;
        tsu_set_desc_init(&set);
        status = tsu_set_create(self->context_, &set, &self->set_);
    }
    if (status == TSU_OK) {
        tsu_gl_desc guest;
        tsu_gl_desc_init(&guest);
        guest.get_proc_address = proc;
        guest.user = user;
        status = tsu_gl_create(self->context_, &guest, &self->guest_);
    }
    if (status != TSU_OK) {
        return self->failed("the shading library does not start", status);
    }
    return Expected<std::unique_ptr<Shading>>(std::move(self));
}

Shading::~Shading()
{
    tsu_gl_destroy(guest_);
    tsu_set_destroy(set_);
    tsu_context_destroy(context_);
}

Expected<Shading::Programs> Shading::build(const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    for (uint32_t i = 0; i < info.input_count; i++) {
        tsu_input_info input;
        tsu_input_info_init(&input);
        tsu_model_input(model, i, &input);
        if (input.flags & TSU_INPUT_EXTRA) {
            return Error{std::string("model ") + info.name + " needs the input " + input.name +
                         ", which strands drawn here do not have"};
        }
    }

    tsu_shader_desc desc;
    tsu_shader_desc_init(&desc);
    desc.target = gl_.es ? TSU_TARGET_300ES : TSU_TARGET_330;
    desc.model_count = 1;
    desc.models = &model;
    tsu_shader *shader = nullptr;
    message_.clear();
    const tsu_status status = tsu_shader_create(context_, &desc, &shader);
    if (status != TSU_OK) {
        return failed("no shader text", status);
    }
    const std::string name = std::string("tsu_") + info.name;
    // The material is the only one of its page.
    const std::string call = "\n#define HAIR(t, l, v, sigma_a) " + name + "_sum(" + name +
                             "_eval(0, t, l, v, sigma_a))\n";
    const std::string text = tsu_shader_text(shader, nullptr) + call;
    tsu_shader_destroy(shader);

    const auto file = [&](const char *which) { return source(folders_.demo, which); };
    Expected<Program> strand =
        link(gl_, {file("strand.vert.glsl")},
             {text, file("coverage.glsl"), file("light.glsl"), file("lit.glsl"),
              file("strand.frag.glsl")});
    if (!strand) {
        return Error{strand.error()};
    }
    Expected<Program> sky = link(gl_, {file("screen.vert.glsl")},
                                 {text, file("light.glsl"), file("lit.glsl"),
                                  file("sky.frag.glsl")});
    if (!sky) {
        return Error{sky.error()};
    }
    message_.clear();
    for (const Program *program : {&*strand, &*sky}) {
        const tsu_status bound = tsu_gl_program_setup(guest_, program->id(), unit, block);
        if (bound != TSU_OK) {
            return failed("the program cannot be set up", bound);
        }
    }
    return Expected<Programs>(Programs{std::move(*strand), std::move(*sky)});
}

Expected<bool> Shading::set(const tsu_model *model, const void *params)
{
    message_.clear();
    tsu_status status = tsu_model_params_check(context_, model, params);
    if (status != TSU_OK) {
        return failed("the material is refused", status);
    }
    if (model != model_) {
        Expected<Programs> programs = build(model);
        if (!programs) {
            return Error{programs.error()};
        }
        uint32_t material = 0;
        if (model_) {
            tsu_set_remove(set_, material_);
            model_ = nullptr;
        }
        status = tsu_set_add(set_, model, params, &material);
        if (status == TSU_OK) {
            programs_ = std::move(*programs);
            model_ = model;
            material_ = material;
        }
    } else {
        status = tsu_set_update(set_, material_, params, nullptr);
    }
    if (status == TSU_OK) {
        status = tsu_set_bake(set_);
    }
    if (status == TSU_OK) {
        status = tsu_gl_sync(guest_, set_);
    }
    if (status != TSU_OK) {
        return failed("the material is refused", status);
    }
    return true;
}

Expected<bool> Shading::reload()
{
    if (model_) {
        Expected<Programs> programs = build(model_);
        if (!programs) {
            return Error{programs.error()};
        }
        programs_ = std::move(*programs);
    }
    return true;
}

const Program &Shading::bind(const Program &program)
{
    gl_.UseProgram(program.id());
    tsu_gl_bind(guest_, material_ / TSU_PAGE_MATERIALS, unit, block);
    return program;
}

const Program &Shading::bind_strand()
{
    return bind(programs_.strand);
}

const Program &Shading::bind_sky()
{
    return bind(programs_.sky);
}

} // namespace tsuya::draw

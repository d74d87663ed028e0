#include "draw/guest.h"

#include <tsuya/set.h>

#include <fstream>
#include <iterator>
#include <utility>

namespace tsuya::draw {

namespace {

constexpr uint32_t unit = 0;
constexpr uint32_t block = 0;

} // namespace

void Guest::log(void *user, int32_t level, int32_t, const char *text)
{
    if (level == TSU_LOG_ERROR) {
        static_cast<Guest *>(user)->message_ = text;
    }
}

int32_t Guest::read(void *user, const char *name, const char **text, size_t *size)
{
    Guest *self = static_cast<Guest *>(user);
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

Error Guest::failed(const char *what, tsu_status status) const
{
    return Error{std::string(what) + ": " +
                 (message_.empty() ? tsu_status_text(status) : message_.c_str())};
}

Expected<std::unique_ptr<Guest>> Guest::create(const gl_api &gl, tsu_gl_proc_fn proc, void *user,
                                               const Folders &folders)
{
    std::unique_ptr<Guest> self(new Guest(gl, folders));
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
    return Expected<std::unique_ptr<Guest>>(std::move(self));
}

Guest::~Guest()
{
    tsu_gl_destroy(guest_);
    tsu_set_destroy(set_);
    tsu_context_destroy(context_);
}

Expected<std::string> Guest::text(const std::vector<const tsu_model *> &models, uint32_t flags)
{
    tsu_shader_desc desc;
    tsu_shader_desc_init(&desc);
    desc.target = gl_.es ? TSU_TARGET_300ES : TSU_TARGET_330;
    desc.flags = flags;
    desc.model_count = uint32_t(models.size());
    desc.models = models.data();
    tsu_shader *shader = nullptr;
    message_.clear();
    const tsu_status status = tsu_shader_create(context_, &desc, &shader);
    if (status != TSU_OK) {
        return failed("no shader text", status);
    }
    const std::string text = tsu_shader_text(shader, nullptr);
    tsu_shader_destroy(shader);
    return text;
}

Expected<bool> Guest::check(const tsu_model *model, const void *params)
{
    message_.clear();
    const tsu_status status = tsu_model_params_check(context_, model, params);
    return status == TSU_OK ? Expected<bool>(true) : failed("the material is refused", status);
}

Expected<bool> Guest::material(const tsu_model *model, const void *params)
{
    message_.clear();
    tsu_status status = TSU_OK;
    if (model != model_) {
        if (model_) {
            tsu_set_remove(set_, material_);
            model_ = nullptr;
        }
        uint32_t material = 0;
        status = tsu_set_add(set_, model, params, &material);
        if (status == TSU_OK) {
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
    return status == TSU_OK ? Expected<bool>(true) : failed("the material is refused", status);
}

Expected<bool> Guest::setup(const Program &program)
{
    message_.clear();
    const tsu_status status = tsu_gl_program_setup(guest_, program.id(), unit, block);
    return status == TSU_OK ? Expected<bool>(true) : failed("the program cannot be set up", status);
}

void Guest::bind(const Program &program) const
{
    gl_.UseProgram(program.id());
    tsu_gl_bind(guest_, material_ / TSU_PAGE_MATERIALS, unit, block);
}

} // namespace tsuya::draw

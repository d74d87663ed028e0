#include "draw/shading.h"

#include <tsuya/models/deep_opacity.h>
#include <tsuya/models/opacity_shadow.h>

#include <cstring>
#include <utility>

namespace tsuya::draw {

Expected<std::unique_ptr<Shading>> Shading::create(const gl_api &gl, tsu_gl_proc_fn proc,
                                                   void *user, const Folders &folders)
{
    Expected<std::unique_ptr<Guest>> guest = Guest::create(gl, proc, user, folders);
    if (!guest) {
        return Error{guest.error()};
    }
    return std::unique_ptr<Shading>(new Shading(gl, std::move(*guest)));
}

namespace {

// The variant of that name; "": "finite" where there is one; "plain" and no such variant: all inputs
// that variants do not take alone. Bits of the model's inputs.
Expected<uint32_t> inputs_of(const tsu_model *model, std::string &variant)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    const std::string wished = variant.empty() ? "finite" : variant;
    std::string names = "plain";
    for (uint32_t i = 0; i < info.variant_count; i++) {
        tsu_variant_info one;
        tsu_variant_info_init(&one);
        tsu_model_variant(model, i, &one);
        names += std::string(", ") + one.name;
        if (wished == one.name) {
            variant = one.name;
            return one.inputs;
        }
    }
    if (!variant.empty() && variant != "plain") {
        return Error{std::string("model ") + info.name + " has no variant \"" + variant +
                     "\"; it has " + names};
    }
    variant.clear();
    uint32_t bits = 0;
    for (uint32_t i = 0; i < info.input_count; i++) {
        tsu_input_info input;
        tsu_input_info_init(&input);
        tsu_model_input(model, i, &input);
        bits |= input.flags & TSU_INPUT_VARIANT ? 0u : 1u << i;
    }
    return bits;
}

// Macros between the library's text and the demo's: how this model takes the shadow.
Expected<std::string> glue(const tsu_model *model, std::string variant, bool areas,
                           bool surrounded, bool &beyond)
{
    const Expected<uint32_t> inputs = inputs_of(model, variant);
    if (!inputs) {
        return Error{inputs.error()};
    }
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    const std::string name = std::string("tsu_") + info.name;
    std::string extra, defines;
    beyond = false;
    for (uint32_t i = 0; i < info.input_count; i++) {
        tsu_input_info input;
        tsu_input_info_init(&input);
        tsu_model_input(model, i, &input);
        if (!(input.flags & TSU_INPUT_EXTRA) || !(*inputs >> i & 1)) {
            continue;
        }
        const std::string which = input.name;
        if (which != "front" && which != "behind" && which != "direct") {
            return Error{std::string("model ") + info.name + " needs the input " + which +
                         ", which strands drawn here do not have"};
        }
        beyond = beyond || which == "behind";
        extra += ", shadow." + which;
    }
    if (!extra.empty()) {
        defines += "#define SCATTERS 1\n";
    }
    if (beyond) {
        defines += "#define BEYOND 1\n";
    }
    // The material is the only one of its page.
    // Where light is looked for, see tsuya/light.h.
    defines += std::string(areas ? "#define AREAS 1\n" : "") +
               (surrounded ? "#define SURROUNDED 1\n" : "");
    defines += std::string("uniform vec2 u_lobe;\n#define FIBER tsu_light_") +
               (name == "tsu_kajiya_kay" ? "cone" : "lobes") + "(u_lobe.x, u_lobe.y)\n";
    return "\n" + defines + "#define HAIR(t, l, v, sigma_a, shadow) " + name + "_sum(" + name +
           (variant.empty() ? "" : "_" + variant) + "_eval(0, t, l, v, sigma_a" + extra + "))\n";
}

} // namespace

Expected<std::string> Shading::library(const std::vector<const tsu_model *> &models)
{
    return guest_->text(models, areas_ || surrounded_ ? TSU_SHADER_LIGHTS : 0);
}

Expected<Shading::Programs> Shading::build(const tsu_model *model, const std::string &variant)
{
    bool beyond = false;
    const Expected<std::string> macros = glue(model, variant, areas_, surrounded_, beyond);
    if (!macros) {
        return Error{macros.error()};
    }
    const Expected<std::string> text =
        library({model, tsu_deep_opacity(), tsu_opacity_shadow()});
    if (!text) {
        return Error{text.error()};
    }
    const auto file = [&](const char *which) { return source(folders().demo, which); };
    Expected<Program> strand =
        link(gl_, {file("strand.vert.glsl")},
             {*text, *macros, file("coverage.glsl"), file("light.glsl"), file("solid.glsl"),
              file("shadow.glsl"), file("lit.glsl"), file("strand.frag.glsl")});
    if (!strand) {
        return Error{strand.error()};
    }
    Expected<Program> sky = link(gl_, {file("screen.vert.glsl")},
                                 {*text, *macros, file("light.glsl"), file("solid.glsl"),
                                  file("shadow.glsl"), file("lit.glsl"), file("sky.frag.glsl")});
    if (!sky) {
        return Error{sky.error()};
    }
    for (const Program *program : {&*strand, &*sky}) {
        const Expected<bool> bound = guest_->setup(*program);
        if (!bound) {
            return Error{bound.error()};
        }
    }
    return Expected<Programs>(Programs{std::move(*strand), std::move(*sky), beyond});
}

Expected<Shading::MapPrograms> Shading::build_maps(const tsu_model *technique)
{
    const auto file = [&](const char *which) { return source(folders().demo, which); };
    const Expected<std::string> text = library({technique});
    if (!text) {
        return Error{text.error()};
    }
    const std::string define = technique == tsu_deep_opacity() ? "\n#define FROM_FRONT 1\n" : "\n";
    Expected<Program> front = link(gl_, {file("strand.vert.glsl")},
                                   {file("coverage.glsl"), file("front.frag.glsl")});
    if (!front) {
        return Error{front.error()};
    }
    Expected<Program> layers =
        link(gl_, {file("strand.vert.glsl")},
             {*text, define, file("coverage.glsl"), file("solid.glsl"), file("layers.frag.glsl")});
    if (!layers) {
        return Error{layers.error()};
    }
    return Expected<MapPrograms>(MapPrograms{std::move(*front), std::move(*layers)});
}

Expected<const Shading::MapPrograms *> Shading::maps(const tsu_model *technique)
{
    if (technique != technique_) {
        Expected<MapPrograms> programs = build_maps(technique);
        if (!programs) {
            return Error{programs.error()};
        }
        map_programs_ = std::move(*programs);
        technique_ = technique;
    }
    return Expected<const MapPrograms *>(&map_programs_);
}

void Shading::read_lobe(const tsu_model *model, const void *params)
{
    tsu_parameter_info info;
    tsu_parameter_info_init(&info);
    for (uint32_t i = 0; tsu_model_parameter(model, i, &info) == TSU_OK; i++) {
        const char *field = static_cast<const char *>(params) + info.offset;
        if (std::strcmp(info.name, "alpha_R") == 0) {
            std::memcpy(&alpha_R_, field, sizeof alpha_R_);
        } else if (std::strcmp(info.name, "beta_R") == 0) {
            std::memcpy(&beta_R_, field, sizeof beta_R_);
        }
    }
}

Expected<bool> Shading::set(const tsu_model *model, const void *params,
                            const std::string &variant)
{
    Expected<bool> good = guest_->check(model, params);
    if (!good) {
        return good;
    }
    if (model != this->model() || variant != variant_) {
        Expected<Programs> programs = build(model, variant);
        if (!programs) {
            return Error{programs.error()};
        }
        good = guest_->material(model, params);
        if (good) {
            programs_ = std::move(*programs);
            variant_ = variant;
        }
    } else {
        good = guest_->material(model, params);
    }
    if (!good) {
        return good;
    }
    read_lobe(model, params);
    return true;
}

Expected<bool> Shading::reload()
{
    technique_ = nullptr;
    return rebuild();
}

Expected<bool> Shading::rebuild()
{
    if (model()) {
        Expected<Programs> programs = build(model(), variant_);
        if (!programs) {
            return Error{programs.error()};
        }
        programs_ = std::move(*programs);
    }
    return true;
}

Expected<bool> Shading::light(bool areas, bool surrounded)
{
    const bool before[2] = {areas_, surrounded_};
    areas_ = areas;
    surrounded_ = surrounded;
    if (areas == before[0] && surrounded == before[1]) {
        return true;
    }
    Expected<bool> built = rebuild();
    if (!built) {
        areas_ = before[0];
        surrounded_ = before[1];
    }
    return built;
}

const Program &Shading::bind(const Program &program)
{
    guest_->bind(program);
    program.set("u_lobe", alpha_R_, beta_R_);
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

#include "scene/build.h"

#include "draw/params.h"
#include "groom/read.h"
#include "scene/head.h"

#include <tsuya/hair_color.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace tsuya::scene {

namespace {

constexpr double degree = 0.01745329251994329577;

// Share of what a fibre scatters that goes on close to the light's way and so still lights the hair
// behind; from 0.6 to 0.9 for fibres of all colours.
constexpr double forward = 0.7;

groom::HairParams hair_params(const Scene &scene)
{
    groom::HairParams p = groom::preset(scene.groom == "curly"  ? groom::Style::curly
                                        : scene.groom == "wavy" ? groom::Style::wavy
                                                                : groom::Style::straight);
    p.radius = scene.fiber_width / 2.0;
    for (const auto &[name, value] : scene.hair) {
        if (name == "seed") {
            p.seed = std::uint64_t(value);
        } else if (name == "strands") {
            p.strands = std::uint32_t(value);
        } else if (name == "points") {
            p.points = std::uint32_t(value);
        } else if (name == "length") {
            p.length = value;
        } else if (name == "length_variation") {
            p.length_variation = value;
        } else if (name == "curl_radius") {
            p.curl_radius = value;
        } else if (name == "curl_frequency") {
            p.curl_frequency = value;
        } else if (name == "clumping") {
            p.clumping = value;
        } else if (name == "frizz") {
            p.frizz = value;
        } else if (name == "volume") {
            p.volume = value;
        }
    }
    return p;
}

// A context that keeps the library's last sentence.
struct Library {
    Library()
    {
        tsu_context_desc desc;
        tsu_context_desc_init(&desc);
        desc.log_user = this;
        desc.log = [](void *user, int32_t level, int32_t, const char *text) {
            if (level == TSU_LOG_ERROR) {
                static_cast<Library *>(user)->message = text;
            }
        };
        desc.jobs = all_cores;
        tsu_context_create(&desc, &context);
    }
    ~Library()
    {
        tsu_context_destroy(context);
    }
    Library(const Library &) = delete;
    Library &operator=(const Library &) = delete;

    Error failed(tsu_status status) const
    {
        // A log line begins with its number in brackets.
        const bool coded = message.rfind("[E", 0) == 0;
        const std::size_t end = coded ? message.find("] ") : std::string::npos;
        const std::string text = end == std::string::npos ? message : message.substr(end + 2);
        return Error{text.empty() ? tsu_status_text(status) : text};
    }

    tsu_context *context = nullptr;
    std::string message;
};

tsu_status color(const Scene &scene, tsu_context *context, double eta, const Material &material,
                 double sigma_a[3])
{
    if (scene.color_by == ColorBy::melanin) {
        return tsu_hair_melanin(context, scene.eumelanin, scene.pheomelanin, sigma_a);
    }
    if (scene.color_by == ColorBy::albedo) {
        return tsu_hair_sigma_a(context, eta, &scene.albedo.x, sigma_a);
    }
    if (scene.color_by == ColorBy::head_albedo) {
        return head_sigma_a(context, head_fibre(material.model, material.params.data()),
                            &scene.head_albedo.x, sigma_a);
    }
    if (scene.color_by == ColorBy::sigma_a) {
        for (int c = 0; c < 3; c++) {
            sigma_a[c] = scene.sigma_a[c];
        }
        return TSU_OK;
    }
    for (uint32_t i = 0; i < tsu_hair_preset_count(); i++) {
        tsu_hair_preset_info info;
        tsu_hair_preset_info_init(&info);
        tsu_hair_preset(i, &info);
        if (scene.color == info.name) {
            std::memcpy(sigma_a, info.sigma_a, sizeof info.sigma_a);
            return TSU_OK;
        }
    }
    return TSU_E_PARAMETER;
}

// The layers of a leaf that the scene says in words.
// Returns: false when they cannot be; `error` then says why, or the library's log does.
bool leaf_layers(const Scene &scene, tsu_context *context, Material &material, std::string &error)
{
    if (scene.contents.empty() || !has_leaf(material.model)) {
        return true;
    }
    for (const auto &given : scene.parameters) {
        if (given.first.rfind("scatter_", 0) == 0 || given.first.rfind("absorption_", 0) == 0) {
            error = given.first + " and a leaf's contents both set its layers; keep one";
            return false;
        }
    }
    tsu_status status = TSU_OK;
    error = set_leaf(context, material.model, scene.contents, material.params.data(), status);
    return error.empty() && status == TSU_OK;
}

void put(Material &material, const tsu_parameter_info &p, const glm::dvec3 &value)
{
    float *field =
        reinterpret_cast<float *>(reinterpret_cast<char *>(material.params.data()) + p.offset);
    for (uint32_t i = 0; i < p.count && i < 3; i++) {
        field[i] = float(value[int(i)]);
    }
}

// Does a model ask for the hair in the light's way?
bool asks_for_hair(const tsu_model *model, const tsu_model_info &info)
{
    for (uint32_t i = 0; i < info.input_count; i++) {
        tsu_input_info input;
        tsu_input_info_init(&input);
        tsu_model_input(model, i, &input);
        if (!std::strcmp(input.name, "front")) {
            return true;
        }
    }
    return false;
}

} // namespace

Expected<Hair> hair(const Scene &scene)
{
    Hair result;
    if (scene.groom.rfind("file:", 0) == 0) {
        groom::ReadOptions options;
        options.unit_scale = scene.unit_scale;
        options.up = scene.up == "z" ? groom::Up::z : groom::Up::y;
        options.radius = float(scene.fiber_width / 2.0);
        groom::Result loaded = groom::read(scene.groom.substr(5), options);
        if (!loaded) {
            return Error{loaded.error()};
        }
        result.groom = std::move(loaded->groom);
        result.report = loaded->report;
        for (const std::string &fact : groom::repairs(result.report)) {
            result.note += (result.note.empty() ? scene.groom.substr(5) + ": " : "; ") + fact;
        }
        return Expected<Hair>(std::move(result));
    }
    groom::Expected<groom::HairyHead> grown = groom::generate(hair_params(scene));
    if (!grown) {
        return Error{grown.error()};
    }
    result.groom = std::move(grown->groom);
    result.report = grown->report;
    result.head = std::move(grown->head);
    result.solid = {grown->centre, grown->semi_axes, grown->neck_centre, grown->neck_axes,
                    grown->neck_span};
    return Expected<Hair>(std::move(result));
}

Expected<Material> material(const Scene &scene)
{
    Library library;
    Material result;
    result.model = tsu_model_find(scene.model.c_str());
    if (!result.model) {
        return Error{"there is no model " + scene.model};
    }
    result.variant = scene.variant == "auto" ? "" : scene.variant;
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(result.model, &info);
    if (scene.shadow == "none" && asks_for_hair(result.model, info)) {
        result.note = "without shadow " + scene.model +
                      " cannot tell what other hair sends; drawn by marschner, its single fibre";
        result.model = tsu_model_find("marschner");
        result.variant.clear();
        tsu_model_describe(result.model, &info);
    }
    result.params.resize(info.params_size / sizeof(std::max_align_t) + 1);
    tsu_model_params_init(result.model, result.params.data(), info.params_size);

    tsu_variant_info variant;
    tsu_variant_info_init(&variant);
    for (uint32_t i = 0; tsu_model_variant(result.model, i, &variant) == TSU_OK; i++) {
        if (result.variant == variant.name) {
            draw::add_flags(result.params.data(), variant.params_flags);
        }
    }
    double eta = 1.55;
    for (uint32_t i = 0; i < info.parameter_count; i++) {
        tsu_parameter_info p;
        tsu_parameter_info_init(&p);
        tsu_model_parameter(result.model, i, &p);
        const auto given = scene.parameters.find(p.name);
        const double unit = std::strcmp(p.unit, "rad") ? 1.0 : degree;
        if (given != scene.parameters.end()) {
            put(result, p, given->second * unit);
        }
        if (!std::strcmp(p.name, "eta")) {
            eta = given != scene.parameters.end() ? given->second.x : p.default_value;
        }
    }
    std::string wrong;
    if (!leaf_layers(scene, library.context, result, wrong)) {
        return wrong.empty() ? library.failed(TSU_E_PARAMETER) : Error{wrong};
    }
    const bool hair = !(info.flags & TSU_MODEL_SURFACE);
    tsu_status status =
        hair ? color(scene, library.context, eta, result, &result.sigma_a.x) : TSU_OK;
    if (hair && status == TSU_OK) {
        status = tsu_hair_albedo(library.context, eta, &result.sigma_a.x, &result.albedo.x);
    }
    for (uint32_t i = 0; i < info.parameter_count && status == TSU_OK; i++) {
        tsu_parameter_info p;
        tsu_parameter_info_init(&p);
        tsu_model_parameter(result.model, i, &p);
        if (!std::strcmp(p.name, "sigma_a")) {
            put(result, p, result.sigma_a);
        }
    }
    if (status == TSU_OK) {
        status = tsu_model_params_check(library.context, result.model, result.params.data());
    }
    if (status != TSU_OK) {
        return library.failed(status);
    }
    return Expected<Material>(std::move(result));
}

namespace {

// The dome becomes the surroundings' constant, and the sky's lights get their radiance: what the
// head is lit by, and the directions in which shadow is looked up.
void surround(const Surroundings &around, const Scene &scene, draw::Frame &frame)
{
    frame.lights.insert(frame.lights.begin(), around.dominant.begin(), around.dominant.end());
    frame.surrounded = true;
    frame.surroundings = around.record;
    for (int k = 0; k < 3; k++) {
        frame.surroundings[std::size_t(k)] += float(scene.dome * scene.dome_color[k]);
    }
    frame.sky = draw::sky(frame.surroundings, 20);
}

} // namespace

draw::Frame frame(const Scene &scene, const Hair &hair, const Material &material, double turn,
                  bool turntable, const Surroundings &around)
{
    draw::Frame frame;
    frame.width = scene.width;
    frame.height = scene.height;
    frame.supersample = scene.supersample;
    frame.lights = lights(scene, middle(hair.groom.points));
    frame.sky = sky(scene);
    if (around.there) {
        surround(around, scene, frame);
    }
    frame.sky_samples = scene.dome_samples;
    frame.background = glm::vec3(scene.background);
    frame.head = scene.head == "auto";
    frame.shadow = scene.shadow == "deep_opacity"     ? draw::Shadow::deep_opacity
                   : scene.shadow == "opacity_shadow" ? draw::Shadow::opacity_shadow
                   : scene.shadow == "grid"           ? draw::Shadow::grid
                                                      : draw::Shadow::none;
    frame.shadow_layers = scene.shadow_layers;
    frame.shadow_size = scene.shadow_size;
    frame.loss = glm::vec3(1.0 - forward * material.albedo);
    frame.sigma_a = glm::vec3(material.sigma_a);
    frame.variation = float(scene.variation);
    frame.width_scale = float(scene.width_scale);
    frame.taper = float(scene.taper);
    Scene turned = scene;
    turned.turn += turn;
    aim(turned, hair, turntable, frame);
    return frame;
}

} // namespace tsuya::scene

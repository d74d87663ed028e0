#include "bench/tiers.h"

#include "draw/params.h"

#include <tsuya/tsuya.h>

#include <cstring>
#include <regex>
#include <stdexcept>

namespace tsuya::bench
{

const std::vector<Tier> &tiers()
{
    static const std::vector<Tier> all = {
#define TIER(name, model, fine, fetches, expression)                                               \
    {#name, tsu_##model(), fine != 0, fetches, expression},
#include "bench/tiers.inc"
#undef TIER
    };
    return all;
}

std::uint32_t params_flags(const Tier &tier)
{
    std::uint32_t flags = 0;
    tsu_variant_info info;
    tsu_variant_info_init(&info);
    for (std::uint32_t i = 0; tsu_model_variant(tier.model, i, &info) == TSU_OK; i++) {
        if (std::strstr(tier.expression, (std::string("_") + info.name + "_eval(").c_str())) {
            flags |= info.params_flags;
        }
    }
    return flags;
}

std::vector<double> parameters(const Tier &tier)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(tier.model, &info);
    std::vector<double> params((info.params_size + sizeof(double) - 1) / sizeof(double));
    if (tsu_model_params_init(tier.model, params.data(), info.params_size) != TSU_OK) {
        throw std::runtime_error(std::string(info.name) + " has no parameters");
    }
    draw::add_flags(params.data(), params_flags(tier));
    return params;
}

std::size_t table_bytes(const Tier &tier)
{
    std::size_t bytes = 0;
    tsu_table_info info;
    tsu_table_info_init(&info);
    const std::uint32_t flags = params_flags(tier);
    for (std::uint32_t i = 0; tsu_model_table(tier.model, i, &info) == TSU_OK; i++) {
        bytes += info.params_flags & ~flags ? 0 : info.bytes;
    }
    return bytes;
}

std::string fragment(tsu_context *context, const Tier &tier)
{
    tsu_shader_desc desc;
    tsu_shader_desc_init(&desc);
    desc.target = TSU_TARGET_330;
    desc.flags = tier.fine ? TSU_SHADER_FINE : 0;
    desc.model_count = 1;
    desc.models = &tier.model;
    tsu_shader *shader = nullptr;
    const tsu_status status = tsu_shader_create(context, &desc, &shader);
    if (status != TSU_OK) {
        throw std::runtime_error(std::string("the text of ") + tier.name + ": " +
                                 tsu_status_text(status));
    }
    const std::string text = tsu_shader_text(shader, nullptr);
    tsu_shader_destroy(shader);
    return text +
           "\nin vec3 t, l, v, sigma_a;\nflat in int material;\n"
           "in float front, behind, direct, transmittance, pigment, thickness;\n"
           "uniform mat3x4 numbers[6];\nout vec4 o;\n#define n t\n"
           "void main()\n{\n    o = vec4(" +
           tier.expression + ", 1.0);\n}\n";
}

// The files are of GLSL 4.50 with locations and bindings, which GLSL 3.30 has not.
std::string baseline(const std::string &name)
{
    for (const Source *s = baseline_sources; s->name; s++) {
        if (name + ".frag" == s->name) {
            std::string text = std::regex_replace(s->text, std::regex("#version[^\n]*"), "");
            text = std::regex_replace(text, std::regex("layout\\(location = \\d+\\) "), "");
            return std::regex_replace(text, std::regex(", set = 0, binding = 0"), "");
        }
    }
    throw std::runtime_error("there is no baseline " + name);
}

} // namespace tsuya::bench

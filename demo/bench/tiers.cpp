#include "bench/tiers.h"

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

std::size_t table_bytes(const tsu_model *model)
{
    std::size_t bytes = 0;
    tsu_table_info info;
    tsu_table_info_init(&info);
    for (std::uint32_t i = 0; tsu_model_table(model, i, &info) == TSU_OK; i++) {
        bytes += info.bytes;
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

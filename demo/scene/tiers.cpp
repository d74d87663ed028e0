#include "scene/tiers.h"

namespace tsuya::scene {

namespace {

Tier hair(const char *name, const char *model, const char *variant, const char *shadow)
{
    return {name,
            false,
            {std::string("model=") + model, std::string("variant=") + variant,
             std::string("shadow=") + shadow}};
}

Tier leaf(const std::string &name, const std::string &model, bool uniform)
{
    Tier tier = {name, true, {"model=" + model, "variant=auto"}};
    if (uniform) {
        tier.words.insert(tier.words.end(), {"leaf.texels=0", "tree.variation=0"});
    }
    return tier;
}

} // namespace

const std::vector<Tier> &tiers()
{
    static const std::vector<Tier> all = {
        hair("unshadowed", "kajiya_kay", "auto", "none"),
        hair("kajiya_kay", "kajiya_kay", "auto", "deep_opacity"),
        hair("marschner", "marschner", "auto", "deep_opacity"),
        hair("zinke", "dual_scattering", "zinke", "deep_opacity"),
        hair("exact", "dual_scattering", "auto", "deep_opacity"),
        hair("plane_parallel", "plane_parallel_hair", "auto", "deep_opacity"),
        leaf("leaf_coarse", "leaf_coarse", false),
        leaf("leaf_body_uniform", "leaf_body", true),
        leaf("leaf_uniform", "leaf", true),
        leaf("leaf_body", "leaf_body", false),
        leaf("leaf", "leaf", false),
    };
    return all;
}

const Tier *find_tier(const std::string &name)
{
    for (const Tier &tier : tiers()) {
        if (tier.name == name) {
            return &tier;
        }
    }
    return nullptr;
}

std::string tier_names(bool leaf)
{
    std::string names;
    for (const Tier &tier : tiers()) {
        if (tier.leaf == leaf) {
            names += (names.empty() ? "" : ", ") + tier.name;
        }
    }
    return names;
}

} // namespace tsuya::scene

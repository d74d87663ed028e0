#include "bench/measure.h"

#include <tsuya/tsuya.h>

#include <map>
#include <stdexcept>
#include <utility>

namespace tsuya::bench
{

namespace
{

constexpr double budget = 2.5e8;

// Milliseconds of one bake.
double bake(tsu_context *context, const Tier &tier)
{
    tsu_set_desc desc;
    tsu_set_desc_init(&desc);
    tsu_set *set = nullptr;
    std::uint32_t material = 0;
    tsu_status status = tsu_set_create(context, &desc, &set);
    if (status == TSU_OK) {
        status = tsu_set_add(set, tier.model, parameters(tier).data(), &material);
    }
    const double start = worked();
    if (status == TSU_OK) {
        status = tsu_set_bake(set);
    }
    const double time = worked() - start;
    tsu_set_destroy(set);
    if (status != TSU_OK) {
        throw std::runtime_error(std::string(tier.name) +
                                 " does not bake: " + tsu_status_text(status));
    }
    return time * 1e-6;
}

} // namespace

Rows measure_bakes(int rounds)
{
    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    tsu_context *context = nullptr;
    if (tsu_context_create(&desc, &context) != TSU_OK) {
        throw std::runtime_error("the library makes no context");
    }
    std::map<std::pair<const tsu_model *, std::uint32_t>, double> times;
    Rows rows;
    for (const Tier &tier : tiers()) {
        const auto kind = std::make_pair(tier.model, params_flags(tier));
        if (table_bytes(tier) == 0) {
            times[kind] = 0.0;
        } else if (!times.count(kind)) {
            std::vector<double> runs;
            const double start = worked();
            do {
                runs.push_back(bake(context, tier));
            } while (rounds ? int(runs.size()) < rounds : worked() - start < budget);
            times[kind] = median(std::move(runs));
        }
        rows.push_back({tier.name, "bake_ms", "", times[kind]});
    }
    tsu_context_destroy(context);
    return rows;
}

Rows measure_memory()
{
    Rows rows;
    for (const Tier &tier : tiers()) {
        rows.push_back({tier.name, "fetches", "", double(tier.fetches)});
        rows.push_back({tier.name, "bytes", "", double(table_bytes(tier))});
    }
    return rows;
}

} // namespace tsuya::bench

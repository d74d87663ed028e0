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
double bake(tsu_context *context, const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    std::vector<double> params((info.params_size + sizeof(double) - 1) / sizeof(double));
    tsu_set_desc desc;
    tsu_set_desc_init(&desc);
    tsu_set *set = nullptr;
    std::uint32_t material = 0;
    tsu_status status = tsu_model_params_init(model, params.data(), info.params_size);
    if (status == TSU_OK) {
        status = tsu_set_create(context, &desc, &set);
    }
    if (status == TSU_OK) {
        status = tsu_set_add(set, model, params.data(), &material);
    }
    const double start = worked();
    if (status == TSU_OK) {
        status = tsu_set_bake(set);
    }
    const double time = worked() - start;
    tsu_set_destroy(set);
    if (status != TSU_OK) {
        throw std::runtime_error(std::string(info.name) +
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
    std::map<const tsu_model *, double> times;
    Rows rows;
    for (const Tier &tier : tiers()) {
        if (table_bytes(tier.model) == 0) {
            times[tier.model] = 0.0;
        } else if (!times.count(tier.model)) {
            std::vector<double> runs;
            const double start = worked();
            do {
                runs.push_back(bake(context, tier.model));
            } while (rounds ? int(runs.size()) < rounds : worked() - start < budget);
            times[tier.model] = median(std::move(runs));
        }
        rows.push_back({tier.name, "bake_ms", "", times[tier.model]});
    }
    tsu_context_destroy(context);
    return rows;
}

Rows measure_memory()
{
    Rows rows;
    for (const Tier &tier : tiers()) {
        rows.push_back({tier.name, "fetches", "", double(tier.fetches)});
        rows.push_back({tier.name, "bytes", "", double(table_bytes(tier.model))});
    }
    return rows;
}

} // namespace tsuya::bench

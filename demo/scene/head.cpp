#include "scene/head.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

namespace tsuya::scene {

namespace {

constexpr std::size_t kept = 16;

bool same(const tsu_hair_head_curve &curve, const tsu_hair_head_desc &fibre)
{
    return curve.eta == fibre.eta && curve.alpha_R == fibre.alpha_R &&
           curve.beta_R == fibre.beta_R && curve.beta_az == fibre.beta_az &&
           curve.scale_shifts == fibre.scale_shifts;
}

} // namespace

tsu_hair_head_desc head_fibre(const tsu_model *model, const void *params)
{
    tsu_hair_head_desc fibre;
    tsu_hair_head_desc_init(&fibre);
    const struct {
        const char *name;
        float &value;
    } fields[] = {{"eta", fibre.eta},
                  {"alpha_R", fibre.alpha_R},
                  {"beta_R", fibre.beta_R},
                  {"beta_az", fibre.beta_az},
                  {"scale_shifts", fibre.scale_shifts}};
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    for (std::uint32_t i = 0; i < info.parameter_count; i++) {
        tsu_parameter_info parameter;
        tsu_parameter_info_init(&parameter);
        tsu_model_parameter(model, i, &parameter);
        for (const auto &field : fields) {
            if (!std::strcmp(field.name, parameter.name)) {
                std::memcpy(&field.value, static_cast<const char *>(params) + parameter.offset,
                            sizeof field.value);
            }
        }
    }
    return fibre;
}

tsu_status head_sigma_a(tsu_context *context, const tsu_hair_head_desc &fibre,
                        const double albedo[3], double sigma_a[3])
{
    static std::mutex mutex;
    static std::deque<tsu_hair_head_curve> curves;
    const std::lock_guard<std::mutex> lock(mutex);
    auto found = std::find_if(curves.begin(), curves.end(),
                              [&](const auto &curve) { return same(curve, fibre); });
    if (found == curves.end()) {
        tsu_hair_head_curve curve;
        tsu_hair_head_curve_init(&curve);
        const tsu_status status = tsu_hair_head_curve_solve(context, &fibre, &curve);
        if (status != TSU_OK) {
            return status;
        }
        if (curves.size() == kept) {
            curves.pop_back();
        }
        curves.push_front(curve);
        found = curves.begin();
    }
    return tsu_hair_head_sigma_a(context, &*found, albedo, sigma_a);
}

void all_cores(void *, void (*job)(void *data, std::uint32_t index), void *data,
               std::uint32_t count)
{
    std::atomic<std::uint32_t> next{0};
    const auto work = [&] {
        for (std::uint32_t i = next++; i < count; i = next++) {
            job(data, i);
        }
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < std::min(std::thread::hardware_concurrency(), count); i++) {
        others.emplace_back(work);
    }
    work();
    for (std::thread &other : others) {
        other.join();
    }
}

} // namespace tsuya::scene

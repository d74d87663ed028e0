#include "evaluate.h"

#include "host.h"
#include "probe.h"

#include <tsuya/set.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace tsuya::command {

namespace {

// Materials of a batch at most: 64 pages, 1 MiB.
constexpr std::size_t batch_materials = 64 * std::size_t(TSU_PAGE_MATERIALS);

using Rows = std::vector<std::size_t>;

// Rows of every distinct material, in the order of their first row.
std::vector<Rows> group(const Question &question)
{
    const std::vector<Value> &inputs = question.function.inputs;
    std::unordered_map<std::string, std::size_t> found;
    std::vector<Rows> groups;
    std::string key;
    for (std::size_t row = 0; row < question.rows; row++) {
        key.clear();
        for (std::size_t i = 0; i < inputs.size(); i++) {
            const double value = question.in[row * inputs.size() + i] + 0.0; // -0 becomes 0
            if (inputs[i].material) {
                key.append(reinterpret_cast<const char *>(&value), sizeof value);
            }
        }
        const auto entry = found.emplace(key, groups.size());
        if (entry.second) {
            groups.emplace_back();
        }
        groups[entry.first->second].push_back(row);
    }
    return groups;
}

// Materials of one batch in a set, and the rows that ask each of them.
class Batch
{
  public:
    Batch(Host &host, const Question &question) : host_(host), set_(host), question_(question)
    {
        tsu_model_info info;
        tsu_model_info_init(&info);
        tsu_model_describe(question.function.model, &info);
        params_.resize((info.params_size + sizeof(double) - 1) / sizeof(double));
        params_size_ = info.params_size;
    }

    // Adds groups from `first` on until one does not fit; moves `first` behind the last added.
    bool fill(const std::vector<Rows> &groups, std::size_t &first, Failure &failure)
    {
        const std::size_t from = first;
        for (; first < groups.size() && first - from < batch_materials; first++) {
            const tsu_status status = add(groups[first]);
            if (status == TSU_E_LIMIT && first > from) {
                break;
            }
            if (status != TSU_OK) {
                failure = {groups[first][0], host_.why(status)};
                return false;
            }
        }
        const tsu_status status = tsu_set_bake(set_.get());
        if (status != TSU_OK) {
            failure = {Failure::no_row, host_.why(status)};
        }
        return status == TSU_OK;
    }

    bool ask_tables(std::vector<double> &out, Failure &failure)
    {
        const Function &function = question_.function;
        for (const Material &material : materials_) {
            for (const std::size_t row : *material.rows) {
                const tsu_status status =
                    tsu_set_evaluate(set_.get(), material.index, function.index,
                                     &question_.in[row * function.inputs.size()],
                                     &out[row * function.outputs.size()]);
                if (status != TSU_OK) {
                    failure = {row, host_.why(status)};
                    return false;
                }
            }
        }
        return true;
    }

    // `probe` is made when it is NULL, and serves every batch.
    bool ask_gpu(std::unique_ptr<Probe> &probe, std::vector<double> &out, Failure &failure)
    {
        if (!probe) {
            probe = Probe::create(host_, question_.function, failure.text);
        }
        if (!probe || !probe->sync(set_.get(), failure.text)) {
            return false;
        }
        std::sort(materials_.begin(), materials_.end(),
                  [](const Material &a, const Material &b) { return a.index < b.index; });
        for (std::size_t from = 0; from < materials_.size();) {
            const std::uint32_t page = materials_[from].index / TSU_PAGE_MATERIALS;
            std::vector<Probe::Row> rows;
            for (; from < materials_.size() && materials_[from].index / TSU_PAGE_MATERIALS == page;
                 from++) {
                for (const std::size_t row : *materials_[from].rows) {
                    rows.push_back({row, materials_[from].index % TSU_PAGE_MATERIALS});
                }
            }
            if (!probe->ask(page, rows, question_.in, out, failure.text)) {
                return false;
            }
        }
        return true;
    }

  private:
    struct Material {
        std::uint32_t index;
        const Rows *rows;
    };

    tsu_status add(const Rows &rows)
    {
        const Function &function = question_.function;
        std::uint32_t index = 0;
        tsu_status status = tsu_model_params_init(function.model, params_.data(), params_size_);
        if (status == TSU_OK) {
            status = tsu_function_params(host_.context(), function.model, function.index,
                                         &question_.in[rows[0] * function.inputs.size()],
                                         params_.data());
        }
        if (status == TSU_OK) {
            status = tsu_set_add(set_.get(), function.model, params_.data(), &index);
        }
        if (status == TSU_OK) {
            materials_.push_back({index, &rows});
        }
        return status;
    }

    Host &host_;
    Set set_;
    const Question &question_;
    std::vector<double> params_; // doubles for their alignment
    std::size_t params_size_ = 0;
    std::vector<Material> materials_;
};

} // namespace

bool evaluate_reference(const Question &question, std::vector<double> &out, Failure &failure)
{
    const Function &function = question.function;
    out.assign(question.rows * function.outputs.size(), 0.0);
    // Small blocks: the time of a row varies with its roughness and inclination.
    constexpr std::size_t block = 16;
    const std::uint32_t blocks = std::uint32_t((question.rows + block - 1) / block);
    std::mutex mutex;
    bool good = true;
    Host host;
    parallel(blocks, [&](std::uint32_t index) {
        const std::size_t end = std::min(question.rows, (index + std::size_t(1)) * block);
        for (std::size_t row = index * block; row < end; row++) {
            const tsu_status status = tsu_function_reference(
                host.context(), function.model, function.index,
                &question.in[row * function.inputs.size()], &out[row * function.outputs.size()]);
            if (status != TSU_OK) {
                const std::lock_guard<std::mutex> lock(mutex);
                if (good || row < failure.row) {
                    failure = {row, host.why(status)};
                }
                good = false;
                return;
            }
        }
    });
    return good;
}

bool evaluate_tables(const Question &question, Where where, std::vector<double> &out,
                     Failure &failure)
{
    out.assign(question.rows * question.function.outputs.size(), 0.0);
    const std::vector<Rows> groups = group(question);
    Host host;
    std::unique_ptr<Probe> probe;
    for (std::size_t first = 0; first < groups.size();) {
        Batch batch(host, question);
        if (!batch.fill(groups, first, failure) ||
            !(where == Where::gpu ? batch.ask_gpu(probe, out, failure)
                                  : batch.ask_tables(out, failure))) {
            return false;
        }
    }
    return true;
}

} // namespace tsuya::command

#include "bench/counted.h"
#include "bench/measure.h"

#include <tsuya/tsuya.h>

#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <utility>

namespace tsuya::bench
{

namespace
{

constexpr std::uint32_t table_sets = 16;
constexpr std::uint32_t unit = 0, block = 0;

void require(tsu_status status, const char *what)
{
    if (status != TSU_OK) {
        throw std::runtime_error(std::string(what) + ": " + tsu_status_text(status));
    }
}

// The host's memory: every block given out is counted.
void *allocate(void *user, void *pointer, std::size_t, std::size_t size)
{
    if (size == 0) {
        std::free(pointer);
        return nullptr;
    }
    ++*static_cast<std::uint64_t *>(user);
    return std::realloc(pointer, size);
}

// A set of materials in the hand of two guests, one of which is counted.
class Scene
{
  public:
    Scene(const Context &context, std::uint32_t materials) : gl_(context.gl())
    {
        tsu_context_desc desc;
        tsu_context_desc_init(&desc);
        desc.allocate = allocate;
        desc.allocate_user = &allocations_;
        require(tsu_context_create(&desc, &library_), "making a context");
        tsu_set_desc set_desc;
        tsu_set_desc_init(&set_desc);
        require(tsu_set_create(library_, &set_desc, &set_), "making a set");
        params_.resize(materials);
        for (std::uint32_t i = 0; i < materials; i++) {
            tsu_marschner_params_init(&params_[i]);
            params_[i].eta = 1.4f + 0.02f * float(i % table_sets);
            std::uint32_t material = 0;
            require(tsu_set_add(set_, tsu_marschner(), &params_[i], &material), "adding");
        }
        require(tsu_set_bake(set_), "baking");
        counted_ = guest(context, counted_proc);
        plain_ = guest(context, offscreen_proc);
        if (!uncounted().empty()) {
            throw std::runtime_error("GL functions that are not counted: " + uncounted());
        }
    }
    ~Scene()
    {
        tsu_gl_destroy(plain_);
        tsu_gl_destroy(counted_);
        tsu_set_destroy(set_);
        tsu_context_destroy(library_);
    }
    Scene(const Scene &) = delete;
    Scene &operator=(const Scene &) = delete;

    // Other values for the first `count` materials, such that nothing is baked.
    void change(std::uint32_t count)
    {
        step_ = (step_ + 1) % 100;
        for (std::uint32_t i = 0; i < count; i++) {
            params_[i].alpha_R = -0.1f + 1e-3f * float(step_);
            require(tsu_set_update(set_, i, &params_[i], nullptr), "changing");
        }
    }
    void sync(bool counting)
    {
        require(tsu_gl_sync(counting ? counted_ : plain_, set_), "tsu_gl_sync");
    }
    void bind(bool counting)
    {
        require(tsu_gl_bind(counting ? counted_ : plain_, 0, unit, block), "tsu_gl_bind");
    }
    void finish() const
    {
        gl_.Finish();
    }
    std::uint64_t allocations() const
    {
        return allocations_;
    }
    std::uint32_t size() const
    {
        return std::uint32_t(params_.size());
    }

  private:
    tsu_gl *guest(const Context &context, tsu_gl_proc_fn proc)
    {
        tsu_gl *made = nullptr;
        tsu_gl_desc desc;
        tsu_gl_desc_init(&desc);
        desc.get_proc_address = proc;
        desc.user = context.user();
        require(tsu_gl_create(library_, &desc, &made), "tsu_gl_create");
        require(tsu_gl_sync(made, set_), "tsu_gl_sync");
        return made;
    }

    const gl_api &gl_;
    std::uint64_t allocations_ = 0;
    tsu_context *library_ = nullptr;
    tsu_set *set_ = nullptr;
    tsu_gl *counted_ = nullptr, *plain_ = nullptr;
    std::vector<tsu_marschner_params> params_;
    int step_ = 0;
};

// `frame` once with counts, then by the clock, as many of them as make a sample.
void measure(Scene &scene, const char *name, int rounds, Rows &rows,
             const std::function<void(bool counting)> &frame)
{
    const std::string key = std::to_string(scene.size()), prefix = std::string(name) + ".";
    frame(true); // what happens at the first time alone
    counts = {};
    const std::uint64_t before = scene.allocations();
    frame(true);
    rows.push_back({"api", prefix + "calls", key, double(counts.calls)});
    rows.push_back({"api", prefix + "bytes", key, double(counts.bytes)});
    rows.push_back({"api", prefix + "allocations", key, double(scene.allocations() - before)});
    const auto sample = [&](int repeats) {
        scene.finish();
        const double start = worked();
        for (int i = 0; i < repeats; i++) {
            frame(false);
        }
        return (worked() - start) / repeats;
    };
    int repeats = 1;
    while (sample(repeats) * repeats < least_sample) {
        repeats *= 2;
    }
    std::vector<double> times;
    for (int round = 0; round < rounds; round++) {
        times.push_back(sample(repeats));
    }
    rows.push_back({"api", prefix + "ns", key, median(std::move(times))});
}

} // namespace

Rows measure_api(const Context &context, int rounds)
{
    const int count = rounds ? rounds : 41;
    Rows rows;
    for (std::uint32_t materials = 1; materials <= 10000; materials *= 10) {
        Scene scene(context, materials);
        measure(scene, "unchanged", count, rows, [&](bool counting) {
            scene.sync(counting);
            scene.bind(counting);
        });
        measure(scene, "bind", count, rows, [&](bool counting) { scene.bind(counting); });
        const std::pair<const char *, std::uint32_t> changes[] = {{"one_changed", 1},
                                                                  {"all_changed", materials}};
        for (const auto &[name, changed] : changes) {
            measure(scene, name, count, rows, [&, n = changed](bool counting) {
                scene.change(n);
                scene.sync(counting);
                scene.bind(counting);
            });
        }
    }
    return rows;
}

} // namespace tsuya::bench

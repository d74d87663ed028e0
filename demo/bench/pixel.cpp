#include "bench/measure.h"

#include <tsuya/tsuya.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tsuya::bench
{

namespace
{

struct Library {
    tsu_context *context = nullptr;

    Library()
    {
        tsu_context_desc desc;
        tsu_context_desc_init(&desc);
        if (tsu_context_create(&desc, &context) != TSU_OK) {
            throw std::runtime_error("the library makes no context");
        }
    }
    ~Library()
    {
        tsu_context_destroy(context);
    }
    Library(const Library &) = delete;
    Library &operator=(const Library &) = delete;
};

// Nanoseconds of one draw.
struct Time {
    double own, wall;
};

// Times draws: by the GPU's own clock where there is one, else by the processor's.
class Timer
{
  public:
    explicit Timer(const Context &context) : gl_(context.gl()), queries_(!context.software())
    {
        if (queries_) {
            gl_.GenQueries(1, &query_);
        }
    }
    ~Timer()
    {
        if (queries_) {
            gl_.DeleteQueries(1, &query_);
        }
    }
    Timer(const Timer &) = delete;
    Timer &operator=(const Timer &) = delete;

    // Each draw is finished before the next: an opaque one would make a tiler forget it.
    Time sample(Stage &stage, const draw::Program &program, int repeats)
    {
        const double start = worked(), begin = wall();
        double on_gpu = 0;
        for (int i = 0; i < repeats; i++) {
            if (queries_) {
                gl_.BeginQuery(GL_TIME_ELAPSED, query_);
            }
            stage.draw(program);
            if (queries_) {
                GLuint64 time = 0;
                gl_.EndQuery(GL_TIME_ELAPSED);
                gl_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &time);
                on_gpu += double(time);
            }
            gl_.Finish();
        }
        const double own = queries_ ? on_gpu : worked() - start;
        return {own / repeats, (wall() - begin) / repeats};
    }

  private:
    const gl_api &gl_;
    bool queries_;
    GLuint query_ = 0;
};

struct Shader {
    std::string name;
    draw::Program program;
    int repeats = 1;
    std::vector<double> times, walls;
};

// A shader that draws nonsense is not worth a time.
void check(const Stage &stage, const std::string &name)
{
    double sum = 0;
    for (const float value : stage.pixels()) {
        if (!(std::isfinite(value) && value >= 0.0f)) {
            throw std::runtime_error(name + " draws a pixel that is not finite and positive");
        }
        sum += double(value);
    }
    // Alpha alone gives one.
    if (!(sum > 1.001 * stage.size() * stage.size())) {
        throw std::runtime_error(name + " draws black");
    }
}

double ratio(const Shader &shader, const Shader &base)
{
    std::vector<double> ratios;
    for (std::size_t i = 0; i < shader.times.size(); i++) {
        ratios.push_back(shader.times[i] / base.times[i]);
    }
    return median(std::move(ratios));
}

} // namespace

Rows measure_pixels(const Context &context, int size, int rounds)
{
    const std::string driver = context.driver();
    const Library library;
    Stage stage(context, library.context, size ? size : driver == "softpipe" ? 64 : 256);
    Timer timer(context);
    std::vector<Shader> shaders;
    for (const char *name : {"lambert", "ggx", "kajiya_kay"}) {
        shaders.push_back({std::string("baseline_") + name, stage.baseline(name), 1, {}, {}});
    }
    for (const Tier &tier : tiers()) {
        shaders.push_back({tier.name, stage.tier(tier), 1, {}, {}});
    }
    for (Shader &shader : shaders) {
        timer.sample(stage, shader.program, 1); // the driver compiles at the first draw
        check(stage, shader.name);
        const double once = timer.sample(stage, shader.program, 1).own;
        shader.repeats = int(std::clamp(least_sample / std::max(once, 1.0), 1.0, 100.0));
    }
    for (int round = 0; round < (rounds ? rounds : 41); round++) {
        for (Shader &shader : shaders) {
            const Time time = timer.sample(stage, shader.program, shader.repeats);
            shader.times.push_back(time.own);
            shader.walls.push_back(time.wall);
        }
    }
    Rows rows;
    const double pixels = double(stage.size()) * stage.size();
    for (const Shader &shader : shaders) {
        rows.push_back({shader.name, "pixel", driver + "/ns", median(shader.times) / pixels});
        rows.push_back({shader.name, "pixel", driver + "/wall_ns", median(shader.walls) / pixels});
        rows.push_back({shader.name, "pixel", driver + "/lambert", ratio(shader, shaders[0])});
        rows.push_back({shader.name, "pixel", driver + "/ggx", ratio(shader, shaders[1])});
    }
    return rows;
}

} // namespace tsuya::bench

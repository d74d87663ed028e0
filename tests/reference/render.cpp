#include "reference/render.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace tsuya::reference {

Path Camera::path(double u, double v) const
{
    const glm::dvec3 through((2.0 * u - 1.0) * tan_x, (1.0 - 2.0 * v) * tan_y, -1.0);
    Path path;
    path.start.position = eye;
    path.direction = glm::normalize(world * through);
    path.near = near * glm::length(through);
    return path;
}

namespace {

void sample_row(const Tracer &tracer, const Camera &camera, const Work &work, Film &film, int y,
                const std::atomic<bool> &stop)
{
    for (int x = 0; x < film.width() && !stop; x++) {
        Pixel &pixel = film.at(x, y);
        const std::uint64_t place =
            std::uint64_t(y) * std::uint64_t(film.width()) + std::uint64_t(x);
        while (pixel.samples < work.samples) {
            Random random(work.seed, place, pixel.samples);
            const double u = (x + random.unit()) / film.width();
            const double v = (y + random.unit()) / film.height();
            pixel.add(tracer.sample(camera.path(u, v), random));
        }
    }
}

} // namespace

bool render(const Tracer &tracer, const Camera &camera, const Work &work, Film &film,
            const std::function<bool(double done)> &tick)
{
    std::atomic<int> next{0}, done{0};
    std::atomic<bool> stop{false};
    std::mutex mutex;
    std::condition_variable ready;
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(work.threads, 1u); i++) {
        threads.emplace_back([&] {
            for (int y = next++; y < film.height() && !stop; y = next++) {
                sample_row(tracer, camera, work, film, y, stop);
                const std::lock_guard<std::mutex> lock(mutex);
                done++;
                ready.notify_one();
            }
        });
    }
    if (tick) {
        std::unique_lock<std::mutex> lock(mutex);
        while (!stop && done < film.height()) {
            ready.wait_for(lock, std::chrono::milliseconds(200));
            if (!tick(double(done) / film.height())) {
                stop = true;
            }
        }
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    return !stop || film.summary().samples >= work.samples;
}

} // namespace tsuya::reference

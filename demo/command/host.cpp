#include "host.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace tsuya::command {

unsigned threads()
{
    return std::max(1u, std::thread::hardware_concurrency());
}

void parallel(std::uint32_t count, const std::function<void(std::uint32_t)> &body)
{
    std::atomic<std::uint32_t> next{0};
    const auto work = [&] {
        for (std::uint32_t i = next++; i < count; i = next++) {
            body(i);
        }
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < std::min<std::uint32_t>(threads(), count); i++) {
        others.emplace_back(work);
    }
    work();
    for (std::thread &other : others) {
        other.join();
    }
}

static void jobs(void *, void (*job)(void *data, std::uint32_t index), void *data,
                 std::uint32_t count)
{
    parallel(count, [&](std::uint32_t i) { job(data, i); });
}

void Host::log(void *user, std::int32_t level, std::int32_t, const char *text)
{
    Host *const self = static_cast<Host *>(user);
    if (level == TSU_LOG_ERROR) {
        const std::lock_guard<std::mutex> lock(self->mutex_);
        self->text_ = text;
    }
}

Host::Host(Jobs where)
{
    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    desc.log = log;
    desc.log_user = this;
    desc.jobs = where == Jobs::all_cores ? jobs : nullptr;
    const tsu_status status = tsu_context_create(&desc, &context_);
    if (status != TSU_OK) {
        throw std::runtime_error(why(status));
    }
}

Host::~Host()
{
    tsu_context_destroy(context_);
}

tsu_context *Host::context() const
{
    return context_;
}

std::string Host::why(tsu_status status) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string text = text_.empty() ? tsu_status_text(status) : text_;
    const std::size_t end = text.find("] ");
    if (text[0] == '[' && end != std::string::npos) {
        text.erase(0, end + 2);
    }
    return text;
}

Set::Set(const Host &host)
{
    tsu_set_desc desc;
    tsu_set_desc_init(&desc);
    const tsu_status status = tsu_set_create(host.context(), &desc, &set_);
    if (status != TSU_OK) {
        throw std::runtime_error(host.why(status));
    }
}

Set::~Set()
{
    tsu_set_destroy(set_);
}

tsu_set *Set::get() const
{
    return set_;
}

} // namespace tsuya::command

// The command as a host of the library: context, log and jobs.
#ifndef TSUYA_DEMO_COMMAND_HOST_H
#define TSUYA_DEMO_COMMAND_HOST_H

#include <tsuya/set.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace tsuya::command {

// Number of threads that a parallel section uses, at least 1.
unsigned threads();

// Calls body(i) once for every i < count, on all cores; returns when all are done.
void parallel(std::uint32_t count, const std::function<void(std::uint32_t)> &body);

// A context that bakes on all cores and remembers the last error of its log.
class Host
{
  public:
    enum class Jobs { one_core, all_cores };

    // Throws std::runtime_error when there is no memory; so does set().
    explicit Host(Jobs jobs = Jobs::all_cores);
    ~Host();
    Host(const Host &) = delete;
    Host &operator=(const Host &) = delete;

    tsu_context *context() const;

    // The last error that the library logged, without its number, as a sentence; else the name of
    // `status`.
    std::string why(tsu_status status) const;

  private:
    static void log(void *user, std::int32_t level, std::int32_t code, const char *text);

    tsu_context *context_ = nullptr;
    mutable std::mutex mutex_;
    std::string text_;
};

// A set that is destroyed with its scope.
class Set
{
  public:
    explicit Set(const Host &host);
    ~Set();
    Set(const Set &) = delete;
    Set &operator=(const Set &) = delete;

    tsu_set *get() const;

  private:
    tsu_set *set_ = nullptr;
};

} // namespace tsuya::command

#endif

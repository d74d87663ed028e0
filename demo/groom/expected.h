// A value, or the one sentence that says why there is none.
#ifndef TSUYA_GROOM_EXPECTED_H
#define TSUYA_GROOM_EXPECTED_H

#include <string>
#include <utility>
#include <variant>

namespace tsuya::groom {

// Why a call failed: a full sentence that names the field or the byte offset,
// what was found there and what is allowed.
struct Error {
    std::string message;
};

// What the calls of this folder return; none of them throws. Test it before
// use: `value()` and `*` need a value, `error()` needs an error.
template <class T> class Expected
{
  public:
    Expected(T value) : state_(std::move(value))
    {
    }
    Expected(Error error) : state_(std::move(error))
    {
    }

    explicit operator bool() const
    {
        return state_.index() == 0;
    }
    T &value()
    {
        return *std::get_if<0>(&state_);
    }
    const T &value() const
    {
        return *std::get_if<0>(&state_);
    }
    T &operator*()
    {
        return value();
    }
    const T &operator*() const
    {
        return value();
    }
    T *operator->()
    {
        return &value();
    }
    const T *operator->() const
    {
        return &value();
    }
    const std::string &error() const
    {
        return std::get_if<1>(&state_)->message;
    }

  private:
    std::variant<T, Error> state_;
};

} // namespace tsuya::groom

#endif

// Private to the readers: the bytes of a file, and errors about them.
#ifndef TSUYA_GROOM_BYTES_H
#define TSUYA_GROOM_BYTES_H

#include "expected.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace tsuya::groom {

// An Error out of its parts, each written with <<.
template <class... Args> Error fail(const Args &...args)
{
    std::ostringstream out;
    (out << ... << args);
    return Error{out.str()};
}

// The little-endian bytes of a file. Callers check `holds()` before they fetch.
class Bytes
{
  public:
    Bytes(const std::uint8_t *data, std::size_t size) : data_(data), size_(size)
    {
    }

    std::uint64_t size() const
    {
        return size_;
    }
    bool holds(std::uint64_t offset, std::uint64_t bytes) const
    {
        return offset <= size_ && bytes <= size_ - offset;
    }
    std::uint32_t u16(std::uint64_t at) const
    {
        return std::uint32_t(data_[at]) | std::uint32_t(data_[at + 1]) << 8;
    }
    std::uint32_t u32(std::uint64_t at) const
    {
        return u16(at) | u16(at + 2) << 16;
    }
    float f32(std::uint64_t at) const
    {
        const std::uint32_t bits = u32(at);
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }

  private:
    const std::uint8_t *data_;
    std::uint64_t size_;
};

// "`what` at offset 4 needs 8 bytes but 5 are left of 9".
inline Error too_short(const Bytes &file, const char *what, std::uint64_t at, std::uint64_t needed)
{
    return fail(what, " at offset ", at, " needs ", needed, " bytes but ",
                at < file.size() ? file.size() - at : 0, " are left of ", file.size());
}

} // namespace tsuya::groom

#endif

// The texture of a set, as a file.
#ifndef TSUYA_DEMO_COMMAND_TEXTURE_H
#define TSUYA_DEMO_COMMAND_TEXTURE_H

#include <tsuya/set.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::command {

// A copy of a set's RGBA16F texels; one texel of zeros when the set has no table.
class Texture
{
  public:
    enum class Format { exr, csv, bin };

    // Format by the ending of `path`. Errors: the path is empty or ends otherwise.
    static bool format_of(const std::string &path, Format &format, std::string &error);

    explicit Texture(const tsu_set *set);

    std::uint32_t width() const;
    std::uint32_t height() const;
    std::size_t bytes() const;

    // Replaces the file as a whole. The formats are described by `tsuya bake --help`.
    bool write(const std::string &path, Format format, std::string &error) const;

  private:
    std::string csv() const;
    std::string bin() const;

    std::uint32_t width_ = 1, height_ = 1;
    std::vector<std::uint16_t> halves_;
};

// The value of an IEEE 754 half.
float half_to_float(std::uint16_t half);

} // namespace tsuya::command

#endif

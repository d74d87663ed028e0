#include "texture.h"

#include "../image/file.h"
#include "number.h"

#include <cmath>
#include <limits>

namespace tsuya::command {

float half_to_float(std::uint16_t half)
{
    const int exponent = (half >> 10) & 31, fraction = half & 1023;
    float value = std::ldexp(float(fraction + 1024), exponent - 25);
    if (exponent == 0) {
        value = std::ldexp(float(fraction), -24);
    } else if (exponent == 31) {
        value = fraction ? std::numeric_limits<float>::quiet_NaN()
                         : std::numeric_limits<float>::infinity();
    }
    return half & 0x8000 ? -value : value;
}

bool Texture::format_of(const std::string &path, Format &format, std::string &error)
{
    const std::size_t dot = path.rfind('.');
    const std::string ending = dot == std::string::npos ? "" : path.substr(dot);
    if (ending == ".exr") {
        format = Format::exr;
    } else if (ending == ".csv") {
        format = Format::csv;
    } else if (ending == ".bin") {
        format = Format::bin;
    } else {
        error = path.empty()
                    ? "-o FILE is missing; its ending, .exr, .csv or .bin, says the format."
                    : "\"" + path + "\" ends in none of .exr, .csv, .bin.";
        return false;
    }
    return true;
}

Texture::Texture(const tsu_set *set) : halves_(4)
{
    tsu_set_info info;
    tsu_set_info_init(&info);
    tsu_set_describe(set, &info);
    const std::uint16_t *const texels = tsu_set_texels(set);
    if (texels && info.width && info.height) {
        width_ = info.width;
        height_ = info.height;
        halves_.assign(texels, texels + std::size_t(width_) * height_ * 4);
    }
}

std::uint32_t Texture::width() const
{
    return width_;
}

std::uint32_t Texture::height() const
{
    return height_;
}

std::size_t Texture::bytes() const
{
    return halves_.size() * sizeof halves_[0];
}

std::string Texture::csv() const
{
    std::string text = "x,y,r,g,b,a\n";
    for (std::size_t i = 0; i < halves_.size(); i += 4) {
        text += std::to_string(i / 4 % width_) + "," + std::to_string(i / 4 / width_);
        for (std::size_t c = 0; c < 4; c++) {
            text += ',';
            append_number(text, double(half_to_float(halves_[i + c])), 9);
        }
        text += '\n';
    }
    return text;
}

std::string Texture::bin() const
{
    std::string text = "TSUYATEX";
    for (const std::uint32_t number : {1u, 32u, width_, height_, 4u, 2u}) {
        for (int shift = 0; shift < 32; shift += 8) {
            text += char(number >> shift & 255);
        }
    }
    for (const std::uint16_t half : halves_) {
        text += char(half & 255);
        text += char(half >> 8);
    }
    return text;
}

bool Texture::write(const std::string &path, Format format, std::string &error) const
{
    if (format == Format::exr) {
        image::Image image;
        image.width = int(width_);
        image.height = int(height_);
        image.channels = 4;
        for (const std::uint16_t half : halves_) {
            image.pixels.push_back(half_to_float(half));
        }
        return image::write_exr(path, image, error);
    }
    const std::string text = format == Format::csv ? csv() : bin();
    return image::replace_file(
        path,
        [&](std::FILE *file, std::string &why) {
            why = "the disk is full";
            return std::fwrite(text.data(), 1, text.size(), file) == text.size();
        },
        error);
}

} // namespace tsuya::command

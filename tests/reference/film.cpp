#include "reference/film.h"

#include "image/file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace tsuya::reference {

namespace {

// Little-endian machines only read what they wrote; the order is checked by the magic number.
struct Header {
    std::uint64_t magic = 0x3152464559555354u; // "TSUYEFR1"
    std::uint64_t key = 0;
    std::uint64_t width = 0, height = 0;
};
static_assert(sizeof(Header) == 32, "no padding");
static_assert(sizeof(Pixel) == 80, "no padding");

std::uint64_t sum_of(const Header &header, const std::vector<Pixel> &pixels)
{
    const std::uint64_t key = key_of(&header, sizeof header, 0xcbf29ce484222325u);
    return key_of(pixels.data(), pixels.size() * sizeof(Pixel), key);
}

} // namespace

void Pixel::add(const Sample &sample)
{
    const glm::dvec3 &c = sample.radiance;
    const double values[4] = {c.x, c.y, c.z, 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z};
    for (std::size_t i = 0; i < 4; i++) {
        sum[i] += values[i];
        squares[i] += values[i] * values[i];
    }
    hair += sample.hair;
    samples++;
}

double Pixel::mean(int channel) const
{
    return samples ? sum[std::size_t(channel)] / double(samples) : 0.0;
}

double Pixel::standard_error(int channel) const
{
    if (samples < 2) {
        return 0.0;
    }
    const double n = double(samples), m = mean(channel);
    const double variance = squares[std::size_t(channel)] / n - m * m;
    return std::sqrt(std::max(variance, 0.0) / (n - 1.0));
}

Film::Film(int width, int height)
    : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height))
{
}

Pixel &Film::at(int x, int y)
{
    return pixels_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
}

const Pixel &Film::at(int x, int y) const
{
    return pixels_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
}

image::Image Film::image() const
{
    image::Image image = {width_, height_, 8, {},
                          {"R", "G", "B", "hair", "se.R", "se.G", "se.B", "se.Y"}};
    for (const Pixel &pixel : pixels_) {
        for (int c = 0; c < 3; c++) {
            image.pixels.push_back(float(pixel.mean(c)));
        }
        image.pixels.push_back(float(pixel.samples ? pixel.hair / double(pixel.samples) : 0.0));
        for (int c = 0; c < 4; c++) {
            image.pixels.push_back(float(pixel.standard_error(c)));
        }
    }
    return image;
}

Summary Film::summary() const
{
    Summary result;
    result.samples = ~std::uint64_t(0);
    double variance = 0.0, hair_variance = 0.0, weight = 0.0;
    for (const Pixel &pixel : pixels_) {
        const double y = pixel.mean(3), error = pixel.standard_error(3);
        const double hair = pixel.samples ? pixel.hair / double(pixel.samples) : 0.0;
        result.samples = std::min(result.samples, pixel.samples);
        result.samples_most = std::max(result.samples_most, pixel.samples);
        result.mean += y;
        variance += error * error;
        result.hair += hair * y;
        hair_variance += hair * error * error;
        weight += hair;
    }
    const double count = double(pixels_.size());
    result.mean /= count;
    result.mean_error = std::sqrt(variance) / count;
    result.hair = weight > 0.0 ? result.hair / weight : 0.0;
    result.hair_error = weight > 0.0 ? std::sqrt(hair_variance / weight) : 0.0;
    result.coverage = weight / count;
    return result;
}

Expected<bool> Film::write(const std::string &path, std::uint64_t key) const
{
    Header header;
    header.key = key;
    header.width = std::uint64_t(width_);
    header.height = std::uint64_t(height_);
    std::string error;
    const bool good = image::replace_file(
        path,
        [&](std::FILE *file, std::string &why) {
            const std::uint64_t sum = sum_of(header, pixels_);
            const bool whole =
                std::fwrite(&header, sizeof header, 1, file) == 1 &&
                std::fwrite(pixels_.data(), sizeof(Pixel), pixels_.size(), file) ==
                    pixels_.size() &&
                std::fwrite(&sum, sizeof sum, 1, file) == 1;
            why = whole ? "" : std::strerror(errno);
            return whole;
        },
        error);
    return good ? Expected<bool>(true) : Error{error};
}

Expected<Film> Film::read(const std::string &path, std::uint64_t key, int width, int height)
{
    std::FILE *file = std::fopen(path.c_str(), "rb");
    if (!file) {
        return Error{"cannot read " + path + ": " + std::strerror(errno)};
    }
    Header header;
    const Header expected;
    Film film(width, height);
    std::uint64_t sum = 0;
    std::string wrong;
    if (std::fread(&header, sizeof header, 1, file) != 1 || header.magic != expected.magic) {
        wrong = " is no state of this program";
    } else if (header.width != std::uint64_t(width) || header.height != std::uint64_t(height)) {
        wrong = " holds a picture of " + std::to_string(header.width) + "x" +
                std::to_string(header.height) + ", not " + std::to_string(width) + "x" +
                std::to_string(height);
    } else if (header.key != key) {
        wrong = " belongs to another scene, groom or --seed";
    } else if (std::fread(film.pixels_.data(), sizeof(Pixel), film.pixels_.size(), file) !=
                   film.pixels_.size() ||
               std::fread(&sum, sizeof sum, 1, file) != 1 || std::fgetc(file) != EOF) {
        wrong = " has not the size that its header says";
    } else if (sum != sum_of(header, film.pixels_)) {
        wrong = " is damaged: its checksum does not match";
    }
    std::fclose(file);
    return wrong.empty() ? Expected<Film>(film) : Error{path + wrong};
}

std::uint64_t key_of(const void *bytes, std::size_t size, std::uint64_t key)
{
    const unsigned char *const at = static_cast<const unsigned char *>(bytes);
    for (std::size_t i = 0; i < size; i++) {
        key = (key ^ at[i]) * 0x100000001b3u;
    }
    return key;
}

} // namespace tsuya::reference

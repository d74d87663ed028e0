// Sums of samples in every pixel, their picture with its standard error, and their state file.
#ifndef TSUYA_TESTS_REFERENCE_FILM_H
#define TSUYA_TESTS_REFERENCE_FILM_H

#include "groom/expected.h"
#include "image/image.h"
#include "reference/tracer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::reference {

using groom::Error;
using groom::Expected;

// Samples of a pixel. Red, green, blue and Rec. 709 luminance.
struct Pixel {
    std::array<double, 4> sum{};
    std::array<double, 4> squares{};
    double hair = 0.0;
    std::uint64_t samples = 0;

    void add(const Sample &sample);
    double mean(int channel) const;
    // Of the mean; 0 before the second sample.
    double standard_error(int channel) const;
};

// What a whole picture says. Hair: weighed by the share of each pixel that it covers.
struct Summary {
    std::uint64_t samples = 0; // least of any pixel
    std::uint64_t samples_most = 0;
    double mean = 0.0;       // luminance over all pixels
    double mean_error = 0.0; // its standard error
    double hair = 0.0;       // luminance
    double hair_error = 0.0; // root mean square of the pixels' standard errors of luminance
    double coverage = 0.0;   // mean share that hair covers
};

class Film
{
  public:
    Film(int width, int height);

    int width() const
    {
        return width_;
    }
    int height() const
    {
        return height_;
    }
    // Top row first.
    Pixel &at(int x, int y);
    const Pixel &at(int x, int y) const;

    // Channels R, G, B, hair, se.R, se.G, se.B, se.Y: linear light, the share of the pixel that hair
    // covers, and the standard errors of the first three and of their luminance.
    image::Image image() const;
    Summary summary() const;

    // Write all sums to `path`, whole or not at all.
    //   key  of what was rendered; read() wants the same
    Expected<bool> write(const std::string &path, std::uint64_t key) const;
    // Errors: it cannot be read, is no state file, is cut short, has another size or key.
    static Expected<Film> read(const std::string &path, std::uint64_t key, int width, int height);

  private:
    int width_, height_;
    std::vector<Pixel> pixels_;
};

// 64-bit FNV-1a of bytes, going on from `key`.
std::uint64_t key_of(const void *bytes, std::size_t size, std::uint64_t key = 0xcbf29ce484222325u);

} // namespace tsuya::reference

#endif

#include "file.h"

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <unistd.h>

namespace tsuya::image {

float srgb_encode(float linear)
{
    const double x = linear > 0 ? std::fmin(double(linear), 1.0) : 0.0;
    return float(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

float srgb_decode(float display)
{
    const double x = display > 0 ? std::fmin(double(display), 1.0) : 0.0;
    return float(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
}

int channel(const Image &image, const std::string &name)
{
    static const char *const usual[4][4] = {
        {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    for (int c = 0; c < image.channels; c++) {
        const bool named = std::size_t(c) < image.names.size();
        const bool implied = image.names.empty() && image.channels <= 4;
        if ((named && image.names[std::size_t(c)] == name) ||
            (implied && name == usual[image.channels - 1][c])) {
            return c;
        }
    }
    return -1;
}

bool fail(std::string &error, const char *what, const std::string &path, const std::string &why)
{
    error = std::string("cannot ") + what + " " + path + ": " + why + ".";
    return false;
}

std::string defect(const Image &image)
{
    if (image.width < 1 || image.height < 1 || image.channels < 1) {
        return "the picture is empty";
    }
    const std::size_t row = std::size_t(image.width) * std::size_t(image.channels);
    if (image.pixels.size() / row != std::size_t(image.height) || image.pixels.size() % row != 0) {
        return "the picture holds " + std::to_string(image.pixels.size()) +
               " values, not width x height x channels";
    }
    return {};
}

bool replace_file(const std::string &path,
                  const std::function<bool(std::FILE *file, std::string &why)> &body,
                  std::string &error)
{
    static std::atomic<unsigned> count{0};
    const std::string part =
        path + "." + std::to_string(getpid()) + "-" + std::to_string(count++) + ".part";

    std::FILE *file = std::fopen(part.c_str(), "wbx");
    if (!file) {
        return fail(error, "write", path, std::strerror(errno));
    }
    std::string why;
    bool good = body(file, why);
    if (good && (std::fflush(file) != 0 || std::ferror(file))) {
        why = std::strerror(errno);
        good = false;
    }
    if (std::fclose(file) != 0 && good) {
        why = std::strerror(errno);
        good = false;
    }
    if (good && std::rename(part.c_str(), path.c_str()) != 0) {
        why = std::strerror(errno);
        good = false;
    }
    if (!good) {
        std::remove(part.c_str());
        return fail(error, "write", path, why);
    }
    return true;
}

} // namespace tsuya::image

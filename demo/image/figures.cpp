#include "image/figures.h"

#include <algorithm>
#include <cmath>

namespace tsuya::image {

namespace {

constexpr double hair_least = 0.3, floor_share = 0.1;
constexpr int around = 2; // pixels to each side that b(r) is the mean over

const double luminance_of[3] = {0.2126, 0.7152, 0.0722};

double luminance(Pixels p)
{
    return luminance_of[0] * double(p[0]) + luminance_of[1] * double(p[1]) +
           luminance_of[2] * double(p[2]);
}

bool is_hair(Pixels picture, std::size_t pixel)
{
    return double(picture[4 * pixel + 3]) > hair_least;
}

// What the traced picture is divided by in each hair pixel.
struct Scale {
    double blurred = 0.0, variance = 0.0; // b(r) and the square of its standard error
    double square = 0.0;                  // b(r)^2 + (0.1 m)^2
};
using Scales = std::vector<std::array<Scale, 4>>;

// Calls with the hair pixels around pixel (x, y), itself included.
template <class Call>
void around_pixel(const Traced &traced, Pixels shares, int x, int y, const Call &call)
{
    for (int v = std::max(y - around, 0); v <= std::min(y + around, traced.height - 1); v++) {
        for (int u = std::max(x - around, 0); u <= std::min(x + around, traced.width - 1); u++) {
            const std::size_t at = std::size_t(v) * std::size_t(traced.width) + std::size_t(u);
            if (is_hair(shares, at)) {
                call(at);
            }
        }
    }
}

struct Ground {
    Scales scales;
    std::vector<int> met;           // hair pixels around each
    std::array<double, 4> middle{}; // m
    double pixels = 0.0;            // hair pixels
};

Ground ground(const Traced &traced, Pixels shares)
{
    Ground result;
    result.scales.resize(traced.mean.size());
    result.met.resize(traced.mean.size());
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        for (std::size_t c = 0; c < 4 && is_hair(shares, i); c++) {
            result.middle[c] += traced.mean[i][c];
        }
        result.pixels += is_hair(shares, i);
    }
    for (double &m : result.middle) {
        m /= result.pixels;
    }
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        if (!is_hair(shares, i)) {
            continue;
        }
        const int x = int(i) % traced.width, y = int(i) / traced.width;
        std::array<double, 4> sum{}, squares{};
        around_pixel(traced, shares, x, y, [&](std::size_t at) {
            result.met[i]++;
            for (std::size_t c = 0; c < 4; c++) {
                sum[c] += traced.mean[at][c];
                squares[c] += traced.error[at][c] * traced.error[at][c];
            }
        });
        for (std::size_t c = 0; c < 4; c++) {
            const double n = result.met[i], least = floor_share * result.middle[c];
            const double b = sum[c] / n;
            result.scales[i][c] = {b, squares[c] / (n * n),
                                   std::max(b * b + least * least, 1e-300)};
        }
    }
    return result;
}

Measures measure(const Traced &traced, Pixels shares, Pixels picture, const Ground &ground)
{
    Measures result;
    double share = 0.0, drawn = 0.0;
    std::array<double, 4> light{}; // of the traced picture
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        const double w = double(shares[4 * i + 3]);
        const Pixels t = picture + 4 * i;
        share += w;
        drawn += w * luminance(t);
        for (std::size_t c = 0; c < 4; c++) {
            light[c] += w * traced.mean[i][c];
        }
        for (std::size_t c = 0; c < 3; c++) {
            result.channel_error[c] += w * double(t[c]);
            if (is_hair(shares, i)) {
                const double off = double(t[c]) - traced.mean[i][c], se = traced.error[i][c];
                result.channel_mse[c] +=
                    (off * off - se * se) / ground.scales[i][c].square / ground.pixels;
            }
        }
    }
    result.mean = light[3] / share;
    result.mean_error = drawn / light[3] - 1.0;
    for (std::size_t c = 0; c < 3; c++) {
        result.channel_error[c] = result.channel_error[c] / light[c] - 1.0;
        result.rel_mse += result.channel_mse[c] / 3.0;
    }
    return result;
}

// Standard error of sum(w r) over itself, in each channel.
std::array<double, 4> error_of_light(const Traced &traced, Pixels shares)
{
    std::array<double, 4> light{}, squares{};
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        const double w = double(shares[4 * i + 3]);
        for (std::size_t c = 0; c < 4; c++) {
            light[c] += w * traced.mean[i][c];
            squares[c] += w * w * traced.error[i][c] * traced.error[i][c];
        }
    }
    for (std::size_t c = 0; c < 4; c++) {
        squares[c] = std::sqrt(squares[c]) / light[c];
    }
    return squares;
}

// Sums over pixels from which the variance of a rel MSE comes.
struct Spread {
    double first = 0.0;  // square of the gradient times the standard error
    double second = 0.0; // variance of the noise's square

    void add(double slope, double square)
    {
        first += slope * slope;
        second += 2.0 * square * square;
    }
    double error() const
    {
        // The gradient is itself taken at the noisy picture, which adds twice `second`.
        return std::sqrt(std::max(first - second, second));
    }
};

// rel MSE of each channel and of all, with bias and error. With e = (t - r)^2 - se^2 and
// D = b^2 + (0.1 m)^2 a channel's is the mean of e / D.
void rel_mse(const Traced &traced, Pixels shares, Pixels picture, const Ground &ground,
             Figures &result)
{
    const double pixels = ground.pixels;
    const auto off = [&](std::size_t i, std::size_t c) {
        return double(picture[4 * i + c]) - traced.mean[i][c];
    };
    // Slopes of e / D along b, and along m summed.
    std::vector<std::array<double, 3>> along_b(traced.mean.size());
    std::array<double, 3> along_m{}, bias{};
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        for (std::size_t c = 0; c < 3 && is_hair(shares, i); c++) {
            const Scale &s = ground.scales[i][c];
            const double se2 = traced.error[i][c] * traced.error[i][c];
            const double e = off(i, c) * off(i, c) - se2;
            const double slope = -2.0 * s.blurred / (s.square * s.square); // of 1 / D
            along_b[i][c] = e * slope / pixels / ground.met[i];
            along_m[c] -= e / (s.square * s.square) * 2.0 * floor_share * floor_share *
                          ground.middle[c] / (pixels * pixels);
            const double bend = 8.0 * s.blurred * s.blurred / (s.square * s.square * s.square) -
                                2.0 / (s.square * s.square);
            bias[c] +=
                (0.5 * e * bend * s.variance - 2.0 * off(i, c) * slope * se2 / ground.met[i]) /
                pixels;
        }
    }
    Spread all;
    std::array<Spread, 3> own;
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        if (!is_hair(shares, i)) {
            continue;
        }
        std::array<double, 3> slope{};
        around_pixel(traced, shares, int(i) % traced.width, int(i) / traced.width,
                     [&](std::size_t at) {
                         for (std::size_t c = 0; c < 3; c++) {
                             slope[c] += along_b[at][c];
                         }
                     });
        double slopes = 0.0, squares = 0.0;
        for (std::size_t c = 0; c < 3; c++) {
            const double se = traced.error[i][c],
                         weight = 1.0 / (ground.scales[i][c].square * pixels);
            const double change = (slope[c] + along_m[c] - 2.0 * weight * off(i, c)) * se;
            own[c].add(change, weight * se * se);
            slopes += change / 3.0;
            squares += weight * se * se / 3.0;
        }
        all.add(slopes, squares);
    }
    result.rel_mse.error = all.error();
    for (std::size_t c = 0; c < 3; c++) {
        result.channel_mse[c].value -= bias[c];
        result.channel_mse[c].error = own[c].error();
        result.rel_mse.value -= bias[c] / 3.0;
    }
}

} // namespace

bool traced(const Image &image, Traced &traced, std::string &error)
{
    static const char *const names[6] = {"R", "G", "B", "se.R", "se.G", "se.B"};
    std::array<int, 7> at{};
    for (std::size_t k = 0; k < 6; k++) {
        at[k] = channel(image, names[k]);
        if (at[k] < 0) {
            error = std::string("there is no channel ") + names[k] +
                    (k < 3 ? "" : ", the standard error that tsuya reference writes");
            return false;
        }
    }
    at[6] = channel(image, "se.Y");
    Traced result;
    result.width = image.width;
    result.height = image.height;
    const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
    for (std::size_t i = 0; i < count; i++) {
        const Pixels p = image.pixels.data() + i * std::size_t(image.channels);
        std::array<double, 4> mean{}, own{};
        for (std::size_t c = 0; c < 3; c++) {
            mean[c] = double(p[at[c]]);
            own[c] = double(p[at[3 + c]]);
            mean[3] += luminance_of[c] * mean[c];
            own[3] += luminance_of[c] * own[c];
        }
        own[3] = at[6] < 0 ? own[3] : double(p[at[6]]);
        for (std::size_t c = 0; c < 4; c++) {
            if (!std::isfinite(mean[c]) || !std::isfinite(own[c]) || own[c] < 0.0) {
                error = "pixel (" + std::to_string(i % std::size_t(image.width)) + ", " +
                        std::to_string(i / std::size_t(image.width)) + ") holds " +
                        (own[c] < 0.0 ? "a negative standard error" : "a value that is not finite");
                return false;
            }
        }
        result.mean.push_back(mean);
        result.error.push_back(own);
    }
    traced = std::move(result);
    return true;
}

std::size_t hair_pixels(const Traced &traced, Pixels picture)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        count += is_hair(picture, i);
    }
    return count;
}

std::vector<Measures> measures(const Traced &traced, const std::vector<Pixels> &pictures)
{
    const Ground all = ground(traced, pictures[0]);
    std::vector<Measures> result;
    for (const Pixels picture : pictures) {
        result.push_back(measure(traced, pictures[0], picture, all));
    }
    return result;
}

std::vector<Figures> figures(const Traced &traced, const std::vector<Pixels> &pictures)
{
    const Pixels shares = pictures[0];
    const Ground all = ground(traced, shares);
    const std::array<double, 4> light = error_of_light(traced, shares);
    std::vector<Figures> result;
    for (const Pixels picture : pictures) {
        const Measures m = measure(traced, shares, picture, all);
        Figures f;
        f.mean = {m.mean, m.mean * light[3]};
        f.mean_error = {m.mean_error, (1.0 + m.mean_error) * light[3]};
        f.rel_mse.value = m.rel_mse;
        for (std::size_t c = 0; c < 3; c++) {
            f.channel_error[c] = {m.channel_error[c], (1.0 + m.channel_error[c]) * light[c]};
            f.channel_mse[c].value = m.channel_mse[c];
        }
        rel_mse(traced, shares, picture, all, f);
        result.push_back(f);
    }
    return result;
}

Figure rms(const Figure &rel_mse)
{
    const double value = std::sqrt(std::max(rel_mse.value, 0.0));
    const double at = std::max(value, std::sqrt(rel_mse.error));
    return {value, at > 0.0 ? 0.5 * rel_mse.error / at : 0.0};
}

namespace {

// -1 blue, 0 white, +1 red.
void shade(double off, float *rgb)
{
    static const float blue[3] = {0.02f, 0.08f, 0.5f}, red[3] = {0.5f, 0.02f, 0.02f};
    const float far = float(std::min(std::abs(off), 1.0));
    for (std::size_t c = 0; c < 3; c++) {
        rgb[c] = 1.0f + far * ((off < 0.0 ? blue : red)[c] - 1.0f);
    }
}

} // namespace

Image error_map(const Traced &traced, Pixels picture)
{
    const Ground all = ground(traced, picture);
    const int strip = std::max(4, traced.height / 24), line = 1;
    Image image = {traced.width, traced.height + line + strip, 3, {}, {}, {}};
    image.pixels.assign(3 * std::size_t(image.width) * std::size_t(image.height), 0.25f);
    for (std::size_t i = 0; i < traced.mean.size(); i++) {
        if (is_hair(picture, i)) {
            const double off = luminance(picture + 4 * i) - traced.mean[i][3];
            shade(off / std::sqrt(all.scales[i][3].square), &image.pixels[3 * i]);
        }
    }
    for (int y = traced.height + line; y < image.height; y++) {
        for (int x = 0; x < image.width; x++) {
            shade(2.0 * (x + 0.5) / image.width - 1.0,
                  &image.pixels[3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))]);
        }
    }
    return image;
}

} // namespace tsuya::image

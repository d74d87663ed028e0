#include "reference/figures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tsuya::reference
{

namespace
{

constexpr double hair_least = 0.3, floor_share = 0.1;
constexpr int around = 2; // pixels to each side that b(r) is the mean over

// Mean luminance of the reference, error of the mean, rel MSE; the last two of each channel.
enum { mean, mean_error, rel_mse, channel_error, channel_mse = channel_error + 3, value_count = 9 };
using Values = std::array<double, value_count>;

double luminance(const float *p)
{
    return 0.2126 * double(p[0]) + 0.7152 * double(p[1]) + 0.0722 * double(p[2]);
}

// 1 / (b^2 + (0.1 m)^2) in every channel; 0 outside hair.
using Weights = std::vector<std::array<double, 3>>;

Weights weights(const Film &film, const draw::Picture &shares)
{
    const int width = film.width(), height = film.height();
    const auto hair = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < width &&
               y<height &&double(shares.pixels[std::size_t(4 * (y * width + x) + 3)])> hair_least;
    };
    Weights result(std::size_t(width) * std::size_t(height), {0.0, 0.0, 0.0});
    std::array<double, 3> middle{};
    int pixels = 0;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            for (int c = 0; c < 3 && hair(x, y); c++) {
                middle[std::size_t(c)] += film.at(x, y).mean(c);
            }
            pixels += hair(x, y);
        }
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            for (int c = 0; c < 3 && hair(x, y); c++) {
                double sum = 0.0;
                int met = 0;
                for (int v = y - around; v <= y + around; v++) {
                    for (int u = x - around; u <= x + around; u++) {
                        if (hair(u, v)) {
                            sum += film.at(u, v).mean(c);
                            met++;
                        }
                    }
                }
                const double least = floor_share * middle[std::size_t(c)] / pixels;
                const double blurred = sum / met;
                result[std::size_t(y * width + x)][std::size_t(c)] =
                    1.0 / std::max(blurred * blurred + least * least, 1e-300) / (3.0 * pixels);
            }
        }
    }
    return result;
}

std::vector<Values> values(const Film &film, const std::vector<draw::Picture> &pictures)
{
    const Weights weight = weights(film, pictures[0]);
    std::vector<Values> result(pictures.size(), Values{});
    double share = 0.0;
    std::array<double, 4> traced{}; // of R, G, B and luminance
    for (int i = 0; i < film.width() * film.height(); i++) {
        const Pixel &pixel = film.at(i % film.width(), i / film.width());
        const double w = double(pictures[0].pixels[std::size_t(4 * i + 3)]);
        share += w;
        for (int c = 0; c < 4; c++) {
            traced[std::size_t(c)] += w * pixel.mean(c);
        }
        for (std::size_t k = 0; k < pictures.size(); k++) {
            const float *const t = &pictures[k].pixels[std::size_t(4 * i)];
            result[k][mean_error] += w * luminance(t);
            for (std::size_t c = 0; c < 3; c++) {
                const double off = double(t[c]) - pixel.mean(int(c));
                const double se = pixel.standard_error(int(c));
                result[k][channel_error + c] += w * double(t[c]);
                result[k][channel_mse + c] +=
                    3.0 * weight[std::size_t(i)][c] * (off * off - se * se);
            }
        }
    }
    for (Values &v : result) {
        v[mean] = traced[3] / share;
        v[mean_error] = v[mean_error] / traced[3] - 1.0;
        for (std::size_t c = 0; c < 3; c++) {
            v[channel_error + c] = v[channel_error + c] / traced[c] - 1.0;
            v[rel_mse] += v[channel_mse + c] / 3.0;
        }
    }
    return result;
}

} // namespace

Batches::Batches(int width, int height) : films_(count, Film(width, height))
{
}

void Batches::bring(const Tracer &tracer, const Camera &camera, std::uint64_t samples,
                    std::uint64_t seed, unsigned threads)
{
    for (int b = 0; b < count; b++) {
        const std::uint64_t own = seed * count + std::uint64_t(b);
        render(tracer, camera, {samples / count, own, threads}, films_[std::size_t(b)]);
    }
}

void Batches::fill(int samples, const std::function<Sample(int, int, int)> &sample)
{
    for (int b = 0; b < count; b++) {
        Film &film = films_[std::size_t(b)];
        for (int i = 0; i < film.width() * film.height(); i++) {
            for (int n = 0; n < samples / count; n++) {
                film.at(i % film.width(), i / film.width()).add(sample(b, i, n));
            }
        }
    }
}

Film Batches::film(int without) const
{
    Film sum(films_[0].width(), films_[0].height());
    for (int b = 0; b < count; b++) {
        for (int i = 0; i < sum.width() * sum.height() && b != without; i++) {
            const int x = i % sum.width(), y = i / sum.width();
            const Pixel &from = films_[std::size_t(b)].at(x, y);
            Pixel &to = sum.at(x, y);
            for (std::size_t c = 0; c < 4; c++) {
                to.sum[c] += from.sum[c];
                to.squares[c] += from.squares[c];
            }
            to.hair += from.hair;
            to.samples += from.samples;
        }
    }
    return sum;
}

std::vector<Figures> figures(const Batches &batches, const std::vector<draw::Picture> &pictures)
{
    const std::vector<Values> all = values(batches.film(), pictures);
    std::vector<std::vector<Values>> parts;
    for (int b = 0; b < Batches::count; b++) {
        parts.push_back(values(batches.film(b), pictures));
    }
    std::vector<Figures> result(pictures.size());
    for (std::size_t k = 0; k < pictures.size(); k++) {
        std::array<Figure, value_count> f;
        for (std::size_t i = 0; i < value_count; i++) {
            const double n = Batches::count;
            double middle = 0.0, squares = 0.0;
            for (const std::vector<Values> &part : parts) {
                middle += part[k][i] / n;
            }
            for (const std::vector<Values> &part : parts) {
                squares += (part[k][i] - middle) * (part[k][i] - middle);
            }
            f[i] = {n * all[k][i] - (n - 1.0) * middle, std::sqrt(squares * (n - 1.0) / n)};
        }
        result[k] = {f[mean], f[mean_error], f[rel_mse], {}, {}};
        std::copy_n(&f[channel_error], 3, result[k].channel_error.begin());
        std::copy_n(&f[channel_mse], 3, result[k].channel_mse.begin());
    }
    return result;
}

} // namespace tsuya::reference

#include "reference/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tsuya::reference
{

namespace
{

// Values of the figures side by side.
constexpr std::size_t value_count = 9;
using Values = std::array<double, value_count>;

std::vector<Values> values(const Film &film, const std::vector<draw::Picture> &pictures)
{
    std::vector<image::Pixels> pixels;
    for (const draw::Picture &picture : pictures) {
        pixels.push_back(picture.pixels.data());
    }
    std::vector<Values> result;
    for (const image::Measures &m : image::measures(traced(film), pixels)) {
        result.push_back({m.mean, m.mean_error, m.rel_mse, m.channel_error[0], m.channel_error[1],
                          m.channel_error[2], m.channel_mse[0], m.channel_mse[1],
                          m.channel_mse[2]});
    }
    return result;
}

} // namespace

image::Traced traced(const Film &film)
{
    image::Traced result = {film.width(), film.height(), {}, {}};
    for (int i = 0; i < film.width() * film.height(); i++) {
        const Pixel &pixel = film.at(i % film.width(), i / film.width());
        result.mean.push_back({pixel.mean(0), pixel.mean(1), pixel.mean(2), pixel.mean(3)});
        result.error.push_back({pixel.standard_error(0), pixel.standard_error(1),
                                pixel.standard_error(2), pixel.standard_error(3)});
    }
    return result;
}

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

bool Batches::write(const std::string &prefix, std::uint64_t key) const
{
    bool good = true;
    for (std::size_t b = 0; b < films_.size(); b++) {
        good = good && films_[b].write(prefix + std::to_string(b), key);
    }
    return good;
}

std::uint64_t Batches::read(const std::string &prefix, std::uint64_t key)
{
    std::vector<Film> found;
    for (std::size_t b = 0; b < films_.size(); b++) {
        Expected<Film> film =
            Film::read(prefix + std::to_string(b), key, films_[b].width(), films_[b].height());
        // A run that was stopped between two files leaves batches of unlike weight.
        if (!film || (b > 0 && film->at(0, 0).samples != found[0].at(0, 0).samples)) {
            return 0;
        }
        found.push_back(std::move(*film));
    }
    films_ = std::move(found);
    return films_[0].at(0, 0).samples * count;
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
        result[k] = {f[0], f[1], f[2], {f[3], f[4], f[5]}, {f[6], f[7], f[8]}};
    }
    return result;
}

} // namespace tsuya::reference

// Figures of pictures against the reference (image/figures.h says which) in equal independent
// parts.
//
// Values and standard errors by the jackknife over batches with seeds of their own: the figures
// again without one batch, for each. It takes away the bias that goes as one over samples, needs no
// law for the noise and sees what pixels and channels share. Where the square of noise outweighs
// the picture's own error it states up to sqrt(2) times too much. `tsuya compare`, which has one
// film, carries the pixels' standard errors instead.
#ifndef TSUYA_TESTS_REFERENCE_FIGURES_H
#define TSUYA_TESTS_REFERENCE_FIGURES_H

#include "draw/renderer.h"
#include "image/figures.h"
#include "reference/film.h"
#include "reference/render.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tsuya::reference
{

using image::Figure;
using image::Figures;

// A reference in equal independent parts.
class Batches
{
  public:
    static constexpr int count = 16;

    Batches(int width, int height);

    // Bring the sum of all batches to this many samples a pixel, a multiple of `count`.
    void bring(const Tracer &tracer, const Camera &camera, std::uint64_t samples,
               std::uint64_t seed, unsigned threads);
    // What was brought so far, in files `prefix` + number: whole or not at all, each.
    bool write(const std::string &prefix, std::uint64_t key) const;
    // Take up what write() left under the same key; returns its samples, 0 without any.
    std::uint64_t read(const std::string &prefix, std::uint64_t key);
    // Put `samples` made-up ones a pixel into all batches together: sample(batch, pixel, number).
    void fill(int samples, const std::function<Sample(int, int, int)> &sample);
    // The sum of all, or of all but one.
    Film film(int without = -1) const;

  private:
    std::vector<Film> films_;
};

// A film as the figures take it.
image::Traced traced(const Film &film);

// Figures of pictures of the batches' size; all with the share of hair of the first.
std::vector<Figures> figures(const Batches &batches, const std::vector<draw::Picture> &pictures);

} // namespace tsuya::reference

#endif

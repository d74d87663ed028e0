// A picture against the reference: error of the mean and relative mean square error, with
// standard errors that are those of the reference's noise alone.
//
// Let t be the picture, r the reference, in channel c of pixel p; w the share of the pixel that
// hair covers, as the renderer draws it, which is the same for all tiers and has no noise; Y
// Rec. 709 luminance. Hair pixels are those with w > 0.3.
//
//   mean error  sum(w Y(t)) / sum(w Y(r)) - 1, over all pixels: signed
//   rel MSE     mean over hair pixels and channels of
//                   ((t - r)^2 - se(r)^2) / (b(r)^2 + (0.1 m)^2)
//               where se(r)^2 is the variance of the reference's pixel, so that its noise cancels,
//               b(r) the mean of r over the hair pixels of the 5x5 pixels around p, so that noise
//               in it hardly counts, and m the mean of r over all hair pixels.
//
// Values and standard errors by the jackknife over batches with seeds of their own: the figures
// again without one batch, for each. It takes away the bias that goes as one over samples, needs no
// law for the noise and sees what pixels and channels share. Where the square of noise outweighs
// the picture's own error it states up to sqrt(2) times too much.
#ifndef TSUYA_TESTS_REFERENCE_FIGURES_H
#define TSUYA_TESTS_REFERENCE_FIGURES_H

#include "draw/renderer.h"
#include "reference/film.h"
#include "reference/render.h"

#include <array>
#include <functional>
#include <vector>

namespace tsuya::reference
{

struct Figure {
    double value = 0.0;
    double error = 0.0; // standard error
};

struct Figures {
    Figure mean;       // luminance of the reference, weighed by w
    Figure mean_error; // share of it
    Figure rel_mse;
    // Of each channel; the mean of their rel MSE is the picture's.
    std::array<Figure, 3> channel_error, channel_mse;
};

// A reference in equal independent parts.
class Batches
{
  public:
    static constexpr int count = 16;

    Batches(int width, int height);

    // Bring the sum of all batches to this many samples a pixel, a multiple of `count`.
    void bring(const Tracer &tracer, const Camera &camera, std::uint64_t samples,
               std::uint64_t seed, unsigned threads);
    // Put `samples` made-up ones a pixel into all batches together: sample(batch, pixel, number).
    void fill(int samples, const std::function<Sample(int, int, int)> &sample);
    // The sum of all, or of all but one.
    Film film(int without = -1) const;

  private:
    std::vector<Film> films_;
};

// Figures of pictures of the batches' size; all with the share of hair of the first.
std::vector<Figures> figures(const Batches &batches, const std::vector<draw::Picture> &pictures);

} // namespace tsuya::reference

#endif

// A picture of hair against a traced one: error of the mean and relative mean square error.
//
// Let t be the picture, r the traced one, in channel c of pixel p; w the share of the pixel that
// hair covers, as the renderer draws it, which is the same for all tiers and has no noise; Y
// Rec. 709 luminance. Hair pixels are those with w > 0.3.
//
//   mean error  sum(w Y(t)) / sum(w Y(r)) - 1, over all pixels: signed
//   rel MSE     mean over hair pixels and channels of
//                   ((t - r)^2 - se(r)^2) / (b(r)^2 + (0.1 m)^2)
//               where se(r)^2 is the variance of the traced pixel, so that its noise cancels,
//               b(r) the mean of r over the hair pixels of the 5x5 pixels around p, so that noise
//               in it hardly counts, and m the mean of r over all hair pixels
//   rms         square root of rel MSE
#ifndef TSUYA_DEMO_IMAGE_FIGURES_H
#define TSUYA_DEMO_IMAGE_FIGURES_H

#include "image/image.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tsuya::image {

// Means of samples, top row first. Red, green, blue, luminance.
struct Traced {
    int width = 0, height = 0;
    std::vector<std::array<double, 4>> mean;
    std::vector<std::array<double, 4>> error; // their standard errors
};

// Take what `tsuya reference` wrote: channels R, G, B, se.R, se.G, se.B and, when there, se.Y.
// Without se.Y the channels' noise is taken as one, which is the most that luminance can have.
// Errors: a channel is missing, a value is not finite, a standard error is below 0.
bool traced(const Image &image, Traced &traced, std::string &error);

// R, G, B and w of each pixel of a picture of the traced one's size.
using Pixels = const float *;

// How many hair pixels there are.
std::size_t hair_pixels(const Traced &traced, Pixels picture);

// The figures as they come, with what bias noise gives them through b(r).
struct Measures {
    double mean = 0.0; // luminance of the traced picture, weighed by w
    double mean_error = 0.0, rel_mse = 0.0;
    // Of each channel; the mean of their rel MSE is the picture's.
    std::array<double, 3> channel_error{}, channel_mse{};
};
// All with w of the first picture, which has hair pixels.
std::vector<Measures> measures(const Traced &traced, const std::vector<Pixels> &pictures);

struct Figure {
    double value = 0.0;
    double error = 0.0; // standard error
};

struct Figures {
    Figure mean, mean_error, rel_mse;
    std::array<Figure, 3> channel_error, channel_mse;
};

// The same with standard errors that are those of the traced picture's noise alone, and without
// the bias. Errors are carried from pixel to figure to first order (the square of noise to second),
// with the noise of pixels independent and that of a pixel's channels as one, which it nearly is
// where all take the same path; and at least what the square of noise alone gives.
std::vector<Figures> figures(const Traced &traced, const std::vector<Pixels> &pictures);

// rms of a rel MSE. A rel MSE that noise brought below 0 has rms 0; the standard error is then that
// of a rel MSE of one standard error.
Figure rms(const Figure &rel_mse);

// Where the errors are: (Y(t) - Y(r)) / sqrt(b(Y(r))^2 + (0.1 m)^2) of each pixel, for PNG. White
// is 0, red too bright and blue too dark, deepest at +1 and -1 and beyond; pixels that are no hair
// pixels are grey. Below a line of grey a strip shows the scale from -1 to +1.
Image error_map(const Traced &traced, Pixels picture);

} // namespace tsuya::image

#endif

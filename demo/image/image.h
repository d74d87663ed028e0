// Pictures in memory, and PNG and EXR files of them.
//
// A file is written beside its target under another name and then renamed, so a target is either
// the old file or the whole new one. Every function that can fail returns false and says why in
// `error`, one clear sentence with the path in it; `error` is left alone on success.
#ifndef TSUYA_DEMO_IMAGE_IMAGE_H
#define TSUYA_DEMO_IMAGE_IMAGE_H

#include <map>
#include <string>
#include <vector>

namespace tsuya::image {

// Linear light, rows from top to bottom, channels of a pixel side by side:
// pixels[(y * width + x) * channels + c]. Alpha, where there is one, is not multiplied in.
struct Image
{
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> pixels;

    // One name per channel, or empty: Y, Y A, R G B, R G B A for 1, 2, 3, 4 channels.
    std::vector<std::string> names = {};

    // Texts by name that an EXR carries beside its pixels; a PNG carries none.
    std::map<std::string, std::string> texts = {};
};

// Bits of one channel in a PNG file.
enum class Depth { eight = 8, sixteen = 16 };

// The sRGB curve of IEC 61966-2-1, both pieces. encode: linear [0, 1] to display [0, 1]; values
// outside are clamped first. decode is its inverse.
float srgb_encode(float linear);
float srgb_decode(float display);

// Writes a PNG with colour on the sRGB curve and alpha as it is. 1 to 4 channels: grey, grey alpha,
// RGB, RGBA; names are not looked at. Values are clamped to [0, 1] and rounded to the nearest
// level.
// Errors: no such folder, disk full, wrong number of channels or values, a value that is NaN.
bool write_png(const std::string &path, const Image &image, std::string &error,
               Depth depth = Depth::eight);

// How a PNG's levels stand for values: on the sRGB curve, or as they are, over the highest level.
enum class Curve { srgb, none };

// Reads any PNG into 1 to 4 linear channels: palettes are resolved, a transparent colour becomes an
// alpha channel, 1 to 16 bits. The file is taken as `curve` says whatever its gamma chunk does.
// Errors: no such file, not a PNG, damaged. `image` is untouched then.
bool read_png(const std::string &path, Image &image, std::string &error,
              Curve curve = Curve::srgb);

// Writes an EXR: scan lines, 32-bit float, ZIP compression, any number of channels under their
// names, any value including infinities and NaN.
// Errors: no such folder, disk full, wrong number of channels, values or names, a name that is
//         empty, longer than 254 bytes or there twice, more than 4 channels without names, texts
//         whose names are such.
bool write_exr(const std::string &path, const Image &image, std::string &error);

// Reads a single-part scan-line EXR of half or float channels; `names` is always filled. Channels
// come in the order R G B Y A, then the others by name. Attributes of type string become texts.
// Errors: no such file, not an EXR, damaged, or tiled, deep, multi-part, sub-sampled or integer,
//         which are not read. `image` is untouched then.
bool read_exr(const std::string &path, Image &image, std::string &error);

// The channel of this name, or -1.
int channel(const Image &image, const std::string &name);

} // namespace tsuya::image

#endif

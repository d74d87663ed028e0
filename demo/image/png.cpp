#include "file.h"

#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <png.h>

namespace tsuya::image {
namespace {

// libpng leaves its calls by longjmp, which must not skip a destructor. The functions below that
// call setjmp therefore hold pointers and numbers only; everything with a destructor is made by
// their callers.
struct Session
{
    png_structp png = nullptr;
    png_infop info = nullptr;
    char why[200] = "";
};

void on_error(png_structp png, png_const_charp text)
{
    Session *session = static_cast<Session *>(png_get_error_ptr(png));
    std::snprintf(session->why, sizeof session->why, "%s", text);
    png_longjmp(png, 1);
}

// Warnings concern optional chunks, which nothing here depends on.
void on_warning(png_structp, png_const_charp)
{
}

struct Writer : Session
{
    Writer()
    {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<Session *>(this), on_error,
                                      on_warning);
        info = png ? png_create_info_struct(png) : nullptr;
    }
    ~Writer()
    {
        png_destroy_write_struct(&png, &info);
    }
    Writer(const Writer &) = delete;
    Writer &operator=(const Writer &) = delete;
};

struct Reader : Session
{
    Reader()
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<Session *>(this), on_error,
                                     on_warning);
        info = png ? png_create_info_struct(png) : nullptr;
    }
    ~Reader()
    {
        png_destroy_read_struct(&png, &info, nullptr);
    }
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;
};

bool write_rows(Session &s, std::FILE *file, int width, int height, int channels, int depth,
                png_bytepp rows)
{
    static const int colour[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                 PNG_COLOR_TYPE_RGB_ALPHA};
    if (setjmp(png_jmpbuf(s.png))) {
        return false;
    }
    png_init_io(s.png, file);
    png_set_IHDR(s.png, s.info, png_uint_32(width), png_uint_32(height), depth,
                 colour[channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(s.png, s.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(s.png, s.info);
    png_write_image(s.png, rows);
    png_write_end(s.png, nullptr);
    return true;
}

bool read_header(Session &s, std::FILE *file)
{
    if (setjmp(png_jmpbuf(s.png))) {
        return false;
    }
    png_init_io(s.png, file);
    png_read_info(s.png, s.info);
    png_set_expand(s.png);
    png_set_interlace_handling(s.png);
    png_read_update_info(s.png, s.info);
    return true;
}

bool read_rows(Session &s, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(s.png))) {
        return false;
    }
    png_read_image(s.png, rows);
    png_read_end(s.png, nullptr);
    return true;
}

bool is_alpha(int c, int channels)
{
    return channels % 2 == 0 && c == channels - 1;
}

std::vector<png_bytep> row_pointers(std::vector<std::uint8_t> &bytes, std::size_t row, int height)
{
    std::vector<png_bytep> rows(static_cast<std::size_t>(height));
    for (std::size_t y = 0; y < rows.size(); y++) {
        rows[y] = bytes.data() + y * row;
    }
    return rows;
}

} // namespace

bool write_png(const std::string &path, const Image &image, std::string &error, Depth depth)
{
    const std::string why = defect(image);
    if (!why.empty()) {
        return fail(error, "write", path, why);
    }
    if (image.channels > 4) {
        return fail(error, "write", path, "a PNG has at most 4 channels");
    }
    const bool wide = depth == Depth::sixteen;
    const double top = wide ? 65535 : 255;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels.size() * (wide ? 2 : 1));
    for (std::size_t i = 0; i < image.pixels.size(); i++) {
        const float x = image.pixels[i];
        if (std::isnan(x)) {
            return fail(error, "write", path, "a value is not a number");
        }
        const int c = int(i % std::size_t(image.channels));
        const float v = is_alpha(c, image.channels) ? std::fmin(std::fmax(x, 0.0F), 1.0F)
                                                    : srgb_encode(x);
        const unsigned level = unsigned(double(v) * top + 0.5);
        if (wide) {
            bytes.push_back(std::uint8_t(level >> 8));
        }
        bytes.push_back(std::uint8_t(level & 255));
    }
    const std::size_t row = bytes.size() / std::size_t(image.height);
    std::vector<png_bytep> rows = row_pointers(bytes, row, image.height);

    return replace_file(
        path,
        [&](std::FILE *file, std::string &said) {
            Writer writer;
            if (!writer.info) {
                said = "out of memory";
                return false;
            }
            const bool good = write_rows(writer, file, image.width, image.height, image.channels,
                                         int(depth), rows.data());
            said = writer.why;
            return good;
        },
        error);
}

bool read_png(const std::string &path, Image &image, std::string &error, Curve curve)
{
    std::FILE *file = std::fopen(path.c_str(), "rb");
    if (!file) {
        return fail(error, "read", path, std::strerror(errno));
    }
    Reader reader;
    std::vector<std::uint8_t> bytes;
    Image read;
    bool wide = false;
    bool good = reader.info && read_header(reader, file);
    if (good) {
        read.width = int(png_get_image_width(reader.png, reader.info));
        read.height = int(png_get_image_height(reader.png, reader.info));
        read.channels = png_get_channels(reader.png, reader.info);
        wide = png_get_bit_depth(reader.png, reader.info) == 16;
        const std::size_t row = png_get_rowbytes(reader.png, reader.info);
        bytes.resize(row * std::size_t(read.height));
        good = read_rows(reader, row_pointers(bytes, row, read.height).data());
    }
    std::fclose(file);
    if (!good) {
        return fail(error, "read", path, reader.info ? reader.why : "out of memory");
    }
    read.pixels.resize(bytes.size() / (wide ? 2 : 1));
    for (std::size_t i = 0; i < read.pixels.size(); i++) {
        const float v = wide ? float(bytes[2 * i] * 256 + bytes[2 * i + 1]) / 65535.0F
                             : float(bytes[i]) / 255.0F;
        const int c = int(i % std::size_t(read.channels));
        const bool plain = curve == Curve::none || is_alpha(c, read.channels);
        read.pixels[i] = plain ? v : srgb_decode(v);
    }
    image = std::move(read);
    return true;
}

} // namespace tsuya::image

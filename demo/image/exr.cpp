#include "file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>
#include <tinyexr.h>

namespace tsuya::image {
namespace {

// Header and pixels of one file being read; what the library allocated goes with it.
struct File
{
    EXRHeader header;
    EXRImage image;

    File()
    {
        InitEXRHeader(&header);
        InitEXRImage(&image);
    }
    ~File()
    {
        FreeEXRImage(&image);
        FreeEXRHeader(&header);
    }
    File(const File &) = delete;
    File &operator=(const File &) = delete;
};

// The library's message, freed, or its code where it left no message.
std::string take(const char *message, int code)
{
    const std::string text =
        message ? message : "it is not a readable EXR (code " + std::to_string(code) + ")";
    FreeEXRErrorMessage(message);
    return text.substr(0, text.find_last_not_of(".\n") + 1);
}

std::vector<std::string> names_of(const Image &image)
{
    if (!image.names.empty()) {
        return image.names;
    }
    switch (image.channels) {
    case 1:
        return {"Y"};
    case 2:
        return {"Y", "A"};
    case 3:
        return {"R", "G", "B"};
    case 4:
        return {"R", "G", "B", "A"};
    default:
        return {};
    }
}

// Indices 0..n-1 in the order in which `before` wants the names.
template <class Before>
std::vector<std::size_t> order(const std::vector<std::string> &names, Before before)
{
    std::vector<std::size_t> index(names.size());
    std::iota(index.begin(), index.end(), std::size_t(0));
    std::sort(index.begin(), index.end(),
              [&](std::size_t a, std::size_t b) { return before(names[a], names[b]); });
    return index;
}

// R G B Y A come first, in this order.
bool before_for_reading(const std::string &a, const std::string &b)
{
    static const std::string usual = "RGBYA";
    const auto rank = [](const std::string &s) {
        return s.size() == 1 ? std::min(usual.find(s), usual.size()) : usual.size();
    };
    return rank(a) != rank(b) ? rank(a) < rank(b) : a < b;
}

std::string name_defect(const Image &image, const std::vector<std::string> &names)
{
    for (const auto &text : image.texts) {
        if (text.first.empty() || text.first.size() > 254) {
            return "the name of a text is empty or longer than 254 bytes";
        }
    }
    if (names.size() != std::size_t(image.channels)) {
        return std::to_string(image.channels) + " channels have " + std::to_string(names.size()) +
               " names";
    }
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); i++) {
        if (sorted[i].empty() || sorted[i].size() > 254) {
            return "a channel name is empty or longer than 254 bytes";
        }
        if (i > 0 && sorted[i] == sorted[i - 1]) {
            return "two channels are called " + sorted[i];
        }
    }
    return {};
}

} // namespace

bool write_exr(const std::string &path, const Image &image, std::string &error)
{
    const std::vector<std::string> names = names_of(image);
    std::string why = defect(image);
    if (why.empty()) {
        why = name_defect(image, names);
    }
    if (!why.empty()) {
        return fail(error, "write", path, why);
    }

    // The format stores channels sorted by name.
    const std::vector<std::size_t> sorted = order(names, std::less<std::string>());
    const std::size_t count = sorted.size(), size = image.pixels.size() / count;
    std::vector<float> planes(image.pixels.size());
    std::vector<unsigned char *> images(count);
    std::vector<EXRChannelInfo> channels(count, EXRChannelInfo{});
    std::vector<int> types(count, TINYEXR_PIXELTYPE_FLOAT);
    for (std::size_t c = 0; c < count; c++) {
        float *plane = planes.data() + c * size;
        for (std::size_t i = 0; i < size; i++) {
            plane[i] = image.pixels[i * count + sorted[c]];
        }
        images[c] = reinterpret_cast<unsigned char *>(plane);
        names[sorted[c]].copy(channels[c].name, 254);
    }

    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = image.channels;
    header.channels = channels.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage pixels;
    InitEXRImage(&pixels);
    pixels.images = images.data();
    pixels.width = image.width;
    pixels.height = image.height;
    pixels.num_channels = image.channels;
    std::map<std::string, std::string> texts = image.texts; // the library wants to change them
    std::vector<EXRAttribute> attributes;
    for (auto &text : texts) {
        EXRAttribute attribute = {};
        text.first.copy(attribute.name, sizeof attribute.name - 1);
        std::strcpy(attribute.type, "string");
        attribute.value = reinterpret_cast<unsigned char *>(text.second.data());
        attribute.size = int(text.second.size());
        attributes.push_back(attribute);
    }
    header.num_custom_attributes = int(attributes.size());
    header.custom_attributes = attributes.data();

    unsigned char *bytes = nullptr;
    const char *message = nullptr;
    const std::size_t length = SaveEXRImageToMemory(&pixels, &header, &bytes, &message);
    if (length == 0) {
        return fail(error, "write", path, take(message, 0));
    }
    const bool good = replace_file(
        path,
        [&](std::FILE *file, std::string &said) {
            const bool whole = std::fwrite(bytes, 1, length, file) == length;
            said = whole ? "" : std::strerror(errno);
            return whole;
        },
        error);
    std::free(bytes);
    return good;
}

bool read_exr(const std::string &path, Image &image, std::string &error)
{
    EXRVersion version;
    const char *message = nullptr;
    int code = ParseEXRVersionFromFile(&version, path.c_str());
    if (code == TINYEXR_ERROR_CANT_OPEN_FILE) {
        return fail(error, "read", path, std::strerror(errno));
    }
    if (code != TINYEXR_SUCCESS) {
        return fail(error, "read", path, "it is not an EXR file");
    }
    if (version.multipart || version.non_image || version.tiled) {
        return fail(error, "read", path, "tiled, deep and multi-part files are not read");
    }
    File file;
    code = ParseEXRHeaderFromFile(&file.header, &version, path.c_str(), &message);
    if (code != TINYEXR_SUCCESS) {
        return fail(error, "read", path, take(message, code));
    }
    std::vector<std::string> names;
    for (int c = 0; c < file.header.num_channels; c++) {
        const EXRChannelInfo &info = file.header.channels[c];
        if (file.header.pixel_types[c] == TINYEXR_PIXELTYPE_UINT || info.x_sampling != 1 ||
            info.y_sampling != 1) {
            return fail(error, "read", path,
                        std::string("channel ") + info.name + " is integer or sub-sampled");
        }
        file.header.requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
        names.emplace_back(info.name);
    }
    code = LoadEXRImageFromFile(&file.image, &file.header, path.c_str(), &message);
    if (code != TINYEXR_SUCCESS) {
        // It has freed the channels and still points to them.
        InitEXRImage(&file.image);
    }
    if (code != TINYEXR_SUCCESS || !file.image.images) {
        return fail(error, "read", path, take(message, code));
    }

    const std::vector<std::size_t> sorted = order(names, before_for_reading);
    const std::size_t count = names.size();
    const std::size_t size = std::size_t(file.image.width) * std::size_t(file.image.height);
    Image read{file.image.width, file.image.height, int(count), std::vector<float>(size * count)};
    for (std::size_t c = 0; c < count; c++) {
        read.names.push_back(names[sorted[c]]);
        const float *plane = reinterpret_cast<const float *>(file.image.images[sorted[c]]);
        for (std::size_t i = 0; i < size; i++) {
            read.pixels[i * count + c] = plane[i];
        }
    }
    for (int i = 0; i < file.header.num_custom_attributes; i++) {
        const EXRAttribute &attribute = file.header.custom_attributes[i];
        if (!std::strcmp(attribute.type, "string") && attribute.size > 0) {
            read.texts[attribute.name] = {reinterpret_cast<const char *>(attribute.value),
                                          std::size_t(attribute.size)};
        }
    }
    image = std::move(read);
    return true;
}

} // namespace tsuya::image

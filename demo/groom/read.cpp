#include "read.h"

#include "formats.h"

#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <vector>

namespace tsuya::groom {

namespace {

Expected<Format> recognise(const Bytes &head, const std::string &extension)
{
    if (head.holds(0, 4)) {
        if (head.u32(0) == 0x52494148u) {
            return Format::hair;
        }
        const float version = head.f32(0);
        // As a .data strand count this is above 1e9: no such file exists.
        if (version >= 4.0f && version < 5.0f) {
            return Format::tfx;
        }
    }
    if (extension == ".tfx") {
        return Format::tfx;
    }
    if (extension == ".hair") {
        return Format::hair;
    }
    if (extension == ".data") {
        return Format::data;
    }
    return fail("the format is unknown: neither \"HAIR\" nor a float 4.x at offset 0, and the "
                "extension \"", extension, "\" is none of .tfx, .hair, .data");
}

Result read_path(const std::string &path, const ReadOptions &options)
{
    std::error_code status;
    const std::filesystem::path name(path);
    if (!std::filesystem::is_regular_file(name, status)) {
        return fail("it does not exist, or is not a regular file");
    }
    const std::uintmax_t size = std::filesystem::file_size(name, status);
    std::ifstream in(name, std::ios::binary);
    if (status || !in) {
        return fail("it cannot be opened for reading");
    }
    std::vector<std::uint8_t> bytes(size);
    if (size && !in.read(reinterpret_cast<char *>(bytes.data()), std::streamsize(size))) {
        return fail("it cannot be read to its end at offset ", size);
    }
    const Expected<Format> format =
        recognise(Bytes(bytes.data(), bytes.size()), name.extension().string());
    if (!format) {
        return Error{format.error()};
    }
    return read(bytes.data(), bytes.size(), *format, options);
}

} // namespace

Result read(const std::uint8_t *bytes, std::size_t size, Format format, const ReadOptions &options)
{
    if (!(options.unit_scale > 0.0 && std::isfinite(options.unit_scale))) {
        return fail("unit_scale is ", options.unit_scale, " but must be finite and above 0");
    }
    if (!(options.radius >= shortest_segment && options.radius <= coordinate_limit)) {
        return fail("radius is ", options.radius, " but must be in [", shortest_segment, ", ",
                    coordinate_limit, "]");
    }
    if (bytes == nullptr && size != 0) {
        return fail("bytes is null but size is ", size);
    }
    const Bytes file(bytes, size);
    try {
        switch (format) {
        case Format::tfx:
            return read_tfx(file, options);
        case Format::hair:
            return read_hair(file, options);
        case Format::data:
            return read_data(file, options);
        }
        return fail("format is ", int(format), " but must be tfx, hair or data");
    } catch (const std::exception &) {
        return Error{"memory ran out while reading the groom"};
    }
}

Result read(const std::string &path, const ReadOptions &options)
{
    try {
        Result result = read_path(path, options);
        return result ? std::move(result) : Result(fail(path, ": ", result.error()));
    } catch (const std::exception &) {
        return Error{path + ": memory ran out while reading the groom"};
    }
}

} // namespace tsuya::groom

#include "formats.h"

#include "builder.h"

namespace tsuya::groom {

namespace {

constexpr std::uint64_t tfx_header = 160;
constexpr std::uint64_t hair_header = 128;
constexpr std::uint64_t most_points = 0xffffffffu; // Groom::first is 32 bits wide

enum HairFlag : std::uint32_t {
    hair_segments = 1,
    hair_points = 2,
    hair_thickness = 4,
};

} // namespace

Result read_tfx(const Bytes &file, const ReadOptions &options)
{
    if (!file.holds(0, tfx_header)) {
        return too_short(file, ".tfx header", 0, tfx_header);
    }
    const float version = file.f32(0);
    if (!(version >= 4.0f && version < 5.0f)) {
        return fail(".tfx version at offset 0 is ", version, " but must be in [4, 5)");
    }
    const std::uint64_t strands = file.u32(4), count = file.u32(8);
    const std::uint64_t positions = file.u32(12), uvs = file.u32(16);
    if (strands == 0) {
        return fail(".tfx strand count at offset 4 is 0 but must be at least 1");
    }
    if (count < 2) {
        return fail(".tfx points per strand at offset 8 is ", count, " but must be at least 2");
    }
    if (positions < tfx_header || positions > file.size()) {
        return fail(".tfx position offset at offset 12 is ", positions, " but must be in [",
                    tfx_header, ", ", file.size(), "], the end of the file");
    }
    // Divided, not multiplied: the product of three 32-bit counts overflows.
    if (strands > (file.size() - positions) / 16 / count) {
        return fail(".tfx positions at offset ", positions, " need ", strands, " x ", count,
                    " x 16 bytes but ", file.size() - positions, " are left of ", file.size());
    }
    const std::uint64_t end = positions + strands * count * 16;
    if (strands * count > most_points) {
        return fail(".tfx holds ", strands * count, " points but at most 4294967295 are allowed");
    }
    if (uvs != 0) {
        if (uvs < tfx_header || !file.holds(uvs, strands * 8)) {
            return fail(".tfx strand uv offset at offset 16 is ", uvs, " and needs ", strands * 8,
                        " bytes there, but must be 0 or in [", tfx_header,
                        ", end], and the file ends at ", file.size());
        }
        if (uvs < end && positions < uvs + strands * 8) {
            return fail(".tfx strand uv at offset ", uvs, " overlaps the positions in [",
                        positions, ", ", end, ")");
        }
    }

    Builder builder(options);
    builder.reserve(strands, strands * count);
    for (std::uint64_t s = 0; s < strands; ++s) {
        for (std::uint64_t i = 0; i < count; ++i) {
            builder.point(file, positions + (s * count + i) * 16);
        }
        if (builder.end() && uvs != 0) {
            builder.uv(file.f32(uvs + s * 8), file.f32(uvs + s * 8 + 4));
        }
    }
    const std::uint64_t used = tfx_header + (end - positions) + (uvs ? strands * 8 : 0);
    return builder.finish(file.size() - used);
}

Result read_hair(const Bytes &file, const ReadOptions &options)
{
    if (!file.holds(0, hair_header)) {
        return too_short(file, ".hair header", 0, hair_header);
    }
    if (file.u32(0) != 0x52494148u) {
        return fail(".hair file does not begin with \"HAIR\" at offset 0");
    }
    const std::uint64_t strands = file.u32(4), points = file.u32(8);
    const std::uint32_t flags = file.u32(12);
    const std::uint64_t default_segments = file.u32(16);
    if (strands == 0) {
        return fail(".hair strand count at offset 4 is 0 but must be at least 1");
    }
    if (!(flags & hair_points)) {
        return fail(".hair flags at offset 12 are ", flags, " but must have bit 2, points");
    }
    const std::uint64_t segments_at = hair_header;
    const std::uint64_t points_at = segments_at + (flags & hair_segments ? strands * 2 : 0);
    const std::uint64_t widths_at = points_at + points * 12;
    std::uint64_t end = widths_at + (flags & hair_thickness ? points * 4 : 0);
    if (!file.holds(segments_at, points_at - segments_at)) {
        return too_short(file, ".hair segment counts", segments_at, strands * 2);
    }
    if (!file.holds(points_at, points * 12)) {
        return too_short(file, ".hair points", points_at, points * 12);
    }
    if (!file.holds(widths_at, end - widths_at)) {
        return too_short(file, ".hair thickness", widths_at, points * 4);
    }
    // Transparency (bit 8, 4 bytes) and colour (bit 16, 12 bytes a point) are
    // not used, but a file without the ones it announces was cut off.
    const std::uint64_t rest = (flags & 8u ? points * 4 : 0) + (flags & 16u ? points * 12 : 0);
    if (!file.holds(end, rest)) {
        return too_short(file, ".hair transparency and colour", end, rest);
    }

    std::uint64_t needed = strands * (default_segments + 1);
    if (flags & hair_segments) {
        needed = strands;
        for (std::uint64_t s = 0; s < strands; ++s) {
            needed += file.u16(segments_at + s * 2);
        }
    }
    if (needed != points) {
        return fail(".hair point count at offset 8 is ", points, " but the segment counts of ",
                    strands, " strands make ", needed, " points");
    }

    Builder builder(options);
    builder.reserve(strands, points);
    std::uint64_t at = 0;
    for (std::uint64_t s = 0; s < strands; ++s) {
        const std::uint64_t n =
            1 + (flags & hair_segments ? file.u16(segments_at + s * 2) : default_segments);
        for (std::uint64_t i = 0; i < n; ++i, ++at) {
            builder.point(file, points_at + at * 12);
            if (flags & hair_thickness) {
                builder.thickness(file.f32(widths_at + at * 4));
            }
        }
        builder.end();
    }
    // Writers leave 0 where they know no width.
    if (!(flags & hair_thickness) && file.f32(20) != 0.0f) {
        builder.groom().constant_radius = builder.radius(file.f32(20));
    }
    return builder.finish(file.size() - end);
}

Result read_data(const Bytes &file, const ReadOptions &options)
{
    if (!file.holds(0, 4)) {
        return too_short(file, ".data strand count", 0, 4);
    }
    const std::uint64_t strands = file.u32(0);
    if (strands == 0 || strands > 0x7fffffffu) {
        return fail(".data strand count at offset 0 is ", std::int32_t(strands),
                    " but must be in [1, 2147483647]");
    }
    if (!file.holds(4, strands * 4)) {
        return fail(".data with ", strands, " strands at offset 0 needs at least ",
                    4 + strands * 4, " bytes but the file has ", file.size());
    }
    Builder builder(options);
    builder.reserve(strands, (file.size() - 4 - strands * 4) / 12);
    std::uint64_t at = 4;
    for (std::uint64_t s = 0; s < strands; ++s) {
        if (!file.holds(at, 4)) {
            return too_short(file, ".data point count", at, 4);
        }
        const std::uint64_t n = file.u32(at);
        if (n > 0x7fffffffu) {
            return fail(".data point count at offset ", at, " is ", std::int64_t(n) - 0x100000000,
                        " but must be in [0, 2147483647]");
        }
        if (!file.holds(at + 4, n * 12)) {
            return too_short(file, ".data points", at + 4, n * 12);
        }
        if (builder.groom().points.size() + n > most_points) {
            return fail(".data holds more than 4294967295 points");
        }
        for (std::uint64_t i = 0; i < n; ++i) {
            builder.point(file, at + 4 + i * 12);
        }
        builder.end();
        at += 4 + n * 12;
    }
    if (at != file.size()) {
        return fail(".data ends at offset ", at, " after ", strands, " strands but the file has ",
                    file.size(), " bytes");
    }
    return builder.finish(0);
}

} // namespace tsuya::groom

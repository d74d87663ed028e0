// Groom files made in memory, byte by byte, for the reader's tests.
#ifndef TSUYA_TESTS_GROOM_FILES_H
#define TSUYA_TESTS_GROOM_FILES_H

#include <glm/vec3.hpp>

#include <cstdint>
#include <cstring>
#include <vector>

namespace groom_files {

using Bytes = std::vector<std::uint8_t>;
using Strand = std::vector<glm::vec3>;
using Strands = std::vector<Strand>;

inline void set32(Bytes &out, std::size_t at, std::uint32_t v)
{
    for (std::size_t k = 0; k < 4; ++k) {
        out[at + k] = std::uint8_t(v >> (8 * k));
    }
}
inline void set_float(Bytes &out, std::size_t at, float v)
{
    std::uint32_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    set32(out, at, bits);
}
inline void put16(Bytes &out, std::size_t v)
{
    out.push_back(std::uint8_t(v));
    out.push_back(std::uint8_t(v >> 8));
}
inline void put32(Bytes &out, std::size_t v)
{
    out.resize(out.size() + 4);
    set32(out, out.size() - 4, std::uint32_t(v));
}
inline void put_float(Bytes &out, float v)
{
    out.resize(out.size() + 4);
    set_float(out, out.size() - 4, v);
}
inline void put_point(Bytes &out, const glm::vec3 &p)
{
    put_float(out, p.x);
    put_float(out, p.y);
    put_float(out, p.z);
}

// Three strands of 4 points, a few centimetres long, gently bent.
inline Strands sample()
{
    Strands out(3);
    for (std::size_t s = 0; s < out.size(); ++s) {
        for (std::size_t i = 0; i < 4; ++i) {
            const float t = float(i) * 0.031f;
            out[s].emplace_back(0.07f * float(s) + t * t, 0.1f - t, 0.013f + 0.5f * t);
        }
    }
    return out;
}

// All strands need the same number of points. uv of strand s is (s / 8, 1 - s / 8).
inline Bytes make_tfx(const Strands &strands, bool uv)
{
    Bytes out(160, 0);
    const std::size_t count = strands[0].size(), end = 160 + strands.size() * count * 16;
    set_float(out, 0, 4.0f);
    set32(out, 4, std::uint32_t(strands.size()));
    set32(out, 8, std::uint32_t(count));
    set32(out, 12, 160);
    set32(out, 16, uv ? std::uint32_t(end) : 0);
    for (const Strand &strand : strands) {
        for (std::size_t i = 0; i < count; ++i) {
            put_point(out, strand[i]);
            put_float(out, i == 0 ? 0.0f : 1.0f);
        }
    }
    for (std::size_t s = 0; uv && s < strands.size(); ++s) {
        put_float(out, float(s) / 8.0f);
        put_float(out, 1.0f - float(s) / 8.0f);
    }
    return out;
}

// `flags` as in the file: 1 segment counts, 2 points (always set), 4 thickness,
// 8 transparency, 16 colour. Thickness of point i of the file is (i + 1) / 1024.
inline Bytes make_hair(const Strands &strands, std::uint32_t flags)
{
    Bytes out(128, 0);
    std::size_t points = 0;
    for (const Strand &strand : strands) {
        points += strand.size();
    }
    std::memcpy(out.data(), "HAIR", 4);
    set32(out, 4, std::uint32_t(strands.size()));
    set32(out, 8, std::uint32_t(points));
    set32(out, 12, flags | 2u);
    set32(out, 16, std::uint32_t(strands[0].size() - 1));
    set_float(out, 20, 0.5f);
    for (std::size_t s = 0; (flags & 1u) && s < strands.size(); ++s) {
        put16(out, strands[s].size() - 1);
    }
    for (const Strand &strand : strands) {
        for (const glm::vec3 &p : strand) {
            put_point(out, p);
        }
    }
    for (std::size_t i = 0; (flags & 4u) && i < points; ++i) {
        put_float(out, float(i + 1) / 1024.0f);
    }
    out.resize(out.size() + (flags & 8u ? points * 4 : 0) + (flags & 16u ? points * 12 : 0));
    return out;
}

inline Bytes make_data(const Strands &strands)
{
    Bytes out;
    put32(out, strands.size());
    for (const Strand &strand : strands) {
        put32(out, strand.size());
        for (const glm::vec3 &p : strand) {
            put_point(out, p);
        }
    }
    return out;
}

} // namespace groom_files

#endif

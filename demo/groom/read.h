// Groom files: TressFX .tfx, Yuksel .hair, USC-HairSalon .data.
#ifndef TSUYA_GROOM_READ_H
#define TSUYA_GROOM_READ_H

#include "expected.h"
#include "groom.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace tsuya::groom {

enum class Format {
    tfx,  // TressFX 4.x: 160 byte header, 4 floats a point, equal point counts, uv a strand
    hair, // Yuksel: 128 byte header with "HAIR", 3 floats a point, optional widths
    data, // USC-HairSalon: counts and 3 floats a point, nothing else
};

// The axis that points up in the file. The groom always has +y up.
enum class Up {
    y, // coordinates are kept
    z, // (x, y, z) becomes (x, z, -y)
};

struct ReadOptions {
    double unit_scale = 1.0; // metres per file unit, finite, > 0; e.g. 0.01 for centimetres
    Up up = Up::y;           // .hair files are mostly Up::z
    float radius = 4e-5f;    // metres, finite, > 0; for files that hold no usable width
};

struct Loaded {
    Groom groom;
    Report report;
};

using Result = Expected<Loaded>;

// Read the groom file `path`. "HAIR" or a leading float 4.x decides for .hair
// or .tfx whatever the name is; without either the extension must be .data.
//
// Errors: an option out of range; a file that cannot be opened or read, or is
//         not a regular file; an unknown format; and all errors of the second
//         form. Messages begin with the path.
Result read(const std::string &path, const ReadOptions &options = {});

// Read `size` bytes of a groom file. Every count is checked against `size`
// before anything is allocated for it, so memory stays in proportion to the
// file whatever its header claims. Byte order is little endian.
//
// Taken:  .tfx   positions (w is not used), strand uv
//         .hair  points, segment counts, thickness (a diameter, scaled like the points)
//         .data  all of it
//         The rest is counted in Report::unused_bytes.
// Errors: an option out of range; a section that ends beyond the file; counts
//         that contradict each other; bytes left over in a .data file (it has
//         no magic, so its size is the only check); zero strands, or none that
//         survives. Messages name the field or offset, the size needed and the
//         size there is.
// Threads: any.
Result read(const std::uint8_t *bytes, std::size_t size, Format format,
            const ReadOptions &options = {});

} // namespace tsuya::groom

#endif

// Private to the reader: is a mesh file what its counts and numbers claim?
//
// OpenMesh trusts a file: it loops for an end of a header that is not there, reserves what a count
// asks for, takes a number that it cannot read as 0, and mixes up the uv of faces that meet three
// at an edge. So a file is walked through once before it gets there.
#ifndef TSUYA_LEAF_CHECK_H
#define TSUYA_LEAF_CHECK_H

#include "groom/expected.h"

#include <cstddef>
#include <string>

namespace tsuya::leaf {

using groom::Error;
using groom::Expected;

// What the walk counted.
struct Counted {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t skipped = 0; // faces that have a vertex twice, which no surface has
    bool normals = false;    // on every corner of a face
    bool uvs = false;        // on every corner of a face
};

// Errors: see leaf/read.h, without the path.
Expected<Counted> check_obj(const std::string &text);
// Taken are ascii, binary_little_endian and binary_big_endian; the elements vertex, of scalars,
// then face, of nothing but a list vertex_indices (or vertex_index) with a count of one byte. In
// binary files x, y, z, nx, ny, nz, u, v, s and t are floats of 32 bits: what OpenMesh reads.
Expected<Counted> check_ply(const std::string &bytes);

} // namespace tsuya::leaf

#endif

// Leaf meshes from files: Wavefront .obj and Stanford .ply, read by OpenMesh.
#ifndef TSUYA_LEAF_READ_H
#define TSUYA_LEAF_READ_H

#include "groom/read.h"
#include "leaf/mesh.h"

#include <string>

namespace tsuya::leaf {

struct ReadOptions {
    double unit_scale = 1.0;     // metres per file unit, finite, > 0
    groom::Up up = groom::Up::y; // of the file
};

struct Loaded {
    Mesh mesh;
    Report report;
};

// Read the mesh file `path`, by its ending.
//
// Taken:   positions, triangles and polygons (as fans), normals of vertices, uv of vertices (.ply:
//          u and v, or s and t) or of corners (.obj). Materials, colours and groups are left alone.
// Mended:  triangles without area are dropped; no normals, or one that is no direction: computed
//          from the triangles; no uv: positions projected along the box's thinnest side, scaled to
//          fill [0, 1] along the longer one, which becomes v; uv that run clockwise keep their
//          texture and get a mirrored tangent frame. The report says which of these happened.
// Errors:  another ending; a file that cannot be read; a number that is none, a face that refers to
//          a vertex that is not there (the message names the line); counts in a .ply header that
//          the file is too short for; positions that are not finite or beyond 1e6 metres; uv of
//          some corners only; no face, or none with an area.
// Threads: one at a time, the reader has one log for all.
Expected<Loaded> read(const std::string &path, const ReadOptions &options = {});

} // namespace tsuya::leaf

#endif

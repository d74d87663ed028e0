// A head with hair out of numbers: straight, wavy or curly, the same for a seed everywhere.
#ifndef TSUYA_GROOM_GENERATE_H
#define TSUYA_GROOM_GENERATE_H

#include "expected.h"
#include "groom.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::groom {

enum class Style {
    straight, // follows the head and falls; curl_radius and curl_frequency are not used
    wavy,     // swings from side to side, mostly in one plane
    curly,    // winds around its own path
};

// What to grow. preset() gives values that suit each other; every field can be
// changed from there within its range.
struct HairParams {
    Style style = Style::straight;
    std::uint64_t seed = 1;          // any
    std::uint32_t strands = 20000;   // [100, 100000]
    std::uint32_t points = 32;       // per strand, [8, 256], and at least 6 per turn of a curl
    double length = 0.28;            // metres along the fibre, mean, [0.02, 1]
    double length_variation = 0.1;   // relative half range of chance, [0, 0.5]; on top of it
                                     // hair is cut longer at the crown than at the nape
    double curl_radius = 0.0;        // metres, [0, 0.03]
    double curl_frequency = 0.0;     // turns per metre of the path curled around, [0, 200]
    double clumping = 0.4;           // [0, 1]; how far tips move to their lock, 1: all the way
    double frizz = 0.15;             // [0, 1]; how far strands leave their lock, 1: about 1 cm
    double volume = 0.016;           // metres, [0, 0.05]; thickness of the hair over the scalp
    double radius = 4e-5;            // metres, of a fibre, [1e-6, 1e-3]
};

HairParams preset(Style style);

// Where hair grows. With no path: a built-in head, 0.15 m wide and 0.23 m high
// without its neck, whose scalp ends at a hairline around the face, over the
// ears and at the nape. The counts in a mesh file's header are trusted, unlike
// those of a groom file: open no mesh from a source you do not trust.
struct ScalpParams {
    std::string path;        // triangle mesh, .obj, .ply, .off or .stl; empty: the built-in head
    double unit_scale = 1.0; // metres per file unit, finite, > 0
    bool cut = false;        // grow only on faces whose centroid is on the plane's upper side:
    glm::vec3 plane_normal{0.0f, 1.0f, 0.0f}; // finite, longer than 1e-6
    double plane_offset = 0.0; // metres along the unit normal from the origin, [-10, 10]
};

// Triangles, counter-clockwise from outside; normals have length 1.
struct Mesh {
    std::vector<glm::vec3> positions; // metres
    std::vector<glm::vec3> normals;   // one per position
    std::vector<std::uint32_t> indices;
};

// Hair and the head under it, in metres, +y up, +z out of the face, +x to the
// person's left. The origin is the centre of the built-in head.
struct HairyHead {
    Groom groom;
    Report report;
    Mesh head;                            // to draw under the hair
    Mesh scalp;                           // where roots are; lies on `head`
    std::vector<std::uint32_t> root_face; // per strand, triangle of `scalp` its root is on
    glm::vec3 centre{0.0f};               // of the ellipsoid that hair is kept out of
    glm::vec3 semi_axes{0.0f};            // metres
    // Of the elliptic cylinder around y that the built-in head's neck nearly is: centre and half
    // axes in x and z, y of its ends; 0 with a head of your own.
    glm::vec2 neck_centre{0.0f}, neck_axes{0.0f}, neck_span{0.0f};
};

// Grow hair. Roots are uniform by area over the scalp; strands leave a side
// parting and a whorl at the crown, fall under gravity and lie around the head.
//
// The result holds the same bytes for the same parameters on every machine
// with plain IEEE 754 doubles (not x87): neither the C library's mathematics
// nor the compiler's choice of fused operations takes part. The normals of the
// meshes are left out of this promise, and so is a mesh file that stores text
// numbers.
//
// No point is more than 1 mm inside the head's ellipsoid. A loaded mesh is
// taken as the ellipsoid inscribed in its bounding box, shrunk for each strand
// so that its root is on it; hair can pass through a face that stands out.
//
// Cost:    100,000 strands of 32 points take less than 3 s on one core.
// Errors:  a parameter out of range (the message names it and the range);
//          too few points for the curl; segments too short for float; a mesh
//          that cannot be read, has a coordinate outside [-10, 10] metres, or
//          no face with an area where hair is to grow.
// Threads: any; with a mesh path one at a time, its reader has one log for all.
Expected<HairyHead> generate(const HairParams &params, const ScalpParams &scalp = {});

} // namespace tsuya::groom

#endif

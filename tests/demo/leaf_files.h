// Mesh files made in memory, for the reader's tests.
#ifndef TSUYA_TESTS_LEAF_FILES_H
#define TSUYA_TESTS_LEAF_FILES_H

#include "leaf/mesh.h"

#include <cstdio>
#include <cstring>
#include <string>

namespace leaf_files {

using tsuya::leaf::Mesh;

enum class Ply { ascii, little, big };

inline std::string number(float v)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", double(v));
    return text;
}

// Wavefront text with corner indices position/uv/normal, all the same.
inline std::string make_obj(const Mesh &mesh, bool uvs = true, bool normals = true)
{
    std::string out = "# a leaf\no leaf\n";
    for (const glm::vec3 &p : mesh.positions) {
        out += "v " + number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
    }
    for (std::size_t i = 0; uvs && i < mesh.uvs.size(); i++) {
        out += "vt " + number(mesh.uvs[i].x) + " " + number(mesh.uvs[i].y) + "\n";
    }
    for (std::size_t i = 0; normals && i < mesh.normals.size(); i++) {
        const glm::vec3 &n = mesh.normals[i];
        out += "vn " + number(n.x) + " " + number(n.y) + " " + number(n.z) + "\n";
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i++) {
        const std::string index = std::to_string(mesh.indices[i] + 1);
        out += (i % 3 == 0 ? "f " : " ") + index;
        out += uvs || normals ? "/" + (uvs ? index : "") : "";
        out += (normals ? "/" + index : "") + (i % 3 == 2 ? "\n" : "");
    }
    return out;
}

template <class T> void put(std::string &out, T value, bool big)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); i++) {
        out += bytes[big ? sizeof(T) - 1 - i : i];
    }
}

inline std::string ply_header(Ply format, std::size_t vertices, std::size_t faces, bool uvs,
                              bool normals)
{
    static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    std::string out = std::string("ply\nformat ") + names[int(format)] + " 1.0\ncomment a leaf\n";
    out += "element vertex " + std::to_string(vertices) + "\n";
    out += "property float x\nproperty float y\nproperty float z\n";
    out += normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "";
    out += uvs ? "property float u\nproperty float v\n" : "";
    out += "element face " + std::to_string(faces) + "\n";
    return out + "property list uchar int vertex_indices\nend_header\n";
}

inline std::string make_ply(const Mesh &mesh, Ply format, bool uvs = true, bool normals = true)
{
    std::string out = ply_header(format, mesh.positions.size(), mesh.triangles(), uvs, normals);
    const auto add = [&](float v, bool last) {
        if (format == Ply::ascii) {
            out += number(v) + (last ? "\n" : " ");
        } else {
            put(out, v, format == Ply::big);
        }
    };
    for (std::size_t i = 0; i < mesh.positions.size(); i++) {
        for (int k = 0; k < 3; k++) {
            add(mesh.positions[i][k], k == 2 && !uvs && !normals);
        }
        for (int k = 0; normals && k < 3; k++) {
            add(mesh.normals[i][k], k == 2 && !uvs);
        }
        for (int k = 0; uvs && k < 2; k++) {
            add(mesh.uvs[i][k], k == 1);
        }
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        if (format == Ply::ascii) {
            out += "3";
        } else {
            out += char(3);
        }
        for (int k = 0; k < 3; k++) {
            const std::uint32_t index = mesh.indices[i + std::size_t(k)];
            if (format == Ply::ascii) {
                out += " " + std::to_string(index);
            } else {
                put(out, index, format == Ply::big);
            }
        }
        out += format == Ply::ascii ? "\n" : "";
    }
    return out;
}

} // namespace leaf_files

#endif

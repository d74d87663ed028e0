// What the tests of leaves share; brings cmocka along.
#ifndef TSUYA_TESTS_LEAF_CHECKS_H
#define TSUYA_TESTS_LEAF_CHECKS_H

#include "leaf/generate.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
extern "C" {
#include <cmocka.h>
}

namespace leaf_checks {

using namespace tsuya::leaf;

inline void expect_error(const std::string &message, const std::vector<std::string> &words)
{
    for (const std::string &word : words) {
        if (message.find(word) == std::string::npos) {
            fail_msg("\"%s\" does not mention \"%s\"", message.c_str(), word.c_str());
        }
    }
}

// `mesh` keeps what mesh.h says of every mesh.
inline void check_promises(const Mesh &mesh)
{
    assert_true(mesh.triangles() > 0 && mesh.indices.size() % 3 == 0);
    const std::size_t count = mesh.positions.size();
    assert_true(mesh.normals.size() == count && mesh.uvs.size() == count &&
                mesh.tangents.size() == count);
    assert_true(mesh.albedo.empty() || mesh.albedo.size() == count);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        assert_true(a < count && b < count && c < count && a != b && b != c && c != a);
    }
    for (std::size_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            assert_true(std::fabs(mesh.positions[i][k]) <= coordinate_limit);
        }
        const glm::vec3 n = mesh.normals[i], t = glm::vec3(mesh.tangents[i]);
        assert_true(std::fabs(glm::length(n) - 1.0f) <= 1e-5f);
        assert_true(std::fabs(glm::length(t) - 1.0f) <= 1e-5f);
        assert_true(std::fabs(glm::dot(n, t)) <= 1e-5f);
        assert_true(std::fabs(mesh.tangents[i].w) == 1.0f);
        assert_true(std::isfinite(mesh.uvs[i].x) && std::isfinite(mesh.uvs[i].y));
    }
}

// FNV-1a over the bytes of some vectors.
class Fingerprint
{
  public:
    template <class T> Fingerprint &add(const std::vector<T> &values)
    {
        const unsigned char *bytes = reinterpret_cast<const unsigned char *>(values.data());
        for (std::size_t i = 0; i < values.size() * sizeof(T); i++) {
            hash_ = (hash_ ^ bytes[i]) * 0x100000001b3u;
        }
        return *this;
    }
    Fingerprint &add(const Mesh &mesh)
    {
        return add(mesh.positions)
            .add(mesh.normals)
            .add(mesh.uvs)
            .add(mesh.tangents)
            .add(mesh.albedo)
            .add(mesh.indices);
    }
    std::uint64_t value() const
    {
        return hash_;
    }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

} // namespace leaf_checks

#endif

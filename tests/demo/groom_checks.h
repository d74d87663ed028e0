// What the tests of readers and generator both check; brings cmocka along.
#ifndef TSUYA_TESTS_GROOM_CHECKS_H
#define TSUYA_TESTS_GROOM_CHECKS_H

#include "groom_files.h"
#include "read.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
extern "C" {
#include <cmocka.h>
}

namespace groom_checks {

using namespace tsuya::groom;
using namespace groom_files;

// `message` mentions all of `words`.
inline void expect_error(const std::string &message, const std::vector<std::string> &words)
{
    for (const std::string &word : words) {
        if (message.find(word) == std::string::npos) {
            fail_msg("\"%s\" does not mention \"%s\"", message.c_str(), word.c_str());
        }
    }
}

// `groom` keeps what groom.h says of every groom.
inline void check_promises(const Groom &groom)
{
    assert_true(groom.strands() > 0);
    assert_int_equal(groom.first.back(), groom.points.size());
    assert_true(groom.radius.empty() || groom.radius.size() == groom.points.size());
    assert_true(groom.uv.empty() || groom.uv.size() == groom.strands());
    for (std::size_t s = 0; s < groom.strands(); ++s) {
        assert_true(groom.first[s + 1] >= groom.first[s] + 2);
    }
    for (const glm::vec2 &uv : groom.uv) {
        assert_true(std::isfinite(uv.x) && std::isfinite(uv.y));
    }
    for (const float r : groom.radius) {
        assert_true(r > 0.0f && r <= coordinate_limit);
    }
    assert_true(groom.constant_radius > 0.0f && groom.constant_radius <= coordinate_limit);
    const Report report = inspect(groom);
    assert_int_equal(report.non_finite_points, 0);
    assert_int_equal(report.degenerate_segments, 0);
    assert_true(std::isfinite(report.mean_length) && report.mean_length > 0.0);
}

inline Result load(const Bytes &bytes, Format format, const ReadOptions &options = {})
{
    return read(bytes.data(), bytes.size(), format, options);
}

inline void expect_refused(const Bytes &bytes, Format format, const std::vector<std::string> &words)
{
    const Result r = load(bytes, format);
    assert_false(bool(r));
    expect_error(r.error(), words);
}

inline void expect_strands(const Groom &groom, const Strands &strands)
{
    assert_int_equal(groom.strands(), strands.size());
    assert_int_equal(groom.seed.size(), strands.size());
    std::size_t at = 0;
    for (std::size_t s = 0; s < strands.size(); ++s) {
        assert_int_equal(groom.first[s], at);
        for (const glm::vec3 &p : strands[s]) {
            assert_true(groom.points[at++] == p);
        }
        assert_true(groom.seed[s] >= 0.0f && groom.seed[s] < 1.0f);
    }
    assert_int_equal(groom.first.back(), at);
    assert_int_equal(groom.points.size(), at);
}

// A folder of its own for files, gone with it.
class Folder
{
  public:
    Folder() : path_(std::filesystem::temp_directory_path() / "tsuya-groom-test")
    {
        path_ += std::to_string(std::uintptr_t(this));
        std::filesystem::create_directories(path_);
    }
    ~Folder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string write(const char *name, const Bytes &bytes) const
    {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), std::streamsize(bytes.size()));
        return file.string();
    }
    std::string path() const
    {
        return path_.string();
    }

  private:
    std::filesystem::path path_;
};

} // namespace groom_checks

#endif

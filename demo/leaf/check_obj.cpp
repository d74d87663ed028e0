#include "leaf/check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace tsuya::leaf {

namespace {

constexpr double largest = 3.4e38; // what a float holds

// The next word of `line`, cut off from it; empty at its end.
std::string_view word(std::string_view &line)
{
    const char *const space = " \t\r\f\v";
    const std::size_t begin = std::min(line.find_first_not_of(space), line.size());
    const std::size_t end = std::min(line.find_first_of(space, begin), line.size());
    const std::string_view result = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return result;
}

template <class T> bool whole(std::string_view text, T &value)
{
    if (!text.empty() && text[0] == '+') {
        text.remove_prefix(1);
    }
    const std::from_chars_result r = std::from_chars(text.data(), text.data() + text.size(), value);
    return r.ec == std::errc() && r.ptr == text.data() + text.size();
}

class Walk
{
  public:
    // Returns: what is wrong with a line; "" when nothing is.
    std::string take(std::string_view line)
    {
        line_++;
        const std::string_view key = word(line);
        if (key == "v") {
            return numbers(line, 3, positions_);
        }
        if (key == "vt") {
            return numbers(line, 2, uvs_);
        }
        if (key == "vn") {
            return numbers(line, 3, normals_);
        }
        return key == "f" ? face(line) : "";
    }

    // Faces may come before what they refer to.
    std::string finish(Counted &counted) const
    {
        counted.vertices = positions_;
        counted.faces = faces_;
        counted.skipped = skipped_;
        counted.uvs = corners_ > 0 && corner_uvs_ == corners_;
        counted.normals = corners_ > 0 && corner_normals_ == corners_;
        const long counts[3] = {long(positions_), long(uvs_), long(normals_)};
        static const char *const names[3] = {"vertices", "uv", "normals"};
        for (int k = 0; k < 3; k++) {
            if (highest_[k] > counts[k]) {
                return "line " + std::to_string(highest_line_[k]) + ": refers to number " +
                       std::to_string(highest_[k]) + " of " + std::to_string(counts[k]) + " " +
                       names[k];
            }
        }
        if (corner_uvs_ > 0 && corner_uvs_ < corners_) {
            return "some corners have a uv and some have none";
        }
        return "";
    }

  private:
    std::string numbers(std::string_view line, int least, std::size_t &count)
    {
        int found = 0;
        for (std::string_view w = word(line); !w.empty() && w[0] != '#'; w = word(line), found++) {
            double value = 0.0;
            if (!whole(w, value) || !(std::fabs(value) <= largest)) {
                return "\"" + std::string(w) + "\" is no finite number";
            }
        }
        count++;
        return found >= least
                   ? ""
                   : "holds " + std::to_string(found) + " numbers of " + std::to_string(least);
    }

    std::string face(std::string_view line)
    {
        std::vector<long> corners;
        for (std::string_view w = word(line); !w.empty(); w = word(line)) {
            const std::string corner(w);
            for (int k = 0; k < 3 && !w.empty(); k++) {
                const std::size_t slash = std::min(w.find('/'), w.size());
                const std::string_view part = w.substr(0, slash);
                w.remove_prefix(std::min(slash + 1, w.size()));
                if (part.empty() && k > 0) {
                    continue;
                }
                const std::string wrong = index(part, k, corners);
                if (!wrong.empty()) {
                    return "corner \"" + corner + "\" " + wrong;
                }
            }
            if (!w.empty()) {
                return "corner \"" + corner + "\" has more than three parts";
            }
            corners_++;
        }
        if (corners.size() < 3) {
            return "a face of " + std::to_string(corners.size()) + " corners";
        }
        const std::size_t all = corners.size();
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        if (corners.size() > 2 && corners.size() < all) {
            return "a face of " + std::to_string(all) + " corners has one of them twice";
        }
        (corners.size() > 2 ? faces_ : skipped_)++;
        return "";
    }

    // k: 0 position, 1 uv, 2 normal
    std::string index(std::string_view part, int k, std::vector<long> &corners)
    {
        long value = 0;
        if (!whole(part, value)) {
            return "is no number";
        }
        const std::size_t counts[3] = {positions_, uvs_, normals_};
        const long from_one = value < 0 ? long(counts[k]) + value + 1 : value;
        if (from_one < 1) {
            return "refers to number " + std::to_string(value);
        }
        if (from_one > highest_[k]) {
            highest_[k] = from_one;
            highest_line_[k] = line_;
        }
        corner_uvs_ += k == 1;
        corner_normals_ += k == 2;
        if (k == 0) {
            corners.push_back(from_one);
        }
        return "";
    }

    std::size_t positions_ = 0, uvs_ = 0, normals_ = 0, faces_ = 0, skipped_ = 0;
    std::size_t corners_ = 0, corner_uvs_ = 0, corner_normals_ = 0;
    long highest_[3] = {0, 0, 0};
    std::size_t line_ = 0, highest_line_[3] = {0, 0, 0};
};

} // namespace

Expected<Counted> check_obj(const std::string &text)
{
    Walk walk;
    std::size_t begin = 0;
    for (std::size_t number = 1; begin < text.size(); number++) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string wrong = walk.take(std::string_view(text).substr(begin, end - begin));
        if (!wrong.empty()) {
            return Error{"line " + std::to_string(number) + ": " + wrong};
        }
        begin = end + 1;
    }
    Counted counted;
    const std::string wrong = walk.finish(counted);
    if (!wrong.empty()) {
        return Error{wrong};
    }
    return counted;
}

} // namespace tsuya::leaf

#include "leaf/check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <sstream>
#include <vector>

namespace tsuya::leaf {

namespace {

struct Column {
    std::string name;
    int size = 4; // bytes
    bool floating = false, single = false;
};

struct Header {
    bool ascii = false, big = false;
    std::size_t vertices = 0, faces = 0, body = 0; // body: offset of the first byte after it
    std::vector<Column> columns;                   // of a vertex
    int index_size = 4;
    bool index_signed = false;
    bool has_list = false;

    bool column(const char *name) const
    {
        return std::any_of(columns.begin(), columns.end(),
                           [&](const Column &c) { return c.name == name; });
    }
};

// Size in bytes of a type; 0: no such type.
int size_of(const std::string &type, bool &floating)
{
    static const struct {
        const char *name;
        int size;
        bool floating;
    } types[] = {
        {"char", 1, false},  {"int8", 1, false},   {"uchar", 1, false},  {"uint8", 1, false},
        {"short", 2, false}, {"int16", 2, false},  {"ushort", 2, false}, {"uint16", 2, false},
        {"int", 4, false},   {"int32", 4, false},  {"uint", 4, false},   {"uint32", 4, false},
        {"float", 4, true},  {"float32", 4, true}, {"double", 8, true},  {"float64", 8, true}};
    for (const auto &t : types) {
        if (type == t.name) {
            floating = t.floating;
            return t.size;
        }
    }
    return 0;
}

bool is_read(const std::string &name)
{
    for (const char *known : {"x", "y", "z", "nx", "ny", "nz", "u", "v", "s", "t"}) {
        if (name == known) {
            return true;
        }
    }
    return false;
}

// OpenMesh reads a header word by word: every line must hold as many words as it should.
using Words = std::vector<std::string>;

std::string element(const Words &words, Header &header, int &which)
{
    const std::string name = words.size() > 1 ? words[1] : "";
    std::size_t count = 0;
    if ((name != "vertex" && name != "face") || (name == "face") != (which == 1)) {
        return "element " + name + " is not read: a vertex element and then a face element are";
    }
    if (words.size() == 3) {
        const char *const end = words[2].data() + words[2].size();
        const std::from_chars_result r = std::from_chars(words[2].data(), end, count);
        if (r.ec == std::errc() && r.ptr == end && count <= 0x7fffffffu) {
            (which == 1 ? header.faces : header.vertices) = count;
            which++;
            return "";
        }
    }
    return "element " + name + " has no count in [0, 2147483647]";
}

std::string property(const Words &words, Header &header, int which)
{
    bool floating = false;
    if (which == 2) {
        const bool list = words.size() == 5 && words[1] == "list";
        const std::string count = list ? words[2] : "", entry = list ? words[3] : "";
        const std::string name = list ? words[4] : "";
        const int size = size_of(entry, floating);
        if (header.has_list || (count != "uchar" && count != "uint8") ||
            (name != "vertex_indices" && name != "vertex_index") || floating ||
            (size != 4 && size != 1)) {
            return "of a face only \"list uchar int vertex_indices\" is read";
        }
        header.has_list = true;
        header.index_size = size;
        header.index_signed = entry[0] != 'u';
        return "";
    }
    const std::string type = words.size() == 3 ? words[1] : "";
    const std::string name = words.size() == 3 ? words[2] : "";
    const int size = size_of(type, floating);
    bool also = false;
    if (which != 1 || size == 0 || size_of(name, also) != 0) {
        return "property " + type + " " + name + " is not read";
    }
    if (is_read(name) && !header.ascii && !(floating && size == 4)) {
        return "property " + name + " is a " + type +
               ", which is not read from a binary file; "
               "write it as float";
    }
    if (header.column(name.c_str())) {
        return "property " + name + " is there twice";
    }
    header.columns.push_back({name, size, floating, size == 4});
    return "";
}

// Returns: what is wrong with the header; "" when nothing is.
std::string parse(const std::string &bytes, Header &header)
{
    std::size_t begin = 0;
    int which = 0; // elements begun
    for (int number = 1; begin < bytes.size(); number++) {
        const std::size_t end = bytes.find('\n', begin);
        if (end == std::string::npos || end - begin > 4000) {
            break;
        }
        std::string text = bytes.substr(begin, end - begin);
        begin = end + 1;
        if (!text.empty() && text.back() == '\r') {
            text.pop_back();
        }
        std::istringstream line(text);
        const Words words{std::istream_iterator<std::string>(line), {}};
        const std::string key = words.empty() ? "" : words[0];
        std::string wrong;
        if (number == 1) {
            wrong = text == "ply" ? "" : "a .ply file begins with a line \"ply\"";
        } else if (number == 2) {
            const std::string format = words.size() == 3 ? words[1] : "";
            header.ascii = format == "ascii";
            header.big = format == "binary_big_endian";
            if (key != "format" || words.back() != "1.0" ||
                (!header.ascii && !header.big && format != "binary_little_endian")) {
                wrong = "\"" + text + "\" is no format";
            }
        } else if (key == "element") {
            wrong = element(words, header, which);
        } else if (key == "property") {
            wrong = property(words, header, which);
        } else if (text == "end_header") {
            header.body = begin;
            const bool place = header.column("x") && header.column("y") && header.column("z");
            return !place                          ? "there is no x, y and z"
                   : which < 2 || !header.has_list ? "there are no faces"
                                                   : "";
        } else if (key != "comment") {
            wrong = "\"" + text + "\" is not understood";
        }
        if (!wrong.empty()) {
            return "line " + std::to_string(number) + ": " + wrong;
        }
    }
    return "the header does not end";
}

class Body
{
  public:
    Body(const std::string &bytes, const Header &header)
        : at_(bytes.data() + header.body), end_(bytes.data() + bytes.size()), header_(header)
    {
    }

    // A number of `size` bytes, or the next word. Returns: false: there is none.
    bool number(int size, bool floating, bool is_signed, double &value)
    {
        if (header_.ascii) {
            return next_word(floating, value);
        }
        if (end_ - at_ < size) {
            return false;
        }
        unsigned char b[8];
        for (int i = 0; i < size; i++) {
            b[header_.big ? size - 1 - i : i] = static_cast<unsigned char>(at_[i]);
        }
        at_ += size;
        std::uint64_t bits = 0;
        for (int i = 0; i < size; i++) {
            bits |= std::uint64_t(b[i]) << (8 * i);
        }
        if (floating && size == 4) {
            const std::uint32_t low = std::uint32_t(bits);
            float single;
            std::memcpy(&single, &low, sizeof single);
            value = double(single);
        } else if (floating) {
            std::memcpy(&value, &bits, sizeof value);
        } else if (is_signed && size < 8 && (bits >> (8 * size - 1) & 1)) {
            value = double(bits) - std::ldexp(1.0, 8 * size);
        } else {
            value = double(bits);
        }
        return true;
    }

    std::size_t left() const
    {
        return std::size_t(end_ - at_);
    }

  private:
    bool next_word(bool floating, double &value)
    {
        const auto blank = [](char c) {
            return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
        };
        while (at_ != end_ && blank(*at_)) {
            at_++;
        }
        const char *const begin = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
        std::from_chars_result r{};
        if (floating) {
            r = std::from_chars(begin, end_, value);
        } else {
            long long integer = 0;
            r = std::from_chars(begin, end_, integer);
            value = double(integer);
        }
        at_ = r.ptr;
        return r.ec == std::errc() && (at_ == end_ || blank(*at_));
    }

    const char *at_, *end_;
    const Header &header_;
};

std::string walk(Body &body, const Header &header, Counted &counted)
{
    for (std::size_t i = 0; i < header.vertices; i++) {
        for (const Column &column : header.columns) {
            double value = 0.0;
            const std::string where = "vertex " + std::to_string(i) + ": " + column.name;
            if (!body.number(column.size, column.floating, false, value)) {
                return where + (body.left() ? " is no number" : " is beyond the file's end");
            }
            // What a float holds; NaN fails every comparison.
            if (column.floating && !(std::fabs(value) <= 3.4e38) &&
                (header.ascii || is_read(column.name))) {
                return where + " is not finite";
            }
        }
    }
    for (std::size_t i = 0; i < header.faces; i++) {
        const std::string where = "face " + std::to_string(i);
        double corners = 0.0;
        if (!body.number(1, false, false, corners)) {
            return where + (body.left() ? " has no count" : " is beyond the file's end");
        }
        if (!(corners >= 3.0 && corners <= 255.0)) {
            return where + " has " + std::to_string(int(std::clamp(corners, -1e9, 1e9))) +
                   " corners but must have 3 to 255";
        }
        std::vector<double> seen;
        for (int k = 0; k < int(corners); k++) {
            double index = 0.0;
            if (!body.number(header.index_size, false, header.index_signed, index)) {
                return where + (body.left() ? " has a corner that is no number"
                                            : " ends beyond the file's end");
            }
            if (!(index >= 0.0 && index < double(header.vertices))) {
                return where + " refers to vertex " +
                       std::to_string((long long)(std::clamp(index, -1e15, 1e15))) + " of " +
                       std::to_string(header.vertices);
            }
            seen.push_back(index);
        }
        std::sort(seen.begin(), seen.end());
        if (std::unique(seen.begin(), seen.end()) != seen.end()) {
            counted.skipped++;
            continue;
        }
        counted.faces++;
    }
    return "";
}

} // namespace

Expected<Counted> check_ply(const std::string &bytes)
{
    Header header;
    const std::string wrong = parse(bytes, header);
    if (!wrong.empty()) {
        return Error{wrong};
    }
    // The least that a count asks for, before anything walks or reserves.
    std::size_t row = 0;
    for (const Column &column : header.columns) {
        row += header.ascii ? 2 : std::size_t(column.size);
    }
    const std::size_t face = header.ascii ? 8 : 1 + 3 * std::size_t(header.index_size);
    const double needed =
        double(row) * double(header.vertices) + double(face) * double(header.faces);
    const std::size_t there = bytes.size() - header.body + 1;
    if (needed > double(there)) {
        return Error{"the header claims " + std::to_string(header.vertices) + " vertices and " +
                     std::to_string(header.faces) + " faces, more than " +
                     std::to_string(there - 1) + " bytes hold"};
    }
    Counted counted;
    counted.vertices = header.vertices;
    Body body(bytes, header);
    const std::string bad = walk(body, header, counted);
    if (!bad.empty()) {
        return Error{bad};
    }
    counted.normals = header.column("nx") && header.column("ny") && header.column("nz");
    counted.uvs =
        (header.column("u") && header.column("v")) || (header.column("s") && header.column("t"));
    return counted;
}

} // namespace tsuya::leaf

#include "draw/strands.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cstring>

namespace tsuya::draw {

namespace {

// Every GL 3.3 and ES 3 driver in use has textures this wide.
constexpr std::size_t row = Strands::row_points;

GLuint texture(const gl_api &gl, GLenum unit, const std::vector<glm::vec4> &texels)
{
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.ActiveTexture(unit);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, GLsizei(row), GLsizei(texels.size() / row), 0,
                  GL_RGBA, GL_FLOAT, texels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return name;
}

// Indices 0 .. keys.size() - 1 by falling key; keys are positive floats, whose bits sort as
// numbers.
std::vector<std::uint32_t> order_by(const std::vector<float> &keys)
{
    constexpr int bits = 11;
    constexpr std::uint32_t buckets = 1u << bits;
    std::vector<std::uint32_t> key(keys.size()), order(keys.size()), next(keys.size());
    for (std::size_t i = 0; i < keys.size(); i++) {
        std::memcpy(&key[i], &keys[i], sizeof key[i]);
        order[i] = std::uint32_t(i);
    }
    for (int shift = 0; shift < 32; shift += bits) {
        std::vector<std::uint32_t> start(buckets + 1, 0);
        for (std::uint32_t k : key) {
            start[buckets - 1 - ((k >> shift) & (buckets - 1)) + 1]++;
        }
        for (std::uint32_t b = 0; b < buckets; b++) {
            start[b + 1] += start[b];
        }
        for (std::uint32_t i : order) {
            next[start[buckets - 1 - ((key[i] >> shift) & (buckets - 1))]++] = i;
        }
        order.swap(next);
    }
    return order;
}

} // namespace

Strands::~Strands()
{
    gl_->DeleteTextures(1, &points_);
    gl_->DeleteTextures(1, &data_);
    gl_->DeleteBuffers(1, &elements_);
    gl_->DeleteVertexArrays(1, &array_);
}

bool Strands::load(const groom::Groom &groom)
{
    const std::size_t rows = (groom.points.size() + row - 1) / row;
    GLint most = 0;
    gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (rows > std::size_t(most)) {
        return false;
    }
    std::vector<glm::vec4> points(rows * row), data(rows * row);
    place_ = groom.points;
    strand_count_ = groom.strands();
    first_.clear();
    strand_.clear();
    for (std::size_t s = 0; s < groom.strands(); s++) {
        const std::uint32_t begin = groom.first[s], end = groom.first[s + 1];
        double length = 0.0;
        for (std::uint32_t i = begin; i < end; i++) {
            if (i > begin) {
                length += glm::distance(groom.points[i - 1], groom.points[i]);
                first_.push_back(i - 1);
                strand_.push_back(std::uint32_t(s));
            }
            const float radius = groom.radius.empty() ? groom.constant_radius : groom.radius[i];
            points[i] = glm::vec4(groom.points[i], radius);
            data[i] = glm::vec4(float(length), 0.0f, groom.seed[s], float(s));
        }
        for (std::uint32_t i = begin; i < end; i++) {
            data[i].y = i + 1 < end ? std::max(float(length) - data[i].x, 1e-12f) : 0.0f;
            data[i].x = i > begin ? std::max(data[i].x, 1e-12f) : 0.0f;
        }
    }
    gl_->DeleteTextures(1, &points_);
    gl_->DeleteTextures(1, &data_);
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    points_ = texture(*gl_, GL_TEXTURE1, points);
    data_ = texture(*gl_, GL_TEXTURE2, data);
    if (!array_) {
        gl_->GenVertexArrays(1, &array_);
        gl_->GenBuffers(1, &elements_);
    }
    count_ = 0;
    rows_ = int(rows);
    return true;
}

float Strands::depth(std::uint32_t point, const glm::mat4 &view) const
{
    const glm::vec3 &p = place_[point];
    return -(view[0].z * p.x + view[1].z * p.y + view[2].z * p.z + view[3].z);
}

void Strands::sort(const glm::mat4 &view, float near)
{
    std::vector<float> keys;
    std::vector<std::uint32_t> kept;
    keys.reserve(first_.size());
    kept.reserve(first_.size());
    for (std::uint32_t point : first_) {
        const float a = depth(point, view), b = depth(point + 1, view);
        if (a > near && b > near) {
            keys.push_back(a + b);
            kept.push_back(point);
        }
    }
    std::vector<std::uint32_t> order = order_by(keys);
    for (std::uint32_t &i : order) {
        i = kept[i];
    }
    upload(order);
}

void Strands::choose(const std::vector<char> &strands, const glm::mat4 &view, float near)
{
    std::vector<std::uint32_t> order;
    for (std::size_t i = 0; i < first_.size(); i++) {
        if (strands[strand_[i]] && depth(first_[i], view) > near &&
            depth(first_[i] + 1, view) > near) {
            order.push_back(first_[i]);
        }
    }
    upload(order);
}

void Strands::all()
{
    upload(first_);
}

void Strands::upload(const std::vector<std::uint32_t> &order)
{
    std::vector<std::uint32_t> elements(order.size() * 6);
    for (std::size_t i = 0; i < order.size(); i++) {
        const std::uint32_t v = order[i] * 4;
        const std::uint32_t quad[6] = {v, v + 1, v + 2, v + 2, v + 1, v + 3};
        std::copy(quad, quad + 6, elements.begin() + std::ptrdiff_t(i * 6));
    }
    gl_->BindVertexArray(array_);
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements_);
    gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(elements.size() * sizeof elements[0]),
                    elements.data(), GL_STREAM_DRAW);
    count_ = GLsizei(elements.size());
}

void Strands::bind() const
{
    gl_->ActiveTexture(GL_TEXTURE1);
    gl_->BindTexture(GL_TEXTURE_2D, points_);
    gl_->ActiveTexture(GL_TEXTURE2);
    gl_->BindTexture(GL_TEXTURE_2D, data_);
}

void Strands::draw() const
{
    bind();
    gl_->BindVertexArray(array_);
    gl_->DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

} // namespace tsuya::draw

#include "draw/plant.h"

#include <algorithm>
#include <array>

namespace tsuya::draw {

namespace {

constexpr GLuint place_attribute = 5, factors_attribute = 9;

struct Vertex {
    glm::vec3 position, normal;
    glm::vec4 tangent;
    glm::vec2 uv;
    glm::vec3 albedo;
};

struct Instance {
    glm::mat4 place;
    glm::vec4 factors; // pigment, thickness
};

const void *offset(std::size_t bytes)
{
    return reinterpret_cast<const void *>(bytes);
}

} // namespace

Plant::Plant(const gl_api *gl) : gl_(gl)
{
    gl_->GenTextures(1, &maps_);
}

Plant::~Plant()
{
    clear();
    gl_->DeleteTextures(1, &maps_);
}

void Plant::clear()
{
    const auto drop = [&](Part &part) {
        gl_->DeleteVertexArrays(1, &part.array);
        gl_->DeleteBuffers(1, &part.vertices);
        gl_->DeleteBuffers(1, &part.elements);
        part = {};
    };
    std::for_each(blades_.begin(), blades_.end(), drop);
    std::for_each(stalks_.begin(), stalks_.end(), drop);
    drop(wood_);
    blades_.clear();
    stalks_.clear();
    gl_->DeleteBuffers(1, &places_);
    places_ = 0;
    triangles_ = 0;
}

Plant::Part Plant::part(const leaf::Mesh &mesh)
{
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); i++) {
        vertices[i] = {mesh.positions[i], mesh.normals[i], mesh.tangents[i], mesh.uvs[i],
                       mesh.albedo.empty() ? glm::vec3(0.0f) : mesh.albedo[i]};
    }
    Part part;
    gl_->GenVertexArrays(1, &part.array);
    gl_->GenBuffers(1, &part.vertices);
    gl_->GenBuffers(1, &part.elements);
    gl_->BindVertexArray(part.array);
    gl_->BindBuffer(GL_ARRAY_BUFFER, part.vertices);
    gl_->BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                    GL_STATIC_DRAW);
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.elements);
    gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * 4),
                    mesh.indices.data(), GL_STATIC_DRAW);
    const struct {
        GLint size;
        std::size_t at;
    } fields[] = {{3, offsetof(Vertex, position)},
                  {3, offsetof(Vertex, normal)},
                  {4, offsetof(Vertex, tangent)},
                  {2, offsetof(Vertex, uv)},
                  {3, offsetof(Vertex, albedo)}};
    for (GLuint i = 0; i < 5; i++) {
        gl_->EnableVertexAttribArray(i);
        gl_->VertexAttribPointer(i, fields[i].size, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                 offset(fields[i].at));
    }
    part.count = GLsizei(mesh.indices.size());
    return part;
}

// Instances `first` and up to `count` from there.
void Plant::place(Part &part, GLuint places, std::size_t first, std::size_t count) const
{
    gl_->BindVertexArray(part.array);
    gl_->BindBuffer(GL_ARRAY_BUFFER, places);
    for (GLuint i = 0; i < 5; i++) {
        const GLuint attribute = i < 4 ? place_attribute + i : factors_attribute;
        gl_->EnableVertexAttribArray(attribute);
        gl_->VertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                                 offset(first * sizeof(Instance) + i * sizeof(glm::vec4)));
        gl_->VertexAttribDivisor(attribute, 1);
    }
    part.instances = GLsizei(count);
}

void Plant::load(const leaf::Plant &plant)
{
    clear();
    std::vector<Instance> instances;
    std::vector<std::array<std::size_t, 2>> ranges;
    for (std::uint32_t k = 0; k < plant.kinds.size(); k++) {
        const std::size_t first = instances.size();
        for (const leaf::Placed &leaf : plant.leaves) {
            if (leaf.kind == k) {
                instances.push_back({leaf.place, {leaf.pigment, leaf.thickness, 0.0f, 0.0f}});
            }
        }
        ranges.push_back({first, instances.size() - first});
    }
    gl_->GenBuffers(1, &places_);
    gl_->BindBuffer(GL_ARRAY_BUFFER, places_);
    gl_->BufferData(GL_ARRAY_BUFFER, GLsizeiptr(instances.size() * sizeof(Instance)),
                    instances.data(), GL_STATIC_DRAW);
    for (std::size_t k = 0; k < plant.kinds.size(); k++) {
        if (ranges[k][1] == 0) {
            continue;
        }
        blades_.push_back(part(plant.kinds[k].blade));
        place(blades_.back(), places_, ranges[k][0], ranges[k][1]);
        triangles_ += ranges[k][1] * plant.kinds[k].blade.triangles();
        if (!plant.kinds[k].stalk.indices.empty()) {
            stalks_.push_back(part(plant.kinds[k].stalk));
            place(stalks_.back(), places_, ranges[k][0], ranges[k][1]);
            triangles_ += ranges[k][1] * plant.kinds[k].stalk.triangles();
        }
    }
    if (!plant.wood.indices.empty()) {
        wood_ = part(plant.wood);
        triangles_ += plant.wood.triangles();
    }
    load_maps(plant.maps);
}

void Plant::load_maps(const leaf::Maps &maps)
{
    const leaf::Maps even = {1, 1, 1.0, {1.0f}, {1.0f}, {0.0f}, {1}};
    const leaf::Maps &from = maps.empty() ? even : maps;
    const std::vector<float> slopes = leaf::slopes(from);
    std::vector<float> texels;
    for (std::size_t i = 0; i < from.pigment.size(); i++) {
        texels.insert(texels.end(),
                      {from.pigment[i], from.thickness[i], slopes[2 * i], slopes[2 * i + 1]});
    }
    gl_->ActiveTexture(GL_TEXTURE1);
    gl_->BindTexture(GL_TEXTURE_2D, maps_);
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, from.width, from.height, 0, GL_RGBA, GL_FLOAT,
                    texels.data());
    gl_->GenerateMipmap(GL_TEXTURE_2D);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    const GLint beyond = from.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, beyond);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, beyond);
}

void Plant::draw(const Part &part) const
{
    gl_->BindVertexArray(part.array);
    if (part.instances > 0) {
        gl_->DrawElementsInstanced(GL_TRIANGLES, part.count, GL_UNSIGNED_INT, nullptr,
                                   part.instances);
        return;
    }
    for (GLuint i = 0; i < 4; i++) {
        const float on = 1.0f;
        gl_->VertexAttrib4f(place_attribute + i, i == 0 ? on : 0.0f, i == 1 ? on : 0.0f,
                            i == 2 ? on : 0.0f, i == 3 ? on : 0.0f);
    }
    gl_->VertexAttrib4f(factors_attribute, 1.0f, 1.0f, 0.0f, 0.0f);
    gl_->DrawElements(GL_TRIANGLES, part.count, GL_UNSIGNED_INT, nullptr);
}

void Plant::blades() const
{
    for (const Part &part : blades_) {
        draw(part);
    }
}

void Plant::wood() const
{
    for (const Part &part : stalks_) {
        draw(part);
    }
    if (wood_.count > 0) {
        draw(wood_);
    }
}

} // namespace tsuya::draw

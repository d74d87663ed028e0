#include "scene/leaf_maps.h"

#include "image/image.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace tsuya::scene
{

namespace
{

constexpr int side_most = 8192;
constexpr double steepest = 20.0;
constexpr double height_most = 1000.0;

// A picture of a map, and how its messages begin.
struct Source {
    std::string name; // key and file
    image::Image image;
    std::array<int, 3> channels{};
    int alpha = -1;
    bool png = false;

    std::size_t first(int x, int y) const
    {
        return (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) *
               std::size_t(image.channels);
    }
    glm::dvec3 value(int x, int y) const
    {
        const float *texel = &image.pixels[first(x, y)];
        return {double(texel[channels[0]]), double(texel[channels[1]]), double(texel[channels[2]])};
    }
    bool painted(int x, int y) const
    {
        return alpha < 0 || image.pixels[first(x, y) + std::size_t(alpha)] != 0.0f;
    }
    // x and y from the top left, as in the file.
    Error bad(int x, int y, const std::string &what) const
    {
        return Error{name + ": texel (" + std::to_string(x) + ", " + std::to_string(y) +
                     ") from the top left " + what};
    }
};

// `count` numbers a texel, the first row at v = 0.
struct Layer {
    int width = 1, height = 1, count = 1;
    std::vector<float> values;

    Layer(int w, int h, int c) : width(w), height(h), count(c)
    {
        values.resize(std::size_t(w) * std::size_t(h) * std::size_t(c));
    }
    std::size_t first(int x, int y) const
    {
        return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(count);
    }
    float *at(int x, int y)
    {
        return &values[first(x, y)];
    }
    const float *at(int x, int y) const
    {
        return &values[first(x, y)];
    }
};

// As short as names the same float: 2.1, not 2.0999999.
std::string text(double value)
{
    char digits[64];
    return {digits, std::to_chars(digits, digits + sizeof digits, float(value)).ptr};
}

bool finite(const glm::dvec3 &v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool ends_in_png(const std::string &path)
{
    const char last = path.back();
    return last == 'g' || last == 'G';
}

Expected<Source> open(const LeafMapKey &key, const std::string &path, bool grey)
{
    Source source;
    source.name = std::string(key.name) + ": " + path;
    source.png = ends_in_png(path);
    std::string error;
    const bool good = source.png ? image::read_png(path, source.image, error, image::Curve::none)
                                 : image::read_exr(path, source.image, error);
    if (!good) {
        return Error{std::string(key.name) + ": " + error};
    }
    const image::Image &image = source.image;
    if (image.width > side_most || image.height > side_most) {
        return Error{source.name + ": " + std::to_string(image.width) + "x" +
                     std::to_string(image.height) + " texels, but a side has at most " +
                     std::to_string(side_most)};
    }
    const auto channel = [&](const char *name) { return image::channel(image, name); };
    source.channels = {channel("R"), channel("G"), channel("B")};
    source.alpha = image.channels > 1 ? channel("A") : -1;
    if (grey && channel("Y") >= 0) {
        source.channels.fill(channel("Y"));
    } else if (grey && image.channels == 1) {
        source.channels.fill(0);
    }
    if (std::count(source.channels.begin(), source.channels.end(), -1)) {
        return Error{source.name + ": it has no channels R, G and B" +
                     (grey ? ", nor a grey one" : "")};
    }
    bool painted = false;
    for (int y = 0; y < image.height && !painted; y++) {
        for (int x = 0; x < image.width && !painted; x++) {
            painted = source.painted(x, y);
        }
    }
    if (!painted) {
        return Error{source.name + ": nothing is painted, its alpha is 0 everywhere"};
    }
    return Expected<Source>(std::move(source));
}

// What is wrong with the grey value, in a sentence about its texel; "" when nothing is.
std::string defect(const glm::dvec3 &v, const std::string &range)
{
    if (!finite(v)) {
        return "is not finite but must be in " + range;
    }
    if (v.x != v.y || v.x != v.z) {
        return "is (" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ") but must be grey";
    }
    return "";
}

template <class Decode>
Expected<Layer> factors(const Source &source, double low, double high, Decode decode)
{
    const std::string range = "[" + text(low) + ", " + text(high) + "]";
    Layer layer(source.image.width, source.image.height, 1);
    for (int y = 0; y < layer.height; y++) {
        for (int x = 0; x < layer.width; x++) {
            const glm::dvec3 value = source.value(x, y);
            double factor = 1.0;
            if (source.painted(x, y)) {
                const std::string wrong = defect(value, range);
                if (!wrong.empty()) {
                    return source.bad(x, y, wrong);
                }
                factor = source.png ? decode(value.x) : value.x;
            }
            if (!(factor >= low && factor <= high)) {
                return source.bad(x, y, "is " + text(factor) + " but must be in " + range);
            }
            *layer.at(x, layer.height - 1 - y) = float(factor);
        }
    }
    return Expected<Layer>(std::move(layer));
}

Expected<Layer> normals(const Source &source, bool green_down)
{
    Layer layer(source.image.width, source.image.height, 2);
    for (int y = 0; y < layer.height; y++) {
        for (int x = 0; x < layer.width; x++) {
            glm::dvec3 n = source.value(x, y);
            n = !source.painted(x, y) ? glm::dvec3(0.0, 0.0, 1.0) : source.png ? 2.0 * n - 1.0 : n;
            const double size = glm::length(n);
            if (!(size >= 0.5 && size <= 1.1)) {
                return source.bad(x, y,
                                  "is a vector of length " + text(size) +
                                      " but must be in [0.5, 1.1]" +
                                      (source.png ? ", after value = (component + 1) / 2"
                                                  : "; an EXR holds the components themselves"));
            }
            if (!(std::hypot(n.x, n.y) <= steepest * n.z)) {
                return source.bad(x, y,
                                  "is (" + text(n.x) + ", " + text(n.y) + ", " + text(n.z) +
                                      "), a slope that must be in [0, " + text(steepest) + "]");
            }
            float *slope = layer.at(x, layer.height - 1 - y);
            slope[0] = float(-n.x / n.z);
            slope[1] = float((green_down ? n.y : -n.y) / n.z);
        }
    }
    return Expected<Layer>(std::move(layer));
}

// How fast u and v grow over the mesh, per metre: means over the area that has a uv.
glm::dvec2 growth(const leaf::Mesh &mesh)
{
    glm::dvec2 sum(0.0);
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const std::uint32_t *c = &mesh.indices[t];
        const glm::dvec3 p = mesh.positions[c[0]];
        const glm::dvec3 a = glm::dvec3(mesh.positions[c[1]]) - p;
        const glm::dvec3 b = glm::dvec3(mesh.positions[c[2]]) - p;
        const glm::dvec2 u = mesh.uvs[c[0]];
        const glm::dvec2 da = glm::dvec2(mesh.uvs[c[1]]) - u, db = glm::dvec2(mesh.uvs[c[2]]) - u;
        if (da.x * db.y == db.x * da.y) {
            continue;
        }
        // The gradient's length times twice the area, from the triangle's metric.
        for (int k = 0; k < 2; k++) {
            sum[k] += glm::length(da[k] * b - db[k] * a);
        }
        area += glm::length(glm::cross(a, b));
    }
    return area > 0.0 ? sum / area : sum;
}

// Slopes of a height map, `metres` for a value of 1. Where there is nothing painted, nothing rises.
Expected<Layer> heights(const Source &source, double metres, const glm::dvec2 &per_metre,
                        bool repeat)
{
    const std::string range = "[" + text(-height_most) + ", " + text(height_most) + "]";
    const int size[2] = {source.image.width, source.image.height};
    for (int y = 0; y < size[1]; y++) {
        for (int x = 0; x < size[0]; x++) {
            const glm::dvec3 value = source.value(x, y);
            std::string wrong = source.painted(x, y) ? defect(value, range) : "";
            if (wrong.empty() && source.painted(x, y) && std::fabs(value.x) > height_most) {
                wrong = "is " + text(value.x) + " but must be in " + range;
            }
            if (!wrong.empty()) {
                return source.bad(x, y, wrong);
            }
        }
    }
    Layer layer(size[0], size[1], 2);
    for (int y = 0; y < size[1]; y++) {
        for (int x = 0; x < size[0]; x++) {
            float *slope = layer.at(x, size[1] - 1 - y);
            for (int k = 0; k < 2 && source.painted(x, y); k++) {
                double rise = 0.0, steps = 0.0;
                for (const int sign : {-1, 1}) {
                    // v grows from row to row upwards.
                    int at[2] = {x, y};
                    at[k] += k == 0 ? sign : -sign;
                    if (repeat) {
                        at[k] = (at[k] + size[k]) % size[k];
                    }
                    if (at[k] >= 0 && at[k] < size[k] && source.painted(at[0], at[1])) {
                        rise += sign * (source.value(at[0], at[1]).x - source.value(x, y).x);
                        steps += 1.0;
                    }
                }
                const double all =
                    steps > 0.0 ? rise / steps * metres * double(size[k]) * per_metre[k] : 0.0;
                if (!(std::fabs(all) <= steepest)) {
                    return source.bad(x, y,
                                      "has a slope of " + text(all) + " but must be in [" +
                                          text(-steepest) + ", " + text(steepest) +
                                          "]; lower mesh.height_mm");
                }
                slope[k] = float(all);
            }
        }
    }
    return Expected<Layer>(std::move(layer));
}

Layer resized(const Layer &from, int width, int height, bool repeat)
{
    Layer to(width, height, from.count);
    const auto place = [&](int i, int count, int there, int side[2]) {
        const double at = (double(i) + 0.5) * double(there) / double(count) - 0.5;
        const int low = int(std::floor(at));
        for (int k = 0; k < 2; k++) {
            side[k] = repeat ? (low + k + there) % there : std::clamp(low + k, 0, there - 1);
        }
        return float(at - low);
    };
    for (int y = 0; y < height; y++) {
        int row[2], column[2];
        const float up = place(y, height, from.height, row);
        for (int x = 0; x < width; x++) {
            const float right = place(x, width, from.width, column);
            const auto across = [&](int r, int c) {
                const float a = from.at(column[0], row[r])[c];
                return a + right * (from.at(column[1], row[r])[c] - a);
            };
            for (int c = 0; c < from.count; c++) {
                const float a = across(0, c);
                to.at(x, y)[c] = a + up * (across(1, c) - a);
            }
        }
    }
    return to;
}

bool beyond(const leaf::Mesh &mesh)
{
    const float slack = 1e-4f; // of rounding in files
    return std::any_of(mesh.uvs.begin(), mesh.uvs.end(), [=](const glm::vec2 &uv) {
        return std::min(uv.x, uv.y) < -slack || std::max(uv.x, uv.y) > 1.0f + slack;
    });
}

} // namespace

const std::array<LeafMapKey, 4> &leaf_map_keys()
{
    static const std::array<LeafMapKey, 4> keys = {{
        {"mesh.pigment_map", &Scene::pigment_map,
         "factor on the mesh's absorbers in [0, 2]: EXR holds it, PNG half of it; PNG levels count "
         "as they are, no sRGB curve"},
        {"mesh.thickness_map", &Scene::thickness_map,
         "factor on its thickness in [0.5, 2]: EXR holds it, PNG the v of 0.5 * 4^v"},
        {"mesh.normal_map", &Scene::normal_map,
         "normals in the tangent frame, red along u, green along v, blue out: EXR holds them, PNG "
         "(n + 1) / 2"},
        {"mesh.height_map", &Scene::height_map,
         "relief towards the upper side, times mesh.height_mm; in place of normals"},
    }};
    return keys;
}

std::string leaf_map_given(const Scene &scene)
{
    for (const LeafMapKey &key : leaf_map_keys()) {
        if (scene.*key.path != "none") {
            return key.name;
        }
    }
    return "";
}

Expected<leaf::Maps> leaf_maps(const Scene &scene, const leaf::Loaded &loaded)
{
    leaf::Maps maps;
    const std::string given = leaf_map_given(scene);
    if (given.empty()) {
        return Expected<leaf::Maps>(std::move(maps));
    }
    if (loaded.report.planar_uv) {
        return Error{given + ": " + scene.mesh + " has no uv to place a map by"};
    }
    if (scene.normal_map != "none" && scene.height_map != "none") {
        return Error{"mesh.normal_map and mesh.height_map both bend the surface; keep one"};
    }
    maps.repeat = beyond(loaded.mesh);
    std::vector<Layer> layers = {Layer(1, 1, 1), Layer(1, 1, 1), Layer(1, 1, 2)};
    layers[0].values[0] = layers[1].values[0] = 1.0f;
    for (std::size_t i = 0; i < leaf_map_keys().size(); i++) {
        const LeafMapKey &key = leaf_map_keys()[i];
        if (scene.*key.path == "none") {
            continue;
        }
        const Expected<Source> source = open(key, scene.*key.path, i != 2);
        if (!source) {
            return Error{source.error()};
        }
        Expected<Layer> read =
            i == 0   ? factors(*source, 0.0, 2.0, [](double v) { return 2.0 * v; })
            : i == 1 ? factors(*source, 0.5, 2.0, [](double v) { return 0.5 * std::pow(4.0, v); })
            : i == 2 ? normals(*source, scene.normal_green == "down")
                     : heights(*source, 1e-3 * scene.height_mm, growth(loaded.mesh), maps.repeat);
        if (!read) {
            return Error{read.error()};
        }
        layers[std::min<std::size_t>(i, 2)] = std::move(*read);
    }
    maps.width = maps.height = 1;
    for (const Layer &layer : layers) {
        maps.width = std::max(maps.width, layer.width);
        maps.height = std::max(maps.height, layer.height);
    }
    for (Layer &layer : layers) {
        if (layer.width != maps.width || layer.height != maps.height) {
            layer = resized(layer, maps.width, maps.height, maps.repeat);
        }
    }
    maps.pigment = std::move(layers[0].values);
    maps.thickness = std::move(layers[1].values);
    maps.slope = std::move(layers[2].values);
    return Expected<leaf::Maps>(std::move(maps));
}

} // namespace tsuya::scene

#include "scene/keys.h"
#include "scene/leaf_maps.h"
#include "scene/scene.h"
#include "scene/tiers.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

namespace tsuya::scene {

namespace {

std::string trimmed(const std::string &text)
{
    const char *const space = " \t\r\f\v";
    const std::size_t begin = text.find_first_not_of(space);
    if (begin == std::string::npos) {
        return "";
    }
    return text.substr(begin, text.find_last_not_of(space) - begin + 1);
}

const char *color_name(ColorBy by)
{
    switch (by) {
    case ColorBy::preset:
        return "color";
    case ColorBy::sigma_a:
        return "sigma_a";
    case ColorBy::melanin:
        return "eumelanin and pheomelanin";
    case ColorBy::albedo:
        return "albedo";
    case ColorBy::head_albedo:
        return "head_albedo";
    }
    return "";
}

bool gives_color(const std::string &name)
{
    return name == "color" || name == "sigma_a" || name == "eumelanin" || name == "pheomelanin" ||
           name == "albedo" || name == "head_albedo";
}

// Reads keys one by one and remembers which it has seen.
class Reader
{
  public:
    explicit Reader(const Scene &base) : scene(base)
    {
    }

    // Returns: what is wrong with a line, without its place; "" when nothing is.
    std::string take(const std::string &line)
    {
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos) {
            return "\"" + line + "\" is not key=value";
        }
        const std::string name = trimmed(line.substr(0, equals));
        const std::string value = trimmed(line.substr(equals + 1));
        Key key;
        if (!find_key(name, key)) {
            return "there is no key " + (name.empty() ? "\"\"" : name) +
                   "; tsuya scenes --help lists them";
        }
        if (!seen_.insert(name).second) {
            return name + " is given twice";
        }
        const ColorBy before = scene.color_by;
        const std::string wrong = key.set(scene, value);
        if (!wrong.empty()) {
            return name + " " + wrong + " but must be " + must_be(key.range);
        }
        tier_ = name == "tier" ? find_tier(value) : tier_;
        for (const std::string &word : tier_ ? tier_->words : std::vector<std::string>()) {
            const std::string own = word.substr(0, word.find('='));
            if (seen_.count(own)) {
                return own + " and tier both are given, but tier=" + tier_->name + " sets " + word +
                       "; keep one";
            }
        }
        if (gives_color(name)) {
            if (colored_ && before != scene.color_by) {
                return std::string(color_name(before)) + " and " + color_name(scene.color_by) +
                       " both give the colour; keep one";
            }
            colored_ = true;
        }
        const LeafBy by = leaf_by(name);
        if (by != LeafBy::nothing && by_ != LeafBy::nothing && by != by_) {
            return "R_top, R_bottom and T take the place of a leaf's name and contents; keep either";
        }
        by_ = by != LeafBy::nothing ? by : by_;
        return "";
    }

    // Returns: what is wrong with all lines together.
    std::string finish() const
    {
        if (tier_ && tier_->leaf != (scene.kind != "hair")) {
            return "tier=" + tier_->name + " shades " + (tier_->leaf ? "leaves" : "hair") +
                   " but kind is " + scene.kind + "; its tiers are " +
                   tier_names(scene.kind != "hair");
        }
        return "";
    }

    Scene scene;

  private:
    static std::string must_be(const std::string &range)
    {
        return range[0] == '[' ? "in " + range : range;
    }

    std::set<std::string> seen_;
    const Tier *tier_ = nullptr;
    bool colored_ = false;
    LeafBy by_ = LeafBy::nothing;
};

} // namespace

Expected<Scene> parse(const std::string &text, const std::string &name, const Scene &base)
{
    Reader reader(base);
    std::size_t begin = 0;
    for (int number = 1; begin < text.size(); number++) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        if (number == 1 && line.rfind("\xef\xbb\xbf", 0) == 0) {
            line.erase(0, 3);
        }
        line = trimmed(line.substr(0, line.find('#')));
        if (line.empty()) {
            continue;
        }
        const std::string wrong = reader.take(line);
        if (!wrong.empty()) {
            return Error{name + ", line " + std::to_string(number) + ": " + wrong};
        }
    }
    const std::string wrong = reader.finish();
    return wrong.empty() ? Expected<Scene>(std::move(reader.scene)) : Error{name + ": " + wrong};
}

Expected<Scene> override(const Scene &base, const std::vector<std::string> &words)
{
    Reader reader(base);
    for (std::size_t i = 0; i < words.size(); i++) {
        const std::string wrong = reader.take(words[i]);
        if (!wrong.empty()) {
            return Error{"argument " + std::to_string(i + 1) + ": " + wrong};
        }
    }
    const std::string wrong = reader.finish();
    return wrong.empty() ? Expected<Scene>(std::move(reader.scene)) : Error{wrong};
}

Expected<Scene> read(const std::string &path, const Scene &base)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return Error{path + " cannot be opened"};
    }
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    Expected<Scene> scene = parse(text, path, base);
    const std::size_t slash = path.rfind('/');
    if (!scene || slash == std::string::npos) {
        return scene;
    }
    const std::string folder = path.substr(0, slash + 1);
    if (scene->groom != base.groom && scene->groom.rfind("file:", 0) == 0 &&
        scene->groom[5] != '/') {
        scene->groom.insert(5, folder);
    }
    std::vector<std::string Scene::*> paths = {&Scene::mesh};
    for (const LeafMapKey &key : leaf_map_keys()) {
        paths.push_back(key.path);
    }
    for (std::string Scene::*const path : paths) {
        std::string &here = (*scene).*path;
        if (here != base.*path && here != "none" && here[0] != '/') {
            here.insert(0, folder);
        }
    }
    return scene;
}

std::string write(const Scene &scene)
{
    const Scene plain;
    std::string text;
    const auto add = [&](const Key &key, const std::string &usual) {
        const std::string value = key.get(scene);
        if (!value.empty() && value != usual) {
            text += key.name + "=" + value + "\n";
        }
    };
    for (const Key &key : keys()) {
        // Of a pigment pair, one at its default must still say where the colour comes from.
        const bool always = gives_color(key.name) && scene.color_by != plain.color_by;
        add(key, always ? "" : key.get(plain));
    }
    for (const auto &light : scene.lights) {
        for (const Key &key : light_keys(light.first)) {
            add(key, "");
        }
    }
    return text;
}

std::string grammar()
{
    const Scene plain;
    std::vector<Key> all = keys();
    for (Key key : light_keys(0)) {
        key.name.replace(0, 6, "lightN");
        all.push_back(key);
    }
    std::string text;
    for (const char *const heading : {"groom", "hair that is grown", "leaf that is grown",
                                      "tree that is grown", "material", "light", "camera",
                                      "picture"}) {
        text += std::string("\n") + heading + ":\n";
        for (const Key &key : all) {
            if (key.group != heading) {
                continue;
            }
            const std::string usual = key.get(plain);
            text += "  " + key.name + "=" + key.range +
                    (usual.empty() ? "" : ", default " + usual) + "\n      " + key.help + "\n";
        }
    }
    return text;
}

bool SceneLight::operator==(const SceneLight &o) const
{
    return direction == o.direction && color == o.color && intensity == o.intensity &&
           kind == o.kind && angle == o.angle && position == o.position && facing == o.facing &&
           width == o.width && height == o.height && sides == o.sides;
}

bool Scene::operator==(const Scene &other) const
{
    for (const Key &key : keys()) {
        if (key.get(*this) != key.get(other)) {
            return false;
        }
    }
    return color_by == other.color_by && lights == other.lights;
}

} // namespace tsuya::scene

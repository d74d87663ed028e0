// Leaves in words: the layers of a leaf's material from a name, from contents, or from faces.
#ifndef TSUYA_SCENE_LEAF_MATERIAL_H
#define TSUYA_SCENE_LEAF_MATERIAL_H

#include <glm/vec3.hpp>

#include <tsuya/leaf.h>

#include <map>
#include <string>
#include <vector>

namespace tsuya::scene {

// A key that says what a leaf is. Contents may be given over a name's; they and the faces exclude
// each other.
struct LeafKey {
    const char *name; // "chlorophyll"
    bool face;        // R_top, R_bottom, T; three numbers
    double low, high;
    const char *help;
};
// Contents, then faces. `leaf`, the name, is not among them.
const std::vector<LeafKey> &leaf_keys();

std::vector<std::string> leaf_names();

// What words said.
struct LeafWords {
    std::string name;                         // "": none
    std::map<std::string, glm::dvec3> values; // by key; contents in .x

    bool empty() const
    {
        return name.empty() && values.empty();
    }
    bool operator==(const LeafWords &other) const;
};

// How a key says what a leaf is: the second replaces the first.
enum class LeafBy { nothing, contents, faces };
LeafBy leaf_by(const std::string &key);

// True for a model whose material has a leaf's layers.
bool has_leaf(const tsu_model *model);

// Set the layers in a model's typed parameters. Where no name and no contents are given, R_top and
// T are needed; R_bottom is 1.4 R_top by default. Returns: "" or what is wrong; an error of the
// library is in the context's log, and "" is returned with `status`.
std::string set_leaf(tsu_context *context, const tsu_model *model, const LeafWords &leaf,
                     void *params, tsu_status &status);

} // namespace tsuya::scene

#endif

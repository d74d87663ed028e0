// The table of keys that the scene parser, writer and grammar share.
#ifndef TSUYA_SCENE_KEYS_H
#define TSUYA_SCENE_KEYS_H

#include "scene/scene.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tsuya::scene {

// One key, or a family of them: "lightN.color" and model parameters are made on the spot.
struct Key {
    std::string name;
    std::string group; // heading in the grammar
    std::string range; // form and range: "[0, 1]", "x,y,z in [-10, 10]", "grid, none"
    std::string help;
    // Read a value; returns "" or what is wrong with it ("is 7", "is not a number").
    std::function<std::string(Scene &, const std::string &)> set;
    // The value as text; "" when the scene does not give it.
    std::function<std::string(const Scene &)> get;
};

// Every fixed key, then those of the models' parameters, in the order of the grammar.
const std::vector<Key> &keys();

// The key of this name, lightN.* included. Returns: false when there is none.
bool find_key(const std::string &name, Key &key);

// Append what leaves and trees are grown from.
void add_leaf_keys(std::vector<Key> &keys);
// And what their material is made of.
void add_leaf_material_keys(std::vector<Key> &keys);

// A key whose value is `map`'s of the part of its name behind the last dot, when it was given.
Key map_key(const char *group, const std::string &name,
            std::map<std::string, double> Scene::*map, double low, double high, bool whole,
            const std::string &help);

// Append model, colour, and one key for each parameter of any model.
void add_material_keys(std::vector<Key> &keys);

// The keys of light `index`.
std::vector<Key> light_keys(int index);
Key environment_key();

// Numbers without a locale: the shortest text that reads back to the same value.
std::string number_text(double value);
// Returns: false when `text` is not one number as a whole.
bool number_value(const std::string &text, double &value);

// Building blocks of keys: a member with a range.
Key number_key(const char *group, const char *name, double Scene::*member, double low,
               double high, const char *help);
Key integer_key(const char *group, const char *name, int Scene::*member, int low, int high,
                const char *help);
Key triple_key(const char *group, const char *name, glm::dvec3 Scene::*member, double low,
               double high, const char *help);
Key word_key(const char *group, const char *name, std::string Scene::*member,
             const std::vector<std::string> &words, const char *help);

// What is wrong with reading `text` as numbers in [low, high], one or three; "" when nothing is.
std::string read_number(const std::string &text, double low, double high, double &value);
std::string read_triple(const std::string &text, double low, double high, glm::dvec3 &value);
std::string triple_text(const glm::dvec3 &value);

// "[0, 1]".
std::string range_text(double low, double high);

} // namespace tsuya::scene

#endif

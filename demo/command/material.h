// Typed parameters of any model from words such as `eta=1.5`, `beta_R_deg=8`, `color=brown`.
#ifndef TSUYA_DEMO_COMMAND_MATERIAL_H
#define TSUYA_DEMO_COMMAND_MATERIAL_H

#include "host.h"

#include "../scene/leaf_material.h"

#include <tsuya/model.h>

#include <set>
#include <string>
#include <vector>

namespace tsuya::command {

// The model's typed parameters, filled with defaults and then word by word.
//
// Keys are parameter names. Angles take radians under their name and degrees under their name with
// "_deg". A colour takes three numbers, r,g,b, or one for all. Where the model has an absorption
// sigma_a, it can also be said by `eumelanin` and `pheomelanin`, by `color` (a preset's name), by
// `albedo` (of one fibre; r,g,b or one) or by `head_albedo` (of thick hair). Every key may be given
// once, and absorption in one way. The layers of a leaf can also be said by `leaf` (a name), by its
// contents (`chlorophyll`, ...) over that, or by `R_top`, `R_bottom` and `T`.
class Material
{
  public:
    // Errors: the model's init failed.
    Material(Host &host, const tsu_model *model);

    // Takes one word. Errors: no "=", unknown key (with the nearest), not a number, wrong count,
    // out of range (with the range in the unit of the key), said twice.
    bool set(const std::string &word, std::string &error);

    // Turns pigments, preset or albedos into sigma_a, a leaf into layers, and lets the library
    // check the whole.
    bool finish(std::string &error);

    // Asks for the tables of a variant. Errors: the model has none of that name.
    bool vary(const std::string &variant, std::string &error);

    void *params();
    // Every key that set() takes.
    std::vector<std::string> keys() const;

  private:
    bool set_color(const std::string &key, const std::string &text, std::string &error);
    bool set_leaf(const std::string &key, const std::string &text, std::string &error);
    bool set_parameter(const tsu_parameter_info &parameter, const std::string &key,
                       const std::string &text, double scale, std::string &error);
    void store(const tsu_parameter_info &parameter, const std::vector<double> &values);
    const tsu_parameter_info *find(const std::string &name) const;

    Host &host_;
    const tsu_model *model_;
    std::vector<double> storage_; // doubles for their alignment
    std::vector<tsu_parameter_info> parameters_;
    std::set<std::string> given_;
    double eumelanin_ = 0, pheomelanin_ = 0;
    std::vector<double> albedo_; // of what the key given says
    std::string preset_;
    scene::LeafWords leaf_;
};

// Numbers between commas. Errors: an empty or unreadable one.
bool parse_numbers(const std::string &text, std::vector<double> &values, std::string &error);

// Names of the natural hair colours.
std::vector<std::string> preset_names();

} // namespace tsuya::command

#endif

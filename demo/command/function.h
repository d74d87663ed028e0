// What a model can be asked, as columns of a table.
#ifndef TSUYA_DEMO_COMMAND_FUNCTION_H
#define TSUYA_DEMO_COMMAND_FUNCTION_H

#include <tsuya/hair_shadow.h>
#include <tsuya/model.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::command {

std::string model_name(const tsu_model *model);
std::vector<std::string> model_names();
// Techniques of self-shadow: they have text and a place in the list of models, and no function.
std::vector<std::string> technique_names();
// The model, or NULL with an error that names the nearest one and all.
const tsu_model *find_model(const std::string &name, std::string &error);

// One input or output. Angles are columns in degrees with "_deg" after the name; everything else
// keeps the name and unit of the API.
struct Value {
    std::string name;   // of the API, "theta_i"
    std::string unit, help;
    std::string column; // "theta_i_deg"
    double scale = 1;   // API value of 1 in the column: pi/180 or 1
    bool material = false;
    double minimum = 0, maximum = 0, default_value = 0; // in units of the API
    std::vector<std::string> words; // names of 0, 1, 2 ...; empty: a number
    std::size_t words_on_tables = 0; // those that the tables and the shader know
};

struct Function {
    const tsu_model *model = nullptr;
    std::uint32_t index = 0;
    std::string name;
    bool reference_only = false; // neither in the tables nor in the shader
    std::vector<Value> inputs, outputs;
};

// Every function of every model, by name, each once.
std::vector<std::string> function_names();

// Function `name` of `model`, or, when `model` is empty, of the first model that has it. A variant
// V of a function F is the function F-V. Errors: no such model, function or variant; the text lists
// what there is.
bool find_function(const std::string &name, const std::string &model, const std::string &variant,
                   Function &out, std::string &error);

// Columns that `function` reads, with range and default, and those that it adds, one a line.
std::string columns_text(const Function &function);

// Turns a column's number into the API's unit and checks it: finite and inside [minimum, maximum].
// "inf" is taken where the maximum stands for it (TSU_VALUE_INFINITE).
// A value outside by at most 1e-9 of the limit is taken as the limit, because degrees to radians
// rounds.
// Errors: "91 is outside [-90, 90]" in the column's unit.
bool to_api(const Value &value, double number, double &out, std::string &error);

// The number of a word of `value`, which has words. Errors: no such word; the text lists them.
bool word_to_api(const Value &value, const std::string &word, double &out, std::string &error);

} // namespace tsuya::command

#endif

// `tsuya eval`: a function of a model as a filter on CSV.
#include "arguments.h"
#include "commands.h"
#include "csv.h"
#include "evaluate.h"
#include "number.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace {

using namespace tsuya::command;

Manual manual()
{
    return {
        "eval",
        "FUNCTION --on reference|cpu|gpu [--model MODEL] [--variant NAME] [FILE|-]",
        "Reads CSV from FILE or standard input, evaluates a function of a model on every row,\n"
        "and writes the same CSV with result columns appended.\n"
        "\n"
        "Lines that begin with # pass through. The first other line names the columns, in any\n"
        "order: the function's inputs, angles in degrees with _deg after the name. Inputs\n"
        "without a column take their default; other columns are copied unchanged. A row that\n"
        "cannot be read or is out of range is an error that names line and column: exit code 2\n"
        "and no output at all. Numbers do not depend on the locale; results have 9 digits for\n"
        "gpu, 17 otherwise.\n"
        "\n"
        "Functions: " +
            joined(function_names()) +
            ".\n"
            "tsuya eval FUNCTION --help lists its columns, tsuya models --json those of all.\n",
        {{"--on", "WHERE",
          "reference: the model in double precision\n"
          "cpu: the baked tables, sampled in C as the shader does\n"
          "gpu: the GLSL that tsuya glsl prints, without a window"},
         {"--model", "MODEL", "default: the first model that has the function"},
         {"--variant", "NAME", "a variant of the function"}},
        "  tsuya eval hair --on gpu rows.csv > values.csv\n"
        "  printf 'theta_i_deg,phi_deg\\n20,180\\n' | tsuya eval hair --on reference\n"
        "  tsuya eval hair --model kajiya_kay --on cpu - < rows.csv\n"};
}

bool read_all(const std::string &path, std::string &text, std::string &error)
{
    std::FILE *const file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
    bool good = file != nullptr;
    for (std::size_t size = 1; good && size > 0;) {
        const std::size_t before = text.size();
        text.resize(before + 65536);
        size = std::fread(&text[before], 1, 65536, file);
        text.resize(before + size);
        good = !std::ferror(file);
    }
    if (!good) {
        error = "cannot read " + path + ": " + std::strerror(errno) + ".";
    }
    if (file && file != stdin) {
        std::fclose(file);
    }
    return good;
}

// Tells about a column that looks like an input in the wrong unit: it would be copied, and the
// input would quietly take its default.
void warn_of_units(const Csv &csv, const Function &function)
{
    for (const Value &value : function.inputs) {
        const std::string other = value.column == value.name ? value.name + "_deg" : value.name;
        if (csv.column(other) >= 0 && csv.column(value.column) < 0) {
            complain("eval",
                     "warning: column " + other + " is only copied; the input is " + value.column +
                         ".",
                     exit_ok);
        }
    }
}

bool read_rows(const Csv &csv, Question &question, bool on_reference, std::string &error)
{
    const std::vector<Value> &inputs = question.function.inputs;
    std::vector<int> columns;
    for (const Value &value : inputs) {
        columns.push_back(csv.column(value.column));
    }
    question.rows = csv.rows();
    question.in.resize(question.rows * inputs.size());
    std::vector<std::string_view> cells;
    for (std::size_t row = 0; row < question.rows; row++) {
        csv.cells(row, cells);
        for (std::size_t i = 0; i < inputs.size(); i++) {
            double &value = question.in[row * inputs.size() + i];
            value = inputs[i].default_value;
            if (columns[i] < 0) {
                continue;
            }
            const std::string_view cell = cells[std::size_t(columns[i])];
            double number;
            std::string why;
            if (!inputs[i].words.empty()) {
                if (word_to_api(inputs[i], std::string(cell), value, why) &&
                    (on_reference || value < double(inputs[i].words_on_tables))) {
                    continue;
                }
                why = why.empty() ? std::string(cell) + " is known to the reference alone" : why;
            } else if (!parse_number(cell, number)) {
                why = cell.empty() ? "the cell is empty"
                                   : "\"" + std::string(cell) + "\" is not a number";
            } else if (to_api(inputs[i], number, value, why)) {
                continue;
            }
            error = "line " + std::to_string(csv.line(row)) + ", column " + inputs[i].column +
                    ": " + why;
            return false;
        }
    }
    return true;
}

bool evaluate(const Question &question, const std::string &on, std::vector<double> &out,
              Failure &failure)
{
    if (on == "reference") {
        return evaluate_reference(question, out, failure);
    }
    return evaluate_tables(question, on == "gpu" ? Where::gpu : Where::tables, out, failure);
}

int eval(const Arguments &arguments, Question &question)
{
    const std::string on = arguments.get("--on");
    const std::string path =
        arguments.positional().size() > 1 ? arguments.positional()[1] : std::string("-");
    std::string text, error;
    Csv csv;
    if (!read_all(path, text, error) || !csv.read(std::move(text), error)) {
        return complain("eval", error, exit_bad_input);
    }
    std::vector<std::string> names;
    for (const Value &value : question.function.outputs) {
        names.push_back(value.column);
        if (csv.column(value.column) >= 0) {
            return complain("eval",
                            "column " + value.column +
                                " of the input has the name of a result; rename it.",
                            exit_bad_input);
        }
    }
    warn_of_units(csv, question.function);
    if (!read_rows(csv, question, on == "reference", error)) {
        return complain("eval", error, exit_bad_input);
    }
    std::vector<double> out;
    Failure failure;
    if (question.rows && !evaluate(question, on, out, failure)) {
        const bool row = failure.row != Failure::no_row;
        return complain("eval",
                        (row ? "line " + std::to_string(csv.line(failure.row)) + ": " : "") +
                            failure.text,
                        row ? exit_bad_input : exit_failure);
    }
    const std::size_t outputs = names.size();
    for (std::size_t i = 0; i < out.size(); i++) {
        out[i] /= question.function.outputs[i % outputs].scale;
    }
    return print("eval", csv.write(names, out, on == "gpu" ? 9 : 17));
}

} // namespace

int command_eval(int argc, char **argv)
{
    Arguments arguments;
    std::string error;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain("eval", error, exit_bad_input);
    }
    const std::vector<std::string> &words = arguments.positional();
    if (arguments.help() && words.empty()) {
        return print("eval", help_text(manual()));
    }
    const std::vector<std::string> places = {"reference", "cpu", "gpu"};
    const std::string on = arguments.get("--on");
    Question question;
    if (arguments.help()) {
        return find_function(words[0], arguments.get("--model"), arguments.get("--variant"),
                             question.function, error)
                   ? print("eval", columns_text(question.function))
                   : complain("eval", error, exit_bad_input);
    }
    if (words.empty() || words.size() > 2) {
        error = words.empty()
                    ? "no function is given; the functions are " + joined(function_names()) + "."
                    : "\"" + words[2] + "\" is one argument too many.";
        return complain("eval", error, exit_bad_input);
    }
    if (std::find(places.begin(), places.end(), on) == places.end()) {
        error = (on.empty() ? "--on is missing"
                            : "--on " + on + " is unknown" + suggestion(on, places)) +
                "; it takes " + joined(places) + ".";
        return complain("eval", error, exit_bad_input);
    }
    if (!find_function(words[0], arguments.get("--model"), arguments.get("--variant"),
                       question.function, error)) {
        return complain("eval", error, exit_bad_input);
    }
    if (question.function.reference_only && on != "reference") {
        error = "function " + question.function.name + " has a reference only; use --on reference.";
        return complain("eval", error, exit_bad_input);
    }
    return eval(arguments, question);
}

// Options and arguments of a subcommand, its help text, and "did you mean".
//
// One table of options serves the parser and the help, so neither can forget one.
#ifndef TSUYA_DEMO_COMMAND_ARGUMENTS_H
#define TSUYA_DEMO_COMMAND_ARGUMENTS_H

#include <map>
#include <string>
#include <vector>

namespace tsuya::command {

// `name` is "--target" or "-o"; `value` is what the help calls its value, empty for a flag.
struct Option {
    std::string name;
    std::string value;
    std::string help;
};

// What `tsuya NAME --help` prints. Every manual has --help without listing it.
struct Manual {
    std::string name;
    std::string usage; // after "tsuya NAME "
    std::string text;  // paragraphs, wrapped by hand
    std::vector<Option> options;
    std::string examples; // one a line
};

class Arguments
{
  public:
    // Splits argv[1..]. `--name value`, `--name=value`, `-o value`; `--` ends the options; a lone
    // "-" is an argument.
    // Errors: unknown option (with the nearest one), missing or unwanted value, option given twice.
    bool parse(const Manual &manual, int argc, char **argv, std::string &error);

    bool help() const; // --help or -h is among the options
    bool has(const std::string &option) const;
    std::string get(const std::string &option) const; // empty when absent
    const std::vector<std::string> &positional() const;

  private:
    bool take(const Manual &manual, const std::string &word, const char *next, bool &used,
              std::string &error);

    std::map<std::string, std::string> options_;
    std::vector<std::string> positional_;
};

// The whole help text of a subcommand.
std::string help_text(const Manual &manual);

// " (did you mean NAME?)" for the candidate nearest to `word`, or "" when none is near.
std::string suggestion(const std::string &word, const std::vector<std::string> &candidates);

// "a, b, c".
std::string joined(const std::vector<std::string> &words);

// Prints "tsuya COMMAND: text" as one line on standard error and returns `code`.
int complain(const std::string &command, const std::string &text, int code);

// Writes all of `text` to standard output; returns exit_ok, or exit_failure with a complaint when
// the disk is full or the reader is gone.
int print(const std::string &command, const std::string &text);

} // namespace tsuya::command

#endif

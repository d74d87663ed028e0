#include "arguments.h"

#include "commands.h"

#include <algorithm>
#include <cstdio>

namespace tsuya::command {

namespace {

// Edits (insert, remove, replace, exchange two neighbours) that turn one word into the other.
std::size_t distance(const std::string &a, const std::string &b)
{
    const std::size_t width = b.size() + 1;
    std::vector<std::size_t> d((a.size() + 1) * width);
    for (std::size_t i = 0; i <= a.size(); i++) {
        for (std::size_t j = 0; j <= b.size(); j++) {
            std::size_t &here = d[i * width + j];
            if (i == 0 || j == 0) {
                here = i + j;
                continue;
            }
            const std::size_t *const above = &d[(i - 1) * width + j];
            here = std::min(
                {above[0] + 1, d[i * width + j - 1] + 1, above[-1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                here = std::min(here, d[(i - 2) * width + j - 2] + 1);
            }
        }
    }
    return d.back();
}

} // namespace

std::string suggestion(const std::string &word, const std::vector<std::string> &candidates)
{
    std::string best;
    std::size_t least = std::max<std::size_t>(word.size() / 2, 1) + 1;
    for (const std::string &candidate : candidates) {
        const bool begins = word.size() > 1 && candidate.compare(0, word.size(), word) == 0;
        const std::size_t edits = begins ? 1 : distance(word, candidate);
        if (edits < least) {
            least = edits;
            best = candidate;
        }
    }
    return best.empty() ? "" : " (did you mean " + best + "?)";
}

std::string joined(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

int complain(const std::string &command, const std::string &text, int code)
{
    const std::string line = "tsuya" + (command.empty() ? "" : " " + command) + ": " + text + "\n";
    std::fputs(line.c_str(), stderr);
    return code;
}

int print(const std::string &command, const std::string &text)
{
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) {
        return complain(command, "cannot write to standard output.", exit_failure);
    }
    return exit_ok;
}

std::string help_text(const Manual &manual)
{
    std::string text = "usage: tsuya " + manual.name;
    text +=
        (manual.usage.empty() ? "" : " ") + manual.usage + "\n\n" + manual.text + "\noptions:\n";
    std::vector<Option> options = manual.options;
    options.push_back({"--help", "", "print this text"});
    for (const Option &option : options) {
        std::string left = "  " + option.name + (option.value.empty() ? "" : " " + option.value);
        left.resize(std::max<std::size_t>(left.size() + 2, 24), ' ');
        std::string help = option.help;
        for (std::size_t at = 0; (at = help.find('\n', at)) != std::string::npos; at++) {
            help.insert(at + 1, 24, ' ');
        }
        text += left + help + "\n";
    }
    return manual.examples.empty() ? text : text + "\nexamples:\n" + manual.examples;
}

bool Arguments::take(const Manual &manual, const std::string &word, const char *next, bool &used,
                     std::string &error)
{
    const std::size_t equals = word.compare(0, 2, "--") == 0 ? word.find('=') : std::string::npos;
    const std::string name = word.substr(0, equals);
    const bool attached = equals != std::string::npos;
    used = false;
    std::vector<std::string> names = {"--help"};
    const Option *option = nullptr;
    for (const Option &candidate : manual.options) {
        names.push_back(candidate.name);
        option = candidate.name == name ? &candidate : option;
    }
    if (!option) {
        error = "unknown option " + name + suggestion(name, names) + "; the options are " +
                joined(names) + ".";
        return false;
    }
    if (has(name)) {
        error = "option " + name + " is given twice.";
        return false;
    }
    if (option->value.empty() ? attached : !attached && !next) {
        error =
            "option " + name +
            (option->value.empty() ? " takes no value." : " needs a value, " + option->value + ".");
        return false;
    }
    used = !option->value.empty() && !attached;
    options_[name] = used ? next : attached ? word.substr(equals + 1) : "";
    return true;
}

bool Arguments::parse(const Manual &manual, int argc, char **argv, std::string &error)
{
    bool options = true;
    for (int i = 1; i < argc; i++) {
        const std::string word = argv[i];
        if (!options || word.size() < 2 || word[0] != '-') {
            positional_.push_back(word);
        } else if (word == "--") {
            options = false;
        } else if (word == "--help" || word == "-h") {
            options_["--help"] = "";
        } else {
            bool used = false;
            if (!take(manual, word, i + 1 < argc ? argv[i + 1] : nullptr, used, error)) {
                return help(); // who asks for help gets it
            }
            i += used;
        }
    }
    return true;
}

bool Arguments::help() const
{
    return has("--help");
}

bool Arguments::has(const std::string &option) const
{
    return options_.count(option) != 0;
}

std::string Arguments::get(const std::string &option) const
{
    const auto found = options_.find(option);
    return found == options_.end() ? "" : found->second;
}

const std::vector<std::string> &Arguments::positional() const
{
    return positional_;
}

} // namespace tsuya::command

#include "number.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace tsuya::command {

std::string_view trimmed(std::string_view text)
{
    const std::size_t from = text.find_first_not_of(" \t");
    if (from == std::string_view::npos) {
        return {};
    }
    return text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

bool parse_number(std::string_view text, double &value)
{
    text = trimmed(text);
    const bool plus = !text.empty() && text[0] == '+';
    text.remove_prefix(plus);
    if (text.empty() || (plus && (text[0] == '-' || text[0] == '+'))) {
        return false;
    }
    const char *const end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, value);
    if (result.ec == std::errc::invalid_argument || result.ptr != end) {
        return false;
    }
    if (result.ec == std::errc::result_out_of_range) {
        // from_chars tells no overflow from underflow; a negative exponent does, and so does a
        // number that starts with 0.
        const std::size_t exponent = text.find_first_of("eE");
        const bool negative = text[0] == '-';
        const bool small = exponent != std::string_view::npos
                               ? text[exponent + 1] == '-'
                               : text[negative] == '0' || text[negative] == '.';
        value = small ? 0.0 : std::numeric_limits<double>::infinity();
        value = negative ? -value : value;
    }
    return true;
}

void append_number(std::string &text, double value, int digits)
{
    if (std::isnan(value)) {
        text += "nan";
        return;
    }
    char buffer[64];
    const std::to_chars_result result =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
    text.append(buffer, result.ptr);
}

std::string number_text(double value, int digits)
{
    std::string text;
    append_number(text, value, digits);
    return text;
}

} // namespace tsuya::command

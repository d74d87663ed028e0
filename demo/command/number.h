// Numbers as text, the same under every locale.
#ifndef TSUYA_DEMO_COMMAND_NUMBER_H
#define TSUYA_DEMO_COMMAND_NUMBER_H

#include <string>
#include <string_view>

namespace tsuya::command {

constexpr double degree = 0.01745329251994329577;

// Without the spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

// Reads one decimal number with spaces around: 1, +1e-3, .5, nan, inf, -inf, infinity in any case.
// Too large is infinite, too small is 0. False when anything else is in the text.
bool parse_number(std::string_view text, double &value);

// Appends `value` as printf's %.<digits>g would in the C locale; nan without a sign, inf, -inf.
void append_number(std::string &text, double value, int digits);
std::string number_text(double value, int digits);

} // namespace tsuya::command

#endif

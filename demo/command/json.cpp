#include "json.h"

#include <charconv>
#include <cmath>

namespace tsuya::command {

void Json::begin_value()
{
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (!closers_.empty()) {
        text_ += first_ ? "\n" : ",\n";
        text_.append(2 * closers_.size(), ' ');
    }
    first_ = false;
}

void Json::quote(std::string_view text)
{
    static const char digits[] = "0123456789abcdef";
    text_ += '"';
    for (const char c : text) {
        const unsigned char byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += c;
        } else if (byte < 0x20 || byte == 0x7f) {
            text_ += "\\u00";
            text_ += digits[byte >> 4];
            text_ += digits[byte & 15];
        } else {
            text_ += c;
        }
    }
    text_ += '"';
}

Json &Json::open(char bracket)
{
    begin_value();
    text_ += bracket;
    closers_.push_back(bracket == '{' ? '}' : ']');
    first_ = true;
    return *this;
}

Json &Json::close()
{
    const char closer = closers_.back();
    closers_.pop_back();
    if (!first_) {
        text_ += '\n';
        text_.append(2 * closers_.size(), ' ');
    }
    text_ += closer;
    text_ += closers_.empty() ? "\n" : "";
    first_ = false;
    return *this;
}

Json &Json::key(std::string_view name)
{
    begin_value();
    quote(name);
    text_ += ": ";
    after_key_ = true;
    return *this;
}

Json &Json::value(std::string_view text)
{
    begin_value();
    quote(text);
    return *this;
}

Json &Json::value(const char *text)
{
    if (text) {
        return value(std::string_view(text));
    }
    begin_value();
    text_ += "null";
    return *this;
}

Json &Json::value(double number)
{
    begin_value();
    if (!std::isfinite(number)) {
        text_ += "null";
        return *this;
    }
    char buffer[64];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
    return *this;
}

Json &Json::value(std::uint64_t number)
{
    begin_value();
    text_ += std::to_string(number);
    return *this;
}

Json &Json::value(bool truth)
{
    begin_value();
    text_ += truth ? "true" : "false";
    return *this;
}

const std::string &Json::text() const
{
    return text_;
}

} // namespace tsuya::command

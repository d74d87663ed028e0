// JSON text, written piece by piece with two spaces a level.
//
// The caller opens and closes objects and arrays in order; inside an object every value is preceded
// by its key. Commas and line ends are put here.
#ifndef TSUYA_DEMO_COMMAND_JSON_H
#define TSUYA_DEMO_COMMAND_JSON_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tsuya::command {

class Json
{
  public:
    Json &open(char bracket); // '{' or '['
    Json &close();
    Json &key(std::string_view name);

    Json &value(std::string_view text);
    Json &value(const char *text); // NULL is null
    // The shortest text that reads back as the same double. JSON has no infinity and no NaN:
    // they become null.
    Json &value(double number);
    Json &value(std::uint64_t number);
    Json &value(bool truth);

    template <class T> Json &field(std::string_view name, T what)
    {
        return key(name).value(what);
    }

    const std::string &text() const;

  private:
    void begin_value();
    void quote(std::string_view text);

    std::string text_;
    std::vector<char> closers_;
    bool first_ = true;
    bool after_key_ = false;
};

} // namespace tsuya::command

#endif

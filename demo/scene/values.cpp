#include "scene/keys.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tsuya::scene {

std::string number_text(double value)
{
    char text[64];
    // Plain digits where they are short: 100000, not 1e+05.
    const double size = std::abs(value);
    const bool plain = value == 0.0 || (size >= 1e-4 && size < 1e12);
    const std::to_chars_result end =
        std::to_chars(text, text + sizeof text, value,
                      plain ? std::chars_format::fixed : std::chars_format::scientific);
    return {text, end.ptr};
}

bool number_value(const std::string &text, double &value)
{
    const char *end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
}

std::string range_text(double low, double high)
{
    return "[" + number_text(low) + ", " + number_text(high) + "]";
}

std::string read_number(const std::string &text, double low, double high, double &value)
{
    double read = 0.0;
    if (!number_value(text, read)) {
        return "is \"" + text + "\", which is not a number";
    }
    if (!std::isfinite(read)) {
        return "is not finite";
    }
    if (read < low || read > high) {
        return "is " + number_text(read);
    }
    value = read;
    return "";
}

std::string read_triple(const std::string &text, double low, double high, glm::dvec3 &value)
{
    glm::dvec3 read{0.0};
    std::size_t begin = 0;
    for (int i = 0; i < 3; i++) {
        const std::size_t comma = text.find(',', begin);
        if ((comma == std::string::npos) != (i == 2)) {
            return "is \"" + text + "\", which is not three numbers with commas between";
        }
        const std::string wrong = read_number(text.substr(begin, comma - begin), low, high,
                                              read[i]);
        if (!wrong.empty()) {
            return wrong;
        }
        begin = comma + 1;
    }
    value = read;
    return "";
}

std::string triple_text(const glm::dvec3 &value)
{
    return number_text(value.x) + "," + number_text(value.y) + "," + number_text(value.z);
}

Key number_key(const char *group, const char *name, double Scene::*member, double low,
               double high, const char *help)
{
    return {name, group, range_text(low, high), help,
            [=](Scene &scene, const std::string &text) {
                return read_number(text, low, high, scene.*member);
            },
            [=](const Scene &scene) { return number_text(scene.*member); }};
}

Key integer_key(const char *group, const char *name, int Scene::*member, int low, int high,
                const char *help)
{
    return {name, group, "whole, " + range_text(low, high), help,
            [=](Scene &scene, const std::string &text) {
                double value = 0.0;
                std::string wrong = read_number(text, low, high, value);
                if (wrong.empty() && value != std::floor(value)) {
                    wrong = "is " + number_text(value);
                }
                if (wrong.empty()) {
                    scene.*member = int(value);
                }
                return wrong;
            },
            [=](const Scene &scene) { return number_text(scene.*member); }};
}

Key map_key(const char *group, const std::string &name,
            std::map<std::string, double> Scene::*map, double low, double high, bool whole,
            const std::string &help)
{
    const std::string field = name.substr(name.rfind('.') + 1);
    return {name, group, (whole ? "whole, " : "") + range_text(low, high), help,
            [=](Scene &scene, const std::string &text) {
                double value = 0.0;
                std::string wrong = read_number(text, low, high, value);
                if (wrong.empty() && whole && value != std::floor(value)) {
                    wrong = "is " + number_text(value);
                }
                if (wrong.empty()) {
                    (scene.*map)[field] = value;
                }
                return wrong;
            },
            [=](const Scene &scene) {
                const auto found = (scene.*map).find(field);
                return found == (scene.*map).end() ? "" : number_text(found->second);
            }};
}

Key triple_key(const char *group, const char *name, glm::dvec3 Scene::*member, double low,
               double high, const char *help)
{
    return {name, group, "a,b,c each in " + range_text(low, high), help,
            [=](Scene &scene, const std::string &text) {
                return read_triple(text, low, high, scene.*member);
            },
            [=](const Scene &scene) { return triple_text(scene.*member); }};
}

Key word_key(const char *group, const char *name, std::string Scene::*member,
             const std::vector<std::string> &words, const char *help)
{
    std::string range;
    for (const std::string &word : words) {
        range += (range.empty() ? "" : ", ") + word;
    }
    return {name, group, range, help,
            [=](Scene &scene, const std::string &text) -> std::string {
                if (std::find(words.begin(), words.end(), text) == words.end()) {
                    return "is \"" + text + "\"";
                }
                scene.*member = text;
                return "";
            },
            [=](const Scene &scene) { return scene.*member; }};
}

} // namespace tsuya::scene

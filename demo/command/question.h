// What `tsuya choose` asks the library.
#ifndef TSUYA_DEMO_COMMAND_QUESTION_H
#define TSUYA_DEMO_COMMAND_QUESTION_H

#include "arguments.h"
#include "host.h"

#include "groom/expected.h"

#include <tsuya/choose.h>

#include <string>
#include <utility>
#include <vector>

namespace tsuya::command {

// A name of the description's and its value, for the print.
using Traits = std::vector<std::pair<std::string, std::vector<double>>>;

struct Question {
    tsu_choose_desc desc;
    Traits traits;
    std::string said; // about a groom from a file
    std::string gpu = "navi21";
};

// Read scene, wish and host, and derive the scene's traits.
// Errors: no scene; a word out of its range, or twice; those of the scene's keys, files and
// colours.
groom::Expected<Question> question_of(const Host &host, const Arguments &arguments);

} // namespace tsuya::command

#endif

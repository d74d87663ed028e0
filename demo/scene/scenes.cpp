// `tsuya scenes`: the gallery, and the grammar of scene files.

#include "command/arguments.h"
#include "command/commands.h"
#include "scene/gallery.h"

#include <algorithm>
#include <string>
#include <vector>

int command_scenes(int argc, char **argv)
{
    using namespace tsuya;
    const command::Manual manual = {
        "scenes",
        "[NAME] [key=value ...]",
        "List the scenes that tsuya render knows; with a NAME, or the path of a scene or groom\n"
        "file, print that scene as a scene file.\n\n"
        "A scene file is text, one key=value a line; # begins a comment. Each key at most once,\n"
        "and one way only to give the colour. A folder in the environment variable\n"
        "TSUYA_SCENES adds scenes of your own. Lengths are metres, angles degrees, colours\n"
        "linear Rec. 709; +y is up, +z out of the face, +x to the person's left.\n\n"
        "The light rigs are key (a key light and a rim), front, side and back. Their strengths\n"
        "against the dome are chosen so that a change of model keeps a picture's mean: a fibre\n"
        "scatters as much light in every model, but each model sends a single light's share\n"
        "another way, Marschner's most of it onwards.\n\n"
        "keys:\n" +
            scene::grammar(),
        {},
        "  tsuya scenes\n"
        "  tsuya scenes straight-brown camera.azimuth_deg=60 > mine.scene\n"};
    command::Arguments arguments;
    std::string error;
    if (!arguments.parse(manual, argc, argv, error)) {
        return command::complain("scenes", error, command::exit_bad_input);
    }
    if (arguments.help()) {
        return command::print("scenes", command::help_text(manual));
    }
    const std::vector<std::string> &words = arguments.positional();
    if (!words.empty()) {
        groom::Expected<scene::Scene> found = scene::find(words[0]);
        if (found) {
            found = scene::override(*found, {words.begin() + 1, words.end()});
        }
        return found ? command::print("scenes", scene::write(*found))
                     : command::complain("scenes", found.error() + ".", command::exit_bad_input);
    }
    const groom::Expected<std::vector<scene::Named>> all = scene::gallery();
    if (!all) {
        return command::complain("scenes", all.error() + ".", command::exit_bad_input);
    }
    std::string text;
    for (const scene::Named &named : *all) {
        std::string name = named.name;
        name.resize(std::max<std::size_t>(name.size() + 2, 24), ' ');
        text += name + named.scene.title + "\n";
    }
    return command::print("scenes", text);
}

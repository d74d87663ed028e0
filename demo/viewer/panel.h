// The panel of sliders: every control writes a key of the scene.
#ifndef TSUYA_VIEWER_PANEL_H
#define TSUYA_VIEWER_PANEL_H

#include "scene/scene.h"

#include <string>

namespace tsuya::viewer {

// What the panel asks for besides the scene.
struct Asked {
    bool grow = false;       // a key of the groom changed: hair has to be made again
    bool screenshot = false; // write `Panel::file`
    bool reload = false;     // read GLSL again
};

struct Panel {
    char file[256] = "tsuya.png";
    std::string message;    // last error or news, shown at the end
    double milliseconds = 0.0; // of the last drawn frame
    std::size_t strands = 0;

    // Show the panel for one frame and change `scene` by it.
    Asked show(scene::Scene &scene);
};

} // namespace tsuya::viewer

#endif

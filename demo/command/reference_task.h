// What `tsuya reference` is asked to do.
#ifndef TSUYA_DEMO_COMMAND_REFERENCE_TASK_H
#define TSUYA_DEMO_COMMAND_REFERENCE_TASK_H

#include "arguments.h"

#include "reference/render.h"
#include "scene/scene.h"

#include <string>

namespace tsuya::command {

struct Task {
    scene::Scene scene;
    std::string said; // about the scene, for the report
    std::string path; // of the picture
    reference::Work work;
    double error = 0.0; // share of the hair's luminance; 0: until all samples are taken
    bool resume = false;

    std::string state() const
    {
        return path + ".state";
    }
};

const Manual &reference_manual();

// Errors: no scene, a path that is no .exr, an option out of range, and those of the scene's keys.
groom::Expected<Task> reference_task(const Arguments &arguments);

} // namespace tsuya::command

#endif

// Private to `tsuya render`: what its two halves share.
#ifndef TSUYA_SCENE_RENDER_H
#define TSUYA_SCENE_RENDER_H

#include "scene/scene.h"

#include <chrono>
#include <string>

namespace tsuya::scene {

class Clock
{
  public:
    double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Exit codes of the command.
int render_complaint(const std::string &text, bool bad_input = true);

// A line that overwrites itself on a terminal; nothing elsewhere.
void render_progress(const std::string &text);

// The picture's file, numbered when there are several.
std::string render_path(const std::string &path, int number, int frames);

// Leaves and trees.
int render_surface(const Scene &scene, const std::string &path, int frames);

} // namespace tsuya::scene

#endif

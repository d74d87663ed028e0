// The scenes that come with the program.
#ifndef TSUYA_SCENE_GALLERY_H
#define TSUYA_SCENE_GALLERY_H

#include "scene/scene.h"

#include <string>
#include <vector>

namespace tsuya::scene {

// A scene file and its text.
struct Source {
    const char *name;
    const char *text;
};

// Files of demo/scenes as they were built in; ends with a NULL name.
extern const Source embedded_scenes[];

struct Named {
    std::string name; // file name without .scene
    Scene scene;
};

// All scenes by name: those built in, and those of the folder in the environment variable
// TSUYA_SCENES, which win over a built-in one of the same name.
// Errors: a scene file that does not parse.
Expected<std::vector<Named>> gallery();

// What a word on a command line means: the path of a groom file (.tfx, .hair, .data), of a leaf's
// mesh (.obj, .ply), of a scene file, or the name of a scene of the gallery, in this order. For a
// groom the scene around it is the default one without a head, for a mesh that of a leaf.
//
// Errors: nothing of the kind, with the names that there are; and as parse().
Expected<Scene> find(const std::string &word);

// True for the path of a groom file, and of a mesh, by its ending.
bool is_groom(const std::string &word);
bool is_mesh(const std::string &word);

// Give a groom of unknown unit and density something to be seen with, and say so. Only for grooms
// from a file; keys that the caller names in `given` are kept.
//
//   camera.azimuth_deg  100, its side, when it is deeper than wide
//   unit_scale   when the largest extent is outside [0.05, 2] metres: such that it is 0.3
//   width_scale  such that the strands' area, length times width, is 1.5 times the groom's
//                largest face
//
// Returns: sentences for the user, empty when nothing was changed.
Expected<std::string> suit(Scene &scene, const std::vector<std::string> &given);

} // namespace tsuya::scene

#endif

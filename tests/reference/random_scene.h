// Scenes drawn at random, on which the predictor of errors is fitted and the chooser is tried.
#ifndef TSUYA_TESTS_REFERENCE_RANDOM_SCENE_H
#define TSUYA_TESTS_REFERENCE_RANDOM_SCENE_H

#include <cstdint>
#include <string>
#include <vector>

namespace tsuya::reference
{

// Keys of scene number `seed`, the same everywhere: a straight, wavy or curly groom of its own
// seed, length and thickness; a colour by name, pigment or dye; roughness; a rig or one to three
// lights, a sky; a camera all around, from near to so far that a strand is a hundredth of a pixel.
std::vector<std::string> random_scene(std::uint64_t seed);

} // namespace tsuya::reference

#endif

// Tiers: the ways of shading that tsuya offers, by rising effort, as a scene says them with tier=.
//
// A tier is a shorthand for keys of a scene; tier= sets them and leaves no trace of its own, so
// write() prints the keys and not the tier. The same file cannot give a tier and one of its keys.
//
//   unshadowed         kajiya_kay, light that no hair dims
//   kajiya_kay         with light dimmed by the fibres in its way
//   marschner          the same
//   zinke              dual scattering as published
//   exact              dual scattering with all orders in closed form
//   plane_parallel     layers of parallel fibres, solved
//   leaf_coarse        Lambert's lobes
//   leaf_body          a leaf without a coat
//   leaf               with one
//   *_uniform          one pigment and thickness for the material, no maps: the picture that a
//                      shader gives which reads the leaf's numbers from uniforms
//
// Fibres are counted in deep opacity maps. Light that has no map is counted in the grid: the sky,
// lights past the eighth, all lights where the context cannot draw maps. A scene whose only light
// is its sky is therefore drawn with the grid by every tier, and nothing else needs to be said.
#ifndef TSUYA_SCENE_TIERS_H
#define TSUYA_SCENE_TIERS_H

#include <string>
#include <vector>

namespace tsuya::scene {

struct Tier {
    std::string name;
    bool leaf;                      // for scenes of kind leaf and tree
    std::vector<std::string> words; // keys with their values
};

const std::vector<Tier> &tiers();
// NULL when there is none of that name.
const Tier *find_tier(const std::string &name);
// Those for hair or for leaves: "a, b, c".
std::string tier_names(bool leaf);

} // namespace tsuya::scene

#endif

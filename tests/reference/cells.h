// The cells of the image table: a head of hair under a light, drawn by every tier of the renderer
// and traced by the reference.
#ifndef TSUYA_TESTS_REFERENCE_CELLS_H
#define TSUYA_TESTS_REFERENCE_CELLS_H

#include "reference/figures.h"
#include "scene/picture.h"

#include <string>
#include <vector>

namespace tsuya::reference
{

// What the renderer can be asked for, by rising effort.
struct Tier {
    const char *name;
    std::vector<std::string> words; // keys of a scene
};

// none            kajiya_kay without shadow: light goes through hair as if it were not there
// kajiya_kay      with hair in the light's way counted in a grid
// marschner       with the same
// deep_opacity    marschner with hair counted in deep opacity maps
// zinke           dual scattering as published, with the same maps
// exact           dual scattering with all orders in closed form, with the same maps
// plane_parallel  layers of parallel fibres solved by adding-doubling, with the same maps
//
// The sky's shadow is the grid's in all but the first.
const std::vector<Tier> &tiers();

struct Cell {
    std::string groom; // straight, curly or the path of a groom file
    std::string color; // a natural one by name, or dyed: blue
    std::string light; // a rig, or rect, point, window, sunset: see scene_of()
    double dome = 1.5; // radiance of the uniform sky
    int size = 256;    // pixels along each side
    std::uint64_t seed = 1;

    // straight, curly or the file's name.
    std::string name() const;
};

// The head is black in reference and tiers: no tier takes light from the head to the hair, and what
// it gives, 7 % of blond hair's luminance and 16 % of black hair's from the front, would hide what
// the tiers do. It stays in the way of light.
//
// The scene of a cell as the reference takes it; with the words of a tier, as the tier does. Lights
// other than the rigs: rect, 0.8 m square and 1 m away, 0.6 sr; point, 0.65 m away; window and
// sunset, the surroundings of these names.
// 3000 strands ten times as wide as hair stand for 30000; a groom from a file is suited as
// scene::suit() does it. Errors: those of the scene's keys and of the file.
Expected<scene::Scene> scene_of(const Cell &cell, const std::vector<std::string> &words = {});

// The scene in one line, without the folder of a groom file: the same on every machine.
std::string line_of(const scene::Scene &scene);

// One cell as it is drawn and traced.
struct Taken {
    Cell cell;
    scene::Scene scene;
    std::vector<draw::Picture> pictures; // one a tier
    std::vector<double> seconds;         // of processor time of each; the first of a tier compiles
};

// Draw cells of one groom by some tiers, one tier after the other, so that its tables are baked
// once for all. Errors: those of scenes, hair, materials and the renderer.
Expected<std::vector<Taken>> draw_cells(scene::Studio &studio, const std::vector<Cell> &cells,
                                        const std::vector<Tier> &tiers);

// Where tracing ends.
struct Limits {
    std::uint64_t least = 32, most = 64; // samples a pixel, multiples of Batches::count
    unsigned threads = 1;
    std::string films; // folder that keeps what was traced (65 MB a cell of 256 pixels): with it a
                       // change to a tier asks for new pictures only; empty: none
};

// Trace a drawn cell until, in every picture, both figures' standard errors are no more than a
// fifth of the smallest of that figure over the pictures (of the error of the mean: a fifth of
// `resolved` where the smallest is below it), or limits.most is reached.
constexpr double resolved = 0.01;
struct Result {
    std::vector<Figures> figures; // one a picture
    std::uint64_t samples = 0;
    Film film; // all batches
};
Expected<Result> trace(const Taken &taken, const Limits &limits);

} // namespace tsuya::reference

#endif

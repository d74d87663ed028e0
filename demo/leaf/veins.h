// Private to the generator: the veins as lines on the flat blade, and the maps painted from them.
#ifndef TSUYA_LEAF_VEINS_H
#define TSUYA_LEAF_VEINS_H

#include "leaf/outline.h"

#include <vector>

namespace tsuya::leaf {

enum class Order { midrib, secondary, tertiary };

struct Vein {
    Order order = Order::secondary;
    std::vector<Flat> points;
    std::vector<double> half_widths; // metres, one per point
};

// Midrib, secondaries, their loops, and the ladder of tertiaries between them; finer veins are the
// painter's.
std::vector<Vein> veins(const Outline &outline);

// Paint all maps. `lower` and `size` are the box that uv fill.
void paint(const Outline &outline, const Flat &lower, const Flat &size, Maps &maps);

} // namespace tsuya::leaf

#endif

#include "groom/numeric.h"

#include "leaf/generate.h"

#include "leaf/blade.h"
#include "leaf/veins.h"

#include <exception>
#include <sstream>
#include <utility>

namespace tsuya::leaf {

using groom::Vec;

namespace {

template <class T> bool outside(const char *field, T value, double low, double high, Error &error)
{
    // Written so that NaN is outside.
    if (double(value) >= low && double(value) <= high) {
        return false;
    }
    std::ostringstream out;
    out << field << " is " << value << " but must be in [" << low << ", " << high << "]";
    error.message = out.str();
    return true;
}

bool invalid(const LeafParams &p, Error &error)
{
    const bool wrong =
        outside("length", p.length, 0.005, 1.0, error) ||
        outside("width", p.width, 0.05, 1.5, error) ||
        outside("widest", p.widest, 0.2, 0.8, error) || outside("tip", p.tip, 0.0, 1.0, error) ||
        outside("base", p.base, 0.0, 1.0, error) || outside("heart", p.heart, 0.0, 0.25, error) ||
        outside("teeth", p.teeth, 0, 80, error) ||
        outside("tooth_depth", p.tooth_depth, 0.0, 0.2, error) ||
        outside("lobes", p.lobes, 0, 8, error) ||
        outside("lobe_depth", p.lobe_depth, 0.0, 0.45, error) ||
        outside("roughness", p.roughness, 0.0, 1.0, error) ||
        outside("petiole", p.petiole, 0.0, 1.5, error) || outside("veins", p.veins, 2, 30, error) ||
        outside("sweep", p.sweep, 0.0, 1.0, error) || outside("curve", p.curve, 0.0, 1.0, error) ||
        outside("loops", p.loops, 0.0, 1.0, error) || outside("fold", p.fold, -1.2, 1.2, error) ||
        outside("curl", p.curl, 0.0, 3.0, error) || outside("bend", p.bend, -3.0, 3.0, error) ||
        outside("twist", p.twist, -2.0, 2.0, error) || outside("wave", p.wave, 0.0, 0.5, error) ||
        outside("blotches", p.blotches, 0.0, 1.0, error) ||
        outside("edge", p.edge, -0.6, 1.0, error) || outside("halo", p.halo, 0.0, 0.9, error) ||
        outside("relief", p.relief, 0.0, 3.0, error) || outside("rows", p.rows, 8, 512, error) ||
        outside("columns", p.columns, 2, 64, error) ||
        (p.texels != 0 && outside("texels", p.texels, 64, 8192, error));
    if (!wrong && p.teeth * 5 > p.rows) {
        error.message = "rows is " + std::to_string(p.rows) + " but must be in [" +
                        std::to_string(p.teeth * 5) + ", 512]: 5 for each tooth";
        return true;
    }
    return wrong;
}

void move(Mesh &mesh, const Vec &by)
{
    for (glm::vec3 &p : mesh.positions) {
        p = glm::vec3(float(double(p.x) - by.x), float(double(p.y) - by.y),
                      float(double(p.z) - by.z));
    }
}

Expected<Leaf> make(const LeafParams &params)
{
    const Outline outline(params);
    const Blade blade(outline);
    Flat lower, size;
    flat_box(outline, lower, size);
    Leaf leaf;
    if (!make_blade(blade, lower, size, leaf.blade, leaf.flat_area)) {
        return Error{"the outline folds over itself: use a smaller lobe_depth, tooth_depth, heart "
                     "or sweep"};
    }
    Vec begin;
    if (params.petiole > 0.0) {
        make_stalk(blade, leaf.stalk, begin);
    }
    move(leaf.blade, begin);
    move(leaf.stalk, begin);
    if (params.texels > 0) {
        paint(outline, lower, size, leaf.maps);
    }
    return Expected<Leaf>(std::move(leaf));
}

LeafParams beech()
{
    LeafParams p;
    p.width = 0.62;
    p.tip = 0.58;
    p.base = 0.62;
    p.curve = 0.25;
    p.sweep = 0.6;
    p.wave = 0.09;
    return p;
}

LeafParams linden()
{
    LeafParams p;
    p.width = 0.95;
    p.widest = 0.36;
    p.tip = 1.0;
    p.base = 1.0;
    p.heart = 0.17;
    p.teeth = 36;
    p.tooth_depth = 0.035;
    p.veins = 7;
    p.sweep = 0.75;
    p.petiole = 0.55;
    p.rows = 180;
    p.fold = 0.25;
    return p;
}

LeafParams willow()
{
    LeafParams p;
    p.length = 0.11;
    p.width = 0.2;
    p.widest = 0.38;
    p.tip = 0.9;
    p.base = 0.45;
    p.veins = 16;
    p.sweep = 0.4;
    p.curve = 0.8;
    p.loops = 1.0;
    p.bend = 0.9;
    p.fold = 0.45;
    p.petiole = 0.1;
    p.columns = 10;
    return p;
}

LeafParams oak()
{
    LeafParams p;
    p.length = 0.11;
    p.width = 0.62;
    p.widest = 0.62;
    p.tip = 0.1;
    p.base = 0.1;
    p.lobes = 6;
    p.lobe_depth = 0.42;
    p.sweep = 0.45;
    p.curve = 0.3;
    p.petiole = 0.06;
    p.rows = 140;
    p.columns = 18;
    p.wave = 0.12;
    return p;
}

LeafParams ficus()
{
    LeafParams p;
    p.width = 0.46;
    p.widest = 0.47;
    p.tip = 1.0;
    p.base = 0.55;
    p.veins = 13;
    p.sweep = 0.35;
    p.curve = 0.7;
    p.loops = 1.0;
    p.roughness = 0.25;
    p.wave = 0.04;
    p.relief = 0.6;
    p.blotches = 0.12;
    return p;
}

const struct {
    const char *name;
    LeafParams (*make)();
} presets[] = {
    {"beech", beech}, {"linden", linden}, {"willow", willow}, {"oak", oak}, {"ficus", ficus}};

} // namespace

const std::vector<std::string> &shapes()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto &p : presets) {
            all.push_back(p.name);
        }
        return all;
    }();
    return names;
}

Expected<LeafParams> preset(const std::string &shape)
{
    std::string names;
    for (const auto &p : presets) {
        if (shape == p.name) {
            return p.make();
        }
        names += (names.empty() ? "" : ", ") + std::string(p.name);
    }
    return Error{"there is no leaf shape " + shape + "; there are " + names};
}

Expected<Leaf> generate(const LeafParams &params)
{
    Error error;
    if (invalid(params, error)) {
        return error;
    }
    try {
        return make(params);
    } catch (const std::exception &) {
        return Error{"memory ran out while growing the leaf"};
    }
}

} // namespace tsuya::leaf

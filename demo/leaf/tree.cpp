#include "groom/numeric.h"

#include "leaf/tree.h"

#include "leaf/skeleton.h"

#include <algorithm>
#include <exception>
#include <sstream>
#include <utility>

namespace tsuya::leaf {

using groom::Random;
using groom::Vec;

namespace {

constexpr std::uint32_t kinds = 4; // of blades, bent and folded each in its way

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

bool invalid(const TreeParams &p, Error &error)
{
    return outside("leaves", p.leaves, 200, 20000, error) ||
           outside("twigs", p.twigs, 40, 4000, error) ||
           outside("height", p.height, 0.5, 30.0, error) ||
           outside("crown_width", p.crown_width, 0.2, 2.0, error) ||
           outside("crown_base", p.crown_base, 0.0, 0.8, error) ||
           outside("phototropism", p.phototropism, 0.0, 1.0, error) ||
           outside("droop", p.droop, 0.0, 1.0, error) ||
           outside("variation", p.variation, 0.0, 0.5, error);
}

// Columns x, y, z of a leaf's frame, scaled, at `place`.
glm::mat4 frame(Vec x, Vec y, Vec z, double scale, Vec place)
{
    const auto column = [&](Vec v, double s, float w) {
        return glm::vec4(float(v.x * s), float(v.y * s), float(v.z * s), w);
    };
    return glm::mat4(column(x, scale, 0.0f), column(y, scale, 0.0f), column(z, scale, 0.0f),
                     column(place, 1.0, 1.0f));
}

class Leafing
{
  public:
    Leafing(const TreeParams &params, const Crown &crown, const std::vector<Bone> &bones)
        : params_(params), crown_(crown), bones_(bones), random_(params.seed, 30)
    {
    }

    // Leaves at even steps along all outer twigs taken together.
    std::vector<Placed> run()
    {
        const double outer = 0.13 * params_.height;
        double total = 0.0;
        for (std::size_t i = 1; i < bones_.size(); i++) {
            total += bones_[i].reach < outer ? span(i) : 0.0;
        }
        const double step = total / double(params_.leaves);
        double next = 0.5 * step, passed = 0.0;
        std::vector<Placed> all;
        for (std::uint32_t i = 1; i < bones_.size(); i++) {
            if (bones_[i].reach >= outer) {
                continue;
            }
            const double here = span(i);
            while (all.size() < params_.leaves && next <= passed + here) {
                all.push_back(leaf(i, (next - passed) / here, std::uint32_t(all.size())));
                next += step;
            }
            passed += here;
        }
        // The last one may fall off the end by rounding.
        while (all.size() < params_.leaves) {
            all.push_back(leaf(std::uint32_t(bones_.size() - 1), 1.0, std::uint32_t(all.size())));
        }
        return all;
    }

  private:
    double span(std::size_t i) const
    {
        return length(bones_[i].place - bones_[bones_[i].parent].place);
    }

    Placed leaf(std::uint32_t bone, double share, std::uint32_t number)
    {
        const Bone &end = bones_[bone], &begin = bones_[end.parent];
        const Vec along = unit(end.place - begin.place, {0.0, 1.0, 0.0});
        const Vec side = unit(cross(along, {0.31, 0.12, 0.94}), {1.0, 0.0, 0.0});
        const Vec other = cross(along, side);
        const double turn = number * 0.38196601125 + 0.08 * random_.range(-1.0, 1.0);
        const Vec radial = side * groom::cosine(turn) + other * groom::sine(turn);
        const double radius = groom::mix(begin.radius, end.radius, share);
        const Vec on_axis = mix(begin.place, end.place, share);
        const Vec at = on_axis + radial * (0.8 * radius);

        const Vec out = crown_.out(at);
        const auto jitter = [&](double size) {
            return Vec{random_.range(-1.0, 1.0), random_.range(-1.0, 1.0),
                       random_.range(-1.0, 1.0)} *
                   size;
        };
        Vec y = unit(along * 0.55 + radial * 0.75 + out * 0.25 +
                         Vec{0.0, 0.25 - 0.9 * params_.droop, 0.0} + jitter(0.25),
                     radial);
        const Vec light = unit(Vec{0.0, 1.0, 0.0} + out * 0.55, out);
        const Vec wanted = unit(light * (0.25 + params_.phototropism) +
                                    radial * (0.5 * (1.0 - params_.phototropism)) + jitter(0.4),
                                light);
        Vec z = wanted - y * dot(wanted, y);
        z = unit(length(z) > 1e-3 ? z : cross(y, side), other);
        const Vec x = unit(cross(y, z), side);
        // Young leaves at the tips are smaller.
        const double young = 1.0 - 0.35 * (end.children.empty() ? share : 0.0);
        const double scale = young * (1.0 + 0.22 * random_.bell() * 2.0);
        Placed placed;
        placed.place = frame(x, y, z, scale, at);
        placed.kind = std::min(std::uint32_t(random_.unit() * kinds), kinds - 1);
        placed.node = bone;
        const double tint = 1.0 + params_.variation * 3.4 * random_.bell() - 0.25 * (1.0 - young);
        placed.pigment = float(std::max(tint, 0.3));
        placed.thickness = float(1.0 + 0.1 * random_.bell() - 0.3 * (1.0 - young));
        return placed;
    }

    const TreeParams &params_;
    const Crown &crown_;
    const std::vector<Bone> &bones_;
    Random random_;
};

Expected<Plant> make(const TreeParams &params)
{
    const Crown crown(params);
    Plant plant;
    for (std::uint32_t i = 0; i < kinds; i++) {
        LeafParams leaf = params.leaf;
        Random random(params.seed, 40 + i);
        leaf.seed = params.leaf.seed + i;
        leaf.texels = i == 0 ? params.leaf.texels : 0;
        leaf.fold = std::clamp(leaf.fold * random.range(0.6, 1.5), -1.2, 1.2);
        leaf.bend = std::clamp(leaf.bend * random.range(0.5, 1.7), -3.0, 3.0);
        leaf.twist = random.range(-0.35, 0.35);
        Expected<Leaf> grown = generate(leaf);
        if (!grown) {
            return Error{"leaf: " + grown.error()};
        }
        plant.kinds.push_back({std::move(grown->blade), std::move(grown->stalk)});
        if (i == 0) {
            plant.maps = std::move(grown->maps);
        }
    }
    const std::vector<Bone> bones = skeleton(params, crown);
    plant.wood = wood(params, bones);
    plant.leaves = Leafing(params, crown, bones).run();
    for (const Bone &bone : bones) {
        plant.nodes.push_back(
            {glm::vec3(float(bone.place.x), float(bone.place.y), float(bone.place.z)), bone.parent,
             float(bone.radius)});
    }
    plant.centre = {float(crown.centre.x), float(crown.centre.y), float(crown.centre.z)};
    plant.half = {float(crown.half.x), float(crown.half.y), float(crown.half.z)};
    return Expected<Plant>(std::move(plant));
}

} // namespace

Expected<TreeParams> tree_preset(const std::string &shape)
{
    Expected<LeafParams> leaf = preset(shape);
    if (!leaf) {
        return Error{leaf.error()};
    }
    TreeParams params;
    params.leaf = *leaf;
    params.leaf.rows = leaf->lobes > 0 ? 26 : 12;
    params.leaf.columns = 3;
    params.leaf.teeth = 0;
    params.leaf.texels = 512;
    params.leaf.relief *= 0.6;
    return params;
}

Expected<Plant> grow(const TreeParams &params)
{
    Error error;
    if (invalid(params, error)) {
        return error;
    }
    try {
        return make(params);
    } catch (const std::exception &) {
        return Error{"memory ran out while growing the tree"};
    }
}

Plant single(Leaf leaf)
{
    Plant plant;
    plant.kinds.push_back({std::move(leaf.blade), std::move(leaf.stalk)});
    plant.maps = std::move(leaf.maps);
    plant.leaves.emplace_back();
    return plant;
}

Plant single(Mesh mesh)
{
    Plant plant;
    plant.kinds.push_back({std::move(mesh), {}});
    plant.leaves.emplace_back();
    return plant;
}

} // namespace tsuya::leaf

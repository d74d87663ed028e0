#include "leaf/skeleton.h"

#include <algorithm>

namespace tsuya::leaf {

using groom::Random;
using groom::Vec;

namespace {

constexpr double tip_radius = 0.0005; // of the height

class Growth
{
  public:
    Growth(const TreeParams &params, const Crown &crown)
        : params_(params), step_(0.0105 * params.height), random_(params.seed, 20)
    {
        while (goals_.size() < params.twigs) {
            const Vec u{random_.range(-1.0, 1.0), random_.range(-1.0, 1.0),
                        random_.range(-1.0, 1.0)};
            const Vec p = crown.centre + u * crown.half;
            if (crown.holds(p)) {
                goals_.push_back({p, 0, 1e30});
            }
        }
        const double volume = 4.19 * crown.half.x * crown.half.y * crown.half.z;
        const double share = volume / double(params.twigs);
        // Side of the cube that a goal has for itself.
        double side = params.height;
        for (int i = 0; i < 60; i++) {
            side -= (side * side * side - share) / (3.0 * side * side);
        }
        kill_ = 0.5 * side;
        reach_ = 5.0 * side;
    }

    std::vector<Bone> run()
    {
        trunk();
        for (int pass = 0; pass < 600 && !goals_.empty(); pass++) {
            if (!grow()) {
                break;
            }
        }
        return std::move(bones_);
    }

  private:
    struct Goal {
        Vec place;
        std::uint32_t bone; // nearest
        double far;         // squared distance to it
    };

    void add(Vec place, std::uint32_t parent)
    {
        Bone bone;
        bone.place = place;
        bone.parent = parent;
        const std::uint32_t self = std::uint32_t(bones_.size());
        bones_.push_back(bone);
        if (self > 0) {
            bones_[parent].children.push_back(self);
        }
        for (Goal &goal : goals_) {
            const Vec d = goal.place - place;
            const double far = dot(d, d);
            if (far < goal.far) {
                goal.far = far;
                goal.bone = self;
            }
        }
    }

    // Up to where the crown begins, not quite straight.
    void trunk()
    {
        Vec at, heading{0.0, 1.0, 0.0};
        add(at, 0);
        const double top = params_.height * (params_.crown_base + 0.08);
        while (at.y < top) {
            heading = unit(heading + Vec{0.06 * random_.range(-1.0, 1.0), 0.05,
                                         0.06 * random_.range(-1.0, 1.0)},
                           heading);
            at = at + heading * step_;
            add(at, std::uint32_t(bones_.size() - 1));
        }
    }

    // One step towards the goals in reach. Returns: false when nothing grew.
    bool grow()
    {
        std::vector<Vec> pull(bones_.size());
        for (const Goal &goal : goals_) {
            if (goal.far < reach_ * reach_) {
                const Vec d = goal.place - bones_[goal.bone].place;
                pull[goal.bone] = pull[goal.bone] + unit(d, {0.0, 1.0, 0.0});
            }
        }
        const std::size_t before = bones_.size();
        for (std::uint32_t i = 0; i < before; i++) {
            if (dot(pull[i], pull[i]) == 0.0) {
                continue;
            }
            const Vec from = bones_[i].place;
            const Vec last = unit(from - bones_[bones_[i].parent].place, {0.0, 1.0, 0.0});
            Vec way = unit(pull[i], {0.0, 1.0, 0.0}) + last * 0.35 + Vec{0.0, 0.08, 0.0};
            way = way + Vec{random_.range(-1.0, 1.0), random_.range(-1.0, 1.0),
                            random_.range(-1.0, 1.0)} *
                            0.14;
            const Vec to = from + unit(way, last) * step_;
            // Two goals may pull a bone to and fro; it would grow the same child again.
            const bool there = std::any_of(
                bones_[i].children.begin(), bones_[i].children.end(),
                [&](std::uint32_t c) { return length(bones_[c].place - to) < 0.35 * step_; });
            if (!there && bones_[i].children.size() < 3) {
                add(to, i);
            }
        }
        const double near = kill_ * kill_;
        goals_.erase(std::remove_if(goals_.begin(), goals_.end(),
                                    [&](const Goal &goal) { return goal.far < near; }),
                     goals_.end());
        return bones_.size() > before;
    }

    const TreeParams &params_;
    double step_, kill_ = 0.0, reach_ = 0.0;
    Random random_;
    std::vector<Goal> goals_;
    std::vector<Bone> bones_;
};

void relax(std::vector<Bone> &bones)
{
    for (int pass = 0; pass < 3; pass++) {
        std::vector<Vec> next(bones.size());
        for (std::size_t i = 0; i < bones.size(); i++) {
            const Bone &bone = bones[i];
            next[i] = bone.place;
            if (i > 0 && !bone.children.empty()) {
                const Vec middle = (bones[bone.parent].place + bones[bone.children[0]].place) * 0.5;
                next[i] = mix(bone.place, middle, 0.4);
            }
        }
        for (std::size_t i = 0; i < bones.size(); i++) {
            bones[i].place = next[i];
        }
    }
}

} // namespace

Crown::Crown(const TreeParams &params)
{
    const double bottom = params.crown_base * params.height;
    half = {0.5 * params.crown_width * params.height, 0.5 * (params.height - bottom),
            0.5 * params.crown_width * params.height};
    centre = {0.0, bottom + half.y, 0.0};
}

bool Crown::holds(Vec p) const
{
    Vec u = (p - centre) / half;
    // Widest below the middle.
    const double wide = 1.0 - 0.28 * u.y;
    u = {u.x / wide, u.y, u.z / wide};
    return dot(u, u) <= 1.0;
}

Vec Crown::out(Vec p) const
{
    return unit((p - centre) / (half * half), {0.0, 1.0, 0.0});
}

std::vector<Bone> skeleton(const TreeParams &params, const Crown &crown)
{
    std::vector<Bone> bones = Growth(params, crown).run();
    relax(bones);
    // Children come after their parents.
    for (std::size_t i = bones.size(); i-- > 0;) {
        Bone &bone = bones[i];
        if (bone.children.empty()) {
            bone.radius = tip_radius * params.height;
        } else {
            double squares = 0.0;
            for (const std::uint32_t c : bone.children) {
                squares += bones[c].radius * bones[c].radius;
                bone.reach =
                    std::max(bone.reach, bones[c].reach + length(bones[c].place - bone.place));
            }
            bone.radius = std::sqrt(squares);
            std::stable_sort(bone.children.begin(), bone.children.end(),
                             [&](std::uint32_t a, std::uint32_t b) {
                                 return bones[a].radius > bones[b].radius;
                             });
        }
    }
    return bones;
}

namespace {

class Turner
{
  public:
    Turner(const TreeParams &params, const std::vector<Bone> &bones)
        : params_(params), bones_(bones)
    {
    }

    Mesh run()
    {
        branch(0, 0);
        for (std::uint32_t i = 0; i < bones_.size(); i++) {
            for (std::size_t k = 1; k < bones_[i].children.size(); k++) {
                branch(i, bones_[i].children[k]);
            }
        }
        make_normals(mesh_);
        make_tangents(mesh_);
        return std::move(mesh_);
    }

  private:
    // From `first` along the thickest children; a side branch begins inside `from`.
    void branch(std::uint32_t from, std::uint32_t first)
    {
        std::vector<std::uint32_t> path;
        if (from != first) {
            path.push_back(from);
        }
        for (std::uint32_t i = first;; i = bones_[i].children[0]) {
            path.push_back(i);
            if (bones_[i].children.empty()) {
                break;
            }
        }
        const double base = bones_[first].radius;
        const std::uint32_t around = base > 0.006 * params_.height   ? 11
                                     : base > 0.002 * params_.height ? 7
                                                                     : 4;
        Vec along = heading(path, 0);
        Vec side = unit(cross(along, {0.21, 0.13, 0.97}), {1.0, 0.0, 0.0});
        const std::uint32_t start = std::uint32_t(mesh_.positions.size());
        double far = 0.0;
        for (std::size_t i = 0; i < path.size(); i++) {
            along = heading(path, i);
            // Carried along without a turn about the branch.
            side = unit(side - along * dot(side, along), side);
            const Vec up = cross(along, side);
            const bool inside = i == 0 && from != first;
            double radius = bones_[inside ? first : path[i]].radius;
            const Vec centre = bones_[path[i]].place;
            if (from == first) {
                // The trunk stands on its roots.
                radius *= 1.0 + 0.45 * (1.0 - groom::smooth(0.0, 0.09, centre.y / params_.height));
            }
            radius *= bones_[path[i]].children.empty() ? 0.55 : 1.0;
            far += i > 0 ? length(centre - bones_[path[i - 1]].place) : 0.0;
            ring(centre, side, up, radius, around, far);
        }
        const std::uint32_t rings = std::uint32_t(path.size());
        for (std::uint32_t i = 0; i + 1 < rings; i++) {
            for (std::uint32_t k = 0; k < around; k++) {
                const std::uint32_t a = start + i * around + k;
                const std::uint32_t b = start + i * around + (k + 1) % around;
                mesh_.indices.insert(mesh_.indices.end(),
                                     {a, b, b + around, a, b + around, a + around});
            }
        }
        for (std::uint32_t k = 1; k + 1 < around; k++) {
            const std::uint32_t last = start + (rings - 1) * around;
            mesh_.indices.insert(mesh_.indices.end(), {start, start + k + 1, start + k});
            mesh_.indices.insert(mesh_.indices.end(), {last, last + k, last + k + 1});
        }
    }

    Vec heading(const std::vector<std::uint32_t> &path, std::size_t i) const
    {
        const Vec before = bones_[path[i > 0 ? i - 1 : 0]].place;
        const Vec after = bones_[path[std::min(i + 1, path.size() - 1)]].place;
        return unit(after - before, {0.0, 1.0, 0.0});
    }

    void ring(Vec centre, Vec side, Vec up, double radius, std::uint32_t around, double far)
    {
        const double thick = groom::smooth(0.0008, 0.012, radius / params_.height);
        const Vec twig{0.115, 0.085, 0.055}, bark{0.135, 0.12, 0.105};
        for (std::uint32_t k = 0; k < around; k++) {
            const double turn = double(k) / double(around);
            const Vec out = side * groom::cosine(turn) + up * groom::sine(turn);
            const Vec p = centre + out * radius;
            mesh_.positions.push_back({float(p.x), float(p.y), float(p.z)});
            mesh_.uvs.emplace_back(float(turn), float(far / params_.height));
            const Vec c = mix(twig, bark, thick);
            mesh_.albedo.push_back({float(c.x), float(c.y), float(c.z)});
        }
    }

    const TreeParams &params_;
    const std::vector<Bone> &bones_;
    Mesh mesh_;
};

} // namespace

Mesh wood(const TreeParams &params, const std::vector<Bone> &bones)
{
    return Turner(params, bones).run();
}

} // namespace tsuya::leaf

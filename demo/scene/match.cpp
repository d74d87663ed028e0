#include "scene/match.h"

#include "scene/keys.h"
#include "scene/picture.h"

#include <algorithm>
#include <cmath>

namespace tsuya::scene
{

namespace
{

constexpr int size_most = 96; // pixels along the longer side

Expected<double> luminance(draw::Renderer &renderer, draw::Frame frame, float gain)
{
    frame.gain = gain;
    const Expected<bool> drawn = renderer.draw(frame);
    return drawn ? Expected<double>(numbers(renderer.picture()).hair) : Error{drawn.error()};
}

} // namespace

Expected<float> match(draw::Renderer &renderer, const Scene &scene, const Hair &hair,
                      const Surroundings &around, double turn_deg, bool turntable)
{
    if (scene.match == "none") {
        return 1.0f;
    }
    Scene small = scene;
    const double scale = std::min(1.0, double(size_most) / std::max(scene.width, scene.height));
    small.width = std::max(16, int(std::lround(scale * scene.width)));
    small.height = std::max(16, int(std::lround(scale * scene.height)));
    const Expected<Scene> other = override(small, {"tier=" + scene.match});
    if (!other) {
        return Error{other.error()};
    }
    // The other tier's hair, this one's, and what is seen of head and background through both.
    double seen[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 3; i++) {
        const Scene &one = i == 0 ? *other : small;
        const Expected<Material> material = scene::material(one);
        if (!material) {
            return Error{material.error()};
        }
        Expected<bool> set = true;
        if (i < 2) {
            set = renderer.material(material->model, material->params.data(), material->variant);
        }
        const Expected<double> value =
            set ? luminance(renderer, frame(one, hair, *material, turn_deg, turntable, around),
                            i == 2 ? 0.0f : 1.0f)
                : Expected<double>(Error{set.error()});
        if (!value) {
            return Error{value.error()};
        }
        seen[i] = *value;
    }
    const double wanted = seen[0] - seen[2], there = seen[1] - seen[2];
    return there > 0.0 && wanted > 0.0 ? float(wanted / there) : 1.0f;
}

} // namespace tsuya::scene

#include "reference/cells.h"

#include "reference/world.h"
#include "scene/gallery.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <map>
#include <utility>

namespace tsuya::reference
{

const std::vector<Tier> &tiers()
{
    static const std::vector<Tier> all = {
        {"none", {"model=kajiya_kay", "shadow=none"}},
        {"kajiya_kay", {"model=kajiya_kay", "shadow=grid"}},
        {"marschner", {"model=marschner", "shadow=grid"}},
        {"deep_opacity", {"model=marschner", "shadow=deep_opacity"}},
        {"zinke", {"model=dual_scattering", "variant=zinke", "shadow=deep_opacity"}},
        {"exact", {"model=dual_scattering", "shadow=deep_opacity"}},
        {"plane_parallel", {"model=plane_parallel_hair", "shadow=deep_opacity"}},
    };
    return all;
}

std::string Cell::name() const
{
    return std::filesystem::path(groom).filename().string();
}

Expected<scene::Scene> scene_of(const Cell &cell, const std::vector<std::string> &words)
{
    const std::string size = std::to_string(cell.size);
    const bool dyed = cell.color == "dyed";
    static const std::map<std::string, std::vector<std::string>> others = {
        {"rect",
         {"light=none", "light0.kind=rect", "light0.position=0.6,0.5,0.6", "light0.width=0.8",
          "light0.height=0.8", "light0.intensity=4"}},
        {"point",
         {"light=none", "light0.kind=point", "light0.position=-0.3,0.3,0.5", "light0.intensity=1"}},
        {"window", {"light=none", "environment=window"}},
        {"sunset", {"light=none", "environment=sunset"}},
    };
    std::vector<std::string> all = {dyed ? "sigma_a=1.2,0.35,0.03" : "color=" + cell.color,
                                    "size=" + size + "x" + size};
    const auto other = others.find(cell.light);
    if (other == others.end()) {
        all.push_back("light=" + cell.light);
    } else {
        all.insert(all.end(), other->second.begin(), other->second.end());
    }
    if (cell.dome != 1.5) {
        all.push_back("dome=" + std::to_string(cell.dome));
    }
    all.insert(all.end(), words.begin(), words.end());
    if (scene::is_groom(cell.groom)) {
        Expected<scene::Scene> found = scene::find(cell.groom);
        found = found ? scene::override(*found, all) : std::move(found);
        if (found) {
            const Expected<std::string> suited = scene::suit(*found, all);
            if (!suited) {
                return Error{suited.error()};
            }
        }
        return found;
    }
    const std::vector<std::string> grown = {"groom=" + cell.groom, "strands=3000",
                                            "width_scale=10"};
    all.insert(all.begin(), grown.begin(), grown.end());
    return scene::override(scene::Scene(), all);
}

std::string line_of(const scene::Scene &scene)
{
    scene::Scene plain = scene;
    plain.title.clear();
    if (plain.groom.rfind("file:", 0) == 0) {
        plain.groom = "file:" + std::filesystem::path(plain.groom.substr(5)).filename().string();
    }
    std::string text = scene::write(plain);
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') {
        text.pop_back();
    }
    return text;
}

namespace
{

double processor_seconds()
{
    return double(std::clock()) / CLOCKS_PER_SEC;
}

draw::Frame frame_of(const scene::Scene &scene, const scene::Hair &hair,
                     const scene::Material &material, const scene::Surroundings &around = {})
{
    draw::Frame frame = scene::frame(scene, hair, material, 0.0, false, around);
    frame.skin = glm::vec3(0.0f); // see cells.h
    return frame;
}

Expected<bool> draw_one(scene::Studio &studio, const scene::Hair &hair, const Tier &tier,
                        Taken &taken)
{
    const Expected<scene::Scene> scene = scene_of(taken.cell, tier.words);
    if (!scene) {
        return Error{scene.error()};
    }
    const Expected<scene::Material> material = scene::material(*scene);
    if (!material) {
        return Error{material.error()};
    }
    const Expected<scene::Surroundings> around = scene::surroundings(*scene);
    if (!around) {
        return Error{around.error()};
    }
    draw::Renderer &renderer = studio.renderer();
    Expected<bool> good =
        renderer.material(material->model, material->params.data(), material->variant);
    const draw::Frame frame = frame_of(*scene, hair, *material, *around);
    renderer.finish();
    const double begin = processor_seconds();
    good = good ? renderer.draw(frame) : std::move(good);
    renderer.finish();
    taken.seconds.push_back(processor_seconds() - begin);
    taken.pictures.push_back(renderer.picture());
    return good;
}

// Whether every standard error is a fifth of the smallest figure.
bool enough(const std::vector<Figures> &figures)
{
    double mean = 1e300, mse = 1e300, mean_error = 0.0, mse_error = 0.0;
    for (const Figures &f : figures) {
        mean = std::min(mean, std::abs(f.mean_error.value));
        mse = std::min(mse, f.rel_mse.value);
        mean_error = std::max(mean_error, f.mean_error.error);
        mse_error = std::max(mse_error, f.rel_mse.error);
    }
    return 5.0 * mean_error <= std::max(mean, resolved) && 5.0 * mse_error <= mse;
}

// Samples to try after so many.
std::uint64_t next(std::uint64_t samples, const Limits &limits)
{
    const std::uint64_t half = samples + samples / 2 + Batches::count - 1;
    return std::min(half / Batches::count * Batches::count, limits.most);
}

std::string film_of(const std::string &folder, const Cell &cell)
{
    return folder + "/" + cell.name() + "-" + cell.color + "-" + cell.light + "-" +
           std::to_string(cell.size) + ".";
}

} // namespace

Expected<std::vector<Taken>> draw_cells(scene::Studio &studio, const std::vector<Cell> &cells,
                                        const std::vector<Tier> &tiers)
{
    std::vector<Taken> result;
    for (const Cell &cell : cells) {
        const Expected<scene::Scene> scene = scene_of(cell);
        if (!scene) {
            return Error{scene.error()};
        }
        result.push_back({cell, *scene, {}, {}});
    }
    if (result.empty()) {
        return Expected<std::vector<Taken>>(std::move(result));
    }
    const Expected<scene::Hair> hair = scene::hair(result[0].scene);
    if (!hair) {
        return Error{hair.error()};
    }
    Expected<bool> good = studio.renderer().load(hair->groom, hair->head, hair->solid);
    for (const Tier &tier : tiers) {
        for (std::size_t i = 0; i < result.size() && good; i++) {
            good = draw_one(studio, *hair, tier, result[i]);
        }
    }
    return good ? Expected<std::vector<Taken>>(std::move(result)) : Error{good.error()};
}

Expected<Result> trace(const Taken &taken, const Limits &limits)
{
    const Expected<scene::Hair> hair = scene::hair(taken.scene);
    const Expected<scene::Material> material = scene::material(taken.scene);
    if (!hair || !material) {
        return Error{hair ? material.error() : hair.error()};
    }
    const draw::Frame frame = frame_of(taken.scene, *hair, *material);
    const Expected<World> world =
        reference::world(taken.scene, *hair, *material, frame, limits.threads);
    if (!world) {
        return Error{world.error()};
    }
    const Tracer tracer(*world);
    Batches batches(taken.cell.size, taken.cell.size);
    const std::string text = line_of(taken.scene);
    const std::uint64_t key = key_of(text.data(), text.size(), taken.cell.seed);
    const std::string kept = limits.films.empty() ? "" : film_of(limits.films, taken.cell);
    Result result{{}, kept.empty() ? 0 : batches.read(kept, key), Film(1, 1)};
    result.samples = std::max(result.samples, limits.least);
    for (;; result.samples = next(result.samples, limits)) {
        batches.bring(tracer, camera(frame), result.samples, taken.cell.seed, limits.threads);
        result.figures = figures(batches, taken.pictures);
        if (result.samples >= limits.most || enough(result.figures)) {
            break;
        }
    }
    if (!kept.empty() && !batches.write(kept, key)) {
        return Error{"cannot write " + kept + "*"};
    }
    result.film = batches.film();
    return Expected<Result>(std::move(result));
}

} // namespace tsuya::reference

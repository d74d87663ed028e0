// `tsuya render` for leaves and trees.

#include "command/arguments.h"
#include "scene/build.h"
#include "scene/picture.h"
#include "scene/plant.h"
#include "scene/render.h"

#include <cstdio>

namespace tsuya::scene {

int render_surface(const Scene &scene, const std::string &path, int frames)
{
    const Clock total;
    const Expected<Material> material = scene::material(scene);
    if (!material) {
        return render_complaint(material.error());
    }
    const Expected<Surroundings> around = surroundings(scene);
    if (!around) {
        return render_complaint(around.error());
    }
    render_progress("reading or growing leaves");
    const Expected<Surface> surface = scene::surface(scene);
    if (!surface) {
        return render_complaint(surface.error());
    }
    const double grow_time = total.seconds();
    Expected<std::unique_ptr<Studio>> studio = Studio::create();
    if (!studio) {
        return render_complaint(studio.error(), false);
    }
    const Expected<draw::SurfaceRenderer *> made = (*studio)->surfaces();
    if (!made) {
        return render_complaint(made.error(), false);
    }
    draw::SurfaceRenderer &renderer = **made;
    renderer.load(surface->plant);
    const Expected<bool> taken = renderer.material(material->model, material->params.data());
    if (!taken) {
        return render_complaint(taken.error());
    }
    Numbers numbers;
    double draw_time = 0.0;
    for (int i = 0; i < frames; i++) {
        render_progress("drawing " + std::to_string(i + 1) + " of " + std::to_string(frames));
        const double turn = 360.0 * double(i) / double(frames);
        const Clock one;
        const Expected<bool> drawn =
            renderer.draw(frame(scene, *surface, turn, frames > 1, *around));
        if (!drawn) {
            return render_complaint(drawn.error());
        }
        const draw::Picture picture = renderer.picture();
        draw_time += one.seconds();
        numbers = i == 0 ? scene::numbers(picture) : numbers;
        const Expected<bool> saved =
            save(render_path(path, i + 1, frames), scene, renderer.screen());
        if (!saved) {
            return render_complaint(saved.error(), false);
        }
    }
    render_progress("");
    char text[512];
    std::snprintf(text, sizeof text,
                  "mean luminance   %.6g\n"
                  "leaf luminance   %.6g, weighed by coverage\n"
                  "leaf coverage    %.4g\n"
                  "time             %.2f s: growing %.2f, drawing %.2f, %d frame%s\n",
                  numbers.mean, numbers.hair, numbers.coverage, total.seconds(), grow_time,
                  draw_time, frames, frames == 1 ? "" : "s");
    return command::print("render", "model            " + scene.model + "\n" + surface->report +
                                        text + "drawn with       " + (*studio)->description() +
                                        "\n");
}

} // namespace tsuya::scene

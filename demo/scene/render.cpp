// `tsuya render`: a scene or a groom to PNG or EXR.

#include "command/arguments.h"
#include "command/commands.h"
#include "scene/gallery.h"
#include "scene/keys.h"
#include "scene/match.h"
#include "scene/picture.h"
#include "scene/render.h"

#include <cstdio>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tsuya::scene {

int render_complaint(const std::string &text, bool bad_input)
{
    render_progress("");
    const bool dot = !text.empty() && (text.back() == '.' || text.back() == '\n');
    return command::complain("render", text + (dot ? "" : "."),
                             bad_input ? command::exit_bad_input : command::exit_failure);
}

void render_progress(const std::string &text)
{
    if (isatty(STDERR_FILENO)) {
        std::fprintf(stderr, "\r\033[K%s", text.c_str());
        std::fflush(stderr);
    }
}

std::string render_path(const std::string &path, int number, int frames)
{
    if (frames == 1) {
        return path;
    }
    char digits[16];
    std::snprintf(digits, sizeof digits, "_%04d", number);
    return path.substr(0, path.size() - 4) + digits + path.substr(path.size() - 4);
}

} // namespace tsuya::scene

namespace {

using namespace tsuya;

const command::Manual &manual()
{
    static const command::Manual text = {
        "render",
        "SCENE|FILE [key=value ...] -o FILE.png|.exr",
        "Draw a scene of the gallery (tsuya scenes), a scene file, or a groom (.tfx, .hair,\n"
        ".data) or a leaf's mesh (.obj, .ply) in a default scene with a fitted camera.\n"
        "key=value words change the scene; tsuya scenes --help lists the keys. PNG holds what a\n"
        "screen shows, EXR linear light and a channel `hair` or `leaf`, the share of each pixel\n"
        "that is covered.\n\n"
        "Printed: strands, points, strands that reached the picture (touch a pixel and are not\n"
        "behind the head), or triangles and leaves; Rec. 709 luminance of the linear picture,\n"
        "times.",
        {{"-o", "FILE", "picture to write: .png or .exr"},
         {"--size", "WxH", "short for size=WxH"},
         {"--frames", "N", "a turntable of N pictures, numbered before the ending, [1, 9999]"}},
        "  tsuya render straight-brown -o brown.png\n"
        "  tsuya render curly-black model=kajiya_kay --size 1024x1024 -o black.exr\n"
        "  tsuya render mohawk.tfx color=red supersample=4 -o mohawk.png\n"
        "  tsuya render tree-backlit seed=2 leaves=5000 -o tree.png\n"};
    return text;
}

int complain(const std::string &text, int code = command::exit_bad_input)
{
    return scene::render_complaint(text, code == command::exit_bad_input);
}

groom::Expected<scene::Scene> asked(const command::Arguments &arguments, std::string &said)
{
    const std::vector<std::string> &words = arguments.positional();
    groom::Expected<scene::Scene> found = scene::find(words[0]);
    std::vector<std::string> changes(words.begin() + 1, words.end());
    if (arguments.has("--size")) {
        changes.push_back("size=" + arguments.get("--size"));
    }
    if (found) {
        found = scene::override(*found, changes);
    }
    if (found && scene::is_groom(words[0])) {
        const groom::Expected<std::string> suited = scene::suit(*found, changes);
        if (!suited) {
            return groom::Error{suited.error()};
        }
        said = *suited;
    }
    return found;
}

std::string report(const scene::Hair &hair, std::size_t reached, const scene::Numbers &numbers)
{
    char text[512];
    std::snprintf(text, sizeof text,
                  "strands          %zu\n"
                  "points           %zu\n"
                  "strands reached  %zu (%.2f %%)\n"
                  "mean luminance   %.6g\n"
                  "hair luminance   %.6g, weighed by coverage\n"
                  "hair coverage    %.4g\n",
                  hair.report.strands, hair.report.points, reached,
                  100.0 * double(reached) / double(hair.report.strands), numbers.mean,
                  numbers.hair, numbers.coverage);
    return text;
}

int render(const scene::Scene &scene, const std::string &path, int frames, std::string said)
{
    const scene::Clock total;
    const groom::Expected<scene::Material> material = scene::material(scene);
    if (!material) {
        return complain(material.error());
    }
    if (!material->note.empty()) {
        std::fprintf(stderr, "tsuya render: %s.\n", material->note.c_str());
    }
    const groom::Expected<scene::Surroundings> around = scene::surroundings(scene);
    if (!around) {
        return complain(around.error());
    }
    scene::render_progress("reading or growing hair");
    const groom::Expected<scene::Hair> hair = scene::hair(scene);
    if (!hair) {
        return complain(hair.error());
    }
    if (!hair->note.empty()) {
        std::fprintf(stderr, "tsuya render: %s.\n", hair->note.c_str());
    }
    const double hair_time = total.seconds();
    groom::Expected<std::unique_ptr<scene::Studio>> studio = scene::Studio::create();
    if (!studio) {
        return complain(studio.error(), command::exit_failure);
    }
    draw::Renderer &renderer = (*studio)->renderer();
    const groom::Expected<bool> taken = (*studio)->take(*hair, *material);
    if (!taken) {
        return complain(taken.error());
    }

    std::size_t reached = 0;
    float gain = 1.0f;
    scene::Numbers numbers;
    double draw_time = 0.0;
    for (int i = 0; i < frames; i++) {
        scene::render_progress("drawing " + std::to_string(i + 1) + " of " +
                               std::to_string(frames));
        const double turn = 360.0 * double(i) / double(frames);
        const groom::Expected<float> matched =
            scene::match(renderer, scene, *hair, *around, turn, frames > 1);
        if (!matched) {
            return complain(matched.error());
        }
        draw::Frame frame = scene::frame(scene, *hair, *material, turn, frames > 1, *around);
        frame.gain = *matched;
        const scene::Clock one;
        const groom::Expected<bool> drawn = renderer.draw(frame);
        if (!drawn) {
            return complain(drawn.error());
        }
        const draw::Picture picture = renderer.picture();
        draw_time += one.seconds();
        if (!renderer.note().empty() && i == 0) {
            std::fprintf(stderr, "tsuya render: %s.\n", renderer.note().c_str());
        }
        if (i == 0) {
            numbers = scene::numbers(picture);
            gain = frame.gain;
        }
        const groom::Expected<bool> saved =
            scene::save(scene::render_path(path, i + 1, frames), scene, renderer.screen());
        if (!saved) {
            return complain(saved.error(), command::exit_failure);
        }
        if (i == 0) {
            reached = renderer.reached(frame);
        }
    }
    scene::render_progress("");
    if (!renderer.maps().plans().empty()) {
        const tsu_hair_shadow_plan &plan = renderer.maps().plans()[0];
        char text[160];
        std::snprintf(text, sizeof text,
                      "shadow map       %ux%u, %u layers, texel %.4g mm, strand spacing %.4g mm\n",
                      plan.size, plan.size, plan.layers, 1e3 * double(plan.texel),
                      1e3 * double(plan.spacing));
        said += text;
    }
    char times[128];
    std::snprintf(times, sizeof times,
                  "time             %.2f s: hair %.2f, drawing %.2f, %d frame%s\n",
                  total.seconds(), hair_time, draw_time, frames, frames == 1 ? "" : "s");
    if (scene.match != "none") {
        char text[96];
        std::snprintf(text, sizeof text, "matched          %s, light of hair times %.4g\n",
                      scene.match.c_str(), double(gain));
        said += text;
    }
    said += "model            " + scene.model + "\n" + report(*hair, reached, numbers) + times +
            "drawn with       " + (*studio)->description() + "\n";
    return command::print("render", said);
}

} // namespace

int command_render(int argc, char **argv)
{
    command::Arguments arguments;
    std::string error;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain(error);
    }
    if (arguments.help()) {
        return command::print("render", command::help_text(manual()));
    }
    if (arguments.positional().empty()) {
        return complain("no scene is given; tsuya scenes lists them");
    }
    const std::string path = arguments.get("-o");
    if (!scene::savable(path)) {
        return complain(path.empty() ? "-o FILE.png or -o FILE.exr is missing"
                                     : "-o " + path + " must end in .png or .exr");
    }
    double frames = 1.0;
    if (arguments.has("--frames")) {
        const std::string wrong = scene::read_number(arguments.get("--frames"), 1.0, 9999.0,
                                                     frames);
        if (!wrong.empty() || frames != double(int(frames))) {
            return complain("--frames " + (wrong.empty() ? "is " + scene::number_text(frames)
                                                         : wrong) +
                            " but must be whole, in [1, 9999]");
        }
    }
    std::string said;
    const groom::Expected<scene::Scene> scene = asked(arguments, said);
    if (!scene) {
        return complain(scene.error());
    }
    return scene->kind == "hair" ? render(*scene, path, int(frames), said)
                                 : scene::render_surface(*scene, path, int(frames));
}

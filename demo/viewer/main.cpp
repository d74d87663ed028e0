// `tsuya-view`: a scene or a groom in a window, drawn by the renderer of `tsuya render`.

#include "command/arguments.h"
#include "command/commands.h"
#include "scene/gallery.h"
#include "scene/keys.h"
#include "scene/match.h"
#include "scene/picture.h"
#include "viewer/panel.h"
#include "viewer/window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace tsuya;

const command::Manual manual = {
    "view",
    "[SCENE|FILE] [key=value ...]",
    "Show a scene of the gallery, a scene file or a groom in a window; without one, the scene\n"
    "straight-brown. Started as tsuya-view. Keys are those of tsuya scenes --help.",
    {{"--glsl", "DIR", "read the library's GLSL from here (glsl of a checkout), again at F5"},
     {"--draw-glsl", "DIR", "the same for the renderer's own (demo/draw of a checkout)"},
     {"--frames", "N", "close after N frames, [1, 1000000]"},
     {"--screenshot", "FILE", "write the last frame, .png or .exr, on closing"}},
    "  tsuya-view mohawk.tfx\n"
    "  tsuya-view curly-black --glsl glsl --draw-glsl demo/draw\n"};

int complain(const std::string &text, int code = command::exit_bad_input)
{
    return command::complain("view", text + ".", code);
}

// Move the camera by what the pointer did.
void steer(scene::Scene &scene, const viewer::Pointer &pointer, const draw::Frame &frame)
{
    scene.camera_azimuth = std::remainder(scene.camera_azimuth - 0.4 * pointer.orbit_x, 360.0);
    scene.camera_elevation = std::clamp(scene.camera_elevation + 0.4 * pointer.orbit_y, -89.0,
                                        89.0);
    scene.camera_zoom = std::clamp(scene.camera_zoom * std::pow(1.1, pointer.wheel), 0.01, 1000.0);
    if (pointer.pan_x == 0.0 && pointer.pan_y == 0.0) {
        return;
    }
    const glm::mat4 to_world = glm::inverse(frame.view);
    const double pixel = 2.0 * frame.distance /
                         (double(frame.projection[1].y) * double(frame.height));
    if (!scene.camera_aims) {
        scene.camera_target = glm::dvec3(frame.eye) -
                              glm::dvec3(to_world[2]) * double(frame.distance);
        scene.camera_aims = true;
        scene.camera_distance = frame.distance * scene.camera_zoom;
    }
    scene.camera_target += pixel * (-pointer.pan_x * glm::dvec3(to_world[0]) +
                                    pointer.pan_y * glm::dvec3(to_world[1]));
}

class Session
{
  public:
    Session(viewer::Window &window, draw::Renderer &renderer, scene::Scene scene)
        : window_(window), renderer_(renderer), scene_(std::move(scene))
    {
    }

    groom::Expected<bool> grow()
    {
        groom::Expected<scene::Hair> hair = scene::hair(scene_);
        if (!hair) {
            return groom::Error{hair.error()};
        }
        hair_ = std::move(*hair);
        panel_.strands = hair_.report.strands;
        panel_.message = hair_.note;
        drawn_ = false;
        return renderer_.load(hair_.groom, hair_.head, hair_.solid);
    }

    // One frame. Nothing is drawn again while nothing changes.
    groom::Expected<bool> step()
    {
        const viewer::Pointer pointer = window_.begin();
        scene::Scene before = scene_;
        window_.size(scene_.width, scene_.height);
        if (scene_.width < 1 || scene_.height < 1) {
            scene_.width = before.width;
            scene_.height = before.height;
        }
        steer(scene_, pointer, frame_);
        const viewer::Asked asked = panel_.show(scene_);
        if (asked.reload || window_.pressed(GLFW_KEY_F5)) {
            const groom::Expected<bool> read = renderer_.reload();
            panel_.message = read ? "GLSL read again" : read.error();
            drawn_ = false;
        }
        if (asked.grow) {
            const groom::Expected<bool> grown = grow();
            if (!grown) {
                panel_.message = grown.error();
                scene_.hair = before.hair;
            }
        }
        groom::Expected<bool> drawn = true;
        if (!drawn_ || !(scene_ == before)) {
            drawn = draw();
        }
        renderer_.screen().present(float(std::exp2(scene_.exposure)), scene_.tone == "film");
        if (asked.screenshot) {
            const groom::Expected<bool> saved = scene::save(panel_.file, scene_, renderer_.screen());
            panel_.message = saved ? std::string("wrote ") + panel_.file : saved.error();
            renderer_.screen().present(float(std::exp2(scene_.exposure)), scene_.tone == "film");
        }
        window_.end();
        return drawn;
    }

    const scene::Scene &scene() const
    {
        return scene_;
    }

  private:
    groom::Expected<bool> draw()
    {
        const auto start = std::chrono::steady_clock::now();
        const groom::Expected<scene::Material> material = scene::material(scene_);
        if (!material) {
            panel_.message = material.error();
            return true;
        }
        if (!material->note.empty()) {
            panel_.message = material->note;
        }
        const groom::Expected<bool> set = renderer_.material(material->model,
                                                             material->params.data(),
                                                             material->variant);
        if (!set) {
            return set;
        }
        const groom::Expected<scene::Surroundings> around = scene::surroundings(scene_);
        if (!around) {
            return groom::Error{around.error()};
        }
        const groom::Expected<float> gain = scene::match(renderer_, scene_, hair_, *around);
        if (!gain) {
            panel_.message = gain.error();
            return true;
        }
        frame_ = scene::frame(scene_, hair_, *material, 0.0, false, *around);
        frame_.gain = *gain;
        groom::Expected<bool> drawn = renderer_.draw(frame_);
        renderer_.finish();
        drawn_ = true;
        panel_.milliseconds = std::chrono::duration<double, std::milli>(
                                  std::chrono::steady_clock::now() - start).count();
        return drawn;
    }

    viewer::Window &window_;
    draw::Renderer &renderer_;
    scene::Scene scene_;
    scene::Hair hair_;
    draw::Frame frame_;
    viewer::Panel panel_;
    bool drawn_ = false;
};

int run(int argc, char **argv)
{
    command::Arguments arguments;
    std::string error;
    if (!arguments.parse(manual, argc, argv, error)) {
        return complain(error);
    }
    if (arguments.help()) {
        return command::print("view", command::help_text(manual));
    }
    double frames = 0.0;
    if (arguments.has("--frames")) {
        const std::string wrong = scene::read_number(arguments.get("--frames"), 1.0, 1e6, frames);
        if (!wrong.empty()) {
            return complain("--frames " + wrong + " but must be in [1, 1000000]");
        }
    }
    const std::string screenshot = arguments.get("--screenshot");
    if (!screenshot.empty() && !scene::savable(screenshot)) {
        return complain("--screenshot " + screenshot + " must end in .png or .exr");
    }
    std::vector<std::string> words = arguments.positional();
    if (words.empty()) {
        words.push_back("straight-brown");
    }
    groom::Expected<scene::Scene> scene = scene::find(words[0]);
    const std::vector<std::string> changes(words.begin() + 1, words.end());
    if (scene) {
        scene = scene::override(*scene, changes);
    }
    if (scene && scene::is_groom(words[0])) {
        const groom::Expected<std::string> suited = scene::suit(*scene, changes);
        if (!suited) {
            return complain(suited.error());
        }
    }
    if (!scene) {
        return complain(scene.error());
    }

    if (scene->kind != "hair") {
        return complain("the window shows hair alone; tsuya render draws a " + scene->kind);
    }
    groom::Expected<std::unique_ptr<viewer::Window>> window =
        viewer::Window::create(std::max(scene->width, 960), std::max(scene->height, 720));
    if (!window) {
        return complain(window.error(), command::exit_failure);
    }
    const draw::Folders folders = {arguments.get("--glsl"), arguments.get("--draw-glsl")};
    groom::Expected<std::unique_ptr<draw::Renderer>> renderer =
        draw::Renderer::create(viewer::Window::proc, nullptr, folders);
    if (!renderer) {
        return complain(renderer.error(), command::exit_failure);
    }
    Session session(**window, **renderer, *scene);
    groom::Expected<bool> good = session.grow();
    for (double i = 0.0; good && (*window)->open() && (frames == 0.0 || i < frames); i++) {
        good = session.step();
    }
    if (good && !screenshot.empty()) {
        good = scene::save(screenshot, session.scene(), (*renderer)->screen());
    }
    return good ? command::exit_ok : complain(good.error());
}

} // namespace

int main(int argc, char **argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception &failure) {
        return complain(std::string("the machine failed: ") + failure.what(),
                        command::exit_failure);
    }
}

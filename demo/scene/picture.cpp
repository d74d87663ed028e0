#include "scene/picture.h"

#include "gpu/offscreen.h"
#include "image/image.h"

#include <cmath>
#include <utility>

namespace tsuya::scene {

Numbers numbers(const draw::Picture &picture)
{
    double sum = 0.0, hair = 0.0, weight = 0.0;
    const std::size_t count = picture.pixels.size() / 4;
    for (std::size_t i = 0; i < count; i++) {
        const float *p = picture.pixels.data() + 4 * i;
        const double y = 0.2126 * double(p[0]) + 0.7152 * double(p[1]) + 0.0722 * double(p[2]);
        sum += y;
        hair += y * double(p[3]);
        weight += double(p[3]);
    }
    Numbers result;
    result.mean = count ? sum / double(count) : 0.0;
    result.hair = weight > 0.0 ? hair / weight : 0.0;
    result.coverage = count ? weight / double(count) : 0.0;
    return result;
}

Expected<std::unique_ptr<Studio>> Studio::create(const draw::Folders &folders)
{
    std::unique_ptr<Studio> self(new Studio);
    const offscreen_desc desc = {OFFSCREEN_ANY, OFFSCREEN_GL, 3, 3};
    char error[512];
    if (!offscreen_create(&desc, &self->context_, error, sizeof error)) {
        return Error{std::string("there is no OpenGL 3.3: ") + error};
    }
    Expected<std::unique_ptr<draw::Renderer>> renderer =
        draw::Renderer::create(offscreen_proc, self->context_, folders);
    if (!renderer) {
        return Error{renderer.error()};
    }
    self->renderer_ = std::move(*renderer);
    self->folders_ = folders;
    return Expected<std::unique_ptr<Studio>>(std::move(self));
}

Studio::~Studio()
{
    renderer_.reset();
    surfaces_.reset();
    offscreen_destroy(context_);
}

Expected<draw::SurfaceRenderer *> Studio::surfaces()
{
    if (!surfaces_) {
        Expected<std::unique_ptr<draw::SurfaceRenderer>> made =
            draw::SurfaceRenderer::create(offscreen_proc, context_, folders_);
        if (!made) {
            return Error{made.error()};
        }
        surfaces_ = std::move(*made);
    }
    return surfaces_.get();
}

std::string Studio::description() const
{
    return offscreen_description(context_);
}

Expected<bool> Studio::take(const Hair &hair, const Material &material)
{
    Expected<bool> loaded = renderer_->load(hair.groom, hair.head, hair.solid);
    return loaded ? renderer_->material(material.model, material.params.data(), material.variant)
                  : std::move(loaded);
}

namespace {

bool ends(const std::string &path, const char *ending)
{
    const std::string e = ending;
    return path.size() > e.size() && path.compare(path.size() - e.size(), e.size(), e) == 0;
}

} // namespace

bool savable(const std::string &path)
{
    return ends(path, ".png") || ends(path, ".exr");
}

Expected<bool> save(const std::string &path, const Scene &scene, draw::Screen &screen)
{
    std::string error;
    if (ends(path, ".exr")) {
        draw::Picture picture = screen.picture();
        const image::Image image = {picture.width, picture.height, 4, std::move(picture.pixels),
                                    {"R", "G", "B", scene.kind == "hair" ? "hair" : "leaf"}};
        return image::write_exr(path, image, error) ? Expected<bool>(true) : Error{error};
    }
    if (!ends(path, ".png")) {
        return Error{path + " must end in .png or .exr"};
    }
    const draw::Picture shown = screen.shown(float(std::exp2(scene.exposure)),
                                             scene.tone == "film");
    image::Image image = {shown.width, shown.height, 3, {}};
    for (std::size_t i = 0; i < shown.pixels.size(); i += 4) {
        image.pixels.insert(image.pixels.end(), {shown.pixels[i], shown.pixels[i + 1],
                                                 shown.pixels[i + 2]});
    }
    return image::write_png(path, image, error) ? Expected<bool>(true) : Error{error};
}

} // namespace tsuya::scene

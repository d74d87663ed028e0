#include "draw/surface.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <utility>

namespace tsuya::draw {

Expected<std::unique_ptr<SurfaceRenderer>> SurfaceRenderer::create(tsu_gl_proc_fn proc, void *user,
                                                                   const Folders &folders)
{
    std::unique_ptr<SurfaceRenderer> self(new SurfaceRenderer);
    const char *missing = nullptr;
    if (!gl_load(&self->gl_, proc, user, &missing)) {
        return Error{std::string("OpenGL is not complete: ") + (missing ? missing : "unknown")};
    }
    Expected<std::unique_ptr<Guest>> guest = Guest::create(self->gl_, proc, user, folders);
    if (!guest) {
        return Error{guest.error()};
    }
    self->guest_ = std::move(*guest);
    self->screen_ = std::make_unique<Screen>(&self->gl_);
    self->plant_ = std::make_unique<Plant>(&self->gl_);
    self->depths_ = std::make_unique<DepthMaps>(&self->gl_);
    const Expected<bool> built = self->build();
    if (!built) {
        return Error{built.error()};
    }
    self->gl_.GenTextures(1, &self->sky_texture_);
    return Expected<std::unique_ptr<SurfaceRenderer>>(std::move(self));
}

SurfaceRenderer::~SurfaceRenderer()
{
    gl_.DeleteTextures(1, &sky_texture_);
}

Expected<bool> SurfaceRenderer::build()
{
    const std::string &folder = guest_->folders().demo;
    const auto text = [&](const char *name) { return source(folder, name); };
    Expected<Program> depth = link(gl_, {text("surface.vert.glsl")}, {text("depth.frag.glsl")});
    Expected<Program> second = link(gl_, {text("surface.vert.glsl")}, {text("second.frag.glsl")});
    Expected<Program> ground = link(gl_, {text("ground.vert.glsl")},
                                    {text("surface_light.glsl"), text("area_light.glsl"),
                                     text("ground.frag.glsl")});
    Expected<Program> wood = link(gl_, {text("surface.vert.glsl")},
                                  {text("surface_light.glsl"), text("area_light.glsl"),
                                   text("wood.frag.glsl")});
    for (const Expected<Program> *program : {&depth, &second, &wood, &ground}) {
        if (!*program) {
            return Error{program->error()};
        }
    }
    depth_ = std::move(*depth);
    second_ = std::move(*second);
    wood_ = std::move(*wood);
    ground_ = std::move(*ground);
    return screen_->build(folder);
}

void SurfaceRenderer::load(const leaf::Plant &plant)
{
    plant_->load(plant);
    loaded_ = plant;
    glm::vec3 lower(1e30f), upper(-1e30f);
    const auto add = [&](const leaf::Mesh &mesh, const glm::mat4 &place) {
        for (const glm::vec3 &p : mesh.positions) {
            const glm::vec3 q = glm::vec3(place * glm::vec4(p, 1.0f));
            lower = glm::min(lower, q);
            upper = glm::max(upper, q);
        }
    };
    for (const leaf::Placed &leaf : plant.leaves) {
        add(plant.kinds[leaf.kind].blade, leaf.place);
        add(plant.kinds[leaf.kind].stalk, leaf.place);
    }
    add(plant.wood, glm::mat4(1.0f));
    middle_ = 0.5f * (lower + upper);
    radius_ = std::max(0.51f * glm::distance(lower, upper), 1e-6f);
    sky_model_ = glm::mat4(0.0f);
}

namespace {

// Macros between the library's text and surface_shade.glsl: what the model has besides eval and
// sum.
std::string glue(const std::string &name, const std::string &library)
{
    const auto has = [&](const std::string &what) {
        return library.find(what) != std::string::npos;
    };
    std::string text = "\n#define LEAF_SUM " + name + "_sum\n";
    if (has(name + "_bent_eval(")) {
        text += "#define BENT 1\n#define LEAF_EVAL " + name + "_bent_eval\n";
    } else {
        text += "#define LEAF_EVAL " + name + "_eval\n";
    }
    if (has(name + "_ambient(")) {
        text += "#define EVEN 1\n#define LEAF_AMBIENCE " + name + "_ambience\n" +
                "#define LEAF_AMBIENT " + name + "_ambient\n";
        const std::size_t begin = library.find("struct " + name + "_ambience {");
        const std::size_t end = library.find('}', begin);
        const bool gloss = library.substr(begin, end - begin).find("specular") != std::string::npos;
        text += gloss ? "#define GLOSS 1\n" : "";
    }
    return text;
}

} // namespace

Expected<bool> SurfaceRenderer::build(const tsu_model *model, Program &leaf, Program &passes)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    if (!(info.flags & TSU_MODEL_SURFACE)) {
        return Error{std::string("model ") + info.name + " shades no leaves; model=leaf does"};
    }
    const Expected<std::string> library = guest_->text({model}, 0);
    if (!library) {
        return Error{library.error()};
    }
    const std::string macros = glue(std::string("tsu_") + info.name, *library);
    const auto text = [&](const char *name) { return source(guest_->folders().demo, name); };
    Expected<Program> first = link(gl_, {text("surface.vert.glsl")},
                                   {*library, macros, text("surface_shade.glsl"),
                                    text("surface_light.glsl"), text("area_light.glsl"),
                                    text("leaf.frag.glsl")});
    if (!first) {
        return Error{first.error()};
    }
    Expected<Program> second =
        link(gl_, {text("screen.vert.glsl")},
             {*library, macros, text("surface_shade.glsl"), text("passes.frag.glsl")});
    if (!second) {
        return Error{second.error()};
    }
    for (const Expected<Program> *program : {&first, &second}) {
        Expected<bool> bound = guest_->setup(**program);
        if (!bound) {
            return bound;
        }
    }
    leaf = std::move(*first);
    passes = std::move(*second);
    return true;
}

Expected<bool> SurfaceRenderer::material(const tsu_model *model, const void *params)
{
    Expected<bool> good = guest_->check(model, params);
    Program leaf, passes;
    if (good) {
        good = build(model, leaf, passes);
    }
    if (good) {
        good = guest_->material(model, params);
    }
    if (!good) {
        return good;
    }
    leaf_ = std::move(leaf);
    Target pixel(&gl_);
    if (!pixel.resize(1, 1, false)) {
        return Error{"this context cannot draw into a float picture of 1x1"};
    }
    pixel.bind();
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    guest_->bind(passes);
    gl_.BindVertexArray(screen_->empty());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    const std::vector<float> read = pixel.read();
    passes_ = {read[0], read[1], read[2]};
    return true;
}

// The sky in the crown, again only when it or the tree has turned.
void SurfaceRenderer::dim_sky(const SurfaceFrame &frame)
{
    if (sky_ == frame.sky && sky_model_ == frame.model) {
        return;
    }
    const float scale = glm::length(glm::vec3(frame.model[0]));
    leaf_sky_ = leaf_sky(loaded_, frame.sky, glm::mat3(frame.model) / scale);
    sky_ = frame.sky;
    sky_model_ = frame.model;
    if (leaf_sky_.texels.empty()) {
        return;
    }
    const glm::ivec3 size = leaf_sky_.size;
    gl_.ActiveTexture(GL_TEXTURE2);
    gl_.BindTexture(GL_TEXTURE_3D, sky_texture_);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA16F, size.x, size.y, 3 * size.z, 0, GL_RGBA, GL_FLOAT,
                   leaf_sky_.texels.data());
    for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        gl_.TexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
    }
    gl_.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
}

void SurfaceRenderer::use(const Program &program, const SurfaceFrame &frame) const
{
    program.set("u_model", frame.model);
    program.set("u_view_projection", frame.projection * frame.view);
    program.set("u_crown", loaded_.centre);
    program.set("u_crown_half", loaded_.half);
    program.set("u_eye", frame.eye);
    program.set("u_roundness", frame.roundness);
    program.set("u_maps", 1);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, plant_->maps());

    std::vector<glm::vec3> directions, colors;
    std::vector<float> records;
    for (std::size_t i = 0; i < frame.lights.size(); i++) {
        directions.push_back(frame.lights[i].direction);
        colors.push_back(frame.lights[i].irradiance);
        if (i < std::size_t(areas_most)) {
            records.insert(records.end(), frame.lights[i].record.begin(),
                           frame.lights[i].record.end());
        }
    }
    program.set("u_lights", int(directions.size()));
    program.set("u_light_direction", directions);
    program.set("u_light_color", colors);
    program.set("u_areas", int(records.size() / 16));
    if (!records.empty()) {
        gl_.Uniform4fv(gl_.GetUniformLocation(program.id(), "u_area"), GLsizei(records.size() / 4),
                       records.data());
    }
    depths_->bind(program, 3);
    program.set("u_leaf_passes", passes_);

    gl_.Uniform4fv(gl_.GetUniformLocation(program.id(), "u_sky"), 9, frame.sky.data());
    program.set("u_leaf_sky", 2);
    gl_.ActiveTexture(GL_TEXTURE2);
    gl_.BindTexture(GL_TEXTURE_3D, sky_texture_);
    const bool dimmed = !leaf_sky_.texels.empty();
    program.set("u_leaf_sky_slab", dimmed ? float(leaf_sky_.size.z) : 0.0f);
    if (dimmed) {
        const glm::vec3 extent = glm::vec3(leaf_sky_.size) * leaf_sky_.cell;
        program.set("u_to_leaf_sky", glm::scale(glm::mat4(1.0f), 1.0f / extent) *
                                         glm::translate(glm::mat4(1.0f), -leaf_sky_.corner) *
                                         glm::inverse(frame.model));
    }
}

Expected<bool> SurfaceRenderer::draw(const SurfaceFrame &frame)
{
    if (frame.lights.size() > std::size_t(lights_most)) {
        return Error{"a frame must have at most " + std::to_string(lights_most) + " lights"};
    }
    for (std::size_t i = std::size_t(areas_most); i < frame.lights.size(); i++) {
        if (frame.lights[i].record[3] > 0.0f) {
            return Error{"lights with a place or a size must be among the first " +
                         std::to_string(areas_most) + " of a frame"};
        }
    }
    if (!guest_->model()) {
        return Error{"there is no material"};
    }
    Expected<bool> sized = screen_->resize(frame.width, frame.height, frame.supersample);
    if (!sized) {
        return sized;
    }
    const float scale = glm::length(glm::vec3(frame.model[0]));
    const glm::vec3 middle = glm::vec3(frame.model * glm::vec4(middle_, 1.0f));
    if (!depths_->draw(depth_, second_, *plant_, frame, middle, scale * radius_,
                       frame.shadow_size)) {
        return Error{"this context cannot draw shadow maps of " +
                     std::to_string(frame.shadow_size) + " texels"};
    }
    dim_sky(frame);

    screen_->begin();
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_BLEND);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearColor(frame.background.x, frame.background.y, frame.background.z, 0.0f);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    guest_->bind(leaf_);
    use(leaf_, frame);
    plant_->blades();
    gl_.UseProgram(wood_.id());
    use(wood_, frame);
    plant_->wood();
    if (frame.ground && !loaded_.nodes.empty()) {
        ground(frame);
    }
    screen_->resolve();
    return true;
}

void SurfaceRenderer::ground(const SurfaceFrame &frame)
{
    gl_.UseProgram(ground_.id());
    use(ground_, frame);
    const glm::vec3 foot = glm::vec3(frame.model * glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    gl_.Uniform4f(gl_.GetUniformLocation(ground_.id(), "u_ground"), foot.x, foot.y, foot.z,
                  3.5f * radius_ * glm::length(glm::vec3(frame.model[0])));
    ground_.set("u_background", frame.background);
    gl_.BindVertexArray(screen_->empty());
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

} // namespace tsuya::draw

#include "rig.h"

#include "question.h"

#include "draw/program.h"
#include "draw/target.h"
#include "gpu/offscreen.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

namespace {

using namespace tsuya;

// One triangle over the whole picture.
const char vertex[] = R"(
void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);
}
)";

struct {
    offscreen *window = nullptr;
    gl_api gl{};
    tsu_context *context = nullptr;
    tsu_gl *guest = nullptr;
    tsu_set *set = nullptr;
    GLuint array = 0;
    std::unique_ptr<draw::Target> target;
    draw::Program program;
} rig;

void log(void *, int32_t, int32_t, const char *text)
{
    std::fprintf(stderr, "%s\n", text);
}

void need(bool good, const char *what)
{
    if (!good) {
        std::fprintf(stderr, "%s\n", what);
        std::exit(1);
    }
}

std::string hair_macros(const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    const std::string name = std::string("tsu_") + info.name;
    std::string extra;
    for (uint32_t i = 0; i < info.input_count; i++) {
        tsu_input_info input;
        tsu_input_info_init(&input);
        tsu_model_input(model, i, &input);
        if (input.flags == TSU_INPUT_EXTRA) { // not those of variants
            extra += std::string(", ") + input.name;
        }
    }
    const char *shape = std::strcmp(info.name, "kajiya_kay") == 0 ? "cone" : "lobes";
    return "\nuniform float u_alpha_R, u_beta_R;\n#define FIBER tsu_light_" + std::string(shape) +
           "(u_alpha_R, u_beta_R)\n#define HAIR(t, l, v, s) " + name + "_sum(" + name +
           "_eval(0, t, l, v, s" + extra + "))\n";
}

float alpha_R, beta_R_used;

} // namespace

tsu_context *rig_context()
{
    return rig.context;
}

void rig_open()
{
    const offscreen_desc desc = {OFFSCREEN_ANY, OFFSCREEN_GL, 3, 3};
    char error[512];
    need(offscreen_create(&desc, &rig.window, error, sizeof error), error);
    const char *missing = nullptr;
    need(gl_load(&rig.gl, offscreen_proc, rig.window, &missing), "OpenGL is too old");
    tsu_context_desc own;
    tsu_context_desc_init(&own);
    own.log = log;
    need(tsu_context_create(&own, &rig.context) == TSU_OK, "no context");
    tsu_gl_desc guest;
    tsu_gl_desc_init(&guest);
    guest.get_proc_address = offscreen_proc;
    guest.user = rig.window;
    need(tsu_gl_create(rig.context, &guest, &rig.guest) == TSU_OK, "no guest");
    rig.gl.GenVertexArrays(1, &rig.array);
    rig.target = std::make_unique<draw::Target>(&rig.gl);
}

void rig_close()
{
    rig.program = draw::Program();
    rig.target.reset();
    tsu_gl_destroy(rig.guest);
    tsu_set_destroy(rig.set);
    offscreen_destroy(rig.window);
    tsu_context_destroy(rig.context);
}

void rig_model(const tsu_model *model, float beta_R)
{
    tsu_set_destroy(rig.set);
    tsu_set_desc set;
    tsu_set_desc_init(&set);
    need(tsu_set_create(rig.context, &set, &rig.set) == TSU_OK, "no set");
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    std::vector<char> params(info.params_size);
    need(tsu_model_params_init(model, params.data(), params.size()) == TSU_OK, "no parameters");
    for (uint32_t i = 0; i < info.parameter_count; i++) {
        tsu_parameter_info parameter;
        tsu_parameter_info_init(&parameter);
        tsu_model_parameter(model, i, &parameter);
        char *field = params.data() + parameter.offset;
        if (std::strcmp(parameter.name, "beta_R") == 0) {
            if (beta_R > 0.0f) {
                std::memcpy(field, &beta_R, sizeof beta_R);
            }
            std::memcpy(&beta_R_used, field, sizeof beta_R_used);
        } else if (std::strcmp(parameter.name, "alpha_R") == 0) {
            std::memcpy(&alpha_R, field, sizeof alpha_R);
        }
    }
    uint32_t material = 0;
    need(tsu_set_add(rig.set, model, params.data(), &material) == TSU_OK, "no material");
    need(tsu_set_bake(rig.set) == TSU_OK, "no tables");
    tsu_shader_desc desc;
    tsu_shader_desc_init(&desc);
    desc.flags = TSU_SHADER_LIGHTS;
    desc.model_count = 1;
    desc.models = &model;
    tsu_shader *shader = nullptr;
    need(tsu_shader_create(rig.context, &desc, &shader) == TSU_OK, "no text");
    auto program = draw::link(rig.gl, {vertex},
                              {tsu_shader_text(shader, nullptr), hair_macros(model), fragment});
    tsu_shader_destroy(shader);
    need(bool(program), program ? "" : program.error().c_str());
    rig.program = std::move(*program);
    need(tsu_gl_program_setup(rig.guest, rig.program.id(), 0, 0) == TSU_OK, "no setup");
    need(tsu_gl_sync(rig.guest, rig.set) == TSU_OK, "no upload");
}

std::vector<Answer> rig_ask(const Query &query)
{
    need(rig.target->resize(query.width, query.height, false), "no target");
    rig.target->bind();
    rig.gl.UseProgram(rig.program.id());
    need(tsu_gl_bind(rig.guest, 0, 0, 0) == TSU_OK, "no binding");
    float record[16];
    need(tsu_light_pack(rig.context, &query.light, record) == TSU_OK, "the light is refused");
    const auto place = [](const char *name) {
        return rig.gl.GetUniformLocation(rig.program.id(), name);
    };
    rig.gl.Uniform4fv(place("u_record"), 4, record);
    rig.gl.Uniform4fv(place("u_environment"), 9, query.record);
    rig.gl.Uniform3fv(place("u_position"), 1, query.position);
    rig.gl.Uniform3fv(place("u_centre"), 1, query.light.position);
    rig.gl.Uniform3fv(place("u_x"), 1, query.light.x);
    rig.gl.Uniform3fv(place("u_y"), 1, query.light.y);
    rig.gl.Uniform3fv(place("u_color"), 1, query.light.color);
    rig.gl.Uniform3fv(place("u_axis"), 3, query.surroundings.axis[0]);
    float shapes[9] = {};
    for (int k = 0; k < Surroundings::lobes; k++) {
        shapes[3 * k] = query.surroundings.amplitude[k];
        shapes[3 * k + 1] = query.surroundings.sharpness[k];
    }
    rig.gl.Uniform3fv(place("u_shape"), 3, shapes);
    rig.program.set("u_constant", query.surroundings.constant);
    rig.program.set("u_question", int(query.question));
    rig.program.set("u_grid", query.grid);
    rig.program.set("u_white", query.white);
    rig.program.set("u_fault", query.fault);
    rig.program.set("u_seed", query.seed);
    rig.program.set("u_disk", query.light.kind == TSU_LIGHT_DISK ? 1 : 0);
    rig.program.set("u_alpha_R", alpha_R);
    rig.program.set("u_beta_R", beta_R_used);
    rig.gl.BindVertexArray(rig.array);
    rig.gl.DrawArrays(GL_TRIANGLES, 0, 3);
    const std::vector<float> pixels = rig.target->read();
    std::vector<Answer> answers(pixels.size() / 4);
    std::memcpy(answers.data(), pixels.data(), pixels.size() * sizeof(float));
    return answers;
}

tsu_environment rig_project(const Surroundings &surroundings)
{
    tsu_environment_desc desc;
    tsu_environment_desc_init(&desc);
    desc.count = 64 * 128;
    desc.user = const_cast<Surroundings *>(&surroundings);
    desc.radiance = [](void *user, uint32_t index, float d[3], float l[3], float *angle) {
        const Surroundings &s = *static_cast<const Surroundings *>(user);
        const double pi = 3.14159265358979323846;
        const double polar = pi * (index / 128 + 0.5) / 64, turn = 2.0 * pi * (index % 128) / 128;
        d[0] = float(std::sin(polar) * std::cos(turn));
        d[1] = float(std::cos(polar));
        d[2] = float(std::sin(polar) * std::sin(turn));
        *angle = float(std::sin(polar) * pi / 64 * 2.0 * pi / 128);
        l[0] = s.constant;
        for (int k = 0; k < Surroundings::lobes; k++) {
            const float along = d[0] * s.axis[k][0] + d[1] * s.axis[k][1] + d[2] * s.axis[k][2];
            l[0] += s.amplitude[k] * std::exp(s.sharpness[k] * (along - 1.0f));
        }
        l[1] = l[2] = l[0];
    };
    tsu_environment environment;
    tsu_environment_init(&environment);
    need(tsu_environment_make(rig.context, &desc, &environment) == TSU_OK, "no environment");
    return environment;
}

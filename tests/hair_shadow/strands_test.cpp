// Maps against rays on the same strands, in memory and on the GPU.
//
// The truth at a point is the mean over 4 x 4 rays in the square of one strand spacing around it: a
// single ray through opaque fibres is 0 or 1, and no mean can be closer to it than to a coin. That
// error is printed too.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "heads.h"
#include "draw/maps.h"
#include "draw/shading.h"
#include "draw/strands.h"
#include "draw/target.h"
#include "gpu/offscreen.h"

#include <tsuya/tsuya.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

extern "C" {
#include <cmocka.h>
}

namespace {

bool es; // the program's argument is "es"

void log(void *, int32_t, int32_t, const char *text)
{
    std::fprintf(stderr, "%s\n", text);
}

// The same on the GPU: the demo's passes, the library's read function.
struct Gpu {
    offscreen *window = nullptr;
    gl_api gl{};
    std::unique_ptr<draw::Shading> shading;
    std::unique_ptr<draw::Strands> strands;
    std::unique_ptr<draw::Maps> maps;
    std::unique_ptr<draw::Target> target;
    GLuint positions = 0, array = 0;
};

Gpu gpu;

std::string text_of(const tsu_model *technique)
{
    tsu_shader_desc desc;
    tsu_shader_desc_init(&desc);
    desc.target = gpu.gl.es ? TSU_TARGET_300ES : TSU_TARGET_330;
    desc.model_count = 1;
    desc.models = &technique;
    tsu_shader *shader = nullptr;
    assert_int_equal(tsu_shader_create(context, &desc, &shader), TSU_OK);
    const std::string text = tsu_shader_text(shader, nullptr);
    tsu_shader_destroy(shader);
    return text;
}

Answers on_gpu(const glm::vec3 &light, const tsu_model *technique, tsu_format format = 0,
               bool placed = false)
{
    draw::MapsAsked asked;
    asked.technique = technique;
    asked.format = format;
    asked.opacity = 0.5f;
    asked.width_scale = width_scale;
    asked.taper = 0.0f;
    // A first tile in front, so that the one that is read has an origin of its own.
    asked.lights = {glm::vec4(0.0f, 0.0f, 1.0f, 0.0f),
                    placed ? glm::vec4(light, 1.0f) : glm::vec4(glm::normalize(light), 0.0f)};
    const auto programs = gpu.shading->maps(technique);
    assert_true(bool(programs));
    if (!gpu.maps->draw(context, asked, (*programs)->front, (*programs)->layers, *gpu.strands)) {
        fail_msg("%s", gpu.maps->why().c_str());
    }
    const bool from_front = technique == tsu_deep_opacity();
    const groom::Expected<draw::Program> read = draw::link(
        gpu.gl, {draw::source("", "screen.vert.glsl")},
        {text_of(technique),
         "uniform highp sampler2D u_positions, u_map_front, u_map_layers, u_map_deeper;\n"
         "uniform vec4 u_shadow[24];\n"
         "out vec4 o_color;\n"
         "void main()\n"
         "{\n"
         "    vec4 record[12];\n"
         "    for (int i = 0; i < 12; i++)\n"
         "        record[i] = u_shadow[12 + i];\n"
         "    vec3 position = texelFetch(u_positions, ivec2(gl_FragCoord.xy), 0).xyz;\n"
         "    tsu_hair_shadow s = tsu_" +
             std::string(from_front ? "deep_opacity_read8(u_map_front, "
                                    : "opacity_shadow_read8(") +
             "u_map_layers, u_map_deeper, record, position);\n"
             "    o_color = vec4(s.front, s.behind, s.direct, s.transmittance);\n"
             "}\n"});
    if (!read) {
        fail_msg("%s", read.error().c_str());
    }
    gpu.target->bind();
    gpu.gl.UseProgram(read->id());
    gpu.maps->bind(*read, 5, true);
    gpu.gl.ActiveTexture(GL_TEXTURE1);
    gpu.gl.BindTexture(GL_TEXTURE_2D, gpu.positions);
    read->set("u_positions", 1);
    gpu.gl.BindVertexArray(gpu.array);
    gpu.gl.DrawArrays(GL_TRIANGLES, 0, 3);
    Answers turned = gpu.target->read(), answers; // top row first
    for (int y = rows - 1; y >= 0; y--) {
        answers.insert(answers.end(), turned.begin() + 4 * columns * y,
                       turned.begin() + 4 * columns * (y + 1));
    }
    assert_int_equal(gpu.gl.GetError(), GL_NO_ERROR);
    return answers;
}

void take(const Head &head)
{
    assert_true(gpu.strands->load(head.groom));
    gpu.maps->load(head.groom);
    std::vector<float> texels;
    for (const Place &place : head.places) {
        texels.insert(texels.end(), {place.position.x, place.position.y, place.position.z, 0.0f});
    }
    gpu.gl.ActiveTexture(GL_TEXTURE1);
    gpu.gl.BindTexture(GL_TEXTURE_2D, gpu.positions);
    gpu.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, columns, rows, 0, GL_RGBA, GL_FLOAT,
                      texels.data());
    gpu.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gpu.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

// Bounds of the mean absolute errors; 0: printed only.
struct Bound {
    groom::Style style;
    const char *name;
    double deep_opacity;
};

const Bound bounds[] = {{groom::Style::straight, "straight", 0.03},
                        {groom::Style::wavy, "wavy", 0.0},
                        {groom::Style::curly, "curly", 0.0}};

bool everything()
{
    return std::getenv("TSUYA_LONG") != nullptr;
}

// Targets that every context has: half floats, and bytes that are rounded at random.
void narrow_formats(const glm::vec3 &light, const tsu_hair_shadow_plan &plan, const Truth &traced)
{
    const Errors half = errors(on_gpu(light, tsu_deep_opacity(), TSU_FORMAT_RGBA16F), traced);
    const Errors bytes = errors(on_gpu(light, tsu_deep_opacity(), TSU_FORMAT_RGBA8), traced);
    say("straight", 0, "deep_opacity, RGBA16F", plan, half);
    say("straight", 0, "deep_opacity, RGBA8", plan, bytes);
    assert_true(half.direct <= 0.03 && half.half <= 0.03);
    assert_true(bytes.direct <= 0.035 && bytes.half <= 0.04);
}

// The constructors for hosts with their own counts, fed with bad numbers.
void constructors(void **)
{
    const groom::Expected<draw::Program> program = draw::link(
        gpu.gl, {draw::source("", "screen.vert.glsl")},
        {text_of(tsu_deep_opacity()),
         "uniform float u_front, u_behind;\n"
         "uniform int u_how;\n"
         "out vec4 o_color;\n"
         "void main()\n"
         "{\n"
         "    tsu_hair_shadow s = tsu_hair_shadow_none();\n"
         "    if (u_how == 1)\n"
         "        s = tsu_hair_shadow_count(u_front, u_behind);\n"
         "    if (u_how == 2)\n"
         "        s = tsu_hair_shadow_transmittance(u_front);\n"
         "    o_color = vec4(s.front, s.behind, s.direct, s.transmittance);\n"
         "}\n"});
    if (!program) {
        fail_msg("%s", program.error().c_str());
    }
    const float inf = INFINITY, unknown = float(TSU_HAIR_SHADOW_UNKNOWN), e = std::exp(-2.0f);
    const struct {
        int how;
        float front, behind, expected[4];
    } cases[] = {{0, 0, 0, {unknown, 0, 1, 1}},       {1, 2, 3, {2, 3, e, e}},
                 {1, 0, 0, {0, 0, 1, 1}},             {1, -1, -2, {0, 0, 1, 1}},
                 {1, NAN, NAN, {0, 0, 1, 1}},         {1, inf, inf, {unknown, unknown, 0, 0}},
                 {2, e, 0, {2, unknown, e, e}},       {2, 1, 0, {0, unknown, 1, 1}},
                 {2, 7, 0, {0, unknown, 1, 1}},       {2, 0, 0, {69.0776f, unknown, 0, 0}},
                 {2, -1, 0, {69.0776f, unknown, 0, 0}}};
    for (const auto &one : cases) {
        gpu.target->bind();
        gpu.gl.Disable(GL_BLEND);
        gpu.gl.UseProgram(program->id());
        program->set("u_how", one.how);
        program->set("u_front", one.front);
        program->set("u_behind", one.behind);
        gpu.gl.BindVertexArray(gpu.array);
        gpu.gl.DrawArrays(GL_TRIANGLES, 0, 3);
        const Answers answers = gpu.target->read();
        for (int k = 0; k < 4; k++) {
            const double bound = 1e-3 * (1.0 + double(one.expected[k]));
            if (!(std::abs(double(answers[std::size_t(k)] - one.expected[k])) < bound)) {
                fail_msg("how %d, %g, %g: value %d is %g", one.how, double(one.front),
                         double(one.behind), k, double(answers[std::size_t(k)]));
            }
        }
    }
}

// One model twice: the same maps but for the rounding of depth and of edges.
double apart(const Answers &a, const Answers &b)
{
    double sum = 0.0;
    for (std::size_t i = 2; i < a.size(); i += 4) {
        sum += std::abs(double(a[i] - b[i]));
    }
    return sum / double(a.size() / 4);
}

void hold(const Errors &e, double bound)
{
    if (bound > 0.0) {
        assert_true(e.direct <= bound && e.half <= bound);
        // No fibre is lost and none is counted twice.
        assert_true(std::abs(e.front + e.behind) < 1.0);
    }
}

// What else there is, for comparison.
void say_others(const Bound &bound, int l, const Head &head, const glm::vec3 &light,
                const Truth &traced)
{
    const tsu_hair_shadow_plan fixed = make(head, light, tsu_opacity_shadow(), 0, 0.5f);
    const Answers twin = in_memory(head, fixed), drawn = on_gpu(light, tsu_opacity_shadow());
    say(bound.name, l, "opacity_shadow, memory", fixed, errors(twin, traced));
    say(bound.name, l, "opacity_shadow, GPU", fixed, errors(drawn, traced));
    assert_true(apart(twin, drawn) < 0.004);
    const tsu_hair_shadow_plan four = make(head, light, tsu_deep_opacity(), 0, 0.5f, 4.0f);
    say(bound.name, l, "deep_opacity, 4 layers", four, errors(in_memory(head, four), traced));
    draw::Grid grid;
    grid.fill(head.groom, {}, false, width_scale);
    say(bound.name, l, "grid of the demo", fixed, errors(by_grid(head, grid, light), traced));
}

void one_light(const Bound &bound, int l, const Head &head)
{
    const glm::vec3 light = glm::normalize(lights[l]);
    const Caster caster(head.groom, light, width_scale);
    const tsu_hair_shadow_plan plan = make(head, light, tsu_deep_opacity(), 0, 0.5f);
    const Truth traced = truth(head, caster, plan.spacing);
    const Answers twin = in_memory(head, plan), drawn = on_gpu(light, tsu_deep_opacity());
    const Errors cpu = errors(twin, traced), gl = errors(drawn, traced);
    say(bound.name, l, "deep_opacity, memory", plan, cpu);
    say(bound.name, l, "deep_opacity, GPU", plan, gl);
    print_message("         GPU against memory: %.5f\n", apart(twin, drawn));
    hold(cpu, bound.deep_opacity);
    hold(gl, bound.deep_opacity);
    assert_true(apart(twin, drawn) < 0.004);
    if (bound.deep_opacity > 0.0 && l == 0) {
        narrow_formats(light, plan, traced);
    }
    if (l == 0 || everything()) {
        say_others(bound, l, head, light, traced);
    }
}

// Light from a place, also one inside the hair: the strands' own maps are those of the library.
void light_at_a_place(void **)
{
    const Head head = grow(groom::Style::straight);
    take(head);
    const float ways[] = {1.5f, 4.0f, 40.0f, 0.02f}; // radii to the light
    for (float way : ways) {
        const glm::vec3 light = head.centre + way * head.radius * glm::normalize(lights[0]);
        const tsu_hair_shadow_plan plan =
            make(head, light, tsu_deep_opacity(), 0, 0.5f, 8.0f, true);
        const Answers twin = in_memory(head, plan);
        const Answers drawn = on_gpu(light, tsu_deep_opacity(), 0, true);
        const double off = apart(twin, drawn);
        print_message("light %g radii away: GPU against memory %.5f\n", double(way), off);
        assert_true(off < 0.006);
        double dimmed = 0.0;
        for (std::size_t i = 2; i < drawn.size(); i += 4) {
            dimmed += double(drawn[i]) / double(drawn.size() / 4);
        }
        assert_true(dimmed < 0.9);
    }
}

void transmittance_against_rays(void **)
{
    for (const Bound &bound : bounds) {
        if (es && bound.style != groom::Style::straight) {
            continue;
        }
        const Head head = grow(bound.style);
        take(head);
        const bool all = !es && (everything() || bound.deep_opacity > 0.0);
        for (int l = 0; l < (all ? 3 : 1); l++) {
            one_light(bound, l, head);
        }
    }
}

// What the size of the map does: printed, and its worth held.
void error_against_size(void **)
{
    for (const Bound &bound : bounds) {
        const Head head = grow(bound.style);
        const glm::vec3 light = glm::normalize(lights[0]);
        const Caster caster(head.groom, light, width_scale);
        const tsu_hair_shadow_plan chosen = make(head, light, tsu_deep_opacity(), 0, 0.5f);
        const Truth traced = truth(head, caster, chosen.spacing);
        const double good = errors(in_memory(head, chosen), traced).half;
        double worst = 0.0, best = 1.0;
        for (uint32_t size : {16u, 32u, 64u, 128u, 256u, 512u, 1024u}) {
            const tsu_hair_shadow_plan plan = make(head, light, tsu_deep_opacity(), size, 0.5f);
            const Errors e = errors(in_memory(head, plan), traced);
            say(bound.name, 0, "deep_opacity, memory", plan, e);
            worst = std::max(worst, e.half);
            best = std::min(best, e.half);
        }
        print_message("%-8s chosen %u: %.4f, best %.4f, worst %.4f\n", bound.name, chosen.size,
                      good, best, worst);
        assert_true(good < 0.7 * worst && good < 1.6 * best);
    }
}

int open(void **)
{
    const offscreen_desc desc = {OFFSCREEN_ANY, es ? OFFSCREEN_ES : OFFSCREEN_GL, 3, es ? 0 : 3};
    char error[512];
    if (!offscreen_create(&desc, &gpu.window, error, sizeof error)) {
        std::fprintf(stderr, "%s\n", error);
        return 1;
    }
    const char *missing = nullptr;
    tsu_context_desc own;
    tsu_context_desc_init(&own);
    own.log = log;
    if (!gl_load(&gpu.gl, offscreen_proc, gpu.window, &missing) ||
        tsu_context_create(&own, &context) != TSU_OK) {
        return 1;
    }
    auto shading = draw::Shading::create(gpu.gl, offscreen_proc, gpu.window, {});
    if (!shading) {
        return 1;
    }
    gpu.shading = std::move(*shading);
    gpu.strands = std::make_unique<draw::Strands>(&gpu.gl);
    gpu.maps = std::make_unique<draw::Maps>(&gpu.gl);
    gpu.target = std::make_unique<draw::Target>(&gpu.gl);
    gpu.gl.GenTextures(1, &gpu.positions);
    gpu.gl.GenVertexArrays(1, &gpu.array);
    return gpu.target->resize(columns, rows, false) ? 0 : 1;
}

int close(void **)
{
    gpu.gl.DeleteTextures(1, &gpu.positions);
    gpu.gl.DeleteVertexArrays(1, &gpu.array);
    gpu.shading.reset();
    gpu.strands.reset();
    gpu.maps.reset();
    gpu.target.reset();
    offscreen_destroy(gpu.window);
    tsu_context_destroy(context);
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    es = argc > 1 && std::string(argv[1]) == "es";
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constructors),
        cmocka_unit_test(light_at_a_place),
        cmocka_unit_test(transmittance_against_rays),
    };
    const struct CMUnitTest sizes[] = {cmocka_unit_test(error_against_size)};
    const int failed = cmocka_run_group_tests_name("strands", tests, open, close);
    return everything() && !es ? failed + cmocka_run_group_tests_name("sizes", sizes, open, close)
                               : failed;
}

// The GL floor with the library's own sets: what a shader reads is what the set holds, after every
// kind of change; and probes on the GPU answer as the same formulas in C.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "fixture.h"

#include <tsuya/tsuya.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct fixture fixture;
static tsu_context *context;

enum { UNIT = 3, BINDING = 2, GRID = 16 };

// The shader text of a probe with a main that draws GRID x GRID answers: x runs theta_i, y phi.
static GLuint probe_program(const tsu_model *model, uint32_t function)
{
    tsu_shader_desc desc;
    tsu_shader *shader;
    static char text[65536];
    tsu_shader_desc_init(&desc);
    desc.target = fixture.gl.es ? TSU_TARGET_300ES : TSU_TARGET_330;
    desc.flags = TSU_SHADER_PROBE;
    desc.model_count = 1;
    desc.models = &model;
    desc.function = function;
    assert_int_equal(tsu_shader_create(context, &desc, &shader), TSU_OK);
    snprintf(text, sizeof text,
             "%s%s\nuniform float first[16];\nuniform int material;\nin vec2 uv;\nout vec4 o;\n"
             "void main() {\n float x[16]; float y[8];\n"
             " for (int i = 0; i < 16; i++) x[i] = first[i];\n"
             " for (int i = 0; i < 8; i++) y[i] = 0.0;\n"
             " x[0] += 2.4 * (uv.x - 0.5); x[2] += 6.28 * uv.y;\n"
             " tsu_probe(material, x, y);\n o = vec4(y[0], y[1], y[2], y[3]);\n}\n",
             fixture.gl.es ? "#version 300 es\n" : "#version 330 core\n",
             tsu_shader_text(shader, NULL));
    tsu_shader_destroy(shader);
    const GLuint program = fixture_program(&fixture, NULL, text);
    assert_true(program != 0);
    return program;
}

static void compare(tsu_gl *gl, tsu_set *set, uint32_t material,
                    const struct fixture_target *target, GLuint program, uint32_t outputs)
{
    static float pixels[GRID * GRID * 4];
    const double row[9] = {0.1, 0.35, 0.0, 1.5, 0.4, 0.0, 0.0, 0.0};
    float first[16] = {0};
    for (int i = 0; i < 9; i++)
        first[i] = (float)row[i];
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    assert_int_equal(tsu_gl_program_setup(gl, program, UNIT, BINDING), TSU_OK);
    assert_int_equal(tsu_gl_bind(gl, material / TSU_PAGE_MATERIALS, UNIT, BINDING), TSU_OK);
    fixture.gl.UseProgram(program);
    fixture.gl.Uniform1fv(fixture.gl.GetUniformLocation(program, "first"), 16, first);
    fixture.gl.Uniform1i(fixture.gl.GetUniformLocation(program, "material"),
                         (GLint)(material % TSU_PAGE_MATERIALS));
    fixture_draw(&fixture, program, target);
    fixture_read(&fixture, target, pixels);
    double peak = 0.0, error = 0.0;
    for (int y = 0; y < GRID; y++)
        for (int x = 0; x < GRID; x++) {
            double in[9], out[8] = {0};
            memcpy(in, row, sizeof in);
            in[0] += 2.4 * ((x + 0.5) / GRID - 0.5);
            in[2] += 6.28 * ((y + 0.5) / GRID);
            in[3] = 1.5; // material inputs are not read, but checked
            in[6] = in[7] = 0.2;
            assert_int_equal(tsu_set_evaluate(set, material, 0, in, out), TSU_OK);
            for (uint32_t k = 0; k < outputs; k++) {
                peak = fmax(peak, out[k]);
                error = fmax(error, fabs(out[k] - (double)pixels[(y * GRID + x) * 4 + (int)k]));
            }
        }
    if (!(error <= 1e-3 * peak))
        fail_msg("GPU and C differ by %g of the peak", error / peak);
}

// A set, the GL floor and a target of size x size.
static void open_all(int size, tsu_set **set, tsu_gl **gl, struct fixture_target *target)
{
    tsu_set_desc set_desc;
    tsu_gl_desc gl_desc;
    tsu_set_desc_init(&set_desc);
    assert_int_equal(tsu_set_create(context, &set_desc, set), TSU_OK);
    tsu_gl_desc_init(&gl_desc);
    gl_desc.get_proc_address = offscreen_proc;
    gl_desc.user = fixture.context;
    assert_int_equal(tsu_gl_create(context, &gl_desc, gl), TSU_OK);
    assert_true(fixture_target_create(&fixture, target, size, size));
}

static void close_all(tsu_set *set, tsu_gl *gl, struct fixture_target *target)
{
    fixture_target_destroy(&fixture, target);
    tsu_gl_destroy(gl);
    tsu_set_destroy(set);
}

static void follows_every_change(void **state)
{
    (void)state;
    tsu_set_desc set_desc;
    tsu_set *set;
    tsu_gl *gl;
    struct fixture_target target;
    open_all(GRID, &set, &gl, &target);
    const GLuint program = probe_program(tsu_marschner(), 0);
    const GLuint cheap = probe_program(tsu_kajiya_kay(), 0);

    tsu_marschner_params params;
    tsu_marschner_params_init(&params);
    uint32_t materials[6];
    for (int i = 0; i < 6; i++) { // past one and past two cells: the texture grows twice
        params.eta = 1.3f + 0.1f * (float)i;
        assert_int_equal(tsu_set_add(set, tsu_marschner(), &params, materials + i), TSU_OK);
        assert_int_equal(tsu_set_bake(set), TSU_OK);
        for (int k = 0; k <= i; k++)
            compare(gl, set, materials[k], &target, program, 4);
    }
    // Tables anew in a texture of the same size.
    params.eta = 1.45f;
    params.beta_az = 0.3f;
    assert_int_equal(tsu_set_update(set, materials[2], &params, NULL), TSU_OK);
    assert_int_equal(tsu_gl_sync(gl, set), TSU_E_STATE);
    assert_int_equal(tsu_set_bake(set), TSU_OK);
    compare(gl, set, materials[2], &target, program, 4);
    // The record alone.
    params.alpha_R = 0.1f;
    params.beta_R = 0.25f;
    int32_t baked_again = 1;
    assert_int_equal(tsu_set_update(set, materials[2], &params, &baked_again), TSU_OK);
    assert_int_equal(baked_again, 0);
    compare(gl, set, materials[2], &target, program, 4);
    // Another model in the same page; a removed place taken again.
    tsu_kajiya_kay_params kajiya;
    tsu_kajiya_kay_params_init(&kajiya);
    assert_int_equal(tsu_set_remove(set, materials[0]), TSU_OK);
    assert_int_equal(tsu_set_add(set, tsu_kajiya_kay(), &kajiya, materials), TSU_OK);
    compare(gl, set, materials[0], &target, cheap, 2);
    compare(gl, set, materials[5], &target, program, 4);

    // A new set, possibly at the old one's address, with as many changes behind it.
    tsu_set_destroy(set);
    tsu_set_desc_init(&set_desc);
    assert_int_equal(tsu_set_create(context, &set_desc, &set), TSU_OK);
    params.eta = 1.9f;
    assert_int_equal(tsu_set_add(set, tsu_marschner(), &params, materials), TSU_OK);
    assert_int_equal(tsu_set_bake(set), TSU_OK);
    compare(gl, set, materials[0], &target, program, 4);

    close_all(set, gl, &target);
}

// Light or view along the strand, opposite and equal directions, no and much absorption: finite,
// not negative, and no brighter than a lobe can be.
// Values for the inputs beyond the fixed ones, each beginning with a comma: of fibres none in the
// way, all, some; of surfaces within their ranges and, in the second case, beyond.
static void extras_of(const tsu_model *model, int which, char *text, size_t size)
{
    static const char *const fibres[] = {"0.0", "1e6", "2.0"};
    static const char *const direct[] = {"1.0", "0.0", "0.1"};
    // Their directions are in the plane of n and along it.
    static const char *const factors[] = {"1.0", "1e6", "0.0"};
    tsu_input_info input;
    tsu_input_info_init(&input);
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    const int surface = (info.flags & TSU_MODEL_SURFACE) != 0;
    size_t used = 0;
    text[0] = '\0';
    for (uint32_t i = 0; tsu_model_input(model, i, &input) == TSU_OK; i++)
        if (input.flags == TSU_INPUT_EXTRA)
            used += (size_t)snprintf(text + used, size - used, ", %s",
                                     (surface                        ? factors
                                      : strcmp(input.name, "direct") ? fibres
                                                                     : direct)[which]);
}

static void extremes_stay_finite(void **state)
{
    (void)state;
    tsu_set *set;
    tsu_gl *gl;
    struct fixture_target target;
    static char text[65536];
    static float pixels[8 * 8 * 4];
    open_all(8, &set, &gl, &target);
    for (uint32_t m = 0; m < 3 * tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m / 3);
        tsu_model_info info;
        double params[32];
        uint32_t material;
        char extras[64];
        extras_of(model, (int)(m % 3), extras, sizeof extras);
        if (m % 3 && !extras[0])
            continue;
        tsu_model_info_init(&info);
        tsu_model_describe(model, &info);
        tsu_model_params_init(model, params, info.params_size);
        assert_int_equal(tsu_set_add(set, model, params, &material), TSU_OK);
        assert_int_equal(tsu_set_bake(set), TSU_OK);
        tsu_shader_desc desc;
        tsu_shader *shader;
        tsu_shader_desc_init(&desc);
        desc.target = fixture.gl.es ? TSU_TARGET_300ES : TSU_TARGET_330;
        desc.model_count = 1;
        desc.models = &model;
        assert_int_equal(tsu_shader_create(context, &desc, &shader), TSU_OK);
        snprintf(text, sizeof text,
                 "%s%s\nuniform int material;\nin vec2 uv;\nout vec4 o;\n"
                 "vec3 direction(int k) {\n"
                 " if (k < 2) return vec3(0.0, 0.0, k == 0 ? 1.0 : -1.0);\n"
                 " if (k < 4) return vec3(k == 2 ? 1.0 : -1.0, 0.0, 0.0);\n"
                 " if (k == 4) return vec3(0.6, 0.0, 0.8000001);\n"
                 " if (k == 5) return vec3(1e-4, 0.0, 1.0);\n"
                 " if (k == 6) return vec3(0.0, 1e-7, -1.0);\n"
                 " return normalize(vec3(1.0, 2.0, 3.0));\n}\n"
                 "void main() {\n"
                 " int i = int(uv.x * 8.0), k = int(uv.y * 8.0);\n"
                 " vec3 sigma = vec3(0.0, 30.0, 1e6);\n"
                 " o = vec4(tsu_%s_sum(tsu_%s_eval(material, vec3(0.0, 0.0, 1.0), direction(i),\n"
                 "     direction(k)%s%s)), 1.0);\n}\n",
                 fixture.gl.es ? "#version 300 es\n" : "#version 330 core\n",
                 tsu_shader_text(shader, NULL), info.name, info.name,
                 info.flags & TSU_MODEL_SURFACE ? "" : ", sigma", extras);
        tsu_shader_destroy(shader);
        const GLuint program = fixture_program(&fixture, NULL, text);
        assert_true(program != 0);
        assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
        assert_int_equal(tsu_gl_program_setup(gl, program, UNIT, BINDING), TSU_OK);
        assert_int_equal(tsu_gl_bind(gl, 0, UNIT, BINDING), TSU_OK);
        fixture.gl.UseProgram(program);
        fixture.gl.Uniform1i(fixture.gl.GetUniformLocation(program, "material"), (GLint)material);
        fixture_draw(&fixture, program, &target);
        fixture_read(&fixture, &target, pixels);
        for (int i = 0; i < 8 * 8 * 4; i++)
            if (!(isfinite(pixels[i]) && pixels[i] >= -1e-6f && pixels[i] < 100.0f))
                fail_msg("%s: light %d, view %d: %g", info.name, i / 4 % 8, i / 32,
                         (double)pixels[i]);
    }
    close_all(set, gl, &target);
}

int main(int argc, char **argv)
{
    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    if (!fixture_open(&fixture, argc, argv) || tsu_context_create(&desc, &context) != TSU_OK)
        return 1;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(follows_every_change),
        cmocka_unit_test(extremes_stay_finite),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    tsu_context_destroy(context);
    return fixture_close(&fixture) && !failed ? 0 : 1;
}

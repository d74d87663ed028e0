// Lobes left out of the text, on the GPU: what is drawn without them is what the whole text draws,
// less these lobes, and their fields are 0.
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

enum { SIZE = 64, VALUES = SIZE * SIZE * 4, UNIT = 1, BINDING = 2 };

static struct fixture fixture;
static tsu_context *context;
static tsu_set *set;
static tsu_gl *gl;
static struct fixture_target target;

static uint32_t add(const tsu_model *model)
{
    tsu_model_info info;
    double params[32];
    uint32_t material;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    tsu_model_params_init(model, params, info.params_size);
    const uint32_t flags = model == tsu_dual_scattering() ? TSU_DUAL_SCATTERING_ZINKE : 0;
    memcpy((char *)params + offsetof(tsu_dual_scattering_params, flags), &flags, sizeof flags);
    assert_int_equal(tsu_set_add(set, model, params, &material), TSU_OK);
    assert_int_equal(tsu_set_bake(set), TSU_OK);
    assert_int_equal(tsu_gl_sync(gl, set), TSU_OK);
    return material;
}

// `expression` in every pixel, each with directions, absorption and fibres of its own.
static void draw(const tsu_model *model, uint32_t material, uint32_t flags, const char *expression,
                 float *pixels)
{
    static char text[65536];
    tsu_shader_desc desc;
    tsu_shader *shader;
    tsu_shader_desc_init(&desc);
    desc.target = fixture.gl.es ? TSU_TARGET_300ES : TSU_TARGET_330;
    desc.flags = flags;
    desc.model_count = 1;
    desc.models = &model;
    assert_int_equal(tsu_shader_create(context, &desc, &shader), TSU_OK);
    const int length = snprintf(
        text, sizeof text,
        "%s%s\nuniform int material;\nout vec4 o;\n"
        "vec3 direction(float a, float b) {\n"
        " float z = 1.98 * fract(a) - 0.99, s = sqrt(1.0 - z * z);\n"
        " return vec3(s * cos(6.2831853 * b), s * sin(6.2831853 * b), z);\n}\n"
        "void main() {\n float x = gl_FragCoord.x, y = gl_FragCoord.y;\n"
        " vec3 t = vec3(0.0, 0.0, 1.0), n = t;\n"
        " vec3 l = direction(0.618034 * x + 0.123 * y, 0.754878 * y);\n"
        " vec3 v = direction(0.569840 * y, 0.324718 * x + 0.71 * y);\n"
        " vec3 sigma = 2.0 * fract(vec3(0.1, 0.37, 0.93) * x + 0.41 * y);\n"
        " sigma *= sigma;\n"
        " float front = 6.0 * fract(0.271 * x + 0.53 * y), behind = 6.0 * fract(0.41 * x);\n"
        " float direct = exp(-front);\n"
        " o = vec4(%s, 1.0);\n}\n",
        fixture.gl.es ? "#version 300 es\n" : "#version 330 core\n", tsu_shader_text(shader, NULL),
        expression);
    assert_true(length > 0 && (size_t)length < sizeof text);
    tsu_shader_destroy(shader);
    const GLuint program = fixture_program(&fixture, NULL, text);
    assert_true(program != 0);
    assert_int_equal(tsu_gl_program_setup(gl, program, UNIT, BINDING), TSU_OK);
    assert_int_equal(tsu_gl_bind(gl, 0, UNIT, BINDING), TSU_OK);
    fixture.gl.UseProgram(program);
    fixture.gl.Uniform1i(fixture.gl.GetUniformLocation(program, "material"), (GLint)material);
    fixture_draw(&fixture, program, &target);
    fixture_read(&fixture, &target, pixels);
    fixture.gl.UseProgram(0);
    fixture.gl.DeleteProgram(program);
}

static float whole[VALUES], less[VALUES], parts[VALUES];

// |less - (whole - parts)| against `share` of the brightest whole; parts may be NULL.
static void compare(const char *what, const float *from, double share)
{
    double peak = 0.0, error = 0.0;
    for (int i = 0; i < VALUES; i++) {
        if (i % 4 == 3)
            continue;
        assert_true(isfinite(less[i]) && isfinite(whole[i]));
        peak = fmax(peak, (double)whole[i]);
        const double wanted = (double)whole[i] - (from ? (double)from[i] : 0.0);
        error = fmax(error, fabs((double)less[i] - wanted));
    }
    print_message("%s: %.2g of the peak\n", what, error / peak);
    assert_true(peak > 0.0 && error <= share * peak);
}

static double most(const float *pixels)
{
    double peak = 0.0;
    for (int i = 0; i < VALUES; i++)
        peak = i % 4 == 3 ? peak : fmax(peak, fabs((double)pixels[i]));
    return peak;
}

#define FIBER "tsu_marschner_eval(material, t, l, v, sigma)"

static void a_fibre_without_lobes(void **state)
{
    (void)state;
    static const struct {
        uint32_t flags;
        const char *what, *parts, *field;
    } cases[] = {
        {TSU_SHADER_DROP_TRT, "TRT", FIBER ".trt", FIBER ".trt"},
        {TSU_SHADER_DROP_RESIDUAL, "residual", FIBER ".res", FIBER ".res"},
        {TSU_SHADER_DROP_TRT | TSU_SHADER_DROP_RESIDUAL, "TRT and residual",
         FIBER ".trt + " FIBER ".res", FIBER ".trt + " FIBER ".res"},
    };
    const tsu_model *model = tsu_marschner();
    const uint32_t material = add(model);
    for (int i = 0; i < 6; i++) {
        const uint32_t fine = i < 3 ? 0 : TSU_SHADER_FINE, flags = cases[i % 3].flags | fine;
        draw(model, material, fine, "tsu_marschner_sum(" FIBER ")", whole);
        draw(model, material, fine, cases[i % 3].parts, parts);
        draw(model, material, flags, "tsu_marschner_sum(" FIBER ")", less);
        assert_true(most(parts) > 1e-3 * most(whole));
        compare(cases[i % 3].what, parts, 1e-6);
        draw(model, material, flags, cases[i % 3].field, less);
        assert_true(most(less) == 0.0);
    }
}

// Without what comes back, the closed form with nothing on the light's side.
static void hair_without_what_comes_back(void **state)
{
    (void)state;
#define REST "(material, t, l, v, sigma, front, direct)"
#define FINITE "(material, t, l, v, sigma, front, behind, direct)"
#define ON                                                                                         \
    "pow(direct, TSU_RECORD(material, 3).w), 0.0, "                                                \
    "tsu_dual_scattering_near_far(material, t, l, v, front).y)"
    // The second model's functions read the first's tables: the relation holds on any.
    static const struct {
        const char *model, *value, *kept;
    } cases[] = {
        {"dual_scattering", "tsu_dual_scattering_eval" REST ".multiple",
         "tsu_dual_scattering_thick(tsu_dual_scattering_at(material, t, v, sigma), front, " ON},
        {"dual_scattering", "tsu_dual_scattering_finite_eval" FINITE ".multiple",
         "tsu_dual_scattering_finite(tsu_dual_scattering_at(material, t, v, sigma), front, "
         "behind, " ON},
        {"plane_parallel_hair", "tsu_plane_parallel_hair_eval" REST ".multiple",
         "tsu_dual_scattering_thick(tsu_plane_parallel_hair_at(material, t, v, sigma), "
         "tsu_plane_parallel_hair_delayed(front), " ON},
        {"plane_parallel_hair", "tsu_plane_parallel_hair_finite_eval" FINITE ".multiple",
         "tsu_dual_scattering_finite(tsu_plane_parallel_hair_at(material, t, v, sigma), "
         "tsu_plane_parallel_hair_delayed(front), tsu_plane_parallel_hair_delayed(behind), " ON},
    };
    const uint32_t material = add(tsu_dual_scattering());
    for (int i = 0; i < 4; i++) {
        const tsu_model *model = tsu_model_find(cases[i].model);
        draw(model, material, 0, cases[i].value, parts);
        draw(model, material, 0, cases[i].kept, whole);
        draw(model, material, TSU_SHADER_DROP_BACK, cases[i].value, less);
        assert_true(most(whole) < most(parts));
        compare(cases[i].value, NULL, 2e-6);
    }
    // Single scattering loses the fibre's lobes, light from other fibres none.
    const uint32_t lobes = TSU_SHADER_DROP_TRT | TSU_SHADER_DROP_RESIDUAL;
    const tsu_model *model = tsu_dual_scattering();
    draw(model, material, 0, "tsu_dual_scattering_sum(tsu_dual_scattering_eval" REST ")", whole);
    draw(model, material, 0, "direct * (" FIBER ".trt + " FIBER ".res)", parts);
    draw(model, material, lobes, "tsu_dual_scattering_sum(tsu_dual_scattering_eval" REST ")", less);
    compare("single", parts, 1e-6);
    // As published, it is nothing beyond the fibre and something on the light's side.
    draw(model, material, 0, "tsu_dual_scattering_zinke_eval" REST ".multiple", whole);
    draw(model, material, TSU_SHADER_DROP_BACK, "tsu_dual_scattering_zinke_eval" REST ".multiple",
         less);
    draw(model, material, 0, "vec3(dot(l.xy, v.xy))", parts);
    long same = 0, lower = 0;
    for (int i = 0; i < VALUES; i++) {
        if (i % 4 == 3)
            continue;
        assert_true(less[i] >= 0.0f && less[i] <= whole[i] * 1.000002f);
        if (parts[i] < -1e-5f) {
            assert_true(fabsf(less[i] - whole[i]) <= 2e-6f * whole[i]);
            same++;
        } else {
            lower += less[i] < 0.9f * whole[i];
        }
    }
    assert_true(same > 1000 && lower > 1000);
}

static void leaves_that_nothing_comes_through(void **state)
{
    (void)state;
#define LEAF "(material, n, l, v, 1.0, 0.8)"
#define SKY "tsu_leaf_ambient(material, n, v, 1.0, 0.8, vec3(1.0), vec3(0.7))"
    static const struct {
        const char *model, *value, *kept;
    } cases[] = {
        {"leaf_body", "tsu_leaf_body_sum(tsu_leaf_body_eval" LEAF ")",
         "tsu_leaf_body_reflected(tsu_leaf_body_eval" LEAF ")"},
        {"leaf", "tsu_leaf_sum(tsu_leaf_eval" LEAF ")",
         "tsu_leaf_reflected(tsu_leaf_eval" LEAF ") + tsu_leaf_eval" LEAF ".specular"},
        {"leaf_coarse", "tsu_leaf_coarse_sum(tsu_leaf_coarse_eval" LEAF ")",
         "tsu_leaf_coarse_reflected(tsu_leaf_coarse_eval" LEAF ")"},
        {"leaf", SKY ".reflected + " SKY ".transmitted", SKY ".reflected"},
    };
    for (int i = 0; i < 4; i++) {
        const tsu_model *model = tsu_model_find(cases[i].model);
        const uint32_t material = add(model);
        draw(model, material, 0, cases[i].value, parts);
        draw(model, material, 0, cases[i].kept, whole);
        draw(model, material, TSU_SHADER_DROP_TRANSMITTED, cases[i].value, less);
        compare(cases[i].value, NULL, 1e-6);
        double lost = 0.0;
        for (int k = 0; k < VALUES; k++)
            lost = fmax(lost, (double)parts[k] - (double)whole[k]);
        assert_true(lost > 0.0);
    }
}

int main(int argc, char **argv)
{
    tsu_context_desc desc;
    tsu_set_desc set_desc;
    tsu_gl_desc gl_desc;
    tsu_context_desc_init(&desc);
    tsu_set_desc_init(&set_desc);
    tsu_gl_desc_init(&gl_desc);
    if (!fixture_open(&fixture, argc, argv) || tsu_context_create(&desc, &context) != TSU_OK)
        return 1;
    gl_desc.get_proc_address = offscreen_proc;
    gl_desc.user = fixture.context;
    if (tsu_set_create(context, &set_desc, &set) != TSU_OK ||
        tsu_gl_create(context, &gl_desc, &gl) != TSU_OK ||
        !fixture_target_create(&fixture, &target, SIZE, SIZE))
        return 1;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fibre_without_lobes),
        cmocka_unit_test(hair_without_what_comes_back),
        cmocka_unit_test(leaves_that_nothing_comes_through),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    fixture_target_destroy(&fixture, &target);
    tsu_gl_destroy(gl);
    tsu_set_destroy(set);
    tsu_context_destroy(context);
    return fixture_close(&fixture) && !failed ? 0 : 1;
}

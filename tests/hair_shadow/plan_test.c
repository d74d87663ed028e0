// Plans: what is chosen, what is refused.
#include "../base/watch.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tests.h"

static struct watch watch;
static tsu_context *context;
static tsu_hair_shadow_desc desc;
static tsu_hair_shadow_plan plan;

static int open(void **state)
{
    (void)state;
    context = watch_open(&watch);
    assert_int_equal(tsu_hair_shadow_desc_init(&desc), TSU_OK);
    desc.radius = 0.2f;
    desc.length = 2800.0f;
    desc.width = 8e-4f;
    assert_int_equal(tsu_hair_shadow_plan_init(&plan), TSU_OK);
    return 0;
}

static int close(void **state)
{
    (void)state;
    tsu_context_destroy(context);
    watch_close(&watch);
    return 0;
}

static void make(void)
{
    const tsu_status status = tsu_hair_shadow_make(context, &desc, &plan);
    if (status != TSU_OK)
        fail_msg("%s", watch.log);
}

// Refused in one line that names the field and both ends of its range; the plan is zero then.
static void refused(tsu_status status, const char *field, const char *range)
{
    watch_quiet(&watch);
    assert_int_equal(tsu_hair_shadow_make(context, &desc, &plan), status);
    assert_int_equal(watch.log_count, 1);
    assert_int_equal(watch.log_level, TSU_LOG_ERROR);
    if (!strstr(watch.log, field) || !strstr(watch.log, range))
        fail_msg("\"%s\" does not name %s and %s", watch.log, field, range);
    assert_int_equal(plan.size, 0);
    assert_int_equal(plan.struct_size, sizeof plan);
}

static void every_number_has_a_range(void **state)
{
    (void)state;
    const tsu_hair_shadow_desc good = desc;
    const struct {
        const char *name, *range;
        float *field, low, high;
    } floats[] = {{"centre", "[-1e9, 1e9]", desc.centre + 1, -2e9f, 2e9f},
                  {"light", "[-1e9, 1e9]", desc.light + 2, -2e9f, 2e9f},
                  {"radius", "[1e-6, 1e9]", &desc.radius, 0.0f, 2e9f},
                  {"width", "[0, 1e9]", &desc.width, -1.0f, 2e9f},
                  {"length", "[0, 1e12]", &desc.length, -1.0f, 2e12f},
                  {"volume", "[0, 1e30]", &desc.volume, -1.0f, 2e30f},
                  {"spacing", "[0, 1e9]", &desc.spacing, -1.0f, 2e9f}};
    for (size_t i = 0; i < sizeof floats / sizeof *floats; i++) {
        const float bad[] = {NAN, -NAN, INFINITY, -INFINITY, floats[i].low, floats[i].high};
        for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
            *floats[i].field = bad[k];
            refused(TSU_E_PARAMETER, floats[i].name, floats[i].range);
            desc = good;
        }
        make();
    }
    const struct {
        const char *name, *range;
        uint32_t *field, bad;
    } whole[] = {{"size", "[8, 8192]", &desc.size, 7},
                 {"size", "[8, 8192]", &desc.size, 8193},
                 {"least_size", "[8, 512]", &desc.least_size, 7},
                 {"least_size", "[8, 512]", &desc.least_size, 513},
                 {"most_size", "[8, 8192]", &desc.most_size, 0},
                 {"most_size", "[8, 8192]", &desc.most_size, 8193},
                 {"tile_x", "[0, 65535]", &desc.tile_x, 65536},
                 {"tile_y", "[0, 65535]", &desc.tile_y, 65536},
                 {"reserved", "[0, 0]", &desc.reserved[0], 1},
                 {"reserved", "[0, 0]", &desc.reserved[1], 1},
                 {"flags", "TSU_HAIR_SHADOW_*", &desc.flags, 16}};
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++) {
        *whole[i].field = whole[i].bad;
        refused(TSU_E_PARAMETER, whole[i].name, whole[i].range);
        desc = good;
    }
    memset(desc.light, 0, sizeof desc.light);
    refused(TSU_E_PARAMETER, "light", "1e-6");
    desc = good;
    desc.model = tsu_marschner();
    refused(TSU_E_PARAMETER, "marschner", "deep_opacity");
    desc = good;
    desc.struct_size = 0;
    refused(TSU_E_STRUCT, "tsu_hair_shadow_desc", "struct_size");
    desc = good;
}

static void parameters_of_the_technique(void **state)
{
    (void)state;
    for (uint32_t t = 0; t < tsu_hair_shadow_count(); t++) {
        tsu_deep_opacity_params params; // both have this layout
        assert_int_equal(sizeof params, sizeof(tsu_opacity_shadow_params));
        assert_int_equal(tsu_model_params_init(tsu_hair_shadow_at(t), &params, sizeof params),
                         TSU_OK);
        const tsu_deep_opacity_params good = params;
        desc.model = tsu_hair_shadow_at(t);
        desc.params = &params;
        const struct {
            const char *name;
            float *field, low, high;
        } fields[] = {{"opacity", &params.opacity, -0.1f, 1.1f},
                      {"spacings", &params.spacings, 0.0f, 101.0f},
                      {"layers", &params.layers, 0.0f, 9.0f},
                      {"growth", &params.growth, -0.1f, 4.1f}};
        for (size_t i = 0; i < 4; i++)
            for (int k = 0; k < 3; k++) {
                *fields[i].field = k == 0 ? NAN : k == 1 ? fields[i].low : fields[i].high;
                refused(TSU_E_PARAMETER, fields[i].name, "[");
                params = good;
            }
        params.layers = 2.5f;
        refused(TSU_E_PARAMETER, "layers", "whole");
        params = good;
        params.growth = 0.5f;
        refused(TSU_E_PARAMETER, "growth", "0 or [1, 4]");
        params = good;
        make();
        assert_int_equal(plan.layers, 8);
    }
}

static void a_size_from_the_spacing(void **state)
{
    (void)state;
    for (int i = 0; i < 5; i++) {
        desc.length = 300.0f * (float)(1 << i);
        desc.volume = 0.006f;
        make();
        const float spacing = sqrtf(desc.volume / desc.length);
        assert_true(fabsf(plan.spacing - spacing) < 1e-6f);
        // 1.5 spacings a texel, or a little less: sizes are whole.
        assert_true(plan.texel <= 1.5f * spacing * 1.0001f);
        assert_true(plan.texel > 1.5f * spacing * 0.96f);
        // Three texels are outside of the sphere.
        assert_true(fabsf(plan.texel * (float)(plan.size - 3) - 0.4f) < 1e-4f);
    }
    desc.spacing = 0.01f;
    make();
    assert_true(plan.spacing == 0.01f && plan.size == 30);
    desc.spacing = 1e-5f;
    make();
    assert_int_equal(plan.size, 512);
    desc.spacing = 1.0f;
    make();
    assert_int_equal(plan.size, 16);
    desc.size = 77;
    make();
    assert_int_equal(plan.size, 77);
}

static void targets_and_passes(void **state)
{
    (void)state;
    const uint32_t blend[3] = {TSU_HAIR_SHADOW_BLEND_32F, TSU_HAIR_SHADOW_BLEND_16F, 0};
    const tsu_format format[3] = {TSU_FORMAT_RGBA32F, TSU_FORMAT_RGBA16F, TSU_FORMAT_RGBA8};
    for (int layers = 1; layers <= 8; layers++)
        for (int t = 0; t < 2; t++)
            for (int f = 0; f < 3; f++) {
                tsu_deep_opacity_params params;
                desc.model = tsu_hair_shadow_at((uint32_t)t);
                const int front = desc.model == tsu_deep_opacity();
                assert_int_equal(tsu_model_params_init(desc.model, &params, sizeof params), TSU_OK);
                params.layers = (float)layers;
                desc.params = &params;
                desc.flags = blend[f];
                make();
                const uint32_t colors = layers > 4 ? 2 : 1;
                assert_int_equal(plan.target_count, colors + (uint32_t)front);
                assert_int_equal(plan.pass_count, front ? 2 : 1);
                assert_int_equal(plan.layers, layers);
                tsu_hair_shadow_target_info target;
                tsu_hair_shadow_pass_info pass;
                assert_int_equal(tsu_hair_shadow_target_info_init(&target), TSU_OK);
                assert_int_equal(tsu_hair_shadow_pass_info_init(&pass), TSU_OK);
                for (uint32_t i = 0; i < plan.target_count; i++) {
                    assert_int_equal(tsu_hair_shadow_target(&plan, i, &target), TSU_OK);
                    const int depth = front && i == 0;
                    assert_int_equal(target.format, depth ? TSU_FORMAT_DEPTH24 : format[f]);
                    assert_true(target.clear[0] == (depth ? 1.0f : 0.0f));
                    assert_string_equal(target.name, depth                     ? "front"
                                                     : i == (uint32_t)front ? "layers"
                                                                            : "deeper");
                }
                uint32_t drawn = 0;
                for (uint32_t i = 0; i < plan.pass_count; i++) {
                    assert_int_equal(tsu_hair_shadow_pass(&plan, i, &pass), TSU_OK);
                    const int depth = front && i == 0;
                    assert_int_equal(pass.depth_test, depth);
                    assert_int_equal(pass.blend_add, !depth);
                    assert_int_equal(strlen(pass.function) > 0, !depth);
                    assert_int_equal(drawn & pass.targets, 0);
                    drawn |= pass.targets;
                }
                assert_int_equal(drawn, (1u << plan.target_count) - 1);
                assert_int_equal(tsu_hair_shadow_target(&plan, plan.target_count, &target),
                                 TSU_E_PARAMETER);
                assert_int_equal(tsu_hair_shadow_pass(&plan, plan.pass_count, &pass),
                                 TSU_E_PARAMETER);
                // Layers grow, from the front to the far side.
                assert_true(plan.boundary[0] == 0.0f);
                for (int k = 0; k < layers; k++)
                    assert_true(plan.boundary[k + 1] > plan.boundary[k]);
                assert_true(fabsf(plan.boundary[layers] - (plan.far_plane - plan.near_plane)) <
                            1e-6f);
            }
}

static void row(const float *matrix, int r, const float p[3], float *out)
{
    *out = matrix[r] * p[0] + matrix[4 + r] * p[1] + matrix[8 + r] * p[2] + matrix[12 + r];
}

// The matrix puts the whole sphere into clip space, and the record undoes its depth.
static void the_matrix_sees_the_sphere(void **state)
{
    (void)state;
    const float directions[5][3] = {
        {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0.4f, -3, 2}, {-1e-3f, 1e-4f, -1}};
    desc.centre[0] = 3.0f;
    desc.centre[2] = -1.0f;
    for (int i = 0; i < 5; i++)
        for (int point = 0; point < 2; point++)
            for (int zero = 0; zero < 2; zero++) {
                desc.flags = 12u | (point ? TSU_HAIR_SHADOW_POINT : 0u) |
                             (zero ? TSU_HAIR_SHADOW_ZERO_TO_ONE : 0u);
                float length = 0.0f;
                for (int k = 0; k < 3; k++)
                    length += directions[i][k] * directions[i][k];
                for (int k = 0; k < 3; k++)
                    desc.light[k] = point ? desc.centre[k] + directions[i][k] / sqrtf(length)
                                          : directions[i][k];
                make();
                assert_int_equal(plan.flags, 0);
                srand(1);
                for (int n = 0; n < 200; n++) {
                    float p[3], c[4], norm = 0.0f;
                    for (int k = 0; k < 3; k++) {
                        p[k] = (float)rand() / (float)RAND_MAX - 0.5f;
                        norm += p[k] * p[k];
                    }
                    for (int k = 0; k < 3; k++)
                        p[k] = desc.centre[k] + p[k] / sqrtf(norm) * desc.radius;
                    for (int k = 0; k < 4; k++)
                        row(plan.to_light, k, p, c + k);
                    assert_true(c[3] > 0.0f);
                    assert_true(fabsf(c[0]) <= c[3] && fabsf(c[1]) <= c[3]);
                    assert_true(c[2] >= (zero ? 0.0f : -c[3]) && c[2] <= c[3]);
                    const float z = zero ? c[2] / c[3] : 0.5f * c[2] / c[3] + 0.5f;
                    const float *r = plan.record, *s = r + 16;
                    const float stored = (s[0] * z + s[1]) / (s[2] * z + s[3]);
                    const float ahead = r[12] * p[0] + r[13] * p[1] + r[14] * p[2] + r[15];
                    assert_true(fabsf(stored - ahead) < 2e-5f);
                    const float x = (r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3]) / c[3];
                    assert_true(fabsf(x - (0.5f * c[0] / c[3] + 0.5f) * (float)plan.size) < 1e-2f);
                }
            }
}

static void nothing_to_draw(void **state)
{
    (void)state;
    desc.length = 0.0f;
    make();
    assert_int_equal(plan.flags, TSU_HAIR_SHADOW_EMPTY);
    assert_int_equal(plan.size, 16);
    assert_true(plan.spacing == 0.0f);
}

static void a_light_in_the_hair_warns_once(void **state)
{
    (void)state;
    desc.flags |= TSU_HAIR_SHADOW_POINT;
    const float inside[3][3] = {{0, 0, 0}, {0.1f, 0, 0.05f}, {0, 0, 0.2f}};
    for (int i = 0; i < 3; i++) {
        memcpy(desc.light, inside[i], sizeof desc.light);
        watch_quiet(&watch);
        make();
        assert_int_equal(watch.log_count, 1);
        assert_int_equal(watch.log_level, TSU_LOG_WARNING);
        assert_int_equal(plan.flags, TSU_HAIR_SHADOW_PARTIAL);
        for (int k = 0; k < 48; k++)
            assert_true(isfinite(plan.record[k]));
    }
}

static void techniques_are_no_materials(void **state)
{
    (void)state;
    tsu_set_desc set_desc;
    tsu_set *set = NULL;
    assert_int_equal(tsu_set_desc_init(&set_desc), TSU_OK);
    assert_int_equal(tsu_set_create(context, &set_desc, &set), TSU_OK);
    for (uint32_t t = 0; t < tsu_hair_shadow_count(); t++) {
        const tsu_model *model = tsu_hair_shadow_at(t);
        tsu_model_info info;
        tsu_deep_opacity_params params;
        uint32_t material = 9;
        assert_int_equal(tsu_model_info_init(&info), TSU_OK);
        assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
        assert_int_equal(info.flags, TSU_MODEL_SHADOW);
        assert_ptr_equal(tsu_model_find(info.name), model);
        for (uint32_t m = 0; m < tsu_model_count(); m++)
            assert_true(tsu_model_at(m) != model);
        assert_int_equal(tsu_model_params_init(model, &params, sizeof params), TSU_OK);
        watch_quiet(&watch);
        assert_int_equal(tsu_set_add(set, model, &params, &material), TSU_E_PARAMETER);
        assert_non_null(strstr(watch.log, info.name));
        assert_int_equal(material, 0);
    }
    assert_null(tsu_hair_shadow_at(tsu_hair_shadow_count()));
    tsu_set_destroy(set);
}

static void nulls(void **state)
{
    (void)state;
    float map[1], shadow[4], point[3] = {0};
    assert_int_equal(tsu_hair_shadow_make(NULL, &desc, &plan), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_shadow_make(context, NULL, &plan), TSU_E_STRUCT);
    assert_int_equal(tsu_hair_shadow_make(context, &desc, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_shadow_target(NULL, 0, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_shadow_pass(NULL, 0, NULL), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_shadow_floats(NULL), 0);
    assert_int_equal(tsu_hair_shadow_write(NULL, NULL, NULL, 0, map), TSU_E_PARAMETER);
    make();
    assert_int_equal(tsu_hair_shadow_write(&plan, NULL, NULL, 1, map), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_shadow_read(&plan, NULL, point, shadow), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_shadow_read(&plan, map, NULL, shadow), TSU_E_PARAMETER);
    assert_int_equal(tsu_hair_shadow_read(&plan, map, point, NULL), TSU_E_PARAMETER);
}

int plan_tests(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, open, close)
    const struct CMUnitTest tests[] = {
        TEST(every_number_has_a_range),      TEST(parameters_of_the_technique),
        TEST(a_size_from_the_spacing),       TEST(targets_and_passes),
        TEST(the_matrix_sees_the_sphere),    TEST(nothing_to_draw),
        TEST(a_light_in_the_hair_warns_once), TEST(techniques_are_no_materials),
        TEST(nulls),
    };
#undef TEST
    return cmocka_run_group_tests_name("plan", tests, NULL, NULL);
}

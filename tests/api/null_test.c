// NULL everywhere: every public function, each pointer in turn, returns and says so.
#include "ask.h"
#include "tests.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static struct ask a;

#define FAILS(call) assert_true((call) < 0)

static void contexts_and_colours(void **state)
{
    (void)state;
    tsu_context *context = NULL;
    tsu_context_desc desc;
    double rgb[3] = {0.5, 0.5, 0.5};
    FAILS(tsu_context_desc_init_sized(NULL, sizeof desc, TSU_VERSION));
    FAILS(tsu_context_create(NULL, &context));
    assert_null(context);
    assert_int_equal(tsu_context_desc_init(&desc), TSU_OK);
    FAILS(tsu_context_create(&desc, NULL));
    FAILS(tsu_context_create(NULL, NULL));
    tsu_context_destroy(NULL);

    ask_open(&a);
    FAILS(tsu_hair_melanin(a.context, 1, 1, NULL));
    FAILS(tsu_hair_albedo(a.context, 1.5, NULL, rgb));
    FAILS(tsu_hair_albedo(a.context, 1.5, rgb, NULL));
    FAILS(tsu_hair_sigma_a(a.context, 1.5, NULL, rgb));
    FAILS(tsu_hair_sigma_a(a.context, 1.5, rgb, NULL));
    tsu_hair_head_desc head;
    tsu_hair_head_curve curve;
    FAILS(tsu_hair_head_desc_init_sized(NULL, sizeof head));
    assert_int_equal(tsu_hair_head_desc_init(&head), TSU_OK);
    assert_int_equal(tsu_hair_head_curve_init(&curve), TSU_OK);
    FAILS(tsu_hair_head_curve_solve(NULL, &head, &curve));
    FAILS(tsu_hair_head_curve_solve(a.context, NULL, &curve));
    FAILS(tsu_hair_head_curve_solve(a.context, &head, NULL));
    assert_int_equal(tsu_hair_head_curve_solve(a.context, &head, &curve), TSU_OK);
    FAILS(tsu_hair_head_albedo(a.context, NULL, rgb, rgb));
    FAILS(tsu_hair_head_albedo(a.context, &curve, NULL, rgb));
    FAILS(tsu_hair_head_albedo(a.context, &curve, rgb, NULL));
    FAILS(tsu_hair_head_sigma_a(a.context, NULL, rgb, rgb));
    FAILS(tsu_hair_head_sigma_a(a.context, &curve, NULL, rgb));
    FAILS(tsu_hair_head_sigma_a(a.context, &curve, rgb, NULL));
    FAILS(tsu_hair_preset(0, NULL));
    FAILS(tsu_info_init_sized(NULL, 64));
    // Without a context there is no logger; good and bad values still return.
    (void)tsu_hair_melanin(NULL, 1, 1, rgb);
    FAILS(tsu_hair_melanin(NULL, -1, 1, rgb));
    FAILS(tsu_hair_albedo(NULL, 9, rgb, rgb));
    FAILS(tsu_hair_sigma_a(NULL, 9, rgb, rgb));
    FAILS(tsu_hair_head_sigma_a(NULL, &curve, rgb, rgb)); // rgb is 0 by now
    ask_close(&a);
}

static void models(void **state)
{
    (void)state;
    const tsu_model *m = tsu_model_at(0);
    unsigned char params[ASK_PARAMS_MOST];
    double in[TSU_FUNCTION_INPUTS] = {0}, out[TSU_FUNCTION_OUTPUTS];
    tsu_value_info value;
    tsu_value_info_init(&value);
    ask_open(&a);
    assert_null(tsu_model_find(NULL));
    FAILS(tsu_model_describe(NULL, (tsu_model_info *)&value));
    FAILS(tsu_model_describe(m, NULL));
    FAILS(tsu_model_parameter(NULL, 0, (tsu_parameter_info *)&value));
    FAILS(tsu_model_parameter(m, 0, NULL));
    FAILS(tsu_model_table(NULL, 0, (tsu_table_info *)&value));
    FAILS(tsu_model_table(m, 0, NULL));
    FAILS(tsu_model_error(NULL, 0, (tsu_error_info *)&value));
    FAILS(tsu_model_error(m, 0, NULL));
    FAILS(tsu_model_input(NULL, 0, (tsu_input_info *)&value));
    FAILS(tsu_model_input(m, 0, NULL));
    FAILS(tsu_model_function(NULL, 0, (tsu_function_info *)&value));
    FAILS(tsu_model_function(m, 0, NULL));
    FAILS(tsu_function_input(NULL, 0, 0, &value));
    FAILS(tsu_function_input(m, 0, 0, NULL));
    FAILS(tsu_function_output(NULL, 0, 0, &value));
    FAILS(tsu_function_output(m, 0, 0, NULL));
    FAILS(tsu_model_params_init(NULL, params, 64));
    FAILS(tsu_model_params_init(m, NULL, 64));
    assert_int_equal(tsu_model_params_init(m, params, ask_model(m).params_size), TSU_OK);
    FAILS(tsu_model_params_check(NULL, m, params));
    FAILS(tsu_model_params_check(a.context, NULL, params));
    FAILS(tsu_model_params_check(a.context, m, NULL));
    for (uint32_t i = 0; i < 3; i++)
        in[i] = ask_input(m, 0, i).default_value;
    FAILS(tsu_function_params(a.context, NULL, 0, in, params));
    FAILS(tsu_function_params(a.context, m, 0, NULL, params));
    FAILS(tsu_function_reference(a.context, NULL, 0, in, out));
    FAILS(tsu_function_reference(a.context, m, 0, NULL, out));
    FAILS(tsu_function_reference(a.context, m, 0, in, NULL));
    in[0] = 1e9;
    FAILS(tsu_function_params(NULL, m, 0, in, params));
    FAILS(tsu_function_reference(NULL, m, 0, in, out));
    tsu_function_info function;
    tsu_function_info_init(&function);
    assert_int_equal(tsu_model_function(m, 0, &function), TSU_OK);
    for (uint32_t i = 0; i < function.input_count; i++)
        in[i] = ask_input(m, 0, i).default_value;
    FAILS(tsu_function_params(a.context, m, 0, in, NULL));
    ask_close(&a);
}

static void sets(void **state)
{
    (void)state;
    const tsu_model *m = tsu_model_at(0), *model = m;
    unsigned char params[ASK_PARAMS_MOST];
    double in[TSU_FUNCTION_INPUTS] = {0}, out[TSU_FUNCTION_OUTPUTS], value;
    const char *name;
    uint32_t material = 5;
    int32_t again = 5;
    tsu_set *set = NULL;
    tsu_set_desc desc;
    tsu_set_info info;
    tsu_region region;
    ask_open(&a);
    assert_int_equal(tsu_model_params_init(m, params, ask_model(m).params_size), TSU_OK);
    FAILS(tsu_set_desc_init_sized(NULL, sizeof desc));
    tsu_set_desc_init(&desc);
    tsu_set_info_init(&info);
    FAILS(tsu_set_create(NULL, &desc, &set));
    FAILS(tsu_set_create(a.context, NULL, &set));
    FAILS(tsu_set_create(a.context, &desc, NULL));
    assert_null(set);
    tsu_set_destroy(NULL);
    FAILS(tsu_set_add(NULL, m, params, &material));
    FAILS(tsu_set_add(a.set, NULL, params, &material));
    FAILS(tsu_set_add(a.set, m, NULL, &material));
    FAILS(tsu_set_add(a.set, m, params, NULL));
    assert_int_equal(tsu_set_add(a.set, m, params, &material), TSU_OK);
    FAILS(tsu_set_update(NULL, 0, params, &again));
    FAILS(tsu_set_update(a.set, 0, NULL, &again));
    assert_int_equal(tsu_set_update(a.set, 0, params, NULL), TSU_OK);
    FAILS(tsu_set_update(a.set, 1, params, &again));
    FAILS(tsu_set_update(a.set, UINT32_MAX, params, &again));
    FAILS(tsu_set_remove(NULL, 0));
    FAILS(tsu_set_remove(a.set, 1));
    FAILS(tsu_set_bake(NULL));
    FAILS(tsu_set_describe(NULL, &info));
    FAILS(tsu_set_describe(a.set, NULL));
    info.struct_size = 0;
    assert_int_equal(tsu_set_describe(a.set, &info), TSU_E_STRUCT);
    assert_null(tsu_set_texels(NULL));
    assert_int_equal(tsu_set_region(NULL, 0, &region), 0);
    assert_int_equal(tsu_set_region(a.set, 0, NULL), 0);
    assert_int_equal(tsu_set_region(a.set, UINT32_MAX, &region), 0);
    assert_null(tsu_set_page(NULL, 0, NULL));
    assert_non_null(tsu_set_page(a.set, 0, NULL));
    assert_null(tsu_set_page(a.set, UINT32_MAX, NULL));
    assert_null(tsu_set_record(NULL, 0));
    assert_null(tsu_set_record(a.set, UINT32_MAX));
    assert_null(tsu_set_params(NULL, 0, &model));
    assert_null(model);
    assert_non_null(tsu_set_params(a.set, 0, NULL));
    assert_int_equal(tsu_set_evaluate(a.set, 0, 0, in, out), TSU_E_STATE);
    assert_int_equal(tsu_set_measure(a.set, 0, 0, &name, &value), TSU_E_STATE);
    assert_int_equal(tsu_set_bake(a.set), TSU_OK);
    FAILS(tsu_set_evaluate(NULL, 0, 0, in, out));
    FAILS(tsu_set_evaluate(a.set, 0, 0, NULL, out));
    FAILS(tsu_set_evaluate(a.set, 0, 0, in, NULL));
    FAILS(tsu_set_evaluate(a.set, 9, 0, in, out));
    FAILS(tsu_set_measure(NULL, 0, 0, &name, &value));
    FAILS(tsu_set_measure(a.set, 0, 0, NULL, &value));
    FAILS(tsu_set_measure(a.set, 0, 0, &name, NULL));
    FAILS(tsu_set_measure(a.set, 0, UINT32_MAX, &name, &value));
    ask_close(&a);
}

static void set_descriptors(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        uint32_t value;
        tsu_status status;
        const char *word;
    } cases[] = {
        {offsetof(tsu_set_desc, struct_size), 0, TSU_E_STRUCT, "tsu_set_desc"},
        {offsetof(tsu_set_desc, struct_size), 12, TSU_E_STRUCT, "tsu_set_desc"},
        {offsetof(tsu_set_desc, flags), 4, TSU_E_PARAMETER, "flags"},
        {offsetof(tsu_set_desc, max_texture_size), 0, TSU_E_PARAMETER, "[128, 65536]"},
        {offsetof(tsu_set_desc, max_texture_size), 127, TSU_E_PARAMETER, "max_texture_size"},
        {offsetof(tsu_set_desc, max_texture_size), 65537, TSU_E_PARAMETER, "max_texture_size"},
        {offsetof(tsu_set_desc, max_materials), 0, TSU_E_PARAMETER, "[1, 1048576]"},
        {offsetof(tsu_set_desc, max_materials), 1048577, TSU_E_PARAMETER, "max_materials"},
    };
    ask_open(&a);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        tsu_set_desc desc;
        tsu_set *set = (tsu_set *)&a;
        assert_int_equal(tsu_set_desc_init(&desc), TSU_OK);
        memcpy((char *)&desc + cases[i].offset, &cases[i].value, sizeof(uint32_t));
        watch_quiet(&a.watch);
        assert_int_equal(tsu_set_create(a.context, &desc, &set), cases[i].status);
        assert_null(set);
        assert_int_equal(a.watch.log_count, 1);
        assert_non_null(strstr(a.watch.log, cases[i].word));
    }
    ask_close(&a);
}

static void *no_function(void *user, const char *name)
{
    (void)user;
    (void)name;
    return NULL;
}

static void shaders_and_gl(void **state)
{
    (void)state;
    tsu_shader_desc desc;
    tsu_shader *shader = NULL;
    size_t size = 9;
    tsu_gl_desc gl_desc;
    tsu_gl *gl = NULL;
    tsu_gl_bindings_info bindings;
    ask_open(&a);
    FAILS(tsu_shader_desc_init_sized(NULL, sizeof desc));
    tsu_shader_desc_init(&desc);
    FAILS(tsu_shader_create(NULL, &desc, &shader));
    FAILS(tsu_shader_create(a.context, NULL, &shader));
    FAILS(tsu_shader_create(a.context, &desc, NULL));
    assert_null(shader);
    tsu_shader_destroy(NULL);
    assert_null(tsu_shader_text(NULL, &size));
    assert_int_equal(size, 0);
    assert_null(tsu_shader_text(NULL, NULL));
    assert_int_equal(tsu_shader_key(NULL), 0);
    assert_null(tsu_shader_source(NULL, 0));
    assert_int_equal(tsu_target_find(NULL), 0);
    assert_null(tsu_target_version(0));
    assert_null(tsu_target_version(-1));

    FAILS(tsu_gl_desc_init_sized(NULL, sizeof gl_desc));
    assert_int_equal(tsu_gl_desc_init(&gl_desc), TSU_OK);
    assert_int_equal(tsu_gl_bindings_init(&bindings), TSU_OK);
    assert_int_equal(tsu_gl_create(a.context, &gl_desc, &gl), TSU_E_PARAMETER);
    gl_desc.get_proc_address = no_function;
    FAILS(tsu_gl_create(NULL, &gl_desc, &gl));
    FAILS(tsu_gl_create(a.context, NULL, &gl));
    FAILS(tsu_gl_create(a.context, &gl_desc, NULL));
    assert_int_equal(tsu_gl_create(a.context, &gl_desc, &gl), TSU_E_UNSUPPORTED);
    assert_null(gl);
    tsu_gl_destroy(NULL);
    tsu_gl_abandon(NULL);
    FAILS(tsu_gl_sync(NULL, a.set));
    FAILS(tsu_gl_program_setup(NULL, 1, 0, 0));
    FAILS(tsu_gl_bind(NULL, 0, 0, 0));
    FAILS(tsu_gl_bindings(NULL, 0, &bindings));
    ask_close(&a);
}

int null_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contexts_and_colours), cmocka_unit_test(models),
        cmocka_unit_test(sets),                 cmocka_unit_test(set_descriptors),
        cmocka_unit_test(shaders_and_gl),
    };
    return cmocka_run_group_tests_name("null", tests, NULL, NULL);
}

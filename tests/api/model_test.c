// What the models say of themselves holds together; contexts, versions and statuses.
#include "tests.h"
#include "watch.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static struct watch watch;

static void assert_text(const char *text)
{
    assert_non_null(text);
    assert_true(text[0] != 0);
}

static int is_name(const char *text)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz"
                                  "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return text && *text && text[strspn(text, letters)] == 0;
}

static void models_are_found_by_name(void **state)
{
    (void)state;
    assert_true(tsu_model_count() >= 2);
    assert_null(tsu_model_at(tsu_model_count()));
    assert_null(tsu_model_at(UINT32_MAX));
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        tsu_model_info info;
        assert_int_equal(tsu_model_info_init(&info), TSU_OK);
        assert_int_equal(tsu_model_describe(tsu_model_at(m), &info), TSU_OK);
        assert_int_equal(info.struct_size, sizeof info);
        assert_true(is_name(info.name));
        assert_text(info.title);
        assert_text(info.source);
        assert_ptr_equal(tsu_model_find(info.name), tsu_model_at(m)); // so names are unique
        assert_true(info.parameter_count > 0 && info.function_count > 0 && info.error_count > 0);
    }
    assert_null(tsu_model_find("no such model"));
    assert_null(tsu_model_find(""));
    assert_ptr_equal(tsu_model_find("marschner"), tsu_marschner());
    assert_ptr_equal(tsu_model_find("kajiya_kay"), tsu_kajiya_kay());
}

static void parameters_lie_in_their_struct(void **state)
{
    (void)state;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        tsu_model_info info;
        tsu_model_info_init(&info);
        assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
        unsigned char params[512];
        char taken[512] = {0};
        assert_true(info.params_size <= sizeof params);
        assert_int_equal(tsu_model_params_init(model, params, info.params_size), TSU_OK);
        for (uint32_t i = 0; i < info.parameter_count; i++) {
            tsu_parameter_info p, other;
            tsu_parameter_info_init(&p);
            tsu_parameter_info_init(&other);
            assert_int_equal(tsu_model_parameter(model, i, &p), TSU_OK);
            assert_true(is_name(p.name));
            assert_text(p.unit);
            assert_text(p.help);
            assert_true(p.count == 1 || p.count == 3);
            assert_true(p.offset >= 8 && p.offset + 4 * p.count <= info.params_size);
            for (size_t k = p.offset; k < p.offset + 4 * p.count; k++)
                assert_int_equal(taken[k]++, 0); // no two fields overlap
            assert_true(isfinite(p.minimum) && isfinite(p.maximum) && p.minimum < p.maximum);
            assert_true(p.default_value >= p.minimum && p.default_value <= p.maximum);
            assert_true(p.rebakes <= 1 && (info.table_count || !p.rebakes));
            float value[3];
            memcpy(value, params + p.offset, 4 * p.count);
            // A colour's one default stands for three: it must lie among them.
            float least = value[0], most = value[0];
            for (uint32_t k = 0; k < p.count; k++) {
                least = fminf(least, value[k]);
                most = fmaxf(most, value[k]);
                assert_true(value[k] >= (float)p.minimum && value[k] <= (float)p.maximum);
            }
            assert_true((float)p.default_value >= least && (float)p.default_value <= most);
            for (uint32_t k = 0; k < i; k++) {
                assert_int_equal(tsu_model_parameter(model, k, &other), TSU_OK);
                assert_string_not_equal(other.name, p.name);
            }
        }
        tsu_parameter_info past;
        tsu_parameter_info_init(&past);
        assert_int_equal(tsu_model_parameter(model, info.parameter_count, &past), TSU_E_PARAMETER);
    }
}

// `rebakes` is true exactly of the parameters that make a baked set stale.
static void rebakes_is_true(void **state)
{
    (void)state;
    tsu_context *context = watch_open(&watch);
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        tsu_model_info info;
        tsu_model_info_init(&info);
        assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
        for (uint32_t i = 0; i < info.parameter_count; i++) {
            tsu_parameter_info p;
            tsu_parameter_info_init(&p);
            assert_int_equal(tsu_model_parameter(model, i, &p), TSU_OK);
            unsigned char params[512];
            assert_int_equal(tsu_model_params_init(model, params, info.params_size), TSU_OK);
            tsu_set_desc desc;
            tsu_set_desc_init(&desc);
            tsu_set *set;
            uint32_t material;
            assert_int_equal(tsu_set_create(context, &desc, &set), TSU_OK);
            assert_int_equal(tsu_set_add(set, model, params, &material), TSU_OK);
            assert_int_equal(tsu_set_bake(set), TSU_OK);
            const float value = (float)(0.4 * p.minimum + 0.6 * p.maximum);
            for (uint32_t k = 0; k < p.count; k++)
                memcpy(params + p.offset + 4 * k, &value, sizeof value);
            int32_t baked_again = 9;
            assert_int_equal(tsu_set_update(set, material, params, &baked_again), TSU_OK);
            if (baked_again != (int32_t)p.rebakes)
                fail_msg("%s.%s says rebakes %u", info.name, p.name, p.rebakes);
            tsu_set_destroy(set);
        }
    }
    tsu_context_destroy(context);
    watch_close(&watch);
}

static void tables_errors_inputs_and_functions(void **state)
{
    (void)state;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        tsu_model_info info;
        tsu_model_info_init(&info);
        assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
        tsu_table_info table;
        tsu_table_info_init(&table);
        for (uint32_t i = 0; i < info.table_count; i++) {
            assert_int_equal(tsu_model_table(model, i, &table), TSU_OK);
            assert_true(is_name(table.name));
            assert_text(table.axes);
            assert_text(table.channels);
            assert_true(table.width <= TSU_CELL && table.height <= TSU_CELL);
            assert_int_equal(table.bytes, table.width * table.height * 8);
        }
        assert_int_equal(tsu_model_table(model, info.table_count, &table), TSU_E_PARAMETER);
        tsu_error_info error;
        tsu_error_info_init(&error);
        for (uint32_t i = 0; i < info.error_count; i++) {
            assert_int_equal(tsu_model_error(model, i, &error), TSU_OK);
            assert_text(error.name);
            assert_text(error.measure);
            assert_text(error.range);
            assert_true(isfinite(error.value) && error.value >= 0);
        }
        assert_int_equal(tsu_model_error(model, info.error_count, &error), TSU_E_PARAMETER);
        static const char *const of_fiber[] = {"material", "t", "l", "v", "sigma_a"};
        static const char *const of_surface[] = {"material", "n", "l", "v"};
        const int surface = (info.flags & TSU_MODEL_SURFACE) != 0;
        const char *const *first = surface ? of_surface : of_fiber;
        const uint32_t fixed = surface ? 4 : 5;
        tsu_input_info input;
        tsu_input_info_init(&input);
        assert_true(info.input_count >= 5);
        for (uint32_t i = 0; i < info.input_count; i++) {
            assert_int_equal(tsu_model_input(model, i, &input), TSU_OK);
            if (i < fixed)
                assert_string_equal(input.name, first[i]);
            assert_int_equal(input.flags & ~(uint32_t)TSU_INPUT_VARIANT,
                             i < fixed ? 0 : TSU_INPUT_EXTRA);
            assert_text(input.type);
            assert_text(input.help);
        }
        assert_int_equal(tsu_model_input(model, info.input_count, &input), TSU_E_PARAMETER);
        tsu_variant_info variant;
        tsu_variant_info_init(&variant);
        uint32_t taken = 0;
        for (uint32_t i = 0; i < info.variant_count; i++) {
            assert_int_equal(tsu_model_variant(model, i, &variant), TSU_OK);
            assert_text(variant.name);
            assert_text(variant.help);
            assert_int_equal(variant.inputs & ((1u << fixed) - 1), (1u << fixed) - 1);
            taken |= variant.inputs;
        }
        assert_int_equal(tsu_model_variant(model, info.variant_count, &variant), TSU_E_PARAMETER);
        for (uint32_t i = 0; i < info.input_count; i++) {
            assert_int_equal(tsu_model_input(model, i, &input), TSU_OK);
            if (input.flags & TSU_INPUT_VARIANT)
                assert_true(taken >> i & 1);
        }
    }
}

static void values_of_functions(void **state)
{
    (void)state;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        tsu_model_info info;
        tsu_model_info_init(&info);
        assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
        tsu_function_info f;
        tsu_function_info_init(&f);
        for (uint32_t i = 0; i < info.function_count; i++) {
            assert_int_equal(tsu_model_function(model, i, &f), TSU_OK);
            assert_true(is_name(f.name));
            assert_text(f.help);
            assert_true(f.input_count >= 1 && f.input_count <= TSU_FUNCTION_INPUTS);
            assert_true(f.output_count >= 1 && f.output_count <= TSU_FUNCTION_OUTPUTS);
            const char *names[TSU_FUNCTION_INPUTS + TSU_FUNCTION_OUTPUTS];
            for (uint32_t k = 0; k < f.input_count + f.output_count; k++) {
                tsu_value_info v;
                tsu_value_info_init(&v);
                if (k < f.input_count) {
                    assert_int_equal(tsu_function_input(model, i, k, &v), TSU_OK);
                    assert_true(v.minimum < v.maximum);
                    assert_true(v.default_value >= v.minimum && v.default_value <= v.maximum);
                } else {
                    assert_int_equal(tsu_function_output(model, i, k - f.input_count, &v), TSU_OK);
                }
                assert_true(is_name(v.name));
                assert_text(v.unit);
                assert_text(v.help);
                names[k] = v.name; // static: lives as long as the library
                for (uint32_t j = 0; j < k; j++)
                    assert_string_not_equal(names[j], names[k]);
            }
            tsu_value_info v;
            tsu_value_info_init(&v);
            assert_int_equal(tsu_function_input(model, i, f.input_count, &v), TSU_E_PARAMETER);
            assert_int_equal(tsu_function_output(model, i, f.output_count, &v), TSU_E_PARAMETER);
        }
        tsu_value_info v;
        tsu_value_info_init(&v);
        assert_int_equal(tsu_model_function(model, info.function_count, &f), TSU_E_PARAMETER);
        assert_int_equal(tsu_function_input(model, info.function_count, 0, &v), TSU_E_PARAMETER);
        assert_int_equal(tsu_function_output(model, info.function_count, 0, &v), TSU_E_PARAMETER);
    }
}

static void contexts_check_their_descriptor(void **state)
{
    (void)state;
    watch_begin(&watch);
    const tsu_context_desc good = watch_desc(&watch);
    assert_int_equal(good.struct_size, sizeof good);
    assert_int_equal(good.version, TSU_VERSION);
    assert_int_equal(tsu_version(), TSU_VERSION);
    static const struct {
        size_t offset;
        uint32_t value;
        tsu_status status;
        const char *word;
    } cases[] = {
        {offsetof(tsu_context_desc, struct_size), 0, TSU_E_STRUCT, "NULL"},
        {offsetof(tsu_context_desc, struct_size), sizeof good - 1, TSU_E_STRUCT, "struct_size"},
        {offsetof(tsu_context_desc, flags), 1, TSU_E_PARAMETER, "flags"},
        {offsetof(tsu_context_desc, reserved), 1, TSU_E_PARAMETER, "tsu_context_desc"},
        {offsetof(tsu_context_desc, version), TSU_VERSION + (1u << 22), TSU_E_VERSION, "version"},
        {offsetof(tsu_context_desc, version), 1023u << 22, TSU_E_VERSION, "version"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        tsu_context_desc desc = good;
        memcpy((char *)&desc + cases[i].offset, &cases[i].value, sizeof(uint32_t));
        tsu_context *context = (tsu_context *)&watch;
        watch_quiet(&watch);
        assert_int_equal(tsu_context_create(&desc, &context), cases[i].status);
        assert_null(context);
        // Where struct_size does not vouch for the logger, silence is right.
        assert_int_equal(watch.log_count, i == 0 ? 0 : 1);
        if (i > 0)
            assert_non_null(strstr(watch.log, cases[i].word));
        assert_int_equal(watch.live, 0);
    }
    tsu_context_desc desc = good;
    desc.version = TSU_VERSION + 5; // a later patch of this major
    tsu_context *context = NULL;
    assert_int_equal(tsu_context_create(&desc, &context), TSU_OK);
    tsu_context_destroy(context);
    assert_int_equal(tsu_context_desc_init_sized(&desc, 79, TSU_VERSION), TSU_E_STRUCT);
    watch_close(&watch);
}

static void statuses_have_names(void **state)
{
    (void)state;
    static const char *const names[] = {
        "TSU_OK",      "TSU_E_PARAMETER",   "TSU_E_STRUCT", "TSU_E_VERSION", "TSU_E_MEMORY",
        "TSU_E_LIMIT", "TSU_E_UNSUPPORTED", "TSU_E_STATE",  "TSU_E_HOST"};
    for (tsu_status s = 0; s >= -8; s--)
        assert_string_equal(tsu_status_text(s), names[-s]);
    const tsu_status others[] = {1, -9, INT32_MAX, INT32_MIN};
    for (int i = 0; i < 4; i++)
        assert_string_equal(tsu_status_text(others[i]), "unknown status");
    assert_int_equal(TSU_E_HOST, -8);
}

int model_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_are_found_by_name),
        cmocka_unit_test(parameters_lie_in_their_struct),
        cmocka_unit_test(rebakes_is_true),
        cmocka_unit_test(tables_errors_inputs_and_functions),
        cmocka_unit_test(values_of_functions),
        cmocka_unit_test(contexts_check_their_descriptor),
        cmocka_unit_test(statuses_have_names),
    };
    return cmocka_run_group_tests_name("model", tests, NULL, NULL);
}

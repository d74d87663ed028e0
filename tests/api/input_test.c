// Inputs of every function of every model against their ranges; no model is named here.
#include "ask.h"
#include "tests.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct ask a;

static void bad_input(const tsu_model *model, uint32_t function, double *in, uint32_t index,
                      double value)
{
    const tsu_value_info info = ask_input(model, function, index);
    const double good = in[index];
    unsigned char params[ASK_PARAMS_MOST], before[ASK_PARAMS_MOST];
    const size_t size = ask_model(model).params_size;
    assert_int_equal(tsu_model_params_init(model, params, size), TSU_OK);
    memcpy(before, params, size);
    double out[TSU_FUNCTION_OUTPUTS];
    for (int i = 0; i < TSU_FUNCTION_OUTPUTS; i++)
        out[i] = 77.0;
    in[index] = value;

    watch_quiet(&a.watch);
    assert_int_equal(tsu_function_params(a.context, model, function, in, params), TSU_E_PARAMETER);
    ask_log(&a.watch, info.name, info.minimum, info.maximum);
    assert_memory_equal(params, before, size);
    watch_quiet(&a.watch);
    assert_int_equal(tsu_function_reference(a.context, model, function, in, out), TSU_E_PARAMETER);
    ask_log(&a.watch, info.name, info.minimum, info.maximum);
    watch_quiet(&a.watch);
    assert_int_equal(tsu_set_evaluate(a.set, 0, function, in, out), TSU_E_PARAMETER);
    ask_log(&a.watch, info.name, info.minimum, info.maximum);
    in[index] = good;
}

static void every_input_has_a_range(void **state)
{
    (void)state;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        const tsu_model_info info = ask_model(model);
        unsigned char params[ASK_PARAMS_MOST];
        uint32_t material;
        ask_open(&a);
        assert_int_equal(tsu_model_params_init(model, params, info.params_size), TSU_OK);
        assert_int_equal(tsu_set_add(a.set, model, params, &material), TSU_OK);
        assert_int_equal(tsu_set_bake(a.set), TSU_OK);
        for (uint32_t f = 0; f < info.function_count; f++) {
            tsu_function_info function;
            assert_int_equal(tsu_function_info_init(&function), TSU_OK);
            assert_int_equal(tsu_model_function(model, f, &function), TSU_OK);
            double in[TSU_FUNCTION_INPUTS] = {0};
            for (uint32_t i = 0; i < function.input_count; i++)
                in[i] = ask_input(model, f, i).default_value;
            double out[TSU_FUNCTION_OUTPUTS];
            assert_int_equal(tsu_function_params(a.context, model, f, in, params), TSU_OK);
            assert_int_equal(tsu_set_update(a.set, 0, params, NULL), TSU_OK);
            assert_int_equal(tsu_set_bake(a.set), TSU_OK);
            assert_int_equal(tsu_function_reference(a.context, model, f, in, out), TSU_OK);
            for (uint32_t i = 0; i < function.output_count; i++)
                assert_true(isfinite(out[i]));
            const int sampled = !(function.flags & TSU_FUNCTION_REFERENCE_ONLY);
            assert_int_equal(tsu_set_evaluate(a.set, 0, f, in, out),
                             sampled ? TSU_OK : TSU_E_UNSUPPORTED);
            for (uint32_t i = 0; sampled && i < function.output_count; i++)
                assert_true(isfinite(out[i]));
            for (uint32_t i = 0; i < function.input_count; i++) {
                const tsu_value_info v = ask_input(model, f, i);
                const double step = 1e-3 * (v.maximum - v.minimum);
                const double values[] = {NAN, INFINITY, -INFINITY, v.minimum - step,
                                         v.maximum + step, 1e300, -1e300};
                for (size_t k = 0; k < sizeof values / sizeof *values; k++)
                    bad_input(model, f, in, i, values[k]);
            }
            assert_int_equal(tsu_function_reference(a.context, model, info.function_count, in, out),
                             TSU_E_PARAMETER);
            assert_int_equal(tsu_set_evaluate(a.set, 0, info.function_count, in, out),
                             TSU_E_PARAMETER);
        }
        ask_close(&a);
    }
}

// Function inputs that belong to the material come out of tsu_function_params() in its fields.
static void material_inputs_reach_the_parameters(void **state)
{
    (void)state;
    ask_open(&a);
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        const tsu_model_info info = ask_model(model);
        for (uint32_t f = 0; f < info.function_count; f++) {
            tsu_function_info function;
            tsu_function_info_init(&function);
            assert_int_equal(tsu_model_function(model, f, &function), TSU_OK);
            double in[TSU_FUNCTION_INPUTS] = {0};
            for (uint32_t i = 0; i < function.input_count; i++) {
                const tsu_value_info v = ask_input(model, f, i);
                // A word stands for a whole material and would hide the others.
                const int number = v.flags & TSU_VALUE_MATERIAL && !strchr(v.unit, '|');
                in[i] = number ? 0.7 * v.minimum + 0.3 * v.maximum : v.default_value;
            }
            unsigned char params[ASK_PARAMS_MOST];
            assert_int_equal(tsu_model_params_init(model, params, info.params_size), TSU_OK);
            assert_int_equal(tsu_function_params(a.context, model, f, in, params), TSU_OK);
            for (uint32_t i = 0; i < function.input_count; i++)
                for (uint32_t p = 0; p < info.parameter_count; p++) {
                    const tsu_parameter_info field = ask_parameter(model, p);
                    float value;
                    memcpy(&value, params + field.offset, sizeof value);
                    if (ask_input(model, f, i).flags & TSU_VALUE_MATERIAL &&
                        strcmp(field.name, ask_input(model, f, i).name) == 0)
                        assert_true(value == (float)in[i]);
                }
        }
    }
    ask_close(&a);
}

// base.h: after a failure every result is zeroed.
static void a_failed_question_zeroes_its_answer(void **state)
{
    (void)state;
    ask_open(&a);
    const tsu_model *model = tsu_model_at(0);
    unsigned char params[ASK_PARAMS_MOST];
    uint32_t material;
    assert_int_equal(tsu_model_params_init(model, params, ask_model(model).params_size), TSU_OK);
    assert_int_equal(tsu_set_add(a.set, model, params, &material), TSU_OK);
    assert_int_equal(tsu_set_bake(a.set), TSU_OK);
    tsu_function_info function;
    tsu_function_info_init(&function);
    assert_int_equal(tsu_model_function(model, 0, &function), TSU_OK);
    double in[TSU_FUNCTION_INPUTS], out[2][TSU_FUNCTION_OUTPUTS];
    for (int i = 0; i < TSU_FUNCTION_INPUTS; i++)
        in[i] = NAN;
    for (int i = 0; i < TSU_FUNCTION_OUTPUTS; i++)
        out[0][i] = out[1][i] = 77.0;
    assert_true(tsu_function_reference(a.context, model, 0, in, out[0]) < 0);
    assert_true(tsu_set_evaluate(a.set, 0, 0, in, out[1]) < 0);
    ask_close(&a);
    for (uint32_t i = 0; i < function.output_count; i++) {
        assert_true(out[0][i] == 0.0);
        assert_true(out[1][i] == 0.0);
    }
}

// The same of descriptions: nothing of an earlier answer may pass for this one.
static void a_failed_description_is_zeroed(void **state)
{
    (void)state;
    union {
        tsu_parameter_info parameter;
        tsu_table_info table;
        tsu_error_info error;
        tsu_input_info input;
        tsu_function_info function;
        tsu_value_info value;
        tsu_hair_preset_info preset;
        unsigned char bytes[128];
    } u;
    static const unsigned char zeros[sizeof u];
    const tsu_model *model = tsu_model_at(0);
    for (int i = 0; i < 8; i++) {
        memset(&u, 0x5a, sizeof u);
        u.value.struct_size = 32; // every info struct has this much
        const uint32_t past = UINT32_MAX;
        const tsu_status status = i == 0   ? tsu_model_parameter(model, past, &u.parameter)
                                  : i == 1 ? tsu_model_table(model, past, &u.table)
                                  : i == 2 ? tsu_model_error(model, past, &u.error)
                                  : i == 3 ? tsu_model_input(model, past, &u.input)
                                  : i == 4 ? tsu_model_function(model, past, &u.function)
                                  : i == 5 ? tsu_function_input(model, past, 0, &u.value)
                                  : i == 6 ? tsu_function_output(model, 0, past, &u.value)
                                           : tsu_hair_preset(past, &u.preset);
        assert_int_equal(status, TSU_E_PARAMETER);
        assert_int_equal(u.value.struct_size, 32);
        assert_memory_equal(u.bytes + 4, zeros, 32 - 4);
    }
}

int input_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_input_has_a_range),
        cmocka_unit_test(material_inputs_reach_the_parameters),
        cmocka_unit_test(a_failed_question_zeroes_its_answer),
        cmocka_unit_test(a_failed_description_is_zeroed),
    };
    return cmocka_run_group_tests_name("input", tests, NULL, NULL);
}

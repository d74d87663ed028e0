// Parameters of every model against their schema; no model is named here.
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

static void refused(const tsu_model *model, const tsu_parameter_info *info, unsigned char *params,
                    uint32_t component, float value)
{
    unsigned char before[ASK_PARAMS_MOST];
    const size_t size = ask_model(model).params_size;
    float good;
    memcpy(&good, params + info->offset + component * sizeof good, sizeof good);
    memcpy(params + info->offset + component * sizeof value, &value, sizeof value);
    memcpy(before, params, size);

    watch_quiet(&a.watch);
    assert_int_equal(tsu_model_params_check(a.context, model, params), TSU_E_PARAMETER);
    ask_log(&a.watch, info->name, info->minimum, info->maximum);
    watch_quiet(&a.watch);
    uint32_t material = 99;
    assert_int_equal(tsu_set_add(a.set, model, params, &material), TSU_E_PARAMETER);
    assert_int_equal(material, 0);
    ask_log(&a.watch, info->name, info->minimum, info->maximum);
    assert_memory_equal(before, params, size);

    // Material 0 of the set is this model with its defaults, and stays it.
    unsigned char defaults[ASK_PARAMS_MOST];
    assert_int_equal(tsu_model_params_init(model, defaults, size), TSU_OK);
    watch_quiet(&a.watch);
    assert_int_equal(tsu_set_update(a.set, 0, params, NULL), TSU_E_PARAMETER);
    ask_log(&a.watch, info->name, info->minimum, info->maximum);
    assert_memory_equal(tsu_set_params(a.set, 0, NULL), defaults, size);

    memcpy(params + info->offset + component * sizeof good, &good, sizeof good);
    assert_int_equal(tsu_model_params_check(a.context, model, params), TSU_OK);
}

static void every_field_has_a_range(void **state)
{
    (void)state;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        const tsu_model_info info = ask_model(model);
        unsigned char params[ASK_PARAMS_MOST];
        ask_open(&a);
        assert_int_equal(tsu_model_params_init(model, params, info.params_size), TSU_OK);
        uint32_t material;
        assert_int_equal(tsu_set_add(a.set, model, params, &material), TSU_OK);
        assert_int_equal(material, 0);
        for (uint32_t i = 0; i < info.parameter_count; i++) {
            const tsu_parameter_info p = ask_parameter(model, i);
            const double step = 1e-3 * (p.maximum - p.minimum);
            for (uint32_t k = 0; k < p.count; k++) {
                refused(model, &p, params, k, NAN);
                refused(model, &p, params, k, -NAN);
                refused(model, &p, params, k, INFINITY);
                refused(model, &p, params, k, -INFINITY);
                refused(model, &p, params, k, (float)(p.minimum - step));
                refused(model, &p, params, k, (float)(p.maximum + step));
                refused(model, &p, params, k, 3e38f);
                refused(model, &p, params, k, -3e38f);
                // Both ends belong to the range.
                const float ends[2] = {(float)p.minimum, (float)p.maximum};
                float good;
                memcpy(&good, params + p.offset + k * sizeof good, sizeof good);
                for (int e = 0; e < 2; e++) {
                    memcpy(params + p.offset + k * sizeof good, ends + e, sizeof good);
                    assert_int_equal(tsu_model_params_check(a.context, model, params), TSU_OK);
                }
                memcpy(params + p.offset + k * sizeof good, &good, sizeof good);
            }
        }
        ask_close(&a);
    }
}

static void sizes_and_flags_of_parameters(void **state)
{
    (void)state;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        const uint32_t size = (uint32_t)ask_model(model).params_size;
        unsigned char params[ASK_PARAMS_MOST] = {0};
        uint32_t material;
        ask_open(&a);
        assert_int_equal(tsu_model_params_init(model, params, size), TSU_OK);
        for (int i = 0; i < 3; i++) {
            const uint32_t wrong[3] = {0, 4, size - 4};
            memcpy(params, wrong + i, sizeof *wrong);
            watch_quiet(&a.watch);
            assert_int_equal(tsu_model_params_check(a.context, model, params), TSU_E_STRUCT);
            assert_non_null(strstr(a.watch.log, ask_model(model).name));
            assert_non_null(strstr(a.watch.log, "struct_size"));
            assert_int_equal(tsu_set_add(a.set, model, params, &material), TSU_E_STRUCT);
        }
        const uint32_t larger = size + 8;
        memcpy(params, &larger, sizeof larger);
        assert_int_equal(tsu_model_params_check(a.context, model, params), TSU_OK);
        params[size + 5] = 1;
        watch_quiet(&a.watch);
        assert_int_equal(tsu_model_params_check(a.context, model, params), TSU_E_STRUCT);
        assert_int_equal(a.watch.log_count, 1);
        assert_int_equal(tsu_model_params_init(model, params, size), TSU_OK);
        const uint32_t flags = 0x80000000u;
        memcpy(params + 4, &flags, sizeof flags);
        watch_quiet(&a.watch);
        assert_int_equal(tsu_model_params_check(a.context, model, params), TSU_E_PARAMETER);
        assert_non_null(strstr(a.watch.log, "flags"));
        assert_int_equal(tsu_set_add(a.set, model, params, &material), TSU_E_PARAMETER);
        assert_true(tsu_model_params_init(model, params, size - 4) == TSU_E_STRUCT);
        assert_true(tsu_model_params_init(model, params, 0) == TSU_E_STRUCT);
        ask_close(&a);
    }
}

int schema_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_field_has_a_range),
        cmocka_unit_test(sizes_and_flags_of_parameters),
    };
    return cmocka_run_group_tests_name("schema", tests, NULL, NULL);
}

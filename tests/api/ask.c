#include "ask.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

void ask_open(struct ask *a)
{
    a->context = watch_open(&a->watch);
    tsu_set_desc desc;
    assert_int_equal(tsu_set_desc_init(&desc), TSU_OK);
    assert_int_equal(tsu_set_create(a->context, &desc, &a->set), TSU_OK);
}

void ask_close(struct ask *a)
{
    tsu_set_destroy(a->set);
    tsu_context_destroy(a->context);
    watch_close(&a->watch);
}

tsu_model_info ask_model(const tsu_model *model)
{
    tsu_model_info info;
    assert_int_equal(tsu_model_info_init(&info), TSU_OK);
    assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
    return info;
}

tsu_parameter_info ask_parameter(const tsu_model *model, uint32_t index)
{
    tsu_parameter_info info;
    assert_int_equal(tsu_parameter_info_init(&info), TSU_OK);
    assert_int_equal(tsu_model_parameter(model, index, &info), TSU_OK);
    return info;
}

void ask_log(const struct watch *w, const char *name, double minimum, double maximum)
{
    assert_int_equal(w->log_count, 1);
    assert_int_equal(w->log_level, TSU_LOG_ERROR);
    assert_null(strchr(w->log, '\n'));
    const char *found = strstr(w->log, name);
    assert_non_null(found);
    const char *range = strchr(w->log, '[');
    range = range ? strchr(range + 1, '[') : NULL; // the first one is the code's
    assert_non_null(range);
    char *middle, *end;
    const double low = strtod(range + 1, &middle), high = strtod(middle + 1, &end);
    assert_true(*middle == ',' && *end == ']');
    assert_true(fabs(low - minimum) <= 1e-8 * fabs(minimum));
    assert_true(fabs(high - maximum) <= 1e-8 * fabs(maximum));
}

tsu_value_info ask_input(const tsu_model *model, uint32_t function, uint32_t index)
{
    tsu_value_info info;
    assert_int_equal(tsu_value_info_init(&info), TSU_OK);
    assert_int_equal(tsu_function_input(model, function, index, &info), TSU_OK);
    return info;
}

// Text without a locale. The truth of a number is the C library's strtod in the C locale.
#define _POSIX_C_SOURCE 200809L // mkdtemp, setenv
#include "base/host.h"
#include "base/text.h"
#include "watch.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char *format(char *out, size_t capacity, const char *text, ...)
{
    struct tsu_i_line line = {out, capacity, 0};
    va_list arguments;
    va_start(arguments, text);
    tsu_i_line_format(&line, text, arguments);
    va_end(arguments);
    assert_int_equal(line.size, strlen(out));
    return out;
}

static void numbers_that_have_one_form(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } cases[] = {
        {0, "0"},           {1, "1"},
        {-1, "-1"},         {0.1, "0.1"},
        {-0.5, "-0.5"},     {1e-9, "1e-9"},
        {-2.5e-7, "-2.5e-7"}, {123456789, "123456789"},
        {1234.5, "1234.5"}, {0.349065850, "0.34906585"},
        {1e6, "1000000"},   {1e300, "1e300"},
        {9999999999.9, "1e10"}, {NAN, "nan"},
        {INFINITY, "inf"},  {-INFINITY, "-inf"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char out[64];
        assert_string_equal(format(out, sizeof out, "%g", cases[i].value), cases[i].text);
    }
}

static void reads_back(double value)
{
    char out[64], *end;
    format(out, sizeof out, "%g", value);
    const double back = strtod(out, &end);
    if (*end || !(fabs(back - value) <= 6e-9 * fabs(value)))
        fail_msg("%.17g is written %s", value, out);
}

static void every_magnitude_reads_back(void **state)
{
    (void)state;
    for (int e = -307; e <= 308; e++) {
        char text[16];
        const double power = strtod(format(text, sizeof text, "1e%d", e), NULL);
        static const double factors[] = {1, 1.00000001, 1.5, 1.23456789, 1.7, 1.79};
        for (int k = 0; k < 6; k++) {
            reads_back(power * factors[k]);
            reads_back(-power * factors[k]);
        }
        if (e < 308)
            reads_back(9.9999999999 * power);
    }
    reads_back(DBL_MAX);
    reads_back(DBL_MIN);
}

// A host may hand a subnormal to a checked parameter, and the log line must still be a number.
static void subnormal_doubles(void **state)
{
    (void)state;
    const double values[] = {2.2e-308, 1e-310, 1e-320, 4.9406564584124654e-324};
    for (int i = 0; i < 4; i++)
        reads_back(values[i]);
}

static void other_conversions(void **state)
{
    (void)state;
    char out[64];
    format(out, sizeof out, "%d %d %u", -2147483647 - 1, 2147483647, 4294967295u);
    assert_string_equal(out, "-2147483648 2147483647 4294967295");
    assert_string_equal(format(out, sizeof out, "%s|%s|100%%", "a", (const char *)NULL),
                        "a|(null)|100%");
}

static void a_full_line_is_cut_and_terminated(void **state)
{
    (void)state;
    for (size_t capacity = 1; capacity <= 20; capacity++) {
        char out[32];
        memset(out, 'x', sizeof out);
        format(out, capacity, "%s=%g,%d", "field", 1.25, -77);
        assert_int_equal(out[capacity], 'x');
        const char whole[] = "field=1.25,-77";
        const size_t kept = capacity - 1 < sizeof whole - 1 ? capacity - 1 : sizeof whole - 1;
        assert_int_equal(strlen(out), kept);
        assert_memory_equal(out, whole, kept);
    }
}

static void a_long_log_line_is_cut(void **state)
{
    (void)state;
    struct watch w;
    tsu_context *context = watch_open(&w);
    char name[2000];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = 0;
    tsu_i_log(context, TSU_LOG_WARNING, 4321, "%s", name);
    assert_int_equal(w.log_count, 1);
    assert_int_equal(w.log_level, TSU_LOG_WARNING);
    assert_int_equal(w.log_code, 4321);
    assert_int_equal(strncmp(w.log, "[W4321] nnnn", 12), 0);
    assert_int_equal(strlen(w.log), 511);
    tsu_context_destroy(context);
    watch_close(&w);
}

static void growing_text(void **state)
{
    (void)state;
    struct watch w;
    tsu_context *context = watch_open(&w);
    struct tsu_i_text text = {.context = context};
    size_t expected = 0;
    for (unsigned i = 0; i < 3000; i++) {
        tsu_i_text_number(&text, i);
        tsu_i_text_string(&text, ",");
        expected += i < 10 ? 2 : i < 100 ? 3 : i < 1000 ? 4 : 5;
    }
    assert_false(text.failed);
    assert_int_equal(text.size, expected);
    assert_int_equal(strlen(text.bytes), expected);
    assert_memory_equal(text.bytes, "0,1,2,3,4,5,6,7,8,9,10,11,", 26);
    assert_string_equal(text.bytes + expected - 5, "2999,");
    w.fail_at = w.calls + 1;
    while (!text.failed)
        tsu_i_text_string(&text, "more");
    const size_t size = text.size;
    tsu_i_text_string(&text, "nothing");
    assert_int_equal(text.size, size);
    tsu_i_text_free(&text);
    tsu_context_destroy(context);
    watch_close(&w);
}

// A system without a comma locale may still be able to compile one.
static int compile_locale(void)
{
    char folder[] = "comma_XXXXXX", command[128];
    if (!mkdtemp(folder))
        return 0;
    snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 ./%s/de_DE.UTF-8 2>/dev/null",
             folder);
    const int made = system(command);
    setenv("LOCPATH", folder, 1);
    const int found = made == 0 && setlocale(LC_NUMERIC, "de_DE.UTF-8") != NULL;
    snprintf(command, sizeof command, "rm -r ./%s", folder);
    return system(command) == 0 && found;
}

static int comma_locale(void)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8",
                                        "nl_NL.UTF-8", "it_IT.UTF-8", "sv_SE.UTF-8", "es_ES.UTF-8"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (setlocale(LC_NUMERIC, names[i]))
            return 1;
    return compile_locale();
}

static void a_comma_locale_changes_nothing(void **state)
{
    (void)state;
    if (!comma_locale()) {
        print_message("no locale with a decimal comma here; tests/lint/names.py shows that the "
                      "library calls nothing that knows a locale\n");
        skip();
    }
    char out[64], theirs[64];
    snprintf(theirs, sizeof theirs, "%g", 0.5);
    assert_string_equal(theirs, "0,5");
    assert_string_equal(format(out, sizeof out, "%g %g %g", 0.1, 1e-9, 1234.5), "0.1 1e-9 1234.5");
    setlocale(LC_NUMERIC, "C");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_that_have_one_form),
        cmocka_unit_test(every_magnitude_reads_back),
        cmocka_unit_test(subnormal_doubles),
        cmocka_unit_test(other_conversions),
        cmocka_unit_test(a_full_line_is_cut_and_terminated),
        cmocka_unit_test(a_long_log_line_is_cut),
        cmocka_unit_test(growing_text),
        cmocka_unit_test(a_comma_locale_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

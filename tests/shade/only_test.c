// Texts of chosen functions: these, what they need, and nothing else; every line where it was.
#include "ask_shader.h"
#include "text_rules.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct ask a;
static struct globals globals;

static tsu_shader *ask_only(const tsu_model *const *models, uint32_t count, const char *only)
{
    a.desc.models = models;
    a.desc.model_count = count;
    a.desc.only = only;
    return ask_shader(&a);
}

enum { LINES = 512, SOURCES = 32 };
struct lines {
    const char *at[SOURCES][LINES];
};

// Where the text says that each of its lines stands.
static void read_lines(const char *text, struct lines *out)
{
    long line = 1, source = 0;
    memset(out, 0, sizeof *out);
    for (const char *at = text; *at; at = strchr(at, '\n') + 1) {
        if (strncmp(at, "#line ", 6) == 0) {
            char *end;
            line = strtol(at + 6, &end, 10);
            source = strtol(end, &end, 10);
            continue;
        }
        assert_true(source < SOURCES && line < LINES);
        out->at[source][line++] = at;
    }
}

static int same_line(const char *x, const char *y)
{
    const size_t size = strcspn(x, "\n");
    return size == strcspn(y, "\n") && memcmp(x, y, size) == 0;
}

// `less` holds lines of `whole` alone, at their places.
static void check_lines(const char *whole, const char *less)
{
    static struct lines before, after;
    read_lines(whole, &before);
    read_lines(less, &after);
    int count = 0;
    for (int s = 0; s < SOURCES; s++)
        for (int i = 1; i < LINES; i++) {
            if (!after.at[s][i] || after.at[s][i][0] == '\n')
                continue;
            count++;
            if (!before.at[s][i] || !same_line(before.at[s][i], after.at[s][i]))
                fail_msg("source %d, line %d: %.60s", s, i, after.at[s][i]);
        }
    assert_true(count > 20);
}

// Each global of a text but the wanted ones is named elsewhere in it.
static void check_needed(const char *text, const char *entry, const char *sum)
{
    char *plain = text_without_comments(text);
    text_globals(text, &globals);
    assert_int_equal(globals_count(&globals, 'f', entry), 1);
    assert_int_equal(globals_count(&globals, 'f', sum), 1);
    for (int i = 0; i < globals.count; i++) {
        const char *name = globals.items[i].name;
        const int wanted = strcmp(name, entry) == 0 || strcmp(name, sum) == 0;
        if (globals.items[i].kind == 'b' || strcmp(name, "tsu_records") == 0)
            continue;
        if (!wanted && text_occurrences(plain, name) < 2)
            fail_msg("%s is there for %s and nobody needs it", name, entry);
    }
    free(plain);
}

static void entries_and_what_they_need(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    int count = 0;
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *model = tsu_model_at(m);
        tsu_shader *whole = ask_only(&model, 1, NULL);
        tsu_shader *empty = ask_only(&model, 1, "");
        assert_string_equal(tsu_shader_text(whole, NULL), tsu_shader_text(empty, NULL));
        tsu_shader_destroy(empty);
        tsu_variant_info variant;
        tsu_variant_info_init(&variant);
        for (int v = -1; v < 0 || tsu_model_variant(model, (uint32_t)v, &variant) == TSU_OK; v++) {
            char entry[96], sum[96];
            snprintf(entry, sizeof entry, "tsu_%s_%s%s", model_name(model),
                     v < 0 ? "" : variant.name, v < 0 ? "eval" : "_eval");
            snprintf(sum, sizeof sum, "tsu_%s_sum", model_name(model));
            tsu_shader *less = ask_only(&model, 1, v < 0 ? "eval" : variant.name);
            tsu_shader *named = ask_only(&model, 1, entry);
            assert_string_equal(tsu_shader_text(less, NULL), tsu_shader_text(named, NULL));
            size_t size, smaller;
            check_needed(tsu_shader_text(less, &smaller), entry, sum);
            check_lines(tsu_shader_text(whole, &size), tsu_shader_text(less, NULL));
            assert_true(smaller < size);
            print_message("%s: %u of %u bytes\n", entry, (unsigned)smaller, (unsigned)size);
            tsu_shader_destroy(less);
            tsu_shader_destroy(named);
            count++;
        }
        tsu_shader_destroy(whole);
    }
    assert_true(count >= (int)tsu_model_count() + 5);
    ask_close(&a);
}

// A model of which nothing is named stays whole; several names; the library's other snippets.
static void several_models_and_names(void **state)
{
    (void)state;
    const tsu_model *const models[] = {tsu_model_find("dual_scattering"),
                                       tsu_model_find("leaf_body"), tsu_model_find("deep_opacity")};
    ask_open(&a, NULL, NULL);
    a.desc.flags = TSU_SHADER_LIGHTS | TSU_SHADER_FADE | TSU_SHADER_DROP_BACK;
    tsu_shader *whole = ask_only(models, 3, NULL);
    tsu_shader *less = ask_only(models, 3, "finite, zinke");
    check_lines(tsu_shader_text(whole, NULL), tsu_shader_text(less, NULL));
    text_globals(tsu_shader_text(less, NULL), &globals);
    static const char *const there[] = {"tsu_dual_scattering_finite_eval",
                                        "tsu_dual_scattering_zinke_eval",
                                        "tsu_leaf_body_ambient",
                                        "tsu_leaf_body_uniform",
                                        "tsu_deep_opacity_read8",
                                        "tsu_light_sample",
                                        "tsu_fade",
                                        "tsu_environment_sample"};
    for (size_t i = 0; i < sizeof there / sizeof *there; i++)
        if (globals_count(&globals, 'f', there[i]) != 1)
            fail_msg("%s is not there", there[i]);
    assert_int_equal(globals_count(&globals, 'f', "tsu_dual_scattering_eval"), 0);
    assert_int_equal(globals_count(&globals, 'f', "tsu_dual_scattering_thick"), 0);
    tsu_shader_destroy(less);
    less = ask_only(models, 3, "ambient,tsu_deep_opacity_read8,eval");
    text_globals(tsu_shader_text(less, NULL), &globals);
    assert_int_equal(globals_count(&globals, 'f', "tsu_leaf_body_ambient"), 1);
    assert_int_equal(globals_count(&globals, 'f', "tsu_leaf_body_eval"), 1);
    assert_int_equal(globals_count(&globals, 'f', "tsu_leaf_body_uniform"), 0);
    assert_int_equal(globals_count(&globals, 'f', "tsu_dual_scattering_zinke_eval"), 0);
    assert_int_equal(globals_count(&globals, 'f', "tsu_deep_opacity_read8"), 1);
    assert_int_equal(globals_count(&globals, 'f', "tsu_deep_opacity_read4"), 0);
    tsu_shader_destroy(less);
    tsu_shader_destroy(whole);
    ask_close(&a);
}

static void names_that_nobody_has(void **state)
{
    (void)state;
    const tsu_model *const models[] = {tsu_model_find("marschner"), tsu_model_find("leaf")};
    ask_open(&a, NULL, NULL);
    a.desc.models = models;
    a.desc.model_count = 2;
    static const char *const bad[] = {
        "finite", "eval,evil", "tsu_kajiya_kay_eval", "TSU_RECORD",
        "a_very_long_word_that_goes_on_and_on_and_on_and_on_and_on_an"
        "d_on_and_on_and_on_and_on_and_on_and_on_and_on_and_on_and_on"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        a.desc.only = bad[i];
        ask_refused(&a, TSU_E_PARAMETER, "only");
    }
    a.desc.only = "eval";
    a.desc.model_count = 1;
    a.desc.flags = TSU_SHADER_PROBE;
    ask_refused(&a, TSU_E_PARAMETER, "only");
    // A host that was compiled before the field was there.
    a.desc.flags = 0;
    a.desc.struct_size = offsetof(tsu_shader_desc, only);
    tsu_shader *old = ask_shader(&a);
    text_globals(tsu_shader_text(old, NULL), &globals);
    assert_int_equal(globals_count(&globals, 'f', "tsu_marschner_sigma_a"), 1);
    tsu_shader_destroy(old);
    ask_close(&a);
}

// Declarations of a host's file, spelled every way; those with KEEP in their lines are needed.
static const char host_text[] =
    "// head, KEEP\n"
    "\n"
    "#define TSU_ONE 1.0 /* KEEP */\n"
    "#define TSU_TWO \\\n"
    "    2.0\n"
    "/* before\n"
    " * tsu_unused( KEEP */\n"
    "const float tsu_table[2] = float[2](TSU_ONE, 3.0); // KEEP\n"
    "struct tsu_pair { float a, b; }; // KEEP\n"
    "struct tsu_other\n"
    "{\n"
    "    float tsu_x;\n"
    "};\n"
    "\n"
    "// alone, before what follows: KEEP\n"
    "\n"
    "#ifdef GL_ES // KEEP\n"
    "float tsu_precise() { return tsu_called_in_a_branch(); } // KEEP\n"
    "#else // KEEP\n"
    "float tsu_precise() { return 0.0; } // KEEP\n"
    "#endif // KEEP\n"
    "float tsu_called_in_a_branch() { return 1.0; } // KEEP\n"
    "float tsu_unused() { if (true) { return TSU_TWO; } return 2.0; }\n"
    "float tsu_helper(tsu_pair p, // KEEP\n"
    "                 float x) // KEEP\n"
    "{ // KEEP\n"
    "    return p.a * tsu_table[0] * x; // KEEP tsu_unused\n"
    "} // KEEP\n"
    "float tsu_helper(float x) { return x; } // KEEP\n"
    "struct tsu_kajiya_kay_lobes { float x; }; // KEEP\n"
    "tsu_kajiya_kay_lobes tsu_kajiya_kay_eval(float x) // KEEP\n"
    "{ return tsu_kajiya_kay_lobes(tsu_helper(tsu_pair(x, x), x)); } // KEEP\n"
    "float tsu_kajiya_kay_sum(tsu_kajiya_kay_lobes l) { return l.x; } // KEEP\n"
    "float tsu_kajiya_kay_sigma_a(int m) { return tsu_unused(); }\n";

static int32_t read_host(void *user, const char *name, const char **text, size_t *size)
{
    (void)user;
    if (strcmp(name, "kajiya_kay/eval.glsl") != 0)
        return 0;
    *text = host_text;
    *size = strlen(host_text);
    return 1;
}

static void any_spelling(void **state)
{
    (void)state;
    const tsu_model *model = tsu_model_find("kajiya_kay");
    ask_open(&a, read_host, NULL);
    tsu_shader *shader = ask_only(&model, 1, "eval");
    const char *text = tsu_shader_text(shader, NULL);
    static struct lines lines;
    read_lines(text, &lines);
    const char *source = NULL;
    int s = 0;
    while ((source = tsu_shader_source(shader, (uint32_t)s)) != NULL &&
           strcmp(source, "kajiya_kay/eval.glsl") != 0)
        s++;
    assert_non_null(source);
    int number = 1, keeps = 0;
    for (const char *at = host_text; *at; at = strchr(at, '\n') + 1, number++) {
        char line[128];
        snprintf(line, sizeof line, "%.*s", (int)strcspn(at, "\n"), at);
        const int keep = strstr(line, "KEEP") != NULL || strcmp(line, "/* before") == 0;
        const char *seen = lines.at[s][number];
        const int there = seen && same_line(seen, at);
        if (line[0] && there != keep)
            fail_msg("line %d is %s: %s", number, there ? "there" : "not there", line);
        keeps += keep;
    }
    assert_true(keeps > 20);
    tsu_shader_destroy(shader);
    ask_close(&a);
}

static void memory_that_fails(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    a.desc.only = "eval";
    const size_t live = a.watch.live;
    long n = 0;
    for (int failed = 1; failed;) {
        tsu_shader *shader = (tsu_shader *)&a;
        a.watch.fail_at = a.watch.calls + ++n;
        const tsu_status status = tsu_shader_create(a.context, &a.desc, &shader);
        failed = a.watch.calls >= a.watch.fail_at;
        assert_int_equal(status, failed ? TSU_E_MEMORY : TSU_OK);
        tsu_shader_destroy(shader);
        assert_int_equal(a.watch.live, live);
    }
    assert_true(n > 3);
    ask_close(&a);
}

int only_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(entries_and_what_they_need), cmocka_unit_test(several_models_and_names),
        cmocka_unit_test(names_that_nobody_has),      cmocka_unit_test(any_spelling),
        cmocka_unit_test(memory_that_fails),
    };
    return cmocka_run_group_tests_name("only", tests, NULL, NULL);
}

// Lobes that are left out: no word of theirs in the text, lines that keep their numbers, directives
// that are nobody's business.
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

static tsu_shader *ask_model(const char *name, uint32_t flags)
{
    static const tsu_model *model;
    model = tsu_model_find(name);
    assert_non_null(model);
    a.desc.models = &model;
    a.desc.model_count = 1;
    a.desc.flags = flags;
    return ask_shader(&a);
}

static void dropped_lobes_leave_no_word(void **state)
{
    (void)state;
    static const struct {
        const char *model;
        uint32_t flag;
        const char *words[3]; // in the whole text, not in the one without the lobe
    } cases[] = {
        {"marschner", TSU_SHADER_DROP_TRT, {"n.z * factor", "path.z"}},
        {"marschner", TSU_SHADER_DROP_RESIDUAL, {"n.w * factor", "path.w"}},
        {"marschner",
         TSU_SHADER_DROP_RESIDUAL | TSU_SHADER_DROP_TRT,
         {"tsu_marschner_absorb(", "n.z * factor", "path.w"}},
        {"dual_scattering", TSU_SHADER_DROP_BACK, {"s.back * near", "sin(m.x)", "d_b"}},
        {"dual_scattering", TSU_SHADER_DROP_TRT, {"path.z"}},
        {"plane_parallel_hair", TSU_SHADER_DROP_BACK, {"s.on * near", "cos2_half * cos2_half"}},
        {"leaf_body", TSU_SHADER_DROP_TRANSMITTED, {"3.5", "second_other"}},
        {"leaf", TSU_SHADER_DROP_TRANSMITTED, {"p * d + d", "first_other"}},
        {"leaf_coarse", TSU_SHADER_DROP_TRANSMITTED, {"3.5"}},
    };
    ask_open(&a, NULL, NULL);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        tsu_shader *whole = ask_model(cases[i].model, 0);
        tsu_shader *less = ask_model(cases[i].model, cases[i].flag);
        char *before = text_without_comments(tsu_shader_text(whole, NULL));
        char *after = text_without_comments(tsu_shader_text(less, NULL));
        for (int w = 0; w < 3 && cases[i].words[w]; w++) {
            if (text_occurrences(before, cases[i].words[w]) == 0)
                fail_msg("%s has no %s", cases[i].model, cases[i].words[w]);
            if (text_occurrences(after, cases[i].words[w]) != 0)
                fail_msg("%s without a lobe has %s", cases[i].model, cases[i].words[w]);
        }
        size_t size, smaller;
        tsu_shader_text(whole, &size);
        tsu_shader_text(less, &smaller);
        assert_true(smaller < size);
        assert_true(tsu_shader_key(whole) != tsu_shader_key(less));
        free(before);
        free(after);
        tsu_shader_destroy(whole);
        tsu_shader_destroy(less);
    }
    ask_close(&a);
}

// A model that has no such lobe has the same text; nothing is left to a preprocessor.
static void other_models_do_not_change(void **state)
{
    (void)state;
    const uint32_t every = TSU_SHADER_DROP_TRT | TSU_SHADER_DROP_RESIDUAL | TSU_SHADER_DROP_BACK |
                           TSU_SHADER_DROP_TRANSMITTED;
    ask_open(&a, NULL, NULL);
    tsu_shader *whole = ask_model("kajiya_kay", 0), *less = ask_model("kajiya_kay", every);
    assert_string_equal(tsu_shader_text(whole, NULL), tsu_shader_text(less, NULL));
    tsu_shader_destroy(whole);
    tsu_shader_destroy(less);
    whole = ask_model("leaf", 0);
    less = ask_model("leaf", every & ~TSU_SHADER_DROP_TRANSMITTED);
    assert_string_equal(tsu_shader_text(whole, NULL), tsu_shader_text(less, NULL));
    tsu_shader_destroy(whole);
    tsu_shader_destroy(less);
    a.desc.models = a.models;
    a.desc.model_count = tsu_model_count();
    static const uint32_t flags[] = {0, TSU_SHADER_FINE, TSU_SHADER_LIGHTS, TSU_SHADER_BLUR};
    for (int i = 0; i < 8; i++) {
        a.desc.flags = flags[i % 4] | (i < 4 ? 0 : every);
        whole = ask_shader(&a);
        const char *text = tsu_shader_text(whole, NULL);
        assert_null(strstr(text, "#if"));
        assert_null(strstr(text, "#else"));
        assert_null(strstr(text, "#endif"));
        assert_null(strstr(text, "TSU_DROP_"));
        assert_null(strstr(text, "TSU_FINE"));
        tsu_shader_destroy(whole);
    }
    a.desc.model_count = 1;
    for (uint32_t bit = TSU_SHADER_DROP_TRT; bit <= TSU_SHADER_DROP_TRANSMITTED; bit *= 2) {
        a.desc.flags = TSU_SHADER_PROBE | bit;
        ask_refused(&a, TSU_E_PARAMETER, "probe");
    }
    ask_close(&a);
}

// A file of the host's: each line carries its own number after "at", and a letter for what must
// happen to it: K kept, D dropped with TRT.
static const char lines[] = "// at 1 K\n"
                            "#ifdef TSU_DROP_TRT\n"
                            "// at 3 d\n"
                            "#else\n"
                            "// at 5 D\n"
                            "#endif\n"
                            "// at 7 K\n"
                            "#ifdef GL_ES\n"
                            "// at 9 K\n"
                            "# ifndef  TSU_DROP_TRT\n"
                            "// at 11 D\n"
                            "#  ifdef TSU_OTHER\n"
                            "// at 13 D\n"
                            "#  else\n"
                            "// at 15 D\n"
                            "#  endif\n"
                            "# endif\n"
                            "#else // foreign\n"
                            "// at 19 K\n"
                            "#endif\n"
                            "#if defined(TSU_DROP_TRT) && defined(TSU_FINE)\n"
                            "// at 22 K\n"
                            "#endif\n"
                            "#if !defined(TSU_DROP_TRT) || defined( TSU_DROP_BACK )\n"
                            "// at 25 D\n"
                            "// at 26 D\n"
                            "// at 27 D\n"
                            "// at 28 D\n"
                            "// at 29 D\n"
                            "// at 30 D\n"
                            "// at 31 D\n"
                            "// at 32 D\n"
                            "// at 33 D\n"
                            "// at 34 D\n"
                            "// at 35 D\n"
                            "// at 36 D\n"
                            "// at 37 D\n"
                            "#else\n"
                            "// at 39 d\n"
                            "#endif\n"
                            "#ifdef TSU_DROP_TRTX\n"
                            "// at 42 K\n"
                            "#endif\n"
                            "// at 44 K\n";

static int32_t read_lines(void *user, const char *name, const char **text, size_t *size)
{
    (void)user;
    if (strcmp(name, "kajiya_kay/eval.glsl") != 0)
        return 0;
    *text = lines;
    *size = strlen(lines);
    return 1;
}

static int wanted(char letter, int dropped)
{
    return letter == 'K' || letter == (dropped ? 'd' : 'D');
}

static void lines_keep_their_numbers(void **state)
{
    (void)state;
    ask_open(&a, read_lines, NULL);
    for (int dropped = 0; dropped < 2; dropped++) {
        tsu_shader *shader = ask_model("kajiya_kay", dropped ? TSU_SHADER_DROP_TRT : 0);
        long line = 1, source = 0;
        int seen = 0, expected = 0;
        for (const char *at = tsu_shader_text(shader, NULL); *at; at = strchr(at, '\n') + 1) {
            if (strncmp(at, "#line ", 6) == 0) {
                char *end;
                line = strtol(at + 6, &end, 10);
                source = strtol(end, &end, 10);
                continue;
            }
            int number;
            char letter;
            if (sscanf(at, "// at %d %c", &number, &letter) == 2) {
                assert_int_equal(line, number);
                assert_string_equal(tsu_shader_source(shader, (uint32_t)source),
                                    "kajiya_kay/eval.glsl");
                if (!wanted(letter, dropped))
                    fail_msg("line %d is there, dropped %d", number, dropped);
                seen++;
            }
            line++;
        }
        for (const char *at = strstr(lines, "// at "); at; at = strstr(at + 1, "// at "))
            expected += wanted(strchr(at, '\n')[-1], dropped);
        assert_int_equal(seen, expected);
        const char *text = tsu_shader_text(shader, NULL);
        assert_int_equal(text_occurrences(text, "#else"), 1);
        assert_int_equal(text_occurrences(text, "#ifdef GL_ES"), 1);
        assert_int_equal(text_occurrences(text, "TSU_DROP_TRT) && defined(TSU_FINE)"), 1);
        assert_int_equal(text_occurrences(text, "TSU_DROP_TRTX"), 1);
        assert_int_equal(text_occurrences(text, "#endif"), 3);
        tsu_shader_destroy(shader);
    }
    ask_close(&a);
}

int drop_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dropped_lobes_leave_no_word),
        cmocka_unit_test(other_models_do_not_change),
        cmocka_unit_test(lines_keep_their_numbers),
    };
    return cmocka_run_group_tests_name("drop", tests, NULL, NULL);
}

// The host's own GLSL files, and where a driver's message points.
#include "ask_shader.h"
#include "text_rules.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct ask a;

static struct {
    const char *name, *text; // the one file that the host has
    char asked[64][64];
    int count;
} files;

static int32_t read_file(void *user, const char *name, const char **text, size_t *size)
{
    assert_ptr_equal(user, &files);
    assert_true(files.count < 64);
    strncpy(files.asked[files.count++], name, 63);
    if (!files.name || strcmp(name, files.name) != 0)
        return 0;
    *text = files.text;
    *size = strlen(files.text);
    return 1;
}

static void begin(const char *name, const char *text)
{
    memset(&files, 0, sizeof files);
    files.name = name;
    files.text = text;
    ask_open(&a, read_file, &files);
}

static void one_file_of_the_hosts(void **state)
{
    (void)state;
    begin(NULL, NULL);
    tsu_shader *plain = ask_shader(&a);
    char name[64];
    assert_true(files.count >= 3);
    for (int i = 0; i < files.count; i++) { // folder/file.glsl, each once
        assert_non_null(strchr(files.asked[i], '/'));
        assert_string_equal(files.asked[i] + strlen(files.asked[i]) - 5, ".glsl");
        for (int k = 0; k < i; k++)
            assert_string_not_equal(files.asked[i], files.asked[k]);
    }
    const int count = files.count;
    for (int i = 0; i < count; i++) {
        strcpy(name, files.asked[i]);
        files.name = name;
        files.text = "float tsu_of_the_host(float x) { return x; }\n";
        files.count = 0;
        tsu_shader *mine = ask_shader(&a);
        const char *text = tsu_shader_text(mine, NULL);
        assert_int_equal(text_occurrences(text, "tsu_of_the_host"), 1);
        assert_true(tsu_shader_key(mine) != tsu_shader_key(plain));
        assert_int_equal(files.count, count);
        tsu_shader_destroy(mine);
        files.name = NULL;
        files.count = 0;
        tsu_shader *again = ask_shader(&a);
        assert_string_equal(tsu_shader_text(again, NULL), tsu_shader_text(plain, NULL));
        tsu_shader_destroy(again);
    }
    tsu_shader_destroy(plain);
    ask_close(&a);
}

static void words_that_belong_to_the_host_stage(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "#version 330\nfloat tsu_x;\n", "void main()\n{\n}\n", "void main(void) {}\n",
        "float tsu_x() { return gl_FragCoord.x; }\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        begin("prelude/records.glsl", texts[i]);
        ask_refused(&a, TSU_E_HOST, "prelude/records.glsl");
        ask_close(&a);
    }
}

// A main is a main however it is spaced, and the words of a comment define nothing.
static void spelling_does_not_hide_a_main(void **state)
{
    (void)state;
    static const char *const mains[] = {"void  main()\n{\n}\n", "void\nmain()\n{\n}\n",
                                        "void\tmain ( )\n{\n}\n", "# version 330\n"};
    int refused = 0;
    for (size_t i = 0; i < sizeof mains / sizeof *mains; i++) {
        begin("prelude/records.glsl", mains[i]);
        tsu_shader *shader = NULL;
        const tsu_status status = tsu_shader_create(a.context, &a.desc, &shader);
        refused += status == TSU_E_HOST && strstr(a.watch.log, "prelude/records.glsl");
        tsu_shader_destroy(shader);
        ask_close(&a);
    }
    assert_int_equal(refused, 4);
}

// Each #line names a source whose file the library can tell, in the order of the text.
static void sources_of_a_message(void **state)
{
    (void)state;
    begin(NULL, NULL);
    for (uint32_t flags = 0; flags <= TSU_SHADER_HARNESS; flags += TSU_SHADER_HARNESS) {
        a.desc.flags = flags;
        files.count = 0;
        tsu_shader *shader = ask_shader(&a);
        const char *text = tsu_shader_text(shader, NULL);
        int file = 0;
        for (const char *at = strstr(text, "#line "); at; at = strstr(at + 1, "#line ")) {
            char *end;
            assert_int_equal(strtol(at + 6, &end, 10), 1);
            const long source = strtol(end, &end, 10);
            assert_true(*end == '\n');
            const char *name = tsu_shader_source(shader, (uint32_t)source);
            assert_non_null(name);
            if (source == 0) // back to the library's own lines
                continue;
            assert_true(file < files.count);
            assert_string_equal(name, files.asked[file]);
            // The line after #line is line 1 of the file: its licence.
            assert_int_equal(strncmp(end + 1, "// SPDX-License-Identifier: MIT\n", 32), 0);
            file++;
        }
        assert_int_equal(file, files.count);
        assert_non_null(tsu_shader_source(shader, 0));
        assert_null(tsu_shader_source(shader, (uint32_t)file + 1));
        assert_null(tsu_shader_source(shader, UINT32_MAX));
        tsu_shader_destroy(shader);
    }
    ask_close(&a);
}

int read_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_file_of_the_hosts),
        cmocka_unit_test(words_that_belong_to_the_host_stage),
        cmocka_unit_test(spelling_does_not_hide_a_main),
        cmocka_unit_test(sources_of_a_message),
    };
    return cmocka_run_group_tests_name("read", tests, NULL, NULL);
}

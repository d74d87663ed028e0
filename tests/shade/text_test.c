// What the assembled text declares, and what the descriptor refuses.
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

static void only_prefixed_names(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    for (int t = 0; t < TARGETS; t++) {
        a.desc.target = tsu_target_find(target_names[t]);
        tsu_shader *shader = ask_shader(&a);
        const char *text = tsu_shader_text(shader, NULL);
        char *plain = text_without_comments(text);
        static const char *const never[] = {"__",         "gl_",  "#version",
                                            "#extension", "main", "discard"};
        for (size_t i = 0; i < sizeof never / sizeof *never; i++)
            if (strstr(plain, never[i]))
                fail_msg("%s: the text holds %s", target_names[t], never[i]);
        text_globals(text, &globals);
        assert_true(globals.count > 10);
        for (int i = 0; i < globals.count; i++) {
            const char *prefix = globals.items[i].kind == 'm' ? "TSU_" : "tsu_";
            if (strncmp(globals.items[i].name, prefix, 4) != 0)
                fail_msg("%s: %s (%c) has no prefix", target_names[t], globals.items[i].name,
                         globals.items[i].kind);
        }
        free(plain);
        tsu_shader_destroy(shader);
    }
    ask_close(&a);
}

static void one_sampler_and_one_block_for_all(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    for (int t = 0; t < TARGETS; t++) {
        a.desc.target = tsu_target_find(target_names[t]);
        tsu_shader *shader = ask_shader(&a);
        text_globals(tsu_shader_text(shader, NULL), &globals);
        assert_int_equal(globals_count(&globals, 'u', NULL), 1);
        assert_int_equal(globals_count(&globals, 'u', "tsu_tables"), 1);
        assert_int_equal(globals_count(&globals, 'b', NULL), 1);
        assert_int_equal(globals_count(&globals, 'b', "tsu_materials"), 1);
        assert_int_equal(globals_count(&globals, 'v', "tsu_records"), 1);
        for (uint32_t m = 0; m < a.desc.model_count; m++) {
            char name[96];
            snprintf(name, sizeof name, "tsu_%s_eval", model_name(a.models[m]));
            assert_int_equal(globals_count(&globals, 'f', name), 1);
            snprintf(name, sizeof name, "tsu_%s_sum", model_name(a.models[m]));
            assert_int_equal(globals_count(&globals, 'f', name), 1);
            snprintf(name, sizeof name, "tsu_%s_lobes", model_name(a.models[m]));
            assert_int_equal(globals_count(&globals, 's', name), 1);
        }
        // GLSL overloads functions; here each name stands once, so nothing is there twice.
        for (int i = 0; i < globals.count; i++) {
            const char kind = globals.items[i].kind;
            assert_int_equal(globals_count(&globals, kind, globals.items[i].name), 1);
        }
        tsu_shader_destroy(shader);
    }
    ask_close(&a);
}

static void the_vulkan_numbers_are_the_hosts(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    a.desc.target = TSU_TARGET_VULKAN;
    a.desc.set = 3;
    a.desc.sampler_binding = 11;
    a.desc.block_binding = 12;
    tsu_shader *shader = ask_shader(&a);
    const char *text = tsu_shader_text(shader, NULL);
    assert_int_equal(text_occurrences(text, "set = 3, binding = 11) uniform sampler2D tsu_"), 1);
    assert_int_equal(text_occurrences(text, "set = 3, binding = 12) uniform tsu_materials"), 1);
    tsu_shader_destroy(shader);
    ask_close(&a);
}

static void a_model_asked_for_twice_appears_once(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    for (uint32_t m = 0; m < tsu_model_count(); m++) {
        const tsu_model *const twice[2] = {tsu_model_at(m), tsu_model_at(m)};
        for (int harness = 0; harness < 2; harness++) {
            a.desc.flags = harness ? TSU_SHADER_HARNESS : 0;
            a.desc.models = twice;
            a.desc.model_count = 1;
            tsu_shader *once = ask_shader(&a);
            a.desc.model_count = 2;
            tsu_shader *both = ask_shader(&a);
            assert_string_equal(tsu_shader_text(once, NULL), tsu_shader_text(both, NULL));
            assert_true(tsu_shader_key(once) == tsu_shader_key(both));
            tsu_shader_destroy(once);
            tsu_shader_destroy(both);
        }
    }
    ask_close(&a);
}

static void a_list_longer_than_the_registry_is_no_error(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    tsu_shader *once = ask_shader(&a);
    a.desc.model_count = 2 * tsu_model_count(); // ask_open() repeats the models
    tsu_shader *twice = NULL;
    const tsu_status status = tsu_shader_create(a.context, &a.desc, &twice);
    const int equal = twice && tsu_shader_key(once) == tsu_shader_key(twice);
    tsu_shader_destroy(once);
    tsu_shader_destroy(twice);
    ask_close(&a);
    assert_int_equal(status, TSU_OK);
    assert_true(equal);
}

static void equal_keys_for_equal_requests(void **state)
{
    (void)state;
    uint64_t keys[TARGETS * 2 * 2];
    int count = 0;
    ask_open(&a, NULL, NULL);
    for (int t = 0; t < TARGETS; t++)
        for (uint32_t m = 0; m < 2; m++)
            for (uint32_t harness = 0; harness < 2; harness++) {
                a.desc.target = tsu_target_find(target_names[t]);
                a.desc.models = a.models + m;
                a.desc.model_count = 1;
                a.desc.flags = harness ? TSU_SHADER_HARNESS : 0;
                tsu_shader *first = ask_shader(&a), *second = ask_shader(&a);
                assert_true(tsu_shader_key(first) == tsu_shader_key(second));
                assert_string_equal(tsu_shader_text(first, NULL), tsu_shader_text(second, NULL));
                assert_true(tsu_shader_key(first) != 0);
                keys[count++] = tsu_shader_key(first);
                tsu_shader_destroy(first);
                tsu_shader_destroy(second);
            }
    // Functions alone are one text for all desktop targets; a complete shader is not.
    for (int i = 0; i < count; i++)
        for (int k = 0; k < i; k++)
            if (i % 4 != k % 4 || i % 2 == 1)
                assert_true(keys[i] != keys[k]);
    ask_close(&a);
}

static void array_mode(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    a.desc.flags = TSU_SHADER_ARRAY;
    static const uint32_t materials[] = {1, 5, 127};
    for (int i = 0; i < 3; i++) {
        a.desc.array_materials = materials[i];
        tsu_shader *shader = ask_shader(&a);
        char line[64];
        // A page's layout, cut after the last material: header and records.
        snprintf(line, sizeof line, "uniform vec4 tsu_records[%u];",
                 (materials[i] + 1) * TSU_RECORD_VEC4);
        assert_int_equal(text_occurrences(tsu_shader_text(shader, NULL), line), 1);
        text_globals(tsu_shader_text(shader, NULL), &globals);
        assert_int_equal(globals_count(&globals, 'b', NULL), 0);
        tsu_shader_destroy(shader);
    }
    a.desc.array_materials = 0;
    ask_refused(&a, TSU_E_PARAMETER, "array_materials");
    a.desc.array_materials = 128;
    ask_refused(&a, TSU_E_PARAMETER, "[1, 127]");
    a.desc.array_materials = 1;
    a.desc.target = TSU_TARGET_VULKAN;
    ask_refused(&a, TSU_E_PARAMETER, "TSU_SHADER_ARRAY");
    ask_close(&a);
}

static void errors_of_the_descriptor(void **state)
{
    (void)state;
    static const tsu_target targets[] = {0, 7, -1, 330};
    ask_open(&a, NULL, NULL);
    const tsu_shader_desc good = a.desc;
    for (int i = 0; i < 4; i++) {
        a.desc.target = targets[i];
        ask_refused(&a, TSU_E_PARAMETER, "target");
    }
    a.desc = good;
    a.desc.flags = 1u << 20;
    ask_refused(&a, TSU_E_PARAMETER, "flags");
    a.desc = good;
    a.desc.reserved = 1;
    ask_refused(&a, TSU_E_PARAMETER, "reserved");
    a.desc = good;
    a.desc.model_count = 0;
    ask_refused(&a, TSU_E_PARAMETER, "model");
    a.desc = good;
    a.desc.models = NULL;
    ask_refused(&a, TSU_E_PARAMETER, "model");
    const tsu_model *const hole[2] = {tsu_model_at(0), NULL};
    a.desc.models = hole;
    a.desc.model_count = 2;
    ask_refused(&a, TSU_E_PARAMETER, "models");
    a.desc = good;
    a.desc.flags = TSU_SHADER_PROBE;
    ask_refused(&a, TSU_E_PARAMETER, "function"); // of which model?
    a.desc.model_count = 1;
    a.desc.function = 1000;
    ask_refused(&a, TSU_E_PARAMETER, "function");
    a.desc = good;
    a.desc.struct_size = 0;
    ask_refused(&a, TSU_E_STRUCT, "tsu_shader_desc");
    a.desc.struct_size = offsetof(tsu_shader_desc, only) - 4;
    ask_refused(&a, TSU_E_STRUCT, "tsu_shader_desc");
    a.desc = good;
    ask_close(&a);
}

static void targets_by_name(void **state)
{
    (void)state;
    static const char *const versions[TARGETS] = {
        "#version 330 core\n", "#version 410 core\n", "#version 450 core\n",
        "#version 300 es\n",   "#version 310 es\n",   "#version 450\n"};
    for (int t = 0; t < TARGETS; t++) {
        assert_int_equal(tsu_target_find(target_names[t]), t + 1);
        assert_string_equal(tsu_target_version(t + 1), versions[t]);
    }
    assert_int_equal(tsu_target_find(""), 0);
    assert_int_equal(tsu_target_find("3300"), 0);
    assert_null(tsu_target_version(TARGETS + 1));
}

static void memory_that_fails(void **state)
{
    (void)state;
    ask_open(&a, NULL, NULL);
    a.desc.flags = TSU_SHADER_HARNESS;
    const size_t live = a.watch.live;
    long n = 0;
    for (int failed = 1; failed;) {
        tsu_shader *shader = (tsu_shader *)&a;
        a.watch.fail_at = a.watch.calls + ++n;
        const tsu_status status = tsu_shader_create(a.context, &a.desc, &shader);
        failed = a.watch.calls >= a.watch.fail_at;
        assert_int_equal(status, failed ? TSU_E_MEMORY : TSU_OK);
        if (failed)
            assert_null(shader);
        tsu_shader_destroy(shader);
        assert_int_equal(a.watch.live, live);
    }
    assert_true(n > 2);
    ask_close(&a);
}

int text_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_prefixed_names),
        cmocka_unit_test(one_sampler_and_one_block_for_all),
        cmocka_unit_test(the_vulkan_numbers_are_the_hosts),
        cmocka_unit_test(a_model_asked_for_twice_appears_once),
        cmocka_unit_test(a_list_longer_than_the_registry_is_no_error),
        cmocka_unit_test(equal_keys_for_equal_requests),
        cmocka_unit_test(array_mode),
        cmocka_unit_test(errors_of_the_descriptor),
        cmocka_unit_test(targets_by_name),
        cmocka_unit_test(memory_that_fails),
    };
    return cmocka_run_group_tests_name("text", tests, NULL, NULL);
}

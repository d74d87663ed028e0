// Every model, alone and with all others, for every target, through glslangValidator.
#define _POSIX_C_SOURCE 200809L // popen
#include "ask_shader.h"

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static struct ask a;
static int compiled;

// `before`, the library's text and `after`, as a fragment shader.
static void compile(const char *what, const char *before, const char *text, const char *after)
{
    const int vulkan = a.desc.target == TSU_TARGET_VULKAN;
    FILE *pipe = popen(vulkan ? "glslangValidator -V -o /dev/null --stdin -S frag"
                              : "glslangValidator --stdin -S frag",
                       "w");
    assert_non_null(pipe);
    fputs(before, pipe);
    fputs(text, pipe);
    fputs(after, pipe);
    // Its exit status is not 0 when it is missing, too.
    if (pclose(pipe) != 0)
        fail_msg("%s for %s does not compile, or glslangValidator is missing", what,
                 target_names[a.desc.target - 1]);
    compiled++;
}

static void compile_models(const char *what, uint32_t flags)
{
    a.desc.flags = flags;
    tsu_shader *shader = ask_shader(&a);
    const char *text = tsu_shader_text(shader, NULL);
    if (flags & TSU_SHADER_HARNESS) {
        assert_int_equal(strncmp(text, tsu_target_version(a.desc.target),
                                 strlen(tsu_target_version(a.desc.target))),
                         0);
        compile(what, "", text, "");
    } else {
        compile(what, tsu_target_version(a.desc.target), text, "void main()\n{\n}\n");
    }
    tsu_shader_destroy(shader);
}

static void compile_drops(const char *what)
{
    static const uint32_t lobes[] = {TSU_SHADER_DROP_TRT, TSU_SHADER_DROP_RESIDUAL,
                                     TSU_SHADER_DROP_BACK, TSU_SHADER_DROP_TRANSMITTED};
    uint32_t all = 0;
    for (int i = 0; i < 4; i++) {
        all |= lobes[i];
        if (a.desc.target == TSU_TARGET_330)
            compile_models(what, lobes[i]);
    }
    compile_models(what, all | TSU_SHADER_HARNESS);
    if (a.desc.target == TSU_TARGET_330)
        compile_models(what, TSU_SHADER_DROP_TRT | TSU_SHADER_FINE);
}

// Chosen entry points, and the harness that calls a variant.
static void compile_only(const tsu_model *model)
{
    tsu_variant_info variant;
    tsu_variant_info_init(&variant);
    a.desc.only = "eval";
    compile_models("eval alone", TSU_SHADER_HARNESS);
    for (uint32_t v = 0; tsu_model_variant(model, v, &variant) == TSU_OK; v++) {
        a.desc.only = variant.name;
        compile_models(variant.name, TSU_SHADER_HARNESS);
    }
    a.desc.only = NULL;
}

static void compile_probes(const tsu_model *model)
{
    tsu_model_info info;
    tsu_function_info function;
    tsu_model_info_init(&info);
    tsu_function_info_init(&function);
    assert_int_equal(tsu_model_describe(model, &info), TSU_OK);
    for (uint32_t f = 0; f < info.function_count; f++) {
        assert_int_equal(tsu_model_function(model, f, &function), TSU_OK);
        a.desc.flags = TSU_SHADER_PROBE;
        a.desc.function = f;
        if (function.flags & TSU_FUNCTION_REFERENCE_ONLY) {
            ask_refused(&a, TSU_E_PARAMETER, "function");
            continue;
        }
        tsu_shader *shader = ask_shader(&a);
        compile(function.name, tsu_target_version(a.desc.target), tsu_shader_text(shader, NULL),
                "layout(location = 0) out vec4 o;\n"
                "void main()\n"
                "{\n"
                "    float x[16];\n"
                "    float y[8];\n"
                "    for (int i = 0; i < 16; i++)\n"
                "        x[i] = 0.1;\n"
                "    for (int i = 0; i < 8; i++)\n"
                "        y[i] = 0.0;\n"
                "    tsu_probe(0, x, y);\n"
                "    o = vec4(y[0], y[1], y[2], y[3]);\n"
                "}\n");
        tsu_shader_destroy(shader);
    }
    a.desc.function = 0;
}

static void everything_compiles(void **state)
{
    (void)state;
    signal(SIGPIPE, SIG_IGN);
    ask_open(&a, NULL, NULL);
    for (int t = 0; t < TARGETS; t++) {
        a.desc.target = tsu_target_find(target_names[t]);
        for (uint32_t m = 0; m <= tsu_model_count(); m++) {
            const int all = m == tsu_model_count();
            a.desc.models = a.models + (all ? 0 : m);
            a.desc.model_count = all ? m : 1;
            const char *what = all ? "all models" : model_name(a.models[m]);
            compile_models(what, 0);
            compile_models(what, TSU_SHADER_HARNESS);
            compile_models(what, TSU_SHADER_LIGHTS);
            compile_models(what, TSU_SHADER_BLUR | TSU_SHADER_FADE);
            compile_drops(what);
            if (a.desc.target != TSU_TARGET_VULKAN) {
                a.desc.array_materials = 3;
                compile_models(what, TSU_SHADER_ARRAY);
                compile_models(what, TSU_SHADER_ARRAY | TSU_SHADER_HARNESS);
            }
            if (!all) {
                compile_probes(a.models[m]);
                compile_only(a.models[m]);
            }
        }
    }
    ask_close(&a);
    print_message("%d shaders compiled\n", compiled);
    assert_true(compiled >= TARGETS * 2 * 3);
}

// The judge itself: a broken text must not pass.
static void a_broken_text_does_not_compile(void **state)
{
    (void)state;
    FILE *pipe = popen("glslangValidator --stdin -S frag > /dev/null", "w");
    assert_non_null(pipe);
    fputs("#version 330 core\nvoid main()\n{\n    tsu_nothing();\n}\n", pipe);
    assert_int_not_equal(pclose(pipe), 0);
}

int compile_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_compiles),
        cmocka_unit_test(a_broken_text_does_not_compile),
    };
    return cmocka_run_group_tests_name("compile", tests, NULL, NULL);
}

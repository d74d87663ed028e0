// Text of the techniques of self-shadow: for every target, alone and among models.
#define _POSIX_C_SOURCE 200809L // popen
#include "ask_shader.h"
#include "text_rules.h"

#include <tsuya/hair_shadow.h>

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct ask a;
static struct globals globals;
static const tsu_model *models[MODELS_MOST];

// Everything that a host may call, with a host's own samplers and record.
static const char host[] =
    "HOST(0) uniform sampler2D front_map;\n"
    "HOST(1) uniform sampler2D layer_map;\n"
    "HOST(2) uniform sampler2D deeper_map;\n"
    "HOST_BLOCK uniform host_block\n"
    "{\n"
    "    vec4 row[12];\n"
    "    vec4 place;\n"
    "};\n"
    "layout(location = 0) out vec4 o_layers;\n"
    "layout(location = 1) out vec4 o_deeper;\n"
    "void main()\n"
    "{\n"
    "    vec3 p = place.xyz;\n"
    "    float share = tsu_hair_shadow_ribbon(0.2, 0.1, 1.0, 2.0, place.xy) *\n"
    "                  tsu_hair_shadow_line(0.1, place.yz);\n"
    "    tsu_hair_shadow s = tsu_hair_shadow_none();\n"
    "    s = tsu_hair_shadow_count(s.front, place.w);\n"
    "    s = tsu_hair_shadow_transmittance(s.direct);\n"
    "    vec4 sum = vec4(s.front, s.behind, s.direct, s.transmittance);\n";
static const char deep[] =
    "    tsu_deep_opacity_write(front_map, row, place.xy, p, share, o_layers, o_deeper);\n"
    "    s = tsu_deep_opacity_read(front_map, layer_map, row, p);\n"
    "    sum += vec4(s.front, s.behind, s.direct, s.transmittance);\n"
    "    s = tsu_deep_opacity_read8(front_map, layer_map, deeper_map, row, p);\n"
    "    sum += vec4(s.front, s.behind, s.direct, s.transmittance);\n";
static const char fixed[] =
    "    tsu_opacity_shadow_write(row, p, share, o_layers, o_deeper);\n"
    "    s = tsu_opacity_shadow_read(layer_map, row, p);\n"
    "    sum += vec4(s.front, s.behind, s.direct, s.transmittance);\n"
    "    s = tsu_opacity_shadow_read8(layer_map, deeper_map, row, p);\n"
    "    sum += vec4(s.front, s.behind, s.direct, s.transmittance);\n";

static void compile(const char *text, int use_deep, int use_fixed)
{
    const int vulkan = a.desc.target == TSU_TARGET_VULKAN;
    FILE *pipe = popen(vulkan ? "glslangValidator -V -o /dev/null --stdin -S frag"
                              : "glslangValidator --stdin -S frag", "w");
    assert_non_null(pipe);
    fputs(tsu_target_version(a.desc.target), pipe);
    fputs(vulkan ? "#define HOST(k) layout(set = 1, binding = k)\n"
                   "#define HOST_BLOCK layout(std140, set = 1, binding = 3)\n"
                 : "#define HOST(k)\n#define HOST_BLOCK layout(std140)\n", pipe);
    fputs(text, pipe);
    fputs(host, pipe);
    fputs(use_deep ? deep : "", pipe);
    fputs(use_fixed ? fixed : "", pipe);
    fputs("    o_layers += sum;\n}\n", pipe);
    if (pclose(pipe) != 0)
        fail_msg("shadow for %s does not compile, or glslangValidator is missing",
                 target_names[a.desc.target - 1]);
}

static void text_of_every_technique(void **state)
{
    (void)state;
    signal(SIGPIPE, SIG_IGN);
    ask_open(&a, NULL, NULL);
    a.desc.models = models;
    for (int t = 0; t < TARGETS; t++)
        for (int with = 1; with < 8; with++) {
            // Bits: deep opacity, opacity shadow, all models.
            uint32_t count = 0;
            for (uint32_t m = 0; with & 4 && m < tsu_model_count(); m++)
                models[count++] = tsu_model_at(m);
            if (with & 1)
                models[count++] = tsu_model_find("deep_opacity");
            if (with & 2)
                models[count++] = tsu_model_find("opacity_shadow");
            a.desc.model_count = count;
            a.desc.target = tsu_target_find(target_names[t]);
            if (with == 4)
                continue; // compile_test has the models alone
            tsu_shader *shader = ask_shader(&a);
            const char *text = tsu_shader_text(shader, NULL);
            text_globals(text, &globals);
            // The host's maps are its own: nothing is declared for them.
            assert_int_equal(globals_count(&globals, 'u', NULL), with & 4 ? 1 : 0);
            assert_int_equal(globals_count(&globals, 'b', NULL), with & 4 ? 1 : 0);
            assert_int_equal(globals_count(&globals, 's', "tsu_hair_shadow"), 1);
            for (int i = 0; i < globals.count; i++) {
                const char *prefix = globals.items[i].kind == 'm' ? "TSU_" : "tsu_";
                assert_int_equal(strncmp(globals.items[i].name, prefix, 4), 0);
                assert_int_equal(
                    globals_count(&globals, globals.items[i].kind, globals.items[i].name), 1);
            }
            compile(text, with & 1, with & 2);
            tsu_shader_destroy(shader);
            a.desc.flags = TSU_SHADER_HARNESS;
            ask_refused(&a, TSU_E_PARAMETER, "models");
            a.desc.flags = TSU_SHADER_PROBE;
            ask_refused(&a, TSU_E_PARAMETER, "function");
            a.desc.flags = 0;
        }
    ask_close(&a);
}

int shadow_tests(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(text_of_every_technique)};
    return cmocka_run_group_tests_name("shadow", tests, NULL, NULL);
}

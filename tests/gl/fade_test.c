// The cross-fade of tiers on the GPU: a dithered fade is the mix on average, its ends are one tier,
// nothing switches back, nothing bad comes of bad weights.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "fixture.h"

#include <tsuya/tsuya.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIZE = 256, PIXELS = SIZE * SIZE, WEIGHTS = 65 };

static struct fixture fixture;
static tsu_context *context;
static struct fixture_target target;
static float pixels[PIXELS * 4], earlier[PIXELS * 4];

static GLuint fade_program(const char *body)
{
    static char text[32768];
    tsu_shader_desc desc;
    tsu_shader *shader;
    const tsu_model *model = tsu_deep_opacity(); // any; it asks for no tables
    tsu_shader_desc_init(&desc);
    desc.target = fixture.gl.es ? TSU_TARGET_300ES : TSU_TARGET_330;
    desc.flags = TSU_SHADER_FADE;
    desc.model_count = 1;
    desc.models = &model;
    assert_int_equal(tsu_shader_create(context, &desc, &shader), TSU_OK);
    const int length =
        snprintf(text, sizeof text,
                 "%s%s\nuniform float weight, gain;\nuniform vec2 corner;\nout vec4 o;\n"
                 "void main() {\n"
                 " vec2 pixel = gl_FragCoord.xy + corner;\n"
                 " int strand = int(gl_FragCoord.y) * 256 + int(gl_FragCoord.x);\n"
                 " vec3 from = vec3(0.3, 1.1, 0.017), to = vec3(0.7, 0.2, 3.0);\n"
                 "%s\n}\n",
                 fixture.gl.es ? "#version 300 es\n" : "#version 330 core\n",
                 tsu_shader_text(shader, NULL), body);
    assert_true(length > 0 && (size_t)length < sizeof text);
    tsu_shader_destroy(shader);
    const GLuint program = fixture_program(&fixture, NULL, text);
    assert_true(program != 0);
    return program;
}

static void draw(GLuint program, float weight, float gain, float corner)
{
    fixture.gl.UseProgram(program);
    fixture.gl.Uniform1f(fixture.gl.GetUniformLocation(program, "weight"), weight);
    fixture.gl.Uniform1f(fixture.gl.GetUniformLocation(program, "gain"), gain);
    const float at[4] = {corner, 2.0f * corner, 0.0f, 0.0f};
    const GLint place = fixture.gl.GetUniformLocation(program, "corner");
    if (place >= 0)
        fixture.gl.Uniform2fv(place, 1, at);
    fixture_draw(&fixture, program, &target);
    fixture_read(&fixture, &target, pixels);
}

static const char by_pixel[] =
    " o = vec4(tsu_fade_takes(tsu_fade_pixel(pixel), weight) ? tsu_fade_gain(gain) * to : from,\n"
    "          1.0);";
static const char by_strand[] =
    " o = vec4(tsu_fade_takes(tsu_fade_strand(uint(strand)), weight) ? tsu_fade_gain(gain) * to\n"
    "                                                                : from, 1.0);";
static const char by_mix[] = " o = vec4(tsu_fade(from, to, weight, gain), 1.0);";

// Share of pixels of a square that took the new tier; fails on a pixel that is neither.
static double share(int x0, int y0, int size, float gain)
{
    long taken = 0;
    for (int y = y0; y < y0 + size; y++)
        for (int x = x0; x < x0 + size; x++) {
            const float *p = pixels + 4 * (y * SIZE + x);
            const int new = p[0] == gain * 0.7f && p[1] == gain * 0.2f && p[2] == gain * 3.0f;
            assert_true(new || (p[0] == 0.3f && p[1] == 1.1f && p[2] == 0.017f));
            taken += new;
        }
    return (double)taken / (size * size);
}

// At every weight and place: the mean over N pixels within 1/sqrt(N), over the whole picture and
// over its squares; a pixel that has switched stays.
static void dithering_is_the_mix(void **state)
{
    (void)state;
    const char *const bodies[2] = {by_pixel, by_strand};
    static const int sizes[3] = {SIZE, 64, 16};
    for (int way = 0; way < 2; way++) {
        const GLuint program = fade_program(bodies[way]);
        double worst[3] = {0.0};
        long beyond = 0;
        for (int i = 0; i < WEIGHTS; i++) {
            const float weight = (float)i / (WEIGHTS - 1);
            draw(program, weight, 0.5f, 0.0f);
            for (int s = 0; s < 3; s++)
                for (int y = 0; y < SIZE; y += sizes[s])
                    for (int x = 0; x < SIZE; x += sizes[s]) {
                        const double off =
                            fabs(share(x, y, sizes[s], 0.5f) - (double)weight) * sizes[s];
                        worst[s] = fmax(worst[s], off);
                        beyond += off > 1.0;
                    }
            for (int p = 0; i > 0 && p < PIXELS; p++)
                if (earlier[4 * p] != 0.3f && pixels[4 * p] != earlier[4 * p])
                    fail_msg("pixel %d switched back at %g", p, (double)weight);
            memcpy(earlier, pixels, sizeof pixels);
        }
        print_message("%s: off by %.2f, %.2f, %.2f /sqrt(N) in squares of 256, 64, 16\n",
                      way ? "strand" : "pixel", worst[0], worst[1], worst[2]);
        // Strands are at random: in a small square the bound is two deviations at least.
        assert_true(worst[0] <= 1.0 && worst[1] <= (way ? 2.5 : 1.0) &&
                    worst[2] <= (way ? 2.5 : 1.0));
        assert_true(way || beyond == 0);
    }
}

// Far from the screen's corner the pattern is as even.
static void large_screens_are_even_too(void **state)
{
    (void)state;
    const GLuint program = fade_program(by_pixel);
    for (float corner = 0.0f; corner < 10000.0f; corner += 1777.0f)
        for (int i = 1; i < 8; i++) {
            draw(program, 0.125f * (float)i, 1.0f, corner);
            assert_true(fabs(share(0, 0, SIZE, 1.0f) - 0.125 * i) <= 1.0 / SIZE);
        }
}

static void the_mix_and_its_ends(void **state)
{
    (void)state;
    static const float a[3] = {0.3f, 1.1f, 0.017f}, b[3] = {0.7f, 0.2f, 3.0f};
    const GLuint program = fade_program(by_mix);
    float before[3] = {0.3f, 1.1f, 0.017f};
    for (int i = 0; i < WEIGHTS; i++) {
        const float weight = (float)i / (WEIGHTS - 1), gain = 1.7f;
        draw(program, weight, gain, 0.0f);
        for (int k = 0; k < 3; k++) {
            const double mix =
                (1.0 - (double)weight) * (double)a[k] + (double)weight * (double)(gain * b[k]);
            assert_true(fabs((double)pixels[k] - mix) <= 4e-7 * (1.0 + mix));
            if (i == 0)
                assert_true(pixels[k] == a[k]);
            if (i == WEIGHTS - 1)
                assert_true(pixels[k] == gain * b[k]);
            assert_true(gain * b[k] > a[k] ? pixels[k] >= before[k] : pixels[k] <= before[k]);
            before[k] = pixels[k];
        }
    }
}

// Weights and gains that are none: one tier or the other, never anything else.
static void bad_weights_give_one_tier(void **state)
{
    (void)state;
    static const char *const bodies[3] = {by_pixel, by_strand, by_mix};
    const float bad[][2] = {{NAN, 0.0f},      {-1.0f, 0.0f},   {-INFINITY, 0.0f}, {-1e-30f, 0.0f},
                            {INFINITY, 1.0f}, {1.0001f, 1.0f}, {3e38f, 1.0f}};
    const float gains[] = {NAN, INFINITY, -INFINITY, -1.0f, 0.0f, 1e30f};
    for (int way = 0; way < 3; way++) {
        const GLuint program = fade_program(bodies[way]);
        for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
            draw(program, bad[i][0], 1.0f, 0.0f);
            if (share(0, 0, SIZE, 1.0f) != (double)bad[i][1])
                fail_msg("%d: weight %g", way, (double)bad[i][0]);
        }
        for (size_t i = 0; i < sizeof gains / sizeof *gains; i++) {
            draw(program, 1.0f, gains[i], 0.0f);
            assert_true(share(0, 0, SIZE, 1.0f) == 1.0);
        }
    }
}

// The thresholds of the shader are those of the C function: hosts may part strands by it.
static void strands_are_parted_alike_in_c(void **state)
{
    (void)state;
    const GLuint program =
        fade_program(" uint id = uint(strand) * (weight > 0.5 ? 65537u : 1u) + uint(gain);\n"
                     " o = vec4(tsu_fade_strand(id), 0.0, 0.0, 1.0);");
    for (int wide = 0; wide < 2; wide++) {
        draw(program, (float)wide, 1000.0f, 0.0f);
        for (uint32_t i = 0; i < PIXELS; i++) {
            const float threshold = tsu_fade_strand(i * (wide ? 65537u : 1u) + 1000u);
            assert_true(threshold >= 0.0f && threshold < 1.0f);
            assert_true(pixels[4 * i] == threshold);
        }
    }
}

int main(int argc, char **argv)
{
    tsu_context_desc desc;
    tsu_context_desc_init(&desc);
    if (!fixture_open(&fixture, argc, argv) || tsu_context_create(&desc, &context) != TSU_OK ||
        !fixture_target_create(&fixture, &target, SIZE, SIZE))
        return 1;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dithering_is_the_mix),
        cmocka_unit_test(large_screens_are_even_too),
        cmocka_unit_test(the_mix_and_its_ends),
        cmocka_unit_test(bad_weights_give_one_tier),
        cmocka_unit_test(strands_are_parted_alike_in_c),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    fixture_target_destroy(&fixture, &target);
    tsu_context_destroy(context);
    return fixture_close(&fixture) && !failed ? 0 : 1;
}

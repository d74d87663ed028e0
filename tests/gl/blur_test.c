// tsu_blur() on the GPU against exact convolution of the map with the Gaussians: borders,
// shadows of veins, spots and noise, at several sizes of texels; and the limits.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "fixture.h"

#include <tsuya/tsuya.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct fixture fixture;
static tsu_context *context;
static tsu_leaf_scale scale;

enum { SIZE = 256, POINTS = 48 };

static float map[SIZE * SIZE * 4];
static double row[SIZE * SIZE], exact[3][SIZE * SIZE];
static float pixels[POINTS * POINTS * 4];

static double soft(double distance)
{
    return fmin(fmax(distance + 0.5, 0.0), 1.0);
}

static double random_unit(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / (1 << 24);
}

enum { BORDER, VEIN, SPOT, KINDS };
static const char *const kind_names[] = {"border", "vein", "spot"};

static void draw_map(int kind, uint32_t seed)
{
    uint32_t state = seed * 7919u + 17u;
    const double angle = 6.2832 * random_unit(&state), c = cos(angle), s = sin(angle);
    const double shift = 20.0 * (random_unit(&state) - 0.5),
                 wide = 4.0 + 10.0 * random_unit(&state);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const double u = x + 0.5 - SIZE / 2, v = y + 0.5 - SIZE / 2;
            const double along = u * c + v * s + shift;
            const double value = kind == BORDER ? soft(along)
                                 : kind == VEIN ? 1.0 - soft(0.5 * wide - fabs(along))
                                                : soft(wide - hypot(u + shift, v - shift));
            for (int k = 0; k < 4; k++)
                map[(y * SIZE + x) * 4 + k] = (float)value;
        }
}

// Convolution with one Gaussian of sigma texels, texels being averages over their areas; the map
// goes on beyond its rim as it ends.
static void add_exact(double sigma, const float weight[3])
{
    static double kernel[SIZE + 1];
    const int reach = (int)fmin(6.0 * sigma + 2.0, SIZE);
    for (int i = 0; i <= reach; i++)
        kernel[i] =
            0.5 * (erf((i + 0.5) / (sigma * sqrt(2.0))) - erf((i - 0.5) / (sigma * sqrt(2.0))));
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            double sum = 0.0;
            for (int i = -reach; i <= reach; i++) {
                const int at = x + i < 0 ? 0 : x + i >= SIZE ? SIZE - 1 : x + i;
                sum += kernel[abs(i)] * (double)map[(y * SIZE + at) * 4];
            }
            row[y * SIZE + x] = sum;
        }
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            double sum = 0.0;
            for (int i = -reach; i <= reach; i++) {
                const int at = y + i < 0 ? 0 : y + i >= SIZE ? SIZE - 1 : y + i;
                sum += kernel[abs(i)] * row[at * SIZE + x];
            }
            for (int k = 0; k < 3; k++)
                exact[k][y * SIZE + x] += (double)weight[k] * sum;
        }
}

static GLuint blur_program(const char *function)
{
    static char text[65536];
    tsu_shader_desc desc;
    tsu_shader *shader;
    const tsu_model *model = tsu_deep_opacity(); // any; it asks for no tables
    tsu_shader_desc_init(&desc);
    desc.target = fixture.gl.es ? TSU_TARGET_300ES : TSU_TARGET_330;
    desc.flags = TSU_SHADER_BLUR;
    desc.model_count = 1;
    desc.models = &model;
    assert_int_equal(tsu_shader_create(context, &desc, &shader), TSU_OK);
    // Points lie on texel centres of the middle of the map, every third.
    const int length = snprintf(
        text, sizeof text,
        "%s%s\nuniform sampler2D map;\nuniform vec4 gaussians[6];\nuniform float scale;\n"
        "out vec4 o;\nvoid main() {\n vec2 at = (floor(gl_FragCoord.xy) * 3.0 + 56.5) / 256.0;\n"
        " o = vec4(%s(map, at, vec2(scale), gaussians), 1.0);\n}\n",
        fixture.gl.es ? "#version 300 es\n" : "#version 330 core\n", tsu_shader_text(shader, NULL),
        function);
    assert_true(length > 0 && (size_t)length < sizeof text);
    tsu_shader_destroy(shader);
    const GLuint program = fixture_program(&fixture, NULL, text);
    assert_true(program != 0);
    return program;
}

static GLuint map_texture(void)
{
    GLuint texture;
    fixture.gl.GenTextures(1, &texture);
    fixture.gl.ActiveTexture(GL_TEXTURE0);
    fixture.gl.BindTexture(GL_TEXTURE_2D, texture);
    fixture.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    fixture.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    fixture.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    fixture.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

static void ask(GLuint program, const struct fixture_target *target, const float *gaussians,
                double texels_per_mm)
{
    fixture.gl.UseProgram(program);
    fixture.gl.Uniform1i(fixture.gl.GetUniformLocation(program, "map"), 0);
    fixture.gl.Uniform4fv(fixture.gl.GetUniformLocation(program, "gaussians"), 6, gaussians);
    fixture.gl.Uniform1f(fixture.gl.GetUniformLocation(program, "scale"), (float)texels_per_mm);
    fixture_draw(&fixture, program, target);
    fixture_read(&fixture, target, pixels);
}

struct errors {
    double most, square;
    long count;
};

static void compare(struct errors *e)
{
    for (int y = 0; y < POINTS; y++)
        for (int x = 0; x < POINTS; x++)
            for (int k = 0; k < 3; k++) {
                const double truth = exact[k][(3 * y + 56) * SIZE + 3 * x + 56];
                const double off = (double)pixels[(y * POINTS + x) * 4 + k] - truth;
                e->most = fmax(e->most, fabs(off));
                e->square += off * off;
                e->count++;
            }
}

static void blurs_are_convolutions(void **state)
{
    (void)state;
    static const double texels[] = {20.0, 60.0};
    // Most error, and of the mean square; fine, coarse.
    static const double bound[2][2] = {{0.06, 0.008}, {0.18, 0.022}};
    struct fixture_target target;
    assert_true(fixture_target_create(&fixture, &target, POINTS, POINTS));
    const GLuint fine = blur_program("tsu_blur"), coarse = blur_program("tsu_blur_coarse");
    const GLuint texture = map_texture();
    for (int side = 0; side < 2; side++)
        for (int t = 0; t < 2; t++) {
            const float *gaussians = side ? scale.transmitted : scale.reflected;
            for (int kind = 0; kind < KINDS; kind++) {
                struct errors e[2] = {{0}};
                for (uint32_t seed = 0; seed < 4; seed++) {
                    draw_map(kind, seed);
                    memset(exact, 0, sizeof exact);
                    for (int j = 0; j < 4; j++)
                        add_exact((double)gaussians[4 * j + 3] * texels[t], gaussians + 4 * j);
                    fixture.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, SIZE, SIZE, 0, GL_RGBA,
                                          GL_FLOAT, map);
                    fixture.gl.GenerateMipmap(GL_TEXTURE_2D);
                    ask(fine, &target, gaussians, texels[t]);
                    compare(e);
                    ask(coarse, &target, gaussians, texels[t]);
                    compare(e + 1);
                }
                for (int form = 0; form < 2; form++) {
                    const double rms = sqrt(e[form].square / (double)e[form].count);
                    print_message("%s, %g texels a mm, %s, %s: most %.3f, rms %.4f\n",
                                  side ? "T" : "R", texels[t], kind_names[kind],
                                  form ? "coarse" : "fine", e[form].most, rms);
                    assert_true(e[form].most <= bound[form][0] && rms <= bound[form][1]);
                }
            }
        }
    fixture.gl.DeleteTextures(1, &texture);
    fixture_target_destroy(&fixture, &target);
}

// An even map comes back as it is, in every channel with light; Gaussians far narrower than a texel
// leave the map alone, far wider than the map give its mean.
static void limits_are_the_map_and_its_mean(void **state)
{
    (void)state;
    struct fixture_target target;
    assert_true(fixture_target_create(&fixture, &target, POINTS, POINTS));
    const GLuint programs[2] = {blur_program("tsu_blur"), blur_program("tsu_blur_coarse")};
    const GLuint texture = map_texture();
    for (int i = 0; i < SIZE * SIZE; i++)
        for (int k = 0; k < 4; k++)
            map[4 * i + k] = 0.25f * (float)(k + 1);
    fixture.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, SIZE, SIZE, 0, GL_RGBA, GL_FLOAT, map);
    fixture.gl.GenerateMipmap(GL_TEXTURE_2D);
    for (int form = 0; form < 2; form++)
        for (double texels = 1e-3; texels < 1e5; texels *= 10.0) {
            ask(programs[form], &target, scale.transmitted, texels);
            for (int i = 0; i < POINTS * POINTS * 4; i++)
                assert_true(fabs((double)pixels[i] - (i % 4 == 3 ? 1.0 : 0.25 * (i % 4 + 1))) <
                            1e-3);
        }
    draw_map(BORDER, 1);
    double mean = 0.0;
    for (int i = 0; i < SIZE * SIZE; i++)
        mean += (double)map[4 * i] / (SIZE * SIZE);
    fixture.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, SIZE, SIZE, 0, GL_RGBA, GL_FLOAT, map);
    fixture.gl.GenerateMipmap(GL_TEXTURE_2D);
    ask(programs[0], &target, scale.transmitted, 1e-3);
    for (int y = 0; y < POINTS; y++)
        for (int x = 0; x < POINTS; x++)
            assert_true(fabs((double)pixels[(y * POINTS + x) * 4] -
                             (double)map[((3 * y + 56) * SIZE + 3 * x + 56) * 4]) < 2e-3);
    ask(programs[1], &target, scale.transmitted, 1e6);
    for (int i = 0; i < POINTS * POINTS; i++)
        assert_true(fabs((double)pixels[4 * i] - mean) < 2e-3);
    fixture.gl.DeleteTextures(1, &texture);
    fixture_target_destroy(&fixture, &target);
}

int main(int argc, char **argv)
{
    tsu_context_desc desc;
    tsu_leaf_scale_desc leaf;
    tsu_context_desc_init(&desc);
    if (!fixture_open(&fixture, argc, argv) || tsu_context_create(&desc, &context) != TSU_OK)
        return 1;
    tsu_leaf_scale_desc_init(&leaf);
    tsu_leaf_scale_init(&scale);
    if (tsu_leaf_scale_solve(context, &leaf, &scale) != TSU_OK)
        return 1;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blurs_are_convolutions),
        cmocka_unit_test(limits_are_the_map_and_its_mean),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    tsu_context_destroy(context);
    return fixture_close(&fixture) && !failed ? 0 : 1;
}

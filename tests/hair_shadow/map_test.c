// The maps in memory against closed forms, and what they make of bad hair.
#include <tsuya/tsuya.h>

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tests.h"

enum { STRANDS_MOST = 40000 };

static tsu_context *context;
static tsu_hair_shadow_desc desc;
static tsu_hair_shadow_plan plan;
static float *map;
static float points[STRANDS_MOST * 2 * 4];
static uint32_t first[STRANDS_MOST + 1];
static uint32_t strands;

static int open(void **state)
{
    (void)state;
    tsu_context_desc own;
    assert_int_equal(tsu_context_desc_init(&own), TSU_OK);
    assert_int_equal(tsu_context_create(&own, &context), TSU_OK);
    assert_int_equal(tsu_hair_shadow_desc_init(&desc), TSU_OK);
    assert_int_equal(tsu_hair_shadow_plan_init(&plan), TSU_OK);
    desc.length = 100.0f;
    desc.width = 0.01f;
    desc.light[1] = 0.0f;
    desc.light[2] = 1.0f;
    desc.size = 32;
    strands = 0;
    srand(3);
    return 0;
}

static int close(void **state)
{
    (void)state;
    free(map);
    map = NULL;
    tsu_context_destroy(context);
    return 0;
}

static float chance(void)
{
    return (float)((double)rand() / ((double)RAND_MAX + 1.0));
}

static void add(float x0, float y0, float z0, float x1, float y1, float z1, float width)
{
    const float both[8] = {x0, y0, z0, width, x1, y1, z1, width};
    memcpy(points + strands * 8, both, sizeof both);
    strands++;
    first[strands] = 2 * strands;
}

static void draw(uint32_t technique)
{
    desc.model = tsu_hair_shadow_at(technique);
    assert_int_equal(tsu_hair_shadow_make(context, &desc, &plan), TSU_OK);
    free(map);
    map = malloc(tsu_hair_shadow_floats(&plan) * sizeof *map);
    assert_non_null(map);
    assert_int_equal(tsu_hair_shadow_write(&plan, points, first, strands, map), TSU_OK);
}

struct shadow {
    float front, behind, direct, transmittance;
};

// Finite, and no energy made, wherever it is read.
static struct shadow at(float x, float y, float z)
{
    const float position[3] = {x, y, z};
    struct shadow s;
    float out[4];
    assert_int_equal(tsu_hair_shadow_read(&plan, map, position, out), TSU_OK);
    memcpy(&s, out, sizeof s);
    for (int k = 0; k < 4; k++)
        assert_true(isfinite(out[k]) && out[k] >= 0.0f);
    assert_true(s.direct <= 1.00001f && s.transmittance <= 1.00001f);
    return s;
}

static void no_shadow(struct shadow s, float behind)
{
    assert_true(s.front == 0.0f && s.behind == behind);
    assert_true(fabsf(s.direct - 1.0f) < 1e-6f && fabsf(s.transmittance - 1.0f) < 1e-6f);
}

// Long fibres at random in a square, -0.4 <= z <= 0.4, that cross the whole of it.
static void slab(int count, float width)
{
    for (int i = 0; i < count; i++) {
        const float y = 1.2f * chance() - 0.6f, z = 0.8f * chance() - 0.4f;
        if (i % 2)
            add(-0.6f, y, z, 0.6f, y, z, width);
        else
            add(y, -0.6f, z, y, 0.6f, z, width);
    }
}

// Fibres of the slab in front of a depth below its top: as many as the depth's share, at the ends
// of layers; linear in between.
static double slab_in_front(double total, double depth, int from_front)
{
    // Distance from where layers begin to the top of the slab.
    const double top = from_front ? 0.0 : 1.02 - 0.4;
    double below = 0.0, above = 0.0, begin = 0.0, end = 1e-9;
    for (int k = 0; k < 8; k++) {
        begin = (double)plan.boundary[k];
        end = (double)plan.boundary[k + 1];
        below = total * fmin(fmax((begin - top) / 0.8, 0.0), 1.0);
        above = total * fmin(fmax((end - top) / 0.8, 0.0), 1.0);
        if (top + depth <= end)
            break;
    }
    return below + (above - below) * (top + depth - begin) / (end - begin);
}

static void a_uniform_slab(void **state)
{
    (void)state;
    const int count = 20000;
    const float width = 0.0005f, total = (float)count * width / 1.2f;
    slab(count, width);
    for (uint32_t t = 0; t < 2; t++) {
        draw(t);
        for (int i = 0; i <= 16; i++) {
            const float z = 0.4f - 0.05f * (float)i;
            double front = 0.0, behind = 0.0;
            for (int k = 0; k < 100; k++) {
                const struct shadow s = at(0.6f * chance() - 0.3f, 0.6f * chance() - 0.3f, z);
                front += (double)s.front / 100.0;
                behind += (double)s.behind / 100.0;
            }
            const double expected = slab_in_front((double)total, 0.05 * i, t == 0);
            // Fibres are random: some 500 cross a texel's column.
            assert_true(fabs(front - expected) < 0.02 * (double)total);
            assert_true(fabs(front + behind - (double)total) < 0.02 * (double)total);
        }
    }
}

static void farther_from_the_light_is_darker(void **state)
{
    (void)state;
    slab(2000, 0.003f);
    for (uint32_t t = 0; t < 2; t++)
        for (int point = 0; point < 2; point++) {
            desc.flags = TSU_HAIR_SHADOW_BLEND_32F | (point ? TSU_HAIR_SHADOW_POINT : 0u);
            desc.light[0] = 1.1f;
            desc.light[2] = 2.5f;
            draw(t);
            for (int n = 0; n < 300; n++) {
                float p[3] = {chance() - 0.5f, chance() - 0.5f, -0.5f}, way[3], last[4] = {0};
                for (int k = 0; k < 3; k++)
                    way[k] = desc.light[k] - (point ? p[k] : 0.0f);
                for (int i = 0; i < 40; i++) {
                    const float s = 0.4f * (float)i / 40.0f;
                    const struct shadow a =
                        at(p[0] + s * way[0], p[1] + s * way[1], p[2] + s * way[2]);
                    if (i > 0) {
                        assert_true(a.front <= last[0] + 2e-5f && a.behind >= last[1] - 2e-5f);
                        assert_true(a.direct >= last[2] - 2e-5f);
                        assert_true(a.transmittance >= last[3] - 2e-5f);
                    }
                    const float now[4] = {a.front, a.behind, a.direct, a.transmittance};
                    memcpy(last, now, sizeof last);
                }
            }
        }
}

static void one_strand(void **state)
{
    (void)state;
    const float width = 0.02f;
    for (int turn = 0; turn < 8; turn++) {
        const float c = cosf(0.4f * (float)turn), s = sinf(0.4f * (float)turn);
        strands = 0;
        add(-0.8f * c, -0.8f * s, 0.1f, 0.8f * c, 0.8f * s, 0.1f, width);
        draw(0);
        // A front strand is in no shadow of its own.
        for (int i = -7; i <= 7; i++) {
            const struct shadow a = at(0.1f * (float)i * c, 0.1f * (float)i * s, 0.1f);
            assert_true(a.front < 1e-6f && a.direct > 1.0f - 1e-6f);
        }
        no_shadow(at(0.0f, 0.0f, 0.5f), at(0.0f, 0.0f, 0.5f).behind);
        // Far behind, the sum across it is its width.
        double sum = 0.0;
        const double step = 0.0005;
        for (int i = -600; i < 600; i++) {
            const double x = ((double)i + 0.5) * step;
            for (int k = 0; k < 50; k++) {
                const double y = 0.64 * ((double)k / 50.0 - 0.5);
                const struct shadow a = at((float)(-(double)s * x + (double)c * y),
                                           (float)((double)c * x + (double)s * y), -0.95f);
                sum += (double)a.front * step / 50.0;
                assert_true(a.behind < 1e-3f);
            }
        }
        assert_true(fabs(sum - (double)width) < 0.03 * (double)width);
    }
}

static void no_strand(void **state)
{
    (void)state;
    for (uint32_t t = 0; t < 2; t++) {
        desc.length = 0.0f;
        draw(t);
        assert_int_equal(plan.flags, TSU_HAIR_SHADOW_EMPTY);
        for (int i = 0; i < 100; i++)
            no_shadow(at(2.0f * chance() - 1.0f, 2.0f * chance() - 1.0f, 2.0f * chance() - 1.0f),
                      0.0f);
    }
}

// Strands of no projected length hide nothing.
static void light_along_the_strands(void **state)
{
    (void)state;
    for (int i = 0; i < 100; i++) {
        const float x = chance() - 0.5f, y = chance() - 0.5f;
        add(x, y, -0.6f, x, y, 0.6f, 0.01f);
    }
    for (uint32_t t = 0; t < 2; t++) {
        draw(t);
        for (int i = 0; i < 100; i++)
            no_shadow(at(points[8 * i], points[8 * i + 1], -0.6f), 0.0f);
    }
}

static void a_light_in_the_hair(void **state)
{
    (void)state;
    slab(2000, 0.003f);
    const float places[5][3] = {
        {0, 0, 0}, {0.1f, 0.2f, 0.05f}, {0.9f, 0, 0}, {1.0f, 0, 0}, {0, 0, -0.3f}};
    desc.flags |= TSU_HAIR_SHADOW_POINT;
    for (int i = 0; i < 5; i++)
        for (uint32_t t = 0; t < 2; t++) {
            memcpy(desc.light, places[i], sizeof desc.light);
            draw(t);
            for (int n = 0; n < 500; n++)
                (void)at(3.0f * chance() - 1.5f, 3.0f * chance() - 1.5f, 3.0f * chance() - 1.5f);
            (void)at(places[i][0], places[i][1], places[i][2]);
        }
}

// A point that is no number takes its two segments with it and nothing else.
static void a_vertex_that_is_no_number(void **state)
{
    (void)state;
    const float bad[3] = {NAN, INFINITY, -INFINITY};
    const float x[5] = {-0.6f, -0.3f, 0.0f, 0.3f, 0.6f};
    add(x[0], 0.1f, 0.2f, x[1], 0.1f, 0.2f, 0.02f);
    add(x[3], 0.1f, 0.2f, x[4], 0.1f, 0.2f, 0.02f);
    for (uint32_t t = 0; t < 2; t++) {
        strands = 2;
        draw(t);
        const size_t floats = tsu_hair_shadow_floats(&plan);
        float *good = malloc(floats * sizeof *good);
        assert_non_null(good);
        memcpy(good, map, floats * sizeof *good);
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 4; c++) {
                float strand[5][4];
                const uint32_t one[2] = {0, 5};
                for (int i = 0; i < 5; i++) {
                    const float p[4] = {x[i], 0.1f, 0.2f, 0.02f};
                    memcpy(strand[i], p, sizeof p);
                }
                strand[2][c] = bad[k];
                assert_int_equal(tsu_hair_shadow_write(&plan, strand[0], one, 1, map), TSU_OK);
                assert_memory_equal(map, good, floats * sizeof *good);
            }
        free(good);
    }
    // And so does a point to shade: it has no shadow.
    for (int k = 0; k < 3; k++) {
        no_shadow(at(bad[k], 0.0f, 0.0f), (float)TSU_HAIR_SHADOW_UNKNOWN);
        no_shadow(at(0.0f, bad[k], 0.0f), (float)TSU_HAIR_SHADOW_UNKNOWN);
        no_shadow(at(0.0f, 0.0f, bad[k]), (float)TSU_HAIR_SHADOW_UNKNOWN);
    }
}

static void outside_of_the_map(void **state)
{
    (void)state;
    slab(2000, 0.003f);
    for (uint32_t t = 0; t < 2; t++) {
        draw(t);
        const struct shadow before = at(0.0f, 0.0f, 50.0f), after = at(0.0f, 0.0f, -50.0f);
        assert_true(before.front == 0.0f && before.behind > 1.0f);
        assert_true(after.front > 1.0f && after.behind == 0.0f);
        assert_true(fabsf(before.behind - after.front) < 1e-3f);
        no_shadow(at(5.0f, 0.0f, 0.0f), 0.0f);
        no_shadow(at(0.0f, -5.0f, 0.0f), 0.0f);
    }
}

int map_tests(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, open, close)
    const struct CMUnitTest tests[] = {
        TEST(a_uniform_slab),
        TEST(farther_from_the_light_is_darker),
        TEST(one_strand),
        TEST(no_strand),
        TEST(light_along_the_strands),
        TEST(a_light_in_the_hair),
        TEST(a_vertex_that_is_no_number),
        TEST(outside_of_the_map),
    };
#undef TEST
    return cmocka_run_group_tests_name("map", tests, NULL, NULL);
}

// Pigment, albedo and presets against the sources that hair_color.h cites.
#include "tests.h"
#include "watch.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct watch watch;
static tsu_context *context;

// d'Eon et al. 2011, section 6.1, as pbrt-v3's hair.cpp and MaterialX carry it.
static const double eumelanin[3] = {0.419, 0.697, 1.37}, pheomelanin[3] = {0.187, 0.4, 1.05};

static void melanin_follows_its_source(void **state)
{
    (void)state;
    context = watch_open(&watch);
    static const double amounts[] = {0, 0.3, 1.3, 8, 100};
    for (int e = 0; e < 5; e++)
        for (int p = 0; p < 5; p++) {
            double sigma_a[3];
            assert_int_equal(tsu_hair_melanin(context, amounts[e], amounts[p], sigma_a), TSU_OK);
            for (int k = 0; k < 3; k++) {
                const double expected = amounts[e] * eumelanin[k] + amounts[p] * pheomelanin[k];
                assert_true(fabs(sigma_a[k] - expected) <= 1e-12 * (1 + expected));
            }
        }
    static const double bad[] = {NAN, -1e-9, 100.001, INFINITY, -INFINITY};
    for (int i = 0; i < 5; i++)
        for (int which = 0; which < 2; which++) {
            double sigma_a[3] = {9, 9, 9};
            watch_quiet(&watch);
            const double e = which ? 1 : bad[i], p = which ? bad[i] : 1;
            assert_int_equal(tsu_hair_melanin(context, e, p, sigma_a), TSU_E_PARAMETER);
            assert_true(sigma_a[0] == 0 && sigma_a[1] == 0 && sigma_a[2] == 0);
            assert_non_null(strstr(watch.log, which ? "pheomelanin" : "eumelanin"));
            assert_non_null(strstr(watch.log, "[0, 100]"));
            assert_int_equal(watch.log_count, 1);
        }
    tsu_context_destroy(context);
    watch_close(&watch);
}

static double albedo_of(double eta, double sigma_a)
{
    const double in[3] = {sigma_a, sigma_a, sigma_a};
    double out[3];
    assert_int_equal(tsu_hair_albedo(context, eta, in, out), TSU_OK);
    assert_true(out[0] == out[1] && out[1] == out[2]);
    return out[0];
}

static void a_fibre_without_pigment_keeps_all_light(void **state)
{
    (void)state;
    context = watch_open(&watch);
    for (int i = 0; i <= 16; i++)
        assert_true(fabs(albedo_of(1.2 + 0.05 * i, 0.0) - 1.0) <= 1e-9);
    tsu_context_destroy(context);
    watch_close(&watch);
}

// Without an inside the fibre is a mirror cylinder: Fresnel's reflectance for unpolarised light,
// averaged over where the light strikes (h) and how it is inclined (theta, weight cos^2). Straight
// midpoint sums; the library's own quadrature has no part in it.
static double surface_reflection(double eta)
{
    enum { N = 400 };
    double sum = 0, weight = 0;
    for (int i = 0; i < N; i++) {
        const double theta = (i + 0.5) / N * 1.5707963267948966, w = cos(theta) * cos(theta);
        for (int j = 0; j < N; j++) {
            const double gamma = (j + 0.5) / N * 1.5707963267948966; // h = sin(gamma), dh = cos
            const double c = cos(theta) * cos(gamma);
            const double t = sqrt(1 - (1 - c * c) / (eta * eta));
            const double s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
            sum += w * cos(gamma) * 0.5 * (s * s + p * p);
            weight += w * cos(gamma);
        }
    }
    return sum / weight;
}

static void black_hair_reflects_at_its_surface(void **state)
{
    (void)state;
    context = watch_open(&watch);
    static const double eta[] = {1.2, 1.3, 1.55, 1.8, 2.0};
    for (int i = 0; i < 5; i++) {
        const double expected = surface_reflection(eta[i]), got = albedo_of(eta[i], 1e6);
        if (!(fabs(got - expected) <= 2e-3 * expected))
            fail_msg("eta %g: %.6f, expected %.6f", eta[i], got, expected);
    }
    tsu_context_destroy(context);
    watch_close(&watch);
}

static void albedo_falls_with_absorption(void **state)
{
    (void)state;
    context = watch_open(&watch);
    double last = 2;
    for (double sigma_a = 0; sigma_a < 15; sigma_a = sigma_a * 1.3 + 0.01) {
        const double now = albedo_of(1.55, sigma_a);
        assert_true(now < last);
        last = now;
    }
    tsu_context_destroy(context);
    watch_close(&watch);
}

static void albedo_comes_back(void **state)
{
    (void)state;
    context = watch_open(&watch);
    double worst = 0, darkest = 0;
    for (int e = 0; e <= 8; e++) {
        const double eta = 1.2 + 0.1 * e, least = albedo_of(eta, 1e6);
        for (double above = 1e-3; above > 1e-12; above *= 0.7) {
            const double in[3] = {least + above, 1.0, 1.0};
            double sigma_a[3], out[3];
            assert_int_equal(tsu_hair_sigma_a(context, eta, in, sigma_a), TSU_OK);
            assert_int_equal(tsu_hair_albedo(context, eta, sigma_a, out), TSU_OK);
            darkest = fmax(darkest, fabs(out[0] - in[0]));
        }
        for (int i = 1; i <= 40; i++) {
            const double albedo = fmin(least + (1 - least) * i / 40.0, 1.0);
            const double in[3] = {albedo, 0.5 * (albedo + 1), 1.0};
            double sigma_a[3], out[3];
            assert_int_equal(tsu_hair_sigma_a(context, eta, in, sigma_a), TSU_OK);
            assert_true(sigma_a[2] == 0.0);
            assert_int_equal(tsu_hair_albedo(context, eta, sigma_a, out), TSU_OK);
            for (int k = 0; k < 3; k++) {
                worst = fmax(worst, fabs(out[k] - in[k]));
                assert_true(sigma_a[k] >= 0.0);
            }
        }
    }
    print_message("albedo -> sigma_a -> albedo: worst %.2g, near the least %.2g\n", worst, darkest);
    assert_true(worst <= 1.01e-12 && darkest <= 1.01e-12);
    tsu_context_destroy(context);
    watch_close(&watch);
}

static void impossible_colours_are_explained(void **state)
{
    (void)state;
    context = watch_open(&watch);
    static const double bad[] = {0.0, 0.09, -1.0, 1.0000001, 2.0, NAN, INFINITY};
    for (int i = 0; i < 7; i++)
        for (int k = 0; k < 3; k++) {
            double in[3] = {0.5, 0.5, 0.5}, out[3] = {9, 9, 9};
            in[k] = bad[i];
            watch_quiet(&watch);
            assert_int_equal(tsu_hair_sigma_a(context, 1.55, in, out), TSU_E_PARAMETER);
            assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
            assert_int_equal(watch.log_count, 1);
            assert_non_null(strstr(watch.log, "albedo"));
            const char *range = strchr(watch.log, '(');
            assert_non_null(range);
            assert_true(fabs(strtod(range + 1, NULL) - surface_reflection(1.55)) < 1e-3);
            assert_non_null(strstr(watch.log, ", 1]"));
        }
    static const double bad_eta[] = {NAN, 1.19, 2.01, INFINITY};
    for (int i = 0; i < 4; i++) {
        const double in[3] = {0.5, 0.5, 0.5};
        double out[3] = {9, 9, 9};
        watch_quiet(&watch);
        assert_int_equal(tsu_hair_sigma_a(context, bad_eta[i], in, out), TSU_E_PARAMETER);
        assert_non_null(strstr(watch.log, "eta"));
        assert_non_null(strstr(watch.log, "[1.2, 2]"));
        assert_int_equal(tsu_hair_albedo(context, bad_eta[i], in, out), TSU_E_PARAMETER);
        assert_true(out[0] == 0 && out[1] == 0 && out[2] == 0);
    }
    static const double bad_sigma[] = {NAN, -1e-6, 1.1e6, INFINITY};
    for (int i = 0; i < 4; i++) {
        const double in[3] = {0.5, bad_sigma[i], 0.5};
        double out[3] = {9, 9, 9};
        watch_quiet(&watch);
        assert_int_equal(tsu_hair_albedo(context, 1.55, in, out), TSU_E_PARAMETER);
        assert_non_null(strstr(watch.log, "sigma_a"));
        assert_non_null(strstr(watch.log, "[0, 1000000]"));
    }
    tsu_context_destroy(context);
    watch_close(&watch);
}

static void presets_are_distinct_colours(void **state)
{
    (void)state;
    context = watch_open(&watch);
    const uint32_t count = tsu_hair_preset_count();
    tsu_hair_preset_info presets[64];
    assert_true(count >= 6 && count <= 64);
    for (uint32_t i = 0; i < count; i++) {
        tsu_hair_preset_info *p = presets + i;
        double expected[3];
        assert_int_equal(tsu_hair_preset_info_init(p), TSU_OK);
        assert_int_equal(tsu_hair_preset(i, p), TSU_OK);
        assert_true(p->name && p->name[0]);
        assert_int_equal(tsu_hair_melanin(context, p->eumelanin, p->pheomelanin, expected), TSU_OK);
        assert_memory_equal(p->sigma_a, expected, sizeof expected);
        for (uint32_t k = 0; k < i; k++) {
            assert_string_not_equal(presets[k].name, p->name);
            assert_memory_not_equal(presets[k].sigma_a, p->sigma_a, sizeof p->sigma_a);
        }
    }
    tsu_hair_preset_info past;
    tsu_hair_preset_info_init(&past);
    assert_int_equal(tsu_hair_preset(count, &past), TSU_E_PARAMETER);
    past.struct_size = 0;
    assert_int_equal(tsu_hair_preset(0, &past), TSU_E_STRUCT);
    tsu_context_destroy(context);
    watch_close(&watch);
}

int color_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(melanin_follows_its_source),
        cmocka_unit_test(a_fibre_without_pigment_keeps_all_light),
        cmocka_unit_test(black_hair_reflects_at_its_surface),
        cmocka_unit_test(albedo_falls_with_absorption),
        cmocka_unit_test(albedo_comes_back),
        cmocka_unit_test(impossible_colours_are_explained),
        cmocka_unit_test(presets_are_distinct_colours),
    };
    return cmocka_run_group_tests_name("color", tests, NULL, NULL);
}

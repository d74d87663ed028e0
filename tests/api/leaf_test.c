// Leaves: presets, contents and reflectances to layers, what layers do, and every refusal. The
// inversion itself: tests/optics/leaf_inverse_test.c.
#include "tests.h"
#include "watched.h"

#include <tsuya/leaf.h>
#include <tsuya/models/leaf.h>

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static tsu_leaf_pigments contents(void)
{
    tsu_leaf_pigments pigments;
    assert_int_equal(tsu_leaf_pigments_init(&pigments), TSU_OK);
    return pigments;
}

static tsu_leaf_reflectance faces(double R_top, double R_bottom, double T)
{
    tsu_leaf_reflectance out;
    assert_int_equal(tsu_leaf_reflectance_init(&out), TSU_OK);
    for (int k = 0; k < 3; k++) {
        out.R_top[k] = R_top;
        out.R_bottom[k] = R_bottom;
        out.T[k] = T;
    }
    return out;
}

static tsu_leaf_report empty(void)
{
    tsu_leaf_report report;
    assert_int_equal(tsu_leaf_report_init(&report), TSU_OK);
    return report;
}

static tsu_leaf_body_params layers(void)
{
    tsu_leaf_body_params params;
    assert_int_equal(tsu_leaf_body_params_init(&params), TSU_OK);
    return params;
}

static double apart(const double a[3], const double b[3])
{
    return fmax(fmax(fabs(a[0] - b[0]), fabs(a[1] - b[1])), fabs(a[2] - b[2]));
}

// Every preset makes layers that the model takes and that do what the report says.
static void presets_become_layers(void **state)
{
    (void)state;
    const uint32_t count = tsu_leaf_preset_count();
    assert_int_equal(count, 9);
    for (uint32_t i = 0; i < count; i++) {
        tsu_leaf_pigments pigments = contents();
        assert_int_equal(tsu_leaf_preset(i, &pigments), TSU_OK);
        for (uint32_t k = 0; k < i; k++)
            assert_string_not_equal(tsu_leaf_preset_name(i), tsu_leaf_preset_name(k));
        tsu_leaf_body_params params = layers();
        params.pigment = 0.5f;
        params.thickness = 2.0f;
        tsu_leaf_report report = empty(), measured = empty();
        assert_int_equal(
            tsu_leaf_from_pigments(context, tsu_leaf_body(), &pigments, &params, &report), TSU_OK);
        assert_true(params.pigment == 0.5f && params.thickness == 2.0f);
        assert_true(params.n == 1.45f);
        params.pigment = params.thickness = 1.0f;
        assert_int_equal(tsu_model_params_check(context, tsu_leaf_body(), &params), TSU_OK);
        assert_int_equal(tsu_leaf_measure(context, tsu_leaf_body(), &params, &measured), TSU_OK);
        // Depths are stored as floats.
        assert_true(apart(measured.R_top, report.R_top) <= 1e-6);
        assert_true(apart(measured.R_bottom, report.R_bottom) <= 1e-6);
        assert_true(apart(measured.T, report.T) <= 1e-6);
        double R[3], T[3];
        assert_int_equal(tsu_leaf_color(context, &pigments, R, T), TSU_OK);
        for (int k = 0; k < 3; k++) {
            const int raised = report.raised >> k & 1, limited = report.limited >> k & 1;
            const int shown = R[k] >= 0.0337 + 0.002 && T[k] >= 0.0005;
            assert_true(raised == !shown);
            if (!raised)
                assert_true(fabs(report.R_top[k] - R[k]) <= 1e-6 &&
                            fabs(report.T[k] - T[k]) <= 1e-6);
            else
                assert_true(report.R_top[k] >= R[k] - 1e-6 && report.T[k] >= 0.0005 - 1e-6);
            if (!limited)
                assert_true(report.residual[k] <= 1e-4 &&
                            fabs(report.R_bottom[k] - pigments.bottom * report.R_top[k]) <= 1e-4);
            else
                assert_true(report.R_bottom[k] < pigments.bottom * report.R_top[k]);
            assert_true(report.residual[k] <= 1e-4 || limited);
        }
        print_message("%-17s R %.3f %.3f %.3f, T %.4f %.4f %.4f, bottom/top %.2f %.2f %.2f%s\n",
                      tsu_leaf_preset_name(i), report.R_top[0], report.R_top[1], report.R_top[2],
                      report.T[0], report.T[1], report.T[2], report.R_bottom[0] / report.R_top[0],
                      report.R_bottom[1] / report.R_top[1], report.R_bottom[2] / report.R_top[2],
                      report.raised ? ", raised" : "");
    }
    assert_null(tsu_leaf_preset_name(count));
    tsu_leaf_pigments past = contents();
    assert_int_equal(tsu_leaf_preset(count, &past), TSU_E_PARAMETER);
    past.struct_size = 0;
    assert_int_equal(tsu_leaf_preset(0, &past), TSU_E_STRUCT);
    // The default is one of them.
    tsu_leaf_pigments mature = contents();
    const tsu_leaf_pigments start = contents();
    uint32_t index = 0;
    while (strcmp(tsu_leaf_preset_name(index), "mature_broadleaf"))
        index++;
    mature.chlorophyll = 0;
    assert_int_equal(tsu_leaf_preset(index, &mature), TSU_OK);
    assert_memory_equal(&mature, &start, sizeof mature);
}

// Output of PROSPECT-D's authors, see tests/optics/prospect_test.c; a white leaf; a black one.
static void spectrum_and_colour(void **state)
{
    (void)state;
    tsu_leaf_pigments pigments = contents();
    pigments.N = 1.2;
    pigments.chlorophyll = 30;
    pigments.carotenoids = 10;
    pigments.anthocyanins = 1;
    pigments.water = 0.015;
    pigments.dry_matter = 0.009;
    static const double rows[][3] = {
        {400, 0.043088, 0.000701}, {560, 0.125130, 0.192810}, {780, 0.385428, 0.531516}};
    for (int i = 0; i < 3; i++) {
        double R, T;
        assert_int_equal(tsu_leaf_spectrum(context, &pigments, rows[i][0], &R, &T), TSU_OK);
        assert_true(fabs(R - rows[i][1]) <= 1e-6 && fabs(T - rows[i][2]) <= 1e-6);
    }
    pigments.chlorophyll = pigments.carotenoids = pigments.anthocyanins = 0;
    pigments.water = pigments.dry_matter = 0;
    double R[3], T[3];
    assert_int_equal(tsu_leaf_color(context, &pigments, R, T), TSU_OK);
    for (int k = 0; k < 3; k++)
        assert_true(fabs(R[k] + T[k] - 1) <= 1e-9);
    pigments.brown = 1e6;
    assert_int_equal(tsu_leaf_color(context, &pigments, R, T), TSU_OK);
    for (int k = 0; k < 3; k++)
        assert_true(R[k] > 0.03 && R[k] < 0.045 && T[k] == 0);
}

// Contents at the ends of their ranges still make layers.
static void odd_contents_become_layers(void **state)
{
    (void)state;
    static const double amounts[] = {0, 1e6};
    for (int i = 0; i < 32; i++) {
        tsu_leaf_pigments pigments = contents();
        pigments.N = i & 1 ? 10 : 1;
        pigments.chlorophyll = pigments.carotenoids = amounts[i >> 1 & 1];
        pigments.anthocyanins = amounts[i >> 2 & 1];
        pigments.brown = pigments.water = pigments.dry_matter = amounts[i >> 3 & 1];
        pigments.bottom = i & 16 ? 4 : 0.25;
        tsu_leaf_body_params params = layers();
        tsu_leaf_report report = empty();
        assert_int_equal(
            tsu_leaf_from_pigments(context, tsu_leaf_body(), &pigments, &params, &report), TSU_OK);
        assert_int_equal(tsu_model_params_check(context, tsu_leaf_body(), &params), TSU_OK);
        for (int k = 0; k < 3; k++)
            assert_true(report.R_top[k] >= 0.03 && report.R_bottom[k] >= 0.03 && report.T[k] >= 0 &&
                        report.R_top[k] + report.T[k] <= 1.0001);
    }
}

// Layers that are known, what they do, and layers that do the same.
static void layers_come_back(void **state)
{
    (void)state;
    tsu_leaf_body_params known = layers();
    static const float scatter[3] = {2.0f, 2.2f, 2.4f}, absorption[3] = {0.8f, 0.3f, 1.5f};
    for (int k = 0; k < 3; k++) {
        known.scatter_top[k] = 0.1f;
        known.absorption_top[k] = absorption[k];
        known.scatter_bottom[k] = scatter[k];
        known.absorption_bottom[k] = 0.9f * absorption[k];
    }
    tsu_leaf_report report = empty(), again = empty();
    assert_int_equal(tsu_leaf_measure(context, tsu_leaf_body(), &known, &report), TSU_OK);
    tsu_leaf_reflectance asked = faces(0, 0, 0);
    memcpy(asked.R_top, report.R_top, sizeof report.R_top);
    memcpy(asked.R_bottom, report.R_bottom, sizeof report.R_bottom);
    memcpy(asked.T, report.T, sizeof report.T);
    tsu_leaf_body_params found = layers();
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &found, &again),
                     TSU_OK);
    for (int k = 0; k < 3; k++) {
        assert_true(again.residual[k] <= 1e-7);
        assert_true(fabs((double)found.scatter_top[k] - 0.1) <= 1e-7);
        assert_true(fabs((double)found.scatter_bottom[k] / (double)scatter[k] - 1) <= 1e-4);
        assert_true(fabs((double)found.absorption_top[k] / (double)absorption[k] - 1) <= 1e-4);
    }
    // Twice the pigment in the factor or in the layers is the same; so is the thickness.
    tsu_leaf_report one = empty(), other = empty();
    tsu_leaf_body_params factor = known, depth = known;
    factor.pigment = 2.0f;
    factor.thickness = 1.5f;
    for (int k = 0; k < 3; k++) {
        depth.scatter_top[k] *= 1.5f;
        depth.scatter_bottom[k] *= 1.5f;
        depth.absorption_top[k] *= 3.0f;
        depth.absorption_bottom[k] *= 3.0f;
    }
    assert_int_equal(tsu_leaf_measure(context, tsu_leaf_body(), &factor, &one), TSU_OK);
    assert_int_equal(tsu_leaf_measure(context, tsu_leaf_body(), &depth, &other), TSU_OK);
    assert_true(apart(one.R_top, other.R_top) <= 1e-7 && apart(one.T, other.T) <= 1e-7);
    assert_true(one.R_top[1] < report.R_top[1]);
    // The glossy model has the same layers.
    tsu_leaf_params glossy;
    assert_int_equal(tsu_leaf_params_init(&glossy), TSU_OK);
    glossy.roughness = 0.6f;
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf(), &asked, &glossy, NULL), TSU_OK);
    assert_memory_equal(glossy.absorption_top, found.absorption_top, sizeof found.absorption_top);
    assert_true(glossy.roughness == 0.6f);
    // A report is not needed.
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &found, NULL),
                     TSU_OK);
}

// An error names field, channel and the nearest possible, in the log and in the report, which can
// then be had.
static void refuse(const tsu_leaf_reflectance *asked, const char *part)
{
    const tsu_leaf_body_params before = layers();
    tsu_leaf_body_params params = before;
    tsu_leaf_report report = empty();
    watch_quiet(&watch);
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), asked, &params, &report),
                     TSU_E_PARAMETER);
    assert_memory_equal(&params, &before, sizeof params);
    assert_int_equal(watch.log_count, 1);
    if (!strstr(watch.log, part))
        fail_msg("\"%s\" is not in \"%s\"", part, watch.log);
    const char *nearest = strstr(watch.log, "nearest possible is R_top ");
    assert_non_null(nearest);
    const char *channel = strchr(watch.log, '['); // of the line's code
    assert_non_null(channel = strchr(channel + 1, '['));
    const int k = atoi(channel + 1);
    nearest += strlen("nearest possible is R_top ");
    assert_true(fabs(strtod(nearest, NULL) - report.R_top[k]) <= 1e-6);
    assert_true(fabs(strtod(strstr(nearest, "R_bottom ") + 9, NULL) - report.R_bottom[k]) <= 1e-6);
    assert_true(fabs(strtod(strstr(nearest, "T ") + 2, NULL) - report.T[k]) <= 1e-6);
    tsu_leaf_reflectance offered = *asked;
    memcpy(offered.R_top, report.R_top, sizeof report.R_top);
    memcpy(offered.R_bottom, report.R_bottom, sizeof report.R_bottom);
    memcpy(offered.T, report.T, sizeof report.T);
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &offered, &params, NULL),
                     TSU_OK);
}

static void impossible_faces_are_explained(void **state)
{
    (void)state;
    tsu_leaf_reflectance asked = faces(0.15, 0.2, 0.15);
    asked.T[1] = 0.9;
    refuse(&asked, "R_bottom[1] + T[1] = 1.1, expected at most 1");
    asked = faces(0.15, 0.2, 0.15);
    asked.R_top[2] = 0.02;
    refuse(&asked, "R_top[2] = 0.02, expected at least 0.0337");
    asked = faces(0.15, 0.2, 0.15);
    asked.R_bottom[0] = -0.5;
    refuse(&asked, "R_bottom[0] = -0.5, expected at least 0.0337");
    asked = faces(0.15, 0.2, 0.15);
    asked.T[0] = -0.25;
    refuse(&asked, "T[0] = -0.25");
    // A yellow leaf is too clear to be twice as bright from below.
    asked = faces(0.2947, 0.5894, 0.2858);
    refuse(&asked, "R_bottom[0] = 0.5894 beside R_top 0.2947 and T 0.2858");
    asked.n = 1.7;
    refuse(&asked, "out of two layers' reach");
}

static void bad_values_are_named(void **state)
{
    (void)state;
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    static const char *const names[] = {"R_top", "R_bottom", "T"};
    for (int field = 0; field < 3; field++)
        for (int i = 0; i < 3; i++) {
            tsu_leaf_reflectance asked = faces(0.15, 0.2, 0.15);
            double *const at[] = {asked.R_top, asked.R_bottom, asked.T};
            at[field][i] = bad[i];
            tsu_leaf_body_params params = layers();
            tsu_leaf_report report = empty();
            const tsu_leaf_report none = empty();
            report.T[0] = 9;
            watch_quiet(&watch);
            assert_int_equal(
                tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &params, &report),
                TSU_E_PARAMETER);
            assert_memory_equal(&report, &none, sizeof none);
            assert_int_equal(watch.log_count, 1);
            assert_non_null(strstr(watch.log, names[field]));
        }
    tsu_leaf_body_params params = layers();
    tsu_leaf_reflectance asked = faces(0.15, 0.2, 0.15);
    asked.n = 1.9;
    watch_quiet(&watch);
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &params, NULL),
                     TSU_E_PARAMETER);
    assert_non_null(strstr(watch.log, "tsu_leaf_reflectance.n = 1.9, expected [1.2, 1.8]"));
    asked = faces(0.15, 0.2, 0.15);
    asked.flags = 2;
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &params, NULL),
                     TSU_E_PARAMETER);
    asked = faces(0.15, 0.2, 0.15);
    asked.struct_size = 8;
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &params, NULL),
                     TSU_E_STRUCT);
    params.struct_size = 8;
    asked = faces(0.15, 0.2, 0.15);
    assert_int_equal(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &params, NULL),
                     TSU_E_STRUCT);

    static const struct {
        size_t offset;
        const char *text;
        double low, high;
    } rows[] = {{offsetof(tsu_leaf_pigments, N), ".N ", 0.99, 10.1},
                {offsetof(tsu_leaf_pigments, chlorophyll), ".chlorophyll ", -1e-9, 1.1e6},
                {offsetof(tsu_leaf_pigments, carotenoids), ".carotenoids ", -1e-9, 1.1e6},
                {offsetof(tsu_leaf_pigments, anthocyanins), ".anthocyanins ", -1e-9, 1.1e6},
                {offsetof(tsu_leaf_pigments, brown), ".brown ", -1e-9, 1.1e6},
                {offsetof(tsu_leaf_pigments, water), ".water ", -1e-9, 1.1e6},
                {offsetof(tsu_leaf_pigments, dry_matter), ".dry_matter ", -1e-9, 1.1e6},
                {offsetof(tsu_leaf_pigments, n), ".n ", 1.19, 1.81},
                {offsetof(tsu_leaf_pigments, bottom), ".bottom ", 0.24, 4.1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int which = 0; which < 3; which++) {
            tsu_leaf_pigments pigments = contents();
            const double value = which == 0 ? rows[i].low : which == 1 ? rows[i].high : NAN;
            memcpy((char *)&pigments + rows[i].offset, &value, sizeof value);
            params = layers();
            tsu_leaf_report report = empty();
            double R[3] = {9, 9, 9}, T[3] = {9, 9, 9};
            watch_quiet(&watch);
            assert_int_equal(
                tsu_leaf_from_pigments(context, tsu_leaf_body(), &pigments, &params, &report),
                TSU_E_PARAMETER);
            assert_int_equal(watch.log_count, 1);
            assert_non_null(strstr(watch.log, rows[i].text));
            assert_int_equal(tsu_leaf_color(context, &pigments, R, T), TSU_E_PARAMETER);
            assert_true(R[0] == 0 && T[2] == 0);
            assert_int_equal(tsu_leaf_spectrum(context, &pigments, 500, R, T), TSU_E_PARAMETER);
        }
    const tsu_leaf_pigments pigments = contents();
    static const double lambdas[] = {399.99, 780.01, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        double R = 9, T = 9;
        watch_quiet(&watch);
        assert_int_equal(tsu_leaf_spectrum(context, &pigments, lambdas[i], &R, &T),
                         TSU_E_PARAMETER);
        assert_true(R == 0 && T == 0);
        assert_non_null(strstr(watch.log, "[400, 780]"));
    }
}

static void nulls_and_no_memory(void **state)
{
    (void)state;
    tsu_leaf_pigments pigments = contents();
    tsu_leaf_reflectance asked = faces(0.15, 0.2, 0.15);
    tsu_leaf_body_params params = layers();
    tsu_leaf_report report = empty();
    double R[3], T[3];
    assert_true(tsu_leaf_pigments_init_sized(NULL, sizeof pigments) < 0);
    assert_true(tsu_leaf_reflectance_init_sized(NULL, sizeof asked) < 0);
    assert_true(tsu_leaf_preset(0, NULL) < 0);
    assert_true(tsu_leaf_spectrum(context, NULL, 500, R, T) < 0);
    assert_true(tsu_leaf_spectrum(context, &pigments, 500, NULL, T) < 0);
    assert_true(tsu_leaf_spectrum(context, &pigments, 500, R, NULL) < 0);
    assert_int_equal(tsu_leaf_spectrum(NULL, &pigments, 500, R, T), TSU_OK);
    assert_true(tsu_leaf_color(context, NULL, R, T) < 0);
    assert_true(tsu_leaf_color(context, &pigments, NULL, T) < 0);
    assert_true(tsu_leaf_color(context, &pigments, R, NULL) < 0);
    assert_true(tsu_leaf_from_pigments(NULL, tsu_leaf_body(), &pigments, &params, &report) < 0);
    assert_true(tsu_leaf_from_pigments(context, tsu_leaf_body(), NULL, &params, &report) < 0);
    assert_true(tsu_leaf_from_pigments(context, tsu_leaf_body(), &pigments, NULL, &report) < 0);
    assert_true(tsu_leaf_from_reflectance(NULL, tsu_leaf_body(), &asked, &params, &report) < 0);
    assert_true(tsu_leaf_from_reflectance(context, tsu_leaf_body(), NULL, &params, &report) < 0);
    assert_true(tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, NULL, &report) < 0);
    assert_true(tsu_leaf_measure(NULL, tsu_leaf_body(), &params, &report) < 0);
    assert_true(tsu_leaf_measure(context, tsu_leaf_body(), NULL, &report) < 0);
    assert_true(tsu_leaf_measure(context, tsu_leaf_body(), &params, NULL) < 0);
    // Hair has no layers.
    tsu_marschner_params hair;
    assert_int_equal(tsu_marschner_params_init(&hair), TSU_OK);
    watch_quiet(&watch);
    assert_int_equal(tsu_leaf_measure(context, tsu_marschner(), &hair, &report), TSU_E_PARAMETER);
    assert_non_null(strstr(watch.log, "marschner"));
    assert_true(tsu_leaf_measure(context, NULL, &params, &report) < 0);
    params.n = NAN;
    assert_int_equal(tsu_leaf_measure(context, tsu_leaf_body(), &params, &report), TSU_E_PARAMETER);
    params = layers();
    const tsu_leaf_body_params before = params;
    for (int call = 0; call < 3; call++) {
        watch.fail_at = watch.calls + 1;
        const tsu_status status =
            call == 0
                ? tsu_leaf_from_pigments(context, tsu_leaf_body(), &pigments, &params, &report)
            : call == 1
                ? tsu_leaf_from_reflectance(context, tsu_leaf_body(), &asked, &params, &report)
                : tsu_leaf_measure(context, tsu_leaf_body(), &params, &report);
        watch.fail_at = 0;
        assert_int_equal(status, TSU_E_MEMORY);
        assert_memory_equal(&params, &before, sizeof params);
    }
}

int leaf_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(presets_become_layers, open_watch, close_watch),
        cmocka_unit_test_setup_teardown(spectrum_and_colour, open_watch, close_watch),
        cmocka_unit_test_setup_teardown(odd_contents_become_layers, open_watch, close_watch),
        cmocka_unit_test_setup_teardown(layers_come_back, open_watch, close_watch),
        cmocka_unit_test_setup_teardown(impossible_faces_are_explained, open_watch, close_watch),
        cmocka_unit_test_setup_teardown(bad_values_are_named, open_watch, close_watch),
        cmocka_unit_test_setup_teardown(nulls_and_no_memory, open_watch, close_watch),
    };
    return cmocka_run_group_tests_name("leaf", tests, NULL, NULL);
}

// Colour of a head: the solution behind tsu_hair_head_curve against figures computed
// independently, and the curve against the solution.
//
// `head_test --print` writes runtime/optics/head_default.inc.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/angle.h"
#include "optics/head_albedo.h"
#include "slab_truth.h"

#include <tsuya/hair_color.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(a) (sizeof(a) / sizeof *(a))

static tsu_context *context;
static double *memory;

static double radians(double degrees)
{
    return degrees * TSU_I_PI / 180.0;
}

// Lobes of tsu_marschner_params, written out once more.
static struct tsu_i_strand strand_of(const tsu_hair_head_desc *desc)
{
    const double a = desc->alpha_R, b = desc->beta_R, s = desc->scale_shifts;
    return (struct tsu_i_strand){
        desc->eta,
        0.0,
        desc->beta_az,
        {a, a * (-0.5 - 0.42 * s), a * (-1.5 - 1.7 * s), a * (-2.5 + 1.3 * s)},
        {b, 0.5 * b, 2.0 * b, 2.0 * b},
        TSU_I_STRAND_DEON,
        TSU_I_LOBES};
}

static tsu_hair_head_desc fibre(double eta, double beta_az, double alpha, double beta, double scale)
{
    tsu_hair_head_desc desc;
    assert_int_equal(tsu_hair_head_desc_init(&desc), TSU_OK);
    desc.eta = (float)eta;
    desc.beta_az = (float)radians(beta_az);
    desc.alpha_R = (float)radians(alpha);
    desc.beta_R = (float)radians(beta);
    desc.scale_shifts = (float)scale;
    return desc;
}

static double solved(const tsu_hair_head_desc *desc, double sigma_a)
{
    struct tsu_i_strand strand = strand_of(desc);
    strand.sigma_a = sigma_a;
    return tsu_i_head_solve(&strand, 0.0, tsu_i_head_azimuths(desc->beta_az), memory);
}

// Monte Carlo walks of another hand, at five inclinations: within three standard errors.
static void half_spaces_are_those_of_walks(void **state)
{
    (void)state;
    int rows = 0;
    for (size_t i = 0; i < COUNT(slab_truth); i++) {
        const struct slab_truth *t = slab_truth + i;
        if (t->tau != 0.0)
            continue;
        const tsu_hair_head_desc desc = fibre(1.55, 10, -7.5, 7.5, 0);
        struct tsu_i_strand strand = strand_of(&desc);
        strand.kind = TSU_I_STRAND_GAUSSIAN;
        strand.sigma_a = t->sigma_a;
        const double r = tsu_i_head_solve(&strand, radians(t->theta_deg),
                                          tsu_i_head_azimuths(strand.beta_az), memory);
        print_message("sigma_a %g, theta %g: %.5f, walk %.5f +- %.5f\n", t->sigma_a, t->theta_deg,
                      r, t->r, t->r_se);
        if (!(fabs(r - t->r) <= 3.0 * t->r_se))
            fail_msg("sigma_a %g, theta %g: %.6f, expected %.6f +- %g", t->sigma_a, t->theta_deg, r,
                     t->r, t->r_se);
        rows++;
    }
    assert_int_equal(rows, 10);
}

static void nodes_are_spread_as_documented(void **state)
{
    (void)state;
    assert_true(tsu_i_head_sigma_a(0) == 0.0);
    for (int i = 1; i < TSU_I_HEAD_NODES - 1; i++) {
        const double root = 0.15 * i / (16 - i);
        assert_true(fabs(tsu_i_head_sigma_a(i) - root * root) <= 1e-15);
    }
    assert_true(tsu_i_head_sigma_a(TSU_I_HEAD_NODES - 1) == 1e6);
}

static tsu_hair_head_curve curve_of(const tsu_hair_head_desc *desc)
{
    tsu_hair_head_curve curve;
    assert_int_equal(tsu_hair_head_curve_init(&curve), TSU_OK);
    assert_int_equal(tsu_hair_head_curve_solve(context, desc, &curve), TSU_OK);
    return curve;
}

static void compiled_constants_are_solutions(void **state)
{
    (void)state;
    tsu_hair_head_desc desc;
    assert_int_equal(tsu_hair_head_desc_init(&desc), TSU_OK);
    const tsu_hair_head_curve curve = curve_of(&desc);
    assert_true(curve.albedo[0] == 1.0);
    static const int nodes[] = {3, 8, 13, 16};
    for (size_t i = 0; i < COUNT(nodes); i++)
        assert_true(fabs(solved(&desc, tsu_i_head_sigma_a(nodes[i])) - curve.albedo[nodes[i]]) <=
                    1e-9);
}

// Albedo to sigma_a by the curve, and back by the solution, at the middles of the nodes and in
// every other colour asked for: what a host relies on.
static void round_trip(const char *name, const tsu_hair_head_desc *desc, int middles, int colours)
{
    const tsu_hair_head_curve curve = curve_of(desc);
    double worst = 0.0;
    for (int i = 0; i < middles + colours; i++) {
        double albedo[3] = {1.0, 1.0, 1.0}, sigma_a[3];
        if (i < middles) {
            const double place = i * 16 / middles + 0.5, root = 0.15 * place / (16 - place);
            sigma_a[0] = sigma_a[1] = sigma_a[2] = root * root;
            assert_int_equal(tsu_hair_head_albedo(context, &curve, sigma_a, albedo), TSU_OK);
        } else {
            const double share = (i - middles + 0.3) / colours;
            albedo[0] = curve.albedo[16] + (1.0 - curve.albedo[16]) * share;
        }
        assert_int_equal(tsu_hair_head_sigma_a(context, &curve, albedo, sigma_a), TSU_OK);
        const double again = solved(desc, sigma_a[0]);
        worst = fmax(worst, fabs(again - albedo[0]));
        if (!(fabs(again - albedo[0]) <= 3e-4))
            fail_msg("%s: albedo %.6f, sigma_a %g, solved %.6f", name, albedo[0], sigma_a[0],
                     again);
    }
    print_message("%s: albedo -> sigma_a -> solution, worst %.2g\n", name, worst);
}

static void the_solution_gives_the_albedo_back(void **state)
{
    (void)state;
    const int many = getenv("TSUYA_LONG") != NULL;
    tsu_hair_head_desc desc;
    assert_int_equal(tsu_hair_head_desc_init(&desc), TSU_OK);
    round_trip("default", &desc, 16, 10);
    static const struct {
        const char *name;
        double eta, beta_az, alpha, beta, scale;
    } fibres[] = {
        {"broad, high index", 2, 30, -20, 30, 1}, {"narrow, high index", 2, 5, 20, 2, 1},
        {"broad, low index", 1.2, 30, 0, 30, 0},  {"narrow, low index", 1.2, 5, -7.5, 2, 0},
        {"usual", 1.45, 15, -3, 12, 0.5},         {"narrow azimuth", 1.55, 7, -10, 5, 1}};
    for (size_t i = 0; i < (many ? COUNT(fibres) : 1); i++) {
        desc = fibre(fibres[i].eta, fibres[i].beta_az, fibres[i].alpha, fibres[i].beta,
                     fibres[i].scale);
        round_trip(fibres[i].name, &desc, many ? 16 : 4, many ? 10 : 2);
    }
}

// The solution against itself with twice the azimuths.
static void azimuths_are_enough(void **state)
{
    (void)state;
    const int many = getenv("TSUYA_LONG") != NULL;
    const double sigma_a[] = {0.002, 0.02, 0.3};
    const double beta_az[] = {10, 20, 5};
    for (int b = 0; b < (many ? 3 : 1); b++)
        for (int i = 0; i < (many ? 3 : 1); i++) {
            const tsu_hair_head_desc desc = fibre(1.55, beta_az[b], -7.5, 7.5, 0);
            struct tsu_i_strand strand = strand_of(&desc);
            strand.sigma_a = sigma_a[many ? i : 1];
            const double few = solved(&desc, strand.sigma_a);
            const double all = tsu_i_head_solve(&strand, 0.0, 12, memory);
            print_message("beta_az %g, sigma_a %g: %.6f, of 12 azimuths %.6f\n", beta_az[b],
                          strand.sigma_a, few, all);
            assert_true(fabs(few - all) <= (beta_az[b] < 10 ? 1e-3 : 3e-4));
        }
}

static void print_default(void)
{
    tsu_hair_head_desc desc;
    tsu_hair_head_desc_init(&desc);
    puts("// Albedo at the nodes for the default fibre; `tests/optics/head_test --print` made "
         "it.\n1.0,");
    for (int i = 1; i < TSU_I_HEAD_NODES; i++)
        printf("%.12f,\n", solved(&desc, tsu_i_head_sigma_a(i)));
}

int main(int argc, char **argv)
{
    tsu_context_desc desc;
    memory = malloc(tsu_i_head_doubles(12) * sizeof *memory);
    if (!memory || tsu_context_desc_init(&desc) != TSU_OK ||
        tsu_context_create(&desc, &context) != TSU_OK)
        return 1;
    int failed = 0;
    if (argc > 1 && !strcmp(argv[1], "--print")) {
        print_default();
    } else {
        const struct CMUnitTest tests[] = {
            cmocka_unit_test(half_spaces_are_those_of_walks),
            cmocka_unit_test(nodes_are_spread_as_documented),
            cmocka_unit_test(compiled_constants_are_solutions),
            cmocka_unit_test(the_solution_gives_the_albedo_back),
            cmocka_unit_test(azimuths_are_enough),
        };
        failed = cmocka_run_group_tests(tests, NULL, NULL);
    }
    tsu_context_destroy(context);
    free(memory);
    return failed;
}

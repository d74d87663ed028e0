// PROSPECT-D against its authors' output, against layers added one by one, and at its ends.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/prospect.h"

#include <math.h>

static void near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.12g, expected %.12g +- %g", value, expected, tolerance);
}

// Output of the authors' own PROSPECT-D (N 1.2, Cab 30, Car 10, Ant 1, Cw 0.015, Cm 0.009), as
// shipped with github.com/jgomezdans/prosail in tests/data: lambda, R, T.
static void authors_output(void **state)
{
    (void)state;
    static const double rows[][3] = {
        {400, 0.043088, 0.000701}, {420, 0.042020, 0.001340}, {440, 0.041348, 0.001487},
        {460, 0.041060, 0.005797}, {480, 0.041099, 0.009585}, {500, 0.044351, 0.029129},
        {520, 0.073960, 0.104443}, {540, 0.116165, 0.176406}, {560, 0.125130, 0.192810},
        {580, 0.093589, 0.147770}, {600, 0.079865, 0.126838}, {620, 0.064719, 0.099508},
        {640, 0.056082, 0.081580}, {660, 0.041735, 0.041453}, {680, 0.036410, 0.017985},
        {700, 0.128955, 0.210680}, {720, 0.283872, 0.409961}, {740, 0.359378, 0.499282},
        {760, 0.378083, 0.522386}, {780, 0.385428, 0.531516}};
    const struct tsu_i_prospect leaf = {1.2, 30, 10, 1, 0, 0.015, 0.009};
    double R[TSU_I_SPECTRUM_POINTS], T[TSU_I_SPECTRUM_POINTS], worst = 0.0;
    tsu_i_prospect_spectrum(&leaf, R, T);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double r, t;
        tsu_i_prospect_leaf(&leaf, rows[i][0], &r, &t);
        worst = fmax(worst, fmax(fabs(r - rows[i][1]), fabs(t - rows[i][2])));
        const int point = ((int)rows[i][0] - TSU_I_SPECTRUM_FIRST) / TSU_I_SPECTRUM_STEP;
        assert_true(r == R[point] && t == T[point]);
    }
    print_message("against the authors' output: %.1e\n", worst);
    assert_true(worst <= 1e-6);
}

// Means over 610..680, 530..570 and 430..490 nm of another implementation with coefficients at
// // 1 nm, of leaves with brown pigments and with other structures. Lines between points 10 nm
// apart leave out the curvature within them.
static void other_leaves(void **state)
{
    (void)state;
    static const struct {
        struct tsu_i_prospect leaf;
        double R[3], T[3];
    } rows[] = {
        {{1.3, 25, 7, 0.5, 0, 0.01, 0.004}, {0.0650, 0.1630, 0.0429}, {0.0787, 0.2124, 0.0122}},
        {{1.8, 70, 14, 1, 0, 0.015, 0.008}, {0.0406, 0.0995, 0.0410}, {0.0064, 0.0561, 0.0002}},
        {{1.6, 3, 8, 0.5, 0.1, 0.008, 0.007}, {0.2947, 0.2869, 0.0569}, {0.2858, 0.2649, 0.0246}},
        {{2.5, 2, 2, 0, 1.5, 0.001, 0.007}, {0.2414, 0.1836, 0.1037}, {0.0958, 0.0564, 0.0176}},
        {{2.5, 50, 10, 0, 0, 0.02, 0.02}, {0.0629, 0.1835, 0.0440}, {0.0076, 0.0563, 0.0004}}};
    static const int band[3][2] = {{610, 680}, {530, 570}, {430, 490}};
    double worst = 0.0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int k = 0; k < 3; k++) {
            double r = 0, t = 0;
            int count = 0;
            for (int nm = band[k][0]; nm <= band[k][1]; nm += 2, count++) {
                double one_r, one_t;
                tsu_i_prospect_leaf(&rows[i].leaf, nm, &one_r, &one_t);
                r += one_r;
                t += one_t;
            }
            worst = fmax(worst, fabs(r / count - rows[i].R[k]));
            worst = fmax(worst, fabs(t / count - rows[i].T[k]));
        }
    print_message("against means over bands: %.1e\n", worst);
    assert_true(worst <= 3e-3);
}

// Colours of two leaves summed at 5 nm by another implementation, with coefficients and observer of
// its own: the 10 nm of the library are enough.
static void colours(void **state)
{
    (void)state;
    static const struct {
        struct tsu_i_prospect leaf;
        double R[3], T[3];
    } rows[] = {{{1.3, 25, 7, 0.5, 0, 0.01, 0.004},
                 {0.09690, 0.13982, 0.03172},
                 {0.13493, 0.18145, -0.00887}},
                {{1.6, 3, 8, 0.5, 0.1, 0.008, 0.007},
                 {0.40066, 0.23745, 0.02884},
                 {0.39217, 0.21534, -0.00561}}};
    double worst = 0.0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double R[TSU_I_SPECTRUM_POINTS], T[TSU_I_SPECTRUM_POINTS], r[3], t[3];
        tsu_i_prospect_spectrum(&rows[i].leaf, R, T);
        tsu_i_spectrum_rgb(R, r);
        tsu_i_spectrum_rgb(T, t);
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, fmax(fabs(r[k] - rows[i].R[k]), fabs(t[k] - rows[i].T[k])));
    }
    print_message("colours at 10 nm against 5 nm: %.1e\n", worst);
    assert_true(worst <= 5e-5);
}

// Plates are the same when contents grow with N. Two unknowns, r and t of a plate lit from
// everywhere, follow from N = 1 and N = 2:
//   R_2 - R_1 = T_1 t r / (1 - r r),  T_2 = T_1 t / (1 - r r);
// piles of 3 to 6 are then added plate by plate.
static void whole_plates_are_added(void **state)
{
    (void)state;
    for (int nm = 400; nm <= 780; nm += 10) {
        struct tsu_i_prospect leaf = {1, 2, 3, 0.5, 0.05, 0.004, 0.002};
        const struct tsu_i_prospect unit = leaf;
        double first_r, first_t, two_r, two_t;
        tsu_i_prospect_leaf(&leaf, nm, &first_r, &first_t);
        leaf = (struct tsu_i_prospect){2, 4, 6, 1, 0.1, 0.008, 0.004};
        tsu_i_prospect_leaf(&leaf, nm, &two_r, &two_t);
        const double r = (two_r - first_r) / two_t, t = two_t / first_t * (1 - r * r);
        double pile_r = r, pile_t = t;
        for (int n = 3; n <= 6; n++) {
            const double between = 1 / (1 - pile_r * r);
            const double more_r = pile_r + pile_t * pile_t * r * between;
            pile_t = pile_t * t * between;
            pile_r = more_r;
            leaf = (struct tsu_i_prospect){n,
                                           n * unit.chlorophyll,
                                           n * unit.carotenoids,
                                           n * unit.anthocyanins,
                                           n * unit.brown,
                                           n * unit.water,
                                           n * unit.dry_matter};
            double R, T;
            tsu_i_prospect_leaf(&leaf, nm, &R, &T);
            near(R, first_r + first_t * pile_r * t / (1 - pile_r * r), 1e-9);
            near(T, first_t * pile_t / (1 - pile_r * r), 1e-9);
        }
    }
}

// Without contents nothing is lost; with very much all that is left is the surface, Fresnel's
// reflectance averaged over the cone of 40 degrees: here by a plain midpoint sum.
static void ends(void **state)
{
    (void)state;
    static const double structure[] = {1, 1.000001, 1.5, 2, 3.7, 10};
    for (size_t i = 0; i < sizeof structure / sizeof *structure; i++)
        for (double nm = 400; nm <= 780; nm += 7.7) {
            struct tsu_i_prospect leaf = {.N = structure[i]};
            double R, T;
            tsu_i_prospect_leaf(&leaf, nm, &R, &T);
            near(R + T, 1.0, 1e-9);
            assert_true(R > 0.03 && T > 0.0);
            for (double content = 1e-15; content < 1e9; content *= 10) {
                const double before_r = R, before_t = T;
                leaf.chlorophyll = leaf.water = content;
                tsu_i_prospect_leaf(&leaf, nm, &R, &T);
                assert_true(R > 0.03 && T >= 0.0 && R + T <= 1.0 + 1e-12);
                assert_true(R <= before_r + 1e-7 && T <= before_t + 1e-7);
            }
            assert_true(T == 0.0);
        }
    const struct tsu_i_prospect black = {.N = 1.5, .brown = 1e6};
    double R, T, sum = 0, weight = 0;
    tsu_i_prospect_leaf(&black, 400, &R, &T);
    const double n = 1.5115; // of the table at 400 nm
    for (int i = 0; i < 20000; i++) {
        const double a = (i + 0.5) / 20000 * 40 * 3.14159265358979 / 180, c = cos(a);
        const double t = sqrt(1 - sin(a) * sin(a) / (n * n));
        const double s = (c - n * t) / (c + n * t), p = (n * c - t) / (n * c + t);
        sum += c * sin(a) * 0.5 * (s * s + p * p);
        weight += c * sin(a);
    }
    near(R, sum / weight, 1e-8);
    near(T, 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(authors_output), cmocka_unit_test(other_leaves),
        cmocka_unit_test(colours),        cmocka_unit_test(whole_plates_are_added),
        cmocka_unit_test(ends),
    };
    return cmocka_run_group_tests_name("prospect", tests, NULL, NULL);
}

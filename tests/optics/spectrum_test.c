// Daylight and observer: published checks of the figures, of the white and of the primaries.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/spectrum.h"

#include <math.h>

static void near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.12g, expected %.12g +- %g", value, expected, tolerance);
}

static void flat(double level, double value[TSU_I_SPECTRUM_POINTS])
{
    for (int i = 0; i < TSU_I_SPECTRUM_POINTS; i++)
        value[i] = level;
}

// CIE 15:2004, table T.3, prints x 0.31272, y 0.32903 for sums at 5 nm. Every other row of the same
// tables moves that by 1e-4, in white and colours alike.
static void white_is_the_published_one(void **state)
{
    (void)state;
    double value[TSU_I_SPECTRUM_POINTS], xyz[3], rgb[3];
    flat(1.0, value);
    tsu_i_spectrum_xyz(value, xyz);
    const double all = xyz[0] + xyz[1] + xyz[2];
    print_message("white: %.5f %.5f %.5f, x %.5f y %.5f\n", xyz[0], xyz[1], xyz[2], xyz[0] / all,
                  xyz[1] / all);
    near(xyz[1], 1.0, 1e-15);
    near(xyz[0] / all, 0.31272, 1.1e-4);
    near(xyz[1] / all, 0.32903, 1.1e-4);
    for (int step = 0; step <= 4; step++) {
        flat(0.25 * step, value);
        tsu_i_spectrum_rgb(value, rgb);
        for (int k = 0; k < 3; k++)
            near(rgb[k], 0.25 * step, 1e-15);
    }
}

// One wavelength alone: its chromaticity is the observer's, whatever the light. Chromaticities of
// the spectrum locus as Wyszecki and Stiles 1982 print them (table I(3.3.1)).
static void lines_lie_on_the_spectrum_locus(void **state)
{
    (void)state;
    static const double locus[][3] = {
        {410, 0.1726, 0.0048}, {450, 0.1566, 0.0177}, {480, 0.0913, 0.1327}, {500, 0.0082, 0.5384},
        {520, 0.0743, 0.8338}, {550, 0.3016, 0.6923}, {580, 0.5125, 0.4866}, {600, 0.6270, 0.3725},
        {650, 0.7260, 0.2740}, {700, 0.7347, 0.2653}};
    for (size_t i = 0; i < sizeof locus / sizeof *locus; i++) {
        double value[TSU_I_SPECTRUM_POINTS], xyz[3];
        flat(0.0, value);
        value[((int)locus[i][0] - TSU_I_SPECTRUM_FIRST) / TSU_I_SPECTRUM_STEP] = 1.0;
        tsu_i_spectrum_xyz(value, xyz);
        const double all = xyz[0] + xyz[1] + xyz[2];
        near(xyz[0] / all, locus[i][1], 1e-4);
        near(xyz[1] / all, locus[i][2], 1e-4);
    }
}

// The matrix of IEC 61966-2-1, which has the same primaries, as printed; its rows are scaled to a
// white that is rounded to four digits, so rows are compared up to a factor.
static void channels_are_those_of_rec_709(void **state)
{
    (void)state;
    static const double matrix[3][3] = {
        {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
    double value[TSU_I_SPECTRUM_POINTS], white[3], worst = 0.0;
    flat(1.0, value);
    tsu_i_spectrum_xyz(value, white);
    for (int i = 0; i < TSU_I_SPECTRUM_POINTS; i++) {
        double xyz[3], rgb[3];
        flat(0.0, value);
        value[i] = 1.0;
        tsu_i_spectrum_xyz(value, xyz);
        tsu_i_spectrum_rgb(value, rgb);
        const double all = xyz[0] + xyz[1] + xyz[2];
        for (int k = 0; k < 3; k++) {
            const double *m = matrix[k];
            const double expected = (m[0] * xyz[0] + m[1] * xyz[1] + m[2] * xyz[2]) /
                                    (m[0] * white[0] + m[1] * white[1] + m[2] * white[2]);
            worst = fmax(worst, fabs(rgb[k] - expected) / all);
        }
    }
    print_message("against the printed matrix: %.1e of X + Y + Z\n", worst);
    assert_true(worst <= 3e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(white_is_the_published_one),
        cmocka_unit_test(lines_lie_on_the_spectrum_locus),
        cmocka_unit_test(channels_are_those_of_rec_709),
    };
    return cmocka_run_group_tests_name("spectrum", tests, NULL, NULL);
}

// Slabs against printed figures, other solvers' runs and closed forms.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "slab_support.h"
#include "slab_figures.h"

#include "optics/angle.h"
#include "optics/fresnel.h"
#include "optics/phase.h"

#include <math.h>
#include <string.h>

#define COUNT(a) (sizeof(a) / sizeof *(a))

static const double zero_mu = 1e-8; // for cosine 0, which is a limit

static void near(const char *what, double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s: %.12g, expected %.12g +- %g", what, value, expected, tolerance);
}

static void solve(struct slab_case *c)
{
    const char *wrong = slab_solve(c);
    if (wrong)
        fail_msg("%s", wrong);
}

static void books(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(slab_books); i++) {
        const struct tsu_i_slab_layer layer = {
            .n = 1.0, .albedo = slab_books[i].a, .depth = slab_books[i].b, .g = slab_books[i].g};
        struct slab_case c = slab_of(&layer, 1, 24);
        const uint32_t in = slab_direction(&c, slab_books[i].mu0, 1.0);
        const double mu = slab_books[i].mu;
        const uint32_t out = mu > 0.0 ? slab_direction(&c, mu, 1.0) : in;
        // A mean over azimuth of so few modes: single scattering is exact in all of them.
        c.desc.modes = mu > 0.0 ? 16 : 1;
        solve(&c);
        const struct tsu_i_slab *s = &c.solved;
        double value = 0.0;
        switch (slab_books[i].quantity) {
        case SLAB_R_MU:
        case SLAB_T_MU:
            for (int k = 0; k < 64; k++) {
                const double phi = TSU_I_PI * (k + 0.5) / 64.0;
                value += (slab_books[i].quantity == SLAB_R_MU
                              ? tsu_i_slab_brdf(s, TSU_I_SLAB_TOP, in, out, phi)
                              : tsu_i_slab_btdf(s, TSU_I_SLAB_TOP, in, out, phi)) *
                         TSU_I_PI / 64.0;
            }
            break;
        case SLAB_UR:
            value = s->reflectance[TSU_I_SLAB_TOP][in];
            break;
        case SLAB_UT:
            value = s->transmittance[TSU_I_SLAB_TOP][in];
            break;
        case SLAB_URU:
            value = s->diffuse_reflectance[TSU_I_SLAB_TOP];
            break;
        case SLAB_UTU:
            value = s->diffuse_transmittance[TSU_I_SLAB_TOP];
            break;
        }
        near("book", value, slab_books[i].value, 5.01e-6);
        slab_free(&c);
    }
}

static void half_spaces(void **state)
{
    (void)state;
    double worst = 0.0;
    for (size_t i = 0; i < COUNT(slab_half_spaces); i++) {
        const struct tsu_i_slab_layer layer = {
            .n = 1.0, .albedo = slab_half_spaces[i].a, .depth = INFINITY};
        struct slab_case c = slab_of(&layer, 1, 24);
        const uint32_t in = slab_direction(&c, 1.0, 1.0);
        const uint32_t out = slab_direction(&c, fmax(slab_half_spaces[i].mu, zero_mu), 1.0);
        solve(&c);
        const struct tsu_i_slab *s = &c.solved;
        const double albedo = s->reflectance[0][out];
        const double r11 = TSU_I_PI * tsu_i_slab_brdf(s, 0, in, out, 1.0);
        near("H, plane albedo", albedo, slab_half_spaces[i].albedo, 2e-7);
        near("H, R(mu, 1)", r11, slab_half_spaces[i].r11, 2e-7);
        worst = fmax(worst, fabs(albedo - slab_half_spaces[i].albedo));
        worst = fmax(worst, fabs(r11 - slab_half_spaces[i].r11));
        assert_true(s->transmittance[0][in] == 0.0);
        slab_free(&c);
    }
    print_message("half spaces: %.1e\n", worst);
}

// 16 nodes at n 1, 8 + 8 above: what models bake with.
static void powers(void **state)
{
    (void)state;
    double worst[2] = {0.0, 0.0};
    for (size_t i = 0; i < COUNT(slab_powers); i++) {
        const int walls = slab_powers[i].n > 1.0;
        const struct tsu_i_slab_layer layer = {.n = slab_powers[i].n,
                                               .albedo = slab_powers[i].a,
                                               .depth = slab_powers[i].b,
                                               .g = slab_powers[i].g};
        struct slab_case c = slab_of(&layer, 1, walls ? 8 : 16);
        slab_direction(&c, slab_powers[i].mu0, 1.0);
        solve(&c);
        const double expected[4] = {slab_powers[i].ur1, slab_powers[i].ut1, slab_powers[i].uru,
                                    slab_powers[i].utu};
        for (int side = 0; side < 2; side++) {
            const double values[4] = {
                c.solved.reflectance[side][0], c.solved.transmittance[side][0],
                c.solved.diffuse_reflectance[side], c.solved.diffuse_transmittance[side]};
            for (int k = 0; k < 4; k++)
                if (expected[k] >= 0.0) {
                    near("powers", values[k], expected[k], walls ? 2e-5 : 5e-6);
                    worst[walls] = fmax(worst[walls], fabs(values[k] - expected[k]));
                }
        }
        slab_free(&c);
    }
    print_message("powers: n 1 %.1e, n > 1 %.1e\n", worst[0], worst[1]);
}

static void disort(void **state)
{
    (void)state;
    static const double rayleigh[3] = {1.0, 0.0, 0.1};
    double worst = 0.0;
    for (size_t i = 0; i < COUNT(slab_disort); i++) {
        struct tsu_i_slab_layer layers[6];
        for (int k = 0; k < slab_disort[i].layers; k++)
            layers[k] = (struct tsu_i_slab_layer){
                .n = 1.0,
                .albedo = slab_disort[i].a[k],
                .depth = slab_disort[i].b[k],
                .g = slab_disort[i].g,
                .chi = slab_disort[i].phase == SLAB_RAYLEIGH ? rayleigh : NULL,
                .chi_count = 3};
        const double mu = fabs(slab_disort[i].mu), phi = slab_disort[i].phi_deg * TSU_I_PI / 180.0;
        struct slab_case c = slab_of(layers, (uint32_t)slab_disort[i].layers, 32);
        const uint32_t in = slab_direction(&c, slab_disort[i].mu0, 1.0);
        const uint32_t out = mu > 0.0 ? slab_direction(&c, mu, 1.0) : in;
        c.desc.modes = 64;
        solve(&c);
        const struct tsu_i_slab *s = &c.solved;
        const double irradiance = slab_disort[i].beam * slab_disort[i].mu0;
        double value = 0.0;
        if (slab_disort[i].mu == 0.0)
            value = irradiance * s->reflectance[0][in] +
                    TSU_I_PI * slab_disort[i].sky * s->diffuse_reflectance[0];
        else if (slab_disort[i].mu > 0.0) // of a sky: what would go to it, backwards
            value = irradiance * tsu_i_slab_brdf(s, 0, in, out, phi) +
                    slab_disort[i].sky * s->reflectance[0][out];
        else
            value = irradiance * tsu_i_slab_btdf(s, 0, in, out, phi) +
                    slab_disort[i].sky * s->transmittance[1][out];
        // The table has eight digits, and not more.
        near("disort", value / slab_disort[i].value, 1.0, 1e-5);
        worst = fmax(worst, fabs(value / slab_disort[i].value - 1.0));
        slab_free(&c);
    }
    print_message("disort: %.1e relative\n", worst);
}

// One solution a medium: all its cosines at once.
static void radiances(void **state)
{
    (void)state;
    double worst = 0.0;
    for (size_t first = 0, end; first < COUNT(slab_radiances); first = end) {
        const double mu0 = slab_radiances[first].mu0;
        const struct tsu_i_slab_layer layer = {.n = 1.0,
                                               .albedo = slab_radiances[first].a,
                                               .depth = slab_radiances[first].b,
                                               .g = slab_radiances[first].g};
        struct slab_case c = slab_of(&layer, 1, 28);
        slab_direction(&c, mu0, 1.0);
        c.desc.modes = 128;
        for (end = first; end < COUNT(slab_radiances) && slab_radiances[end].mu0 == mu0; end++) {
            uint32_t u = 1;
            while (u < c.desc.direction_count && c.directions[u].mu != slab_radiances[end].mu)
                u++;
            if (u == c.desc.direction_count)
                slab_direction(&c, slab_radiances[end].mu, 1.0);
        }
        solve(&c);
        for (size_t i = first; i < end; i++) {
            uint32_t u = 1;
            while (c.directions[u].mu != slab_radiances[i].mu)
                u++;
            const double phi = slab_radiances[i].phi_deg * TSU_I_PI / 180.0;
            const double value = slab_radiances[i].kind == 'R'
                                     ? tsu_i_slab_brdf(&c.solved, 0, 0, u, phi)
                                     : tsu_i_slab_btdf(&c.solved, 0, 0, u, phi);
            near("radiance", value / slab_radiances[i].value, 1.0, 2e-5);
            worst = fmax(worst, fabs(value / slab_radiances[i].value - 1.0));
        }
        slab_free(&c);
    }
    print_message("radiances: %.1e relative\n", worst);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(books),  cmocka_unit_test(half_spaces), cmocka_unit_test(powers),
        cmocka_unit_test(disort), cmocka_unit_test(radiances),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

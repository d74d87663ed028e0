// Slabs that absorb nothing give back what they get, over the whole range of every parameter; and
// limits: nothing scatters, nothing is there, no end to it.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "slab_support.h"

#include "optics/angle.h"
#include "optics/fresnel.h"
#include "optics/quadrature.h"

#include <math.h>
#include <stdlib.h>

#define COUNT(a) (sizeof(a) / sizeof *(a))

static int is_long(void)
{
    const char *text = getenv("TSUYA_LONG");
    return text && *text == '1';
}

static void near(const char *what, double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s: %.15g, expected %.15g +- %g", what, value, expected, tolerance);
}

// Largest deviation of R + T from 1, over cosines, Lambertian light, both sides.
static double imbalance(const struct tsu_i_slab_layer *layers, uint32_t count, uint32_t nodes)
{
    static const double cosines[] = {1.0, 0.6, 0.1, 0.001};
    struct slab_case c = slab_of(layers, count, nodes);
    for (size_t i = 0; i < COUNT(cosines); i++)
        slab_direction(&c, cosines[i], 1.0);
    const char *wrong = slab_solve(&c);
    if (wrong)
        fail_msg("%s", wrong);
    double worst = 0.0;
    for (int side = 0; side < 2; side++) {
        const struct tsu_i_slab *s = &c.solved;
        double sums[COUNT(cosines) + 1];
        for (size_t i = 0; i < COUNT(cosines); i++)
            sums[i] = s->reflectance[side][i] + s->transmittance[side][i];
        sums[COUNT(cosines)] = s->diffuse_reflectance[side] + s->diffuse_transmittance[side];
        for (size_t i = 0; i < COUNT(sums); i++)
            if (!(fabs(sums[i] - 1.0) <= worst))
                worst = fabs(sums[i] - 1.0);
    }
    slab_free(&c);
    return worst;
}

static void white_slabs_conserve(void **state)
{
    (void)state;
    static const double depths[] = {0.0, 1e-8, 1e-4, 0.1, 3.0, 1e2, 1e6, 1e9, INFINITY};
    static const double gs[] = {-0.95, -0.4, 0.0, 0.5, 0.85, 0.95, 0.99};
    static const double indices[] = {1.0, 1.00001, 1.01, 1.2, 1.5, 2.0};
    static const uint32_t nodes[] = {8, 24};
    double worst = 0.0;
    for (size_t k = 0; k < COUNT(nodes); k++)
        for (size_t i = 0; i < COUNT(depths); i++)
            for (size_t j = 0; j < COUNT(gs); j++)
                for (size_t l = 0; l < COUNT(indices); l++) {
                    const struct tsu_i_slab_layer layer = {
                        .n = indices[l], .albedo = 1.0, .depth = depths[i], .g = gs[j]};
                    const double off = imbalance(&layer, 1, nodes[k]);
                    if (!(off <= 1e-9))
                        fail_msg("n %g, depth %g, g %g, %u nodes: R + T off by %.3g", indices[l],
                                 depths[i], gs[j], (unsigned)nodes[k], off);
                    worst = fmax(worst, off);
                }
    print_message("R + T - 1: %.1e\n", worst);
}

static double unit(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

// Random stacks of up to four layers, any of them thick or thin.
static void white_stacks_conserve(void **state)
{
    (void)state;
    uint64_t seed = 41;
    double worst = 0.0;
    const int cases = is_long() ? 4000 : 80;
    for (int i = 0; i < cases; i++) {
        struct tsu_i_slab_layer layers[4];
        const uint32_t count = 1 + (uint32_t)(4.0 * unit(&seed));
        for (uint32_t k = 0; k < count; k++)
            layers[k] = (struct tsu_i_slab_layer){.n = unit(&seed) < 0.3 ? 1.0 : 1.0 + unit(&seed),
                                                  .albedo = 1.0,
                                                  .depth = pow(10.0, -8.0 + 14.0 * unit(&seed)),
                                                  .g = -0.95 + 1.94 * unit(&seed)};
        const double off = imbalance(layers, count, unit(&seed) < 0.5 ? 8 : 16);
        if (!(off <= 1e-9))
            fail_msg("stack %d: R + T off by %.3g", i, off);
        worst = fmax(worst, off);
    }
    print_message("stacks, R + T - 1: %.1e\n", worst);
}

// Nearly white: what is absorbed is 1 - albedo times the mean way inside, which for Lambertian
// light in an index-matched slab is twice the thickness, however it scatters (Blanco and Fournier
// 2003).
static void a_little_absorption(void **state)
{
    (void)state;
    static const double depths[] = {1e-6, 0.01, 1.0, 100.0, 1e4};
    for (size_t i = 0; i < COUNT(depths); i++)
        for (double g = -0.9; g < 1.0; g += 0.45) {
            // Small enough for what is absorbed to be linear in it.
            const double dark = 1e-9 / (depths[i] * depths[i] + depths[i]);
            const struct tsu_i_slab_layer layer = {
                .n = 1.0, .albedo = 1.0 - dark, .depth = depths[i], .g = g};
            struct slab_case c = slab_of(&layer, 1, 16);
            assert_null(slab_solve(&c));
            const double lost =
                1.0 - c.solved.diffuse_reflectance[0] - c.solved.diffuse_transmittance[0];
            near("absorbed", lost, 2.0 * (1.0 - layer.albedo) * depths[i], 1e-12);
            slab_free(&c);
        }
}

static void plates(double n_1, double n_2, double mu, double pass, double *r, double *t)
{
    // Outside, first medium, second medium, outside: a walk of intensities.
    const double k2 = 1.0 - mu * mu, a = sqrt(n_1 * n_1 - k2), b = sqrt(n_2 * n_2 - k2);
    const double mirror[3] = {tsu_i_fresnel_reflect(1.0, mu, n_1, a),
                              tsu_i_fresnel_reflect(n_1, a, n_2, b),
                              tsu_i_fresnel_reflect(n_2, b, 1.0, mu)};
    const double through[2] = {pow(pass, n_1 / a), pow(pass, n_2 / b)};
    double down[2] = {1.0 - mirror[0], 0.0}, up[2] = {0.0, 0.0};
    *r = mirror[0];
    *t = 0.0;
    for (int i = 0; i < 2000; i++) {
        const double d0 = down[0] * through[0], d1 = down[1] * through[1];
        const double u0 = up[0] * through[0], u1 = up[1] * through[1];
        *r += u0 * (1.0 - mirror[0]);
        *t += d1 * (1.0 - mirror[2]);
        down[0] = u0 * mirror[0];
        up[0] = d0 * mirror[1] + u1 * (1.0 - mirror[1]);
        down[1] = d0 * (1.0 - mirror[1]) + u1 * mirror[1];
        up[1] = d1 * mirror[2];
    }
}

// Two absorbing media that scatter nothing, the same from both methods; also with no thickness.
static void clear_plates(void **state)
{
    (void)state;
    static const double indices[][2] = {{1.5, 1.5}, {1.3, 1.7}, {1.7, 1.3}, {1.0, 2.0}, {1.0, 1.0}};
    static const double cosines[] = {1.0, 0.7, 0.2, 0.01};
    for (size_t i = 0; i < COUNT(indices); i++)
        for (double depth = 0.0; depth < 2.0; depth += 0.6) {
            struct tsu_i_slab_layer layers[2] = {{.depth = depth}, {.depth = depth}};
            for (int k = 0; k < 2; k++) {
                layers[k].n = indices[i][k];
                layers[k].albedo = depth > 0.0 ? 0.0 : 0.7;
            }
            struct slab_case c = slab_of(layers, 2, 12);
            for (size_t u = 0; u < COUNT(cosines); u++)
                slab_direction(&c, cosines[u], 1.0);
            assert_null(slab_solve(&c));
            double sky_r = 0.0, sky_t = 0.0;
            for (int q = 0; q < 512; q++) {
                double weight, r, t;
                const double mu = tsu_i_quadrature_node(0.0, 1.0, 32, q, &weight);
                plates(indices[i][0], indices[i][1], mu, exp(-depth), &r, &t);
                sky_r += 2.0 * mu * weight * r;
                sky_t += 2.0 * mu * weight * t;
            }
            for (size_t u = 0; u < COUNT(cosines); u++) {
                double r, t;
                plates(indices[i][0], indices[i][1], cosines[u], exp(-depth), &r, &t);
                near("plates, R", c.solved.reflectance[0][u], r, 1e-12);
                near("plates, T", c.solved.transmittance[0][u], t, 1e-12);
                near("plates, mirrored", c.solved.specular[0][u], r, 1e-12);
                near("plates, straight", c.solved.direct[1][u], t, 1e-12);
            }
            near("plates, sky R", c.solved.diffuse_reflectance[0], sky_r, 2e-6);
            near("plates, sky T", c.solved.diffuse_transmittance[0], sky_t, 2e-6);
            slab_free(&c);
        }
}

// Slides: an index of the slab's own changes nothing; two more boundaries otherwise.
static void slides(void **state)
{
    (void)state;
    const struct tsu_i_slab_layer layer = {.n = 1.4, .albedo = 0.9, .depth = 3.0, .g = 0.5};
    double r[3], t[3];
    for (int k = 0; k < 3; k++) {
        struct slab_case c = slab_of(&layer, 1, 12);
        slab_direction(&c, 0.8, 1.0);
        c.desc.slide_top = c.desc.slide_bottom = k == 1 ? 1.4 : k == 2 ? 1.6 : 1.0;
        assert_null(slab_solve(&c));
        r[k] = c.solved.diffuse_reflectance[0];
        t[k] = c.solved.transmittance[0][0];
        slab_free(&c);
    }
    near("slide of the slab's index", r[1], r[0], 1e-12);
    near("slide of the slab's index", t[1], t[0], 1e-12);
    // As a layer of its own that is clear.
    const struct tsu_i_slab_layer clear[3] = {{.n = 1.6}, layer, {.n = 1.6}};
    struct slab_case c = slab_of(clear, 3, 12);
    slab_direction(&c, 0.8, 1.0);
    assert_null(slab_solve(&c));
    near("slide as a layer", c.solved.diffuse_reflectance[0], r[2], 1e-7);
    near("slide as a layer", c.solved.transmittance[0][0], t[2], 1e-7);
    assert_true(fabs(r[2] - r[0]) > 1e-3);
    slab_free(&c);
}

// A conservative slab of any thickness lets 4/3 / (b (1 - g) + 1.42) of Lambertian light through
// (diffusion with the extrapolation length of Milne's problem, 0.7104); nothing is left of an
// absorbing one.
static void thick(void **state)
{
    (void)state;
    for (double depth = 1e3; depth <= 1e9; depth *= 1e3)
        for (double g = -0.5; g < 0.99; g += 0.5) {
            const struct tsu_i_slab_layer layer = {.n = 1.0, .albedo = 1.0, .depth = depth, .g = g};
            struct slab_case c = slab_of(&layer, 1, 16);
            assert_null(slab_solve(&c));
            const double t = c.solved.diffuse_transmittance[0] * (depth * (1.0 - g) + 1.42);
            near("thick", t / (4.0 / 3.0), 1.0, 2.0 / depth + 1e-7);
            slab_free(&c);
        }
    const double depths[] = {1e9, INFINITY};
    double r[2];
    for (int k = 0; k < 2; k++) {
        const struct tsu_i_slab_layer layer = {
            .n = 1.4, .albedo = 0.9, .depth = depths[k], .g = 0.8};
        struct slab_case c = slab_of(&layer, 1, 16);
        slab_direction(&c, 0.3, 1.0);
        assert_null(slab_solve(&c));
        r[k] = c.solved.reflectance[0][0];
        assert_true(c.solved.transmittance[0][0] == 0.0);
        assert_true(c.solved.diffuse_transmittance[1] == 0.0);
        slab_free(&c);
    }
    near("half space", r[1], r[0], 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(white_slabs_conserve),
        cmocka_unit_test(white_stacks_conserve),
        cmocka_unit_test(a_little_absorption),
        cmocka_unit_test(clear_plates),
        cmocka_unit_test(slides),
        cmocka_unit_test(thick),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// Stacks of layers, light inside them, and descriptions that make no sense.
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
#include <string.h>

enum { TOP = TSU_I_SLAB_TOP, BOTTOM = TSU_I_SLAB_BOTTOM };

static void near(const char *what, double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s: %.15g, expected %.15g +- %g", what, value, expected, tolerance);
}

static void relative(const char *what, double value, double expected, double tolerance)
{
    near(what, value / expected, 1.0, tolerance);
}

static void solve(struct slab_case *c, const struct tsu_i_slab_layer *layers, uint32_t count,
                  uint32_t nodes)
{
    *c = slab_of(layers, count, nodes);
    slab_direction(c, 0.9, 1.0);
    slab_direction(c, 0.25, 1.0);
    c->desc.modes = 8 * nodes;
    const char *wrong = slab_solve(c);
    if (wrong)
        fail_msg("%s", wrong);
}

static void the_same(const struct slab_case *a, const struct slab_case *b, int side, int other,
                     double tolerance)
{
    for (uint32_t in = 0; in < 2; in++) {
        relative("reflectance", b->solved.reflectance[other][in], a->solved.reflectance[side][in],
                 tolerance);
        relative("transmittance", b->solved.transmittance[other][in],
                 a->solved.transmittance[side][in], tolerance);
        for (uint32_t out = 0; out < 2; out++)
            for (double phi = 0.0; phi < 3.2; phi += 0.7) {
                relative("BRDF", tsu_i_slab_brdf(&b->solved, other, in, out, phi),
                         tsu_i_slab_brdf(&a->solved, side, in, out, phi), tolerance);
                relative("BTDF", tsu_i_slab_btdf(&b->solved, other, in, out, phi),
                         tsu_i_slab_btdf(&a->solved, side, in, out, phi), tolerance);
            }
    }
}

// One layer in three unequal parts; a stack upside down; moments in place of g.
static void layers_are_consistent(void **state)
{
    (void)state;
    struct slab_case a, b;
    struct tsu_i_slab_layer whole = {.n = 1.45, .albedo = 0.93, .depth = 4.0, .g = 0.7}, parts[3];
    for (int k = 0; k < 3; k++)
        parts[k] = whole;
    parts[0].depth = 0.7;
    parts[1].depth = 0.0;
    parts[2].depth = 3.3;
    solve(&a, &whole, 1, 12);
    solve(&b, parts, 3, 12);
    the_same(&a, &b, TOP, TOP, 1e-7);
    the_same(&a, &b, TOP, BOTTOM, 1e-7);
    slab_free(&b);
    double chi[800];
    for (int l = 0; l < 800; l++)
        chi[l] = pow(whole.g, l);
    whole.chi = chi;
    whole.chi_count = 800;
    solve(&b, &whole, 1, 12);
    the_same(&a, &b, TOP, TOP, 1e-9);
    slab_free(&a);
    slab_free(&b);
    const struct tsu_i_slab_layer stack[3] = {{.n = 1.3, .albedo = 0.9, .depth = 1.0, .g = 0.6},
                                              {.n = 1.6, .albedo = 0.99, .depth = 3.0, .g = -0.2},
                                              {.n = 1.4, .albedo = 0.5, .depth = 0.5, .g = 0.1}};
    const struct tsu_i_slab_layer turned[3] = {stack[2], stack[1], stack[0]};
    solve(&a, stack, 3, 12);
    solve(&b, turned, 3, 12);
    the_same(&a, &b, TOP, BOTTOM, 1e-10);
    the_same(&a, &b, BOTTOM, TOP, 1e-10);
    // Reciprocity: both sides are solved by products of their own.
    for (double phi = 0.0; phi < 3.2; phi += 0.7) {
        relative("BRDF backwards", tsu_i_slab_brdf(&a.solved, BOTTOM, 0, 1, phi),
                 tsu_i_slab_brdf(&a.solved, BOTTOM, 1, 0, phi), 1e-12);
        relative("BTDF backwards", tsu_i_slab_btdf(&a.solved, TOP, 0, 1, phi),
                 tsu_i_slab_btdf(&a.solved, BOTTOM, 1, 0, phi), 1e-12);
    }
    slab_free(&a);
    slab_free(&b);
}

// What BRDF and BTDF send to all directions is what the powers say.
static void radiances_add_up(void **state)
{
    (void)state;
    enum { COSINES = 32, AZIMUTHS = 64 };
    const struct tsu_i_slab_layer stack[2] = {{.n = 1.35, .albedo = 0.95, .depth = 1.0, .g = 0.6},
                                              {.n = 1.5, .albedo = 0.9, .depth = 2.0, .g = 0.3}};
    for (int side = 0; side < 2; side++) {
        struct slab_case c = slab_of(stack, 2, 12);
        double weight[COSINES], r = 0.0, t = 0.0;
        const uint32_t in = slab_direction(&c, 0.8, 1.0);
        struct tsu_i_slab_direction all[COSINES + 1];
        for (int i = 0; i < COSINES; i++)
            all[i + 1] = (struct tsu_i_slab_direction){
                tsu_i_quadrature_node(0.0, 1.0, 2, i, weight + i), 1.0};
        all[0] = c.directions[in];
        c.desc.modes = 96;
        c.desc.direction_count = COSINES + 1;
        c.desc.directions = all;
        assert_null(tsu_i_slab_check(&c.desc));
        c.memory = malloc(tsu_i_slab_doubles(&c.desc) * sizeof(double));
        assert_non_null(c.memory);
        tsu_i_slab_solve(&c.solved, &c.desc, c.memory);
        for (int i = 0; i < COSINES; i++)
            for (int k = 0; k < AZIMUTHS; k++) {
                const double phi = TSU_I_PI * (k + 0.5) / AZIMUTHS;
                const double share = 2.0 * TSU_I_PI / AZIMUTHS * all[i + 1].mu * weight[i];
                r += share * tsu_i_slab_brdf(&c.solved, side, in, (uint32_t)i + 1, phi);
                t += share * tsu_i_slab_btdf(&c.solved, side, in, (uint32_t)i + 1, phi);
            }
        near("all of the BRDF", r + c.solved.specular[side][in], c.solved.reflectance[side][in],
             1e-7);
        near("all of the BTDF", t + c.solved.direct[side][in], c.solved.transmittance[side][in],
             1e-7);
        slab_free(&c);
    }
}

// Light inside: at the ends it is what leaves, in between what is lost is absorbed.
static void inside(void **state)
{
    (void)state;
    const struct tsu_i_slab_layer stack[2] = {{.n = 1.0, .albedo = 0.95, .depth = 2.0, .g = 0.6},
                                              {.n = 1.0, .albedo = 0.8, .depth = 1.0, .g = 0.1}};
    for (int end = 0; end < 2; end++) {
        struct slab_case c = slab_of(stack, 2, 16);
        slab_direction(&c, 0.9, 1.0);
        slab_direction(&c, 0.25, 1.0);
        c.desc.modes = 128;
        c.desc.inside_wanted = 1;
        c.desc.level_layer = (uint32_t)end;
        c.desc.level_depth = end ? 1.0 : 0.0;
        assert_null(slab_solve(&c));
        const struct tsu_i_slab *s = &c.solved;
        const double one = 1.0;
        for (int side = 0; side < 2; side++) {
            const int lit = side == end;
            relative("out of the end", end ? s->inside_down[side][0] : s->inside_up[side][0],
                     lit ? s->reflectance[side][0] : s->transmittance[side][0], 1e-12);
            relative("into the end", lit ? (end ? s->inside_up : s->inside_down)[side][0] : one,
                     one, 1e-12);
            relative("sky", (end ? s->sky_down : s->sky_up)[side][1],
                     lit ? s->reflectance[side][1] : s->transmittance[!side][1], 1e-12);
            relative("radiance", tsu_i_slab_inside(s, side, !end, 0, 1, 1.1),
                     lit ? tsu_i_slab_brdf(s, side, 0, 1, 1.1)
                         : tsu_i_slab_btdf(s, side, 0, 1, 1.1),
                     1e-12);
        }
        slab_free(&c);
    }
    // d(net flux) / d(tau) = -(1 - albedo) times the flux without its cosine, walls and all.
    enum { COSINES = 31, AZIMUTHS = 48 };
    const struct tsu_i_slab_layer layer = {.n = 1.4, .albedo = 0.9, .depth = 2.0, .g = 0.5};
    const double step = 1e-3;
    double net[2], met = 0.0;
    for (int k = 0; k < 3; k++) {
        struct slab_case c = slab_of(&layer, 1, 12);
        struct tsu_i_slab_direction all[2 * COSINES + 1];
        double x[COSINES], weight[COSINES];
        const double critical = sqrt(1.0 - 1.0 / 1.96), mu0 = 0.7;
        tsu_i_quadrature_gauss(COSINES, x, weight);
        all[0] = (struct tsu_i_slab_direction){mu0, 1.0};
        for (int i = 0; i < COSINES; i++) {
            all[1 + i] = (struct tsu_i_slab_direction){0.5 * critical * (1.0 + x[i]), 1.4};
            // On the steep side by the outer cosine, as light goes with its root at the edge.
            all[1 + COSINES + i] = (struct tsu_i_slab_direction){0.5 * (1.0 + x[i]), 1.0};
        }
        c.desc.directions = all;
        c.desc.direction_count = k < 2 ? 1 : 2 * COSINES + 1;
        c.desc.modes = k < 2 ? 1 : 96;
        c.desc.inside_wanted = 1;
        c.desc.level_depth = 0.8 + (k < 2 ? (k ? step : -step) : 0.0);
        assert_null(tsu_i_slab_check(&c.desc));
        c.memory = malloc(tsu_i_slab_doubles(&c.desc) * sizeof(double));
        assert_non_null(c.memory);
        tsu_i_slab_solve(&c.solved, &c.desc, c.memory);
        if (k < 2) {
            net[k] = c.solved.inside_down[TOP][0] - c.solved.inside_up[TOP][0];
            slab_free(&c);
            continue;
        }
        for (uint32_t i = 1; i < c.desc.direction_count; i++)
            for (int a = 0; a < AZIMUTHS; a++) {
                const double phi = TSU_I_PI * (a + 0.5) / AZIMUTHS,
                             w = 0.5 * weight[(i - 1) % COSINES];
                const double outside = all[i].mu;
                const double slope =
                    i <= COSINES ? critical
                                 : outside / (1.96 * sqrt(1.0 - (1.0 - outside * outside) / 1.96));
                for (int up = 0; up < 2; up++)
                    met += 2.0 * TSU_I_PI / AZIMUTHS * w * slope *
                           tsu_i_slab_inside(&c.solved, TOP, up, 0, i, phi);
            }
        // And the beam, down and up, over its cosine inside.
        const double mu = sqrt(1.0 - (1.0 - mu0 * mu0) / 1.96);
        const double r = tsu_i_fresnel_reflect(1.0, mu0, 1.4, 1.4 * mu), pass = exp(-2.0 / mu);
        const double down = (1.0 - r) / (1.0 - r * r * pass * pass) * exp(-0.8 / mu);
        const double up = (1.0 - r) / (1.0 - r * r * pass * pass) * r * pass * exp(-1.2 / mu);
        met += (down + up) / mu;
        near("absorbed inside", (net[0] - net[1]) / (2.0 * step), 0.1 * met, 2e-6);
        slab_free(&c);
    }
}

static double unit(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return (double)(*seed >> 11) * 0x1p-53;
}

// Photons one by one through the same stack: share reflected and let through.
static void walk(const struct tsu_i_slab_layer *layers, int count, double mu0, int photons,
                 double *r, double *t)
{
    uint64_t seed = 88172645463325252u;
    double back = 0.0, through = 0.0;
    for (int i = 0; i < photons; i++) {
        int at = -1; // the medium: -1 above, count below
        double mu = mu0, weight = 1.0, tau = 0.0;
        int down = 1, moves = 1;
        while (moves) {
            // At a boundary: towards the next medium, or mirrored.
            const int next = down ? at + 1 : at - 1;
            const double n_a = at < 0 || at >= count ? 1.0 : layers[at].n;
            const double n_b = next < 0 || next >= count ? 1.0 : layers[next].n;
            const double k2 = n_a * n_a * (1.0 - mu * mu), b2 = n_b * n_b - k2;
            const double b = b2 > 0.0 ? sqrt(b2) : 0.0;
            if (unit(&seed) < tsu_i_fresnel_reflect(n_a, n_a * mu, n_b, b)) {
                down = !down;
                if (at < 0)
                    break;
            } else {
                mu = b / n_b;
                at = next;
                if (at < 0 || at >= count)
                    break;
            }
            tau = down ? 0.0 : layers[at].depth;
            for (;;) {
                tau += (down ? -mu : mu) * log(1.0 - unit(&seed));
                if (tau < 0.0 || tau > layers[at].depth)
                    break;
                weight *= layers[at].albedo;
                if (weight < 1e-6) {
                    moves = 0;
                    break;
                }
                const double g = layers[at].g, u = unit(&seed);
                const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
                const double turn = g != 0.0 ? (1.0 + g * g - s * s) / (2.0 * g) : 2.0 * u - 1.0;
                const double z = (down ? mu : -mu) * turn +
                                 sqrt(fmax((1.0 - turn * turn) * (1.0 - mu * mu), 0.0)) *
                                     cos(2.0 * TSU_I_PI * unit(&seed));
                down = z > 0.0;
                mu = fmin(fmax(fabs(z), 1e-12), 1.0);
            }
        }
        back += moves && !down ? weight : 0.0;
        through += moves && down ? weight : 0.0;
    }
    *r = back / photons;
    *t = through / photons;
}

static void photons_agree(void **state)
{
    (void)state;
    enum { PHOTONS = 300000 };
    static const struct tsu_i_slab_layer stacks[][2] = {
        {{.n = 1.3, .albedo = 0.95, .depth = 1.0, .g = 0.7},
         {.n = 1.6, .albedo = 0.9, .depth = 1.5, .g = 0.2}},
        {{.n = 1.6, .albedo = 0.98, .depth = 2.0, .g = -0.4},
         {.n = 1.2, .albedo = 0.95, .depth = 0.5, .g = 0.8}},
        {{.n = 1.0, .albedo = 0.9, .depth = 1.0, .g = 0.5},
         {.n = 1.5, .albedo = 0.99, .depth = 3.0, .g = 0.0}}};
    static const double cosines[] = {1.0, 0.3, 0.6};
    for (size_t i = 0; i < sizeof stacks / sizeof *stacks; i++) {
        double r, t;
        struct slab_case c = slab_of(stacks[i], 2, 12);
        slab_direction(&c, cosines[i], 1.0);
        assert_null(slab_solve(&c));
        walk(stacks[i], 2, cosines[i], PHOTONS, &r, &t);
        // Four standard deviations, of a photon's weight in [0, 1].
        near("R of photons", r, c.solved.reflectance[TOP][0], 4.0 * sqrt(0.25 / PHOTONS));
        near("T of photons", t, c.solved.transmittance[TOP][0], 4.0 * sqrt(0.25 / PHOTONS));
        slab_free(&c);
    }
}

// MCML's runs (Wang and Jacques 1995, its random numbers replaced by better ones), two slabs and a
// stack of two layers in air, 2e7 photons: absorbed, and reflected with the mirror's part. Made for
// this project by other hands.
static void mcml(void **state)
{
    (void)state;
    static const struct {
        struct tsu_i_slab_layer layers[2];
        uint32_t count;
        double absorbed, error;
    } runs[] = {
        {{{.n = 1.0, .albedo = 0.9, .depth = 2.0, .g = 0.75}}, 1, 0.241597, 1.1e-4},
        {{{.n = 1.4, .albedo = 0.95, .depth = 8.0}}, 1, 0.575702, 1.7e-4},
        {{{.n = 1.45, .albedo = 0.98, .depth = 5.0, .g = 0.5}}, 1, 0.309718, 1.2e-4},
        {{{.n = 1.45, .albedo = 400.0 / 430.0, .depth = 4.3, .g = 0.6},
          {.n = 1.45, .albedo = 300.0 / 308.0, .depth = 4.62, .g = 0.3}},
         2,
         0.716535,
         1.9e-4},
    };
    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++) {
        struct slab_case c = slab_of(runs[i].layers, runs[i].count, 8);
        slab_direction(&c, 1.0, 1.0);
        assert_null(slab_solve(&c));
        near("absorbed", 1.0 - c.solved.reflectance[TOP][0] - c.solved.transmittance[TOP][0],
             runs[i].absorbed, runs[i].error);
        slab_free(&c);
    }
}

static void wrong(struct slab_case *c, const char *name)
{
    c->desc.directions = c->directions;
    const char *text = tsu_i_slab_check(&c->desc);
    if (!text || strncmp(text, name, strlen(name)) != 0)
        fail_msg("%s: the check says %s", name, text ? text : "nothing");
}

static void bad_descriptions_are_named(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        struct tsu_i_slab_layer layer;
    } layers[] = {
        {"layers.albedo", {.n = 1.0, .albedo = 1.0 + 1e-15, .depth = 1.0}},
        {"layers.albedo", {.n = 1.0, .albedo = -0.1, .depth = 1.0}},
        {"layers.albedo", {.n = 1.0, .albedo = NAN, .depth = 1.0}},
        {"layers.n", {.n = 0.99, .albedo = 0.5, .depth = 1.0}},
        {"layers.n", {.n = NAN, .albedo = 0.5, .depth = 1.0}},
        {"layers.n", {.n = INFINITY, .albedo = 0.5, .depth = 1.0}},
        {"layers.depth", {.n = 1.0, .albedo = 0.5, .depth = -1e-9}},
        {"layers.depth", {.n = 1.0, .albedo = 0.5, .depth = NAN}},
        {"layers.g", {.n = 1.0, .albedo = 0.5, .depth = 1.0, .g = 1.0}},
        {"layers.g", {.n = 1.0, .albedo = 0.5, .depth = 1.0, .g = -1.0}},
        {"layers.g", {.n = 1.0, .albedo = 0.5, .depth = 1.0, .g = NAN}},
    };
    for (size_t i = 0; i < sizeof layers / sizeof *layers; i++) {
        struct slab_case c = slab_of(&layers[i].layer, 1, 8);
        wrong(&c, layers[i].name);
    }
    const double dim[1] = {0.5}, strong[2] = {1.0, 1.5};
    struct tsu_i_slab_layer layer = {.n = 1.4, .albedo = 0.5, .depth = 1.0, .chi = dim};
    struct slab_case c = slab_of(&layer, 1, 8);
    wrong(&c, "layers.chi_count");
    layer.chi_count = 1;
    wrong(&c, "layers.chi");
    layer.chi = strong;
    layer.chi_count = 2;
    wrong(&c, "layers.chi");
    layer.chi = NULL;
    c.desc.layer_count = 0;
    wrong(&c, "layer_count");
    c = slab_of(&layer, 1, 3);
    wrong(&c, "nodes");
    c = slab_of(&layer, 1, 8);
    c.desc.modes = 65;
    wrong(&c, "modes");
    c = slab_of(&layer, 1, 8);
    c.desc.slide_bottom = 0.5;
    wrong(&c, "slide_bottom");
    c = slab_of(&layer, 1, 8);
    slab_direction(&c, 0.0, 1.0);
    wrong(&c, "directions.mu");
    c.directions[0] = (struct tsu_i_slab_direction){0.5, 0.9};
    wrong(&c, "directions.n");
    c.directions[0].n = 1.0;
    c.desc.inside_wanted = 1;
    c.desc.level_depth = 1.1;
    wrong(&c, "level_depth");
    c.desc.level_layer = 1;
    wrong(&c, "level_layer");
    c.desc.inside_wanted = 0;
    assert_null(tsu_i_slab_check(&c.desc));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_are_consistent),
        cmocka_unit_test(radiances_add_up),
        cmocka_unit_test(inside),
        cmocka_unit_test(photons_agree),
        cmocka_unit_test(mcml),
        cmocka_unit_test(bad_descriptions_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

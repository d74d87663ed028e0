// Layers from faces: leaves of PROSPECT, leaves at random, what cannot be, and the ends.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "optics/leaf_inverse.h"
#include "optics/leaf_presets.h"
#include "optics/slab.h"

#include <math.h>
#include <stdlib.h>

static double *memory;

static int setup(void **state)
{
    (void)state;
    memory = calloc(tsu_i_leaf_inverse_doubles(), sizeof *memory);
    return memory ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    free(memory);
    return 0;
}

// Uniform in [0, 1), the same on every machine.
static double chance(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static double between(uint32_t *state, double low, double high)
{
    return low * pow(high / low, chance(state));
}

static double apart(const struct tsu_i_leaf_faces *a, const struct tsu_i_leaf_faces *b)
{
    return fmax(fmax(fabs(a->R_top - b->R_top), fabs(a->R_bottom - b->R_bottom)),
                fabs(a->T - b->T));
}

// Faces by the solver alone with nodes of its own, from depths: none of the inversion has a part in
// it but the depths.
static struct tsu_i_leaf_faces solved(double n, double g, const struct tsu_i_leaf_layers *layers,
                                      uint32_t nodes)
{
    const double scatter[2] = {layers->scatter_top, layers->scatter_bottom};
    const double absorption[2] = {layers->absorption_top, layers->absorption_bottom};
    struct tsu_i_slab_layer layer[2];
    for (int i = 0; i < 2; i++) {
        const double whole = scatter[i] / (1 - g);
        layer[i] = (struct tsu_i_slab_layer){.n = n,
                                             .albedo = whole / (whole + absorption[i]),
                                             .depth = whole + absorption[i],
                                             .g = g};
    }
    const struct tsu_i_slab_direction normal = {.mu = 1, .n = 1};
    const struct tsu_i_slab_desc desc = {.layers = layer,
                                         .layer_count = 2,
                                         .slide_top = 1,
                                         .slide_bottom = 1,
                                         .nodes = nodes,
                                         .modes = 1,
                                         .directions = &normal,
                                         .direction_count = 1};
    assert_null(tsu_i_slab_check(&desc));
    double *room = calloc(tsu_i_slab_doubles(&desc), sizeof *room);
    assert_non_null(room);
    struct tsu_i_slab slab;
    tsu_i_slab_solve(&slab, &desc, room);
    const struct tsu_i_leaf_faces faces = {slab.reflectance[0][0], slab.reflectance[1][0],
                                           slab.transmittance[0][0]};
    free(room);
    return faces;
}

// Means over 610..680, 530..570 and 430..490 nm of PROSPECT-D, and the index there.
static const double leaves[5][2][3] = {{{.0650, .1630, .0429}, {.0787, .2124, .0122}},
                                       {{.0406, .0995, .0410}, {.0064, .0561, .0002}},
                                       {{.2947, .2869, .0569}, {.2858, .2649, .0246}},
                                       {{.2414, .1836, .1037}, {.0958, .0564, .0176}},
                                       {{.0629, .1835, .0440}, {.0076, .0563, .0004}}};
static const double indices[3] = {1.4483, 1.4737, 1.4942};
enum { YELLOW = 2 };

static void leaves_of_prospect(void **state)
{
    (void)state;
    static const double ratios[] = {1.0, 1.2, 1.4, 1 / 1.4};
    double worst = 0, worst_solved = 0;
    int most = 0;
    for (int r = 0; r < 4; r++)
        for (int i = 0; i < 5; i++)
            for (int k = 0; k < 3; k++) {
                const double top = leaves[i][0][k];
                // The surface alone reflects so much; a darker face has no leaf behind it.
                const double bottom = fmax(ratios[r] * top, tsu_i_leaf_surface(indices[k]) + 1e-3);
                const struct tsu_i_leaf_question question = {
                    indices[k], 0.5, {top, bottom, leaves[i][1][k]}};
                struct tsu_i_leaf_inverse leaf;
                tsu_i_leaf_invert(&question, &leaf, memory);
                if (leaf.answer != TSU_I_LEAF_REACHED)
                    fail_msg("leaf %d, channel %d, ratio %g: %.2g", i, k, ratios[r], leaf.residual);
                const struct tsu_i_leaf_faces again = solved(indices[k], 0.5, &leaf.layers, 20);
                worst = fmax(worst, leaf.residual);
                worst_solved = fmax(worst_solved, apart(&again, &question.faces));
                most = leaf.solutions > most ? leaf.solutions : most;
            }
    print_message("leaves: residual %.1e, by 20 nodes %.1e, at most %d solutions\n", worst,
                  worst_solved, most);
    assert_true(worst <= 1e-7);
    assert_true(worst_solved <= 5e-6);
    assert_true(most <= 150);
}

static void faces_are_the_solver_s(void **state)
{
    (void)state;
    uint32_t seed = 3;
    double worst = 0;
    for (int i = 0; i < 40; i++) {
        const double n = 1 + 0.6 * chance(&seed), g = 1.2 * chance(&seed) - 0.5;
        const struct tsu_i_leaf_layers layers = {between(&seed, 1e-2, 3), between(&seed, 1e-3, 5),
                                                 between(&seed, 1e-2, 10), between(&seed, 1e-3, 5)};
        struct tsu_i_leaf_faces faces;
        tsu_i_leaf_solve(n, g, &layers, &faces, memory);
        const struct tsu_i_leaf_faces truth = solved(n, g, &layers, 24);
        worst = fmax(worst, apart(&faces, &truth));
    }
    print_message("faces: %.1e\n", worst);
    assert_true(worst <= 1e-5);
}

// Whatever two layers do can be asked for. Those found need not be the same: three numbers do not
// tell four depths apart.
static void any_layers_come_back(void **state)
{
    (void)state;
    uint32_t seed = 11;
    double worst = 0;
    for (int i = 0; i < 120; i++) {
        const struct tsu_i_leaf_layers layers = {between(&seed, 2e-3, 3), between(&seed, 2e-3, 4),
                                                 between(&seed, 1e-2, 8), between(&seed, 2e-3, 4)};
        struct tsu_i_leaf_question question = {.n = 1.3 + 0.3 * chance(&seed), .g = 0.5};
        tsu_i_leaf_solve(question.n, question.g, &layers, &question.faces, memory);
        struct tsu_i_leaf_inverse leaf;
        tsu_i_leaf_invert(&question, &leaf, memory);
        worst = fmax(worst, leaf.residual);
        if (leaf.answer != TSU_I_LEAF_REACHED)
            fail_msg("%g %g %g %g: %.2g", layers.scatter_top, layers.absorption_top,
                     layers.scatter_bottom, layers.absorption_bottom, leaf.residual);
        struct tsu_i_leaf_faces again;
        tsu_i_leaf_solve(question.n, question.g, &leaf.layers, &again, memory);
        assert_true(fabs(apart(&again, &question.faces) - leaf.residual) <= 1e-9);
    }
    print_message("layers at random: %.1e\n", worst);
}

// The clear layer's scattering stays at 0.1 for leaves, so that a species differs in few numbers.
static void leaves_keep_a_clear_layer(void **state)
{
    (void)state;
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            for (int mirrored = 0; mirrored < 2; mirrored++) {
                const double R = leaves[i][0][k], T = leaves[i][1][k];
                const struct tsu_i_leaf_question question = {
                    indices[k], 0.5, {mirrored ? 1.4 * R : R, mirrored ? R : 1.4 * R, T}};
                struct tsu_i_leaf_inverse leaf;
                tsu_i_leaf_invert(&question, &leaf, memory);
                const double clear =
                    mirrored ? leaf.layers.scatter_bottom : leaf.layers.scatter_top;
                assert_int_equal(leaf.answer, TSU_I_LEAF_REACHED);
                assert_true(fabs(clear - 0.1) <= 1e-9);
            }
}

static struct tsu_i_leaf_inverse refused(double n, double R_top, double R_bottom, double T,
                                         enum tsu_i_leaf_answer why)
{
    const struct tsu_i_leaf_question question = {n, 0.5, {R_top, R_bottom, T}};
    struct tsu_i_leaf_inverse leaf, again;
    tsu_i_leaf_invert(&question, &leaf, memory);
    if (leaf.answer != why)
        fail_msg("%g %g %g: answer %d, expected %d", R_top, R_bottom, T, (int)leaf.answer,
                 (int)why);
    assert_true(fabs(apart(&leaf.faces, &question.faces) - leaf.residual) <= 1e-15);
    // What is offered is possible.
    const struct tsu_i_leaf_question offered = {n, 0.5, leaf.faces};
    tsu_i_leaf_invert(&offered, &again, memory);
    if (again.answer != TSU_I_LEAF_REACHED)
        fail_msg("%g %g %g: offered %g %g %g and refused it: %g", R_top, R_bottom, T,
                 leaf.faces.R_top, leaf.faces.R_bottom, leaf.faces.T, again.residual);
    return leaf;
}

static void impossible_faces_are_refused(void **state)
{
    (void)state;
    refused(1.45, 0.5, 0.5, 0.6, TSU_I_LEAF_ENERGY);
    refused(1.45, 0.3, 0.8, 0.3, TSU_I_LEAF_ENERGY);
    refused(1.45, 1, 1, 1, TSU_I_LEAF_ENERGY);
    refused(1.45, 0.02, 0.1, 0.1, TSU_I_LEAF_SURFACE);
    refused(1.45, 0.1, 0.02, 0.1, TSU_I_LEAF_SURFACE);
    refused(1.45, 0, 0, 0, TSU_I_LEAF_SURFACE);
    refused(1.45, 0, 0, 1, TSU_I_LEAF_SURFACE);
    refused(1.45, 0.2, 0.2, -0.1, TSU_I_LEAF_SURFACE);
    refused(1.45, 0.1, 0.6, 0.3, TSU_I_LEAF_REACH);
    refused(1.45, 0.04, 0.04, 0.9, TSU_I_LEAF_REACH); // clear, but the far wall reflects too
    // A yellow leaf is too clear to look twice as bright from below.
    for (int k = 0; k < 2; k++) {
        const double R = leaves[YELLOW][0][k], T = leaves[YELLOW][1][k];
        const struct tsu_i_leaf_inverse leaf = refused(indices[k], R, 2 * R, T, TSU_I_LEAF_REACH);
        print_message("yellow, R_bottom twice %g: nearest %.4f %.4f %.4f\n", R, leaf.faces.R_top,
                      leaf.faces.R_bottom, leaf.faces.T);
        assert_true(leaf.residual > 0.01 && leaf.residual < 0.05);
    }
}

static double distance(const struct tsu_i_leaf_faces *a, const double b[3])
{
    return sqrt(pow(a->R_top - b[0], 2) + pow(a->R_bottom - b[1], 2) + pow(a->T - b[2], 2));
}

// Neither leaves all over the four depths nor those around the nearest one are nearer.
static void nearest_is_nearest(void **state)
{
    (void)state;
    static const double asked[][3] = {
        {0.2947, 0.5894, 0.2858}, {0.5, 0.5, 0.6}, {0.02, 0.1, 0.1}, {0.1, 0.6, 0.3}};
    enum { COUNT = sizeof asked / sizeof *asked, SIDE = 7 };
    struct tsu_i_leaf_inverse leaf[COUNT];
    double best[COUNT];
    for (int q = 0; q < COUNT; q++) {
        const struct tsu_i_leaf_question question = {
            1.45, 0.5, {asked[q][0], asked[q][1], asked[q][2]}};
        tsu_i_leaf_invert(&question, leaf + q, memory);
        best[q] = INFINITY;
    }
    for (int i = 0; i < SIDE * SIDE * SIDE * SIDE; i++) {
        const struct tsu_i_leaf_layers layers = {1e-4 * pow(10, 0.9 * (i % SIDE)),
                                                 1e-4 * pow(10, 0.75 * (i / SIDE % SIDE)),
                                                 0.05 * pow(10, 0.4 * (i / SIDE / SIDE % SIDE)),
                                                 1e-4 * pow(10, 0.75 * (i / SIDE / SIDE / SIDE))};
        const struct tsu_i_leaf_faces faces = solved(1.45, 0.5, &layers, 4);
        for (int q = 0; q < COUNT; q++)
            best[q] = fmin(best[q], distance(&faces, asked[q]));
    }
    uint32_t seed = 5;
    for (int q = 0; q < COUNT; q++) {
        const double nearest = distance(&leaf[q].faces, asked[q]), all = best[q];
        for (int i = 0; i < 300; i++) {
            const struct tsu_i_leaf_layers *l = &leaf[q].layers;
            const struct tsu_i_leaf_layers layers = {l->scatter_top * between(&seed, 0.7, 1.4),
                                                     l->absorption_top * between(&seed, 0.7, 1.4),
                                                     l->scatter_bottom * between(&seed, 0.7, 1.4),
                                                     l->absorption_bottom *
                                                         between(&seed, 0.7, 1.4)};
            struct tsu_i_leaf_faces faces;
            tsu_i_leaf_solve(1.45, 0.5, &layers, &faces, memory);
            best[q] = fmin(best[q], distance(&faces, asked[q]));
        }
        print_message("nearest %.5f; around it %.5f, everywhere %.5f\n", nearest, best[q], all);
        assert_true(nearest <= best[q] + 1e-4);
    }
}

static void a_wish_for_the_lower_face_gives_way(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        const double R = leaves[YELLOW][0][k], T = leaves[YELLOW][1][k];
        double last = 0;
        for (double ratio = 1; ratio <= 3; ratio += 0.25) {
            const struct tsu_i_leaf_question question = {indices[k], 0.5, {R, ratio * R, T}};
            struct tsu_i_leaf_inverse leaf;
            tsu_i_leaf_invert_near(&question, &leaf, memory);
            assert_int_equal(leaf.answer, TSU_I_LEAF_REACHED);
            assert_true(fabs(leaf.faces.R_top - R) <= 1e-6 && fabs(leaf.faces.T - T) <= 1e-6);
            assert_true(leaf.faces.R_bottom <= ratio * R + 1e-6);
            assert_true(leaf.faces.R_bottom >= last - 1e-6);
            last = leaf.faces.R_bottom;
        }
        print_message("yellow: R_bottom up to %.3f of R_top\n", last / R);
        // More than 1.4, less than what stays when T is kept of all light.
        assert_true(last > 1.4 * R && last < 1 - T);
    }
}

// No numbers are so odd that depths or faces are none.
static void ends_are_finite(void **state)
{
    (void)state;
    static const double values[] = {0, 1e-9, 0.03, 0.0337, 0.04, 0.2, 0.5, 0.9, 1};
    enum { COUNT = sizeof values / sizeof *values };
    for (int i = 0; i < COUNT * COUNT * COUNT; i += 13) {
        const struct tsu_i_leaf_question question = {
            i % 2 ? 1.45 : 1.0,
            0.5,
            {values[i % COUNT], values[i / COUNT % COUNT], values[i / COUNT / COUNT]}};
        struct tsu_i_leaf_inverse leaf[2];
        tsu_i_leaf_invert(&question, leaf, memory);
        tsu_i_leaf_invert_near(&question, leaf + 1, memory);
        for (int k = 0; k < 2; k++) {
            const struct tsu_i_leaf_layers *l = &leaf[k].layers;
            const double depths[4] = {l->scatter_top, l->absorption_top, l->scatter_bottom,
                                      l->absorption_bottom};
            for (int d = 0; d < 4; d++)
                assert_true(depths[d] >= 0 && depths[d] <= 100);
            const struct tsu_i_leaf_faces *f = &leaf[k].faces;
            assert_true(f->R_top >= 0 && f->R_bottom >= 0 && f->T >= 0);
            assert_true(fmax(f->R_top, f->R_bottom) + f->T <= 1 + 1e-3);
            assert_true(leaf[k].residual >= 0 && leaf[k].residual <= 1);
        }
    }
    // A white leaf needs no pigment.
    const struct tsu_i_leaf_question white = {1.45, 0.5, {0.6, 0.6, 0.4}};
    struct tsu_i_leaf_inverse leaf;
    tsu_i_leaf_invert(&white, &leaf, memory);
    assert_int_equal(leaf.answer, TSU_I_LEAF_REACHED);
    assert_true(leaf.layers.absorption_top + leaf.layers.absorption_bottom < 1e-4);
}

// The presets' figures, made with coefficients every 1 nm, are those of their contents.
static void presets_are_what_they_are_made_of(void **state)
{
    (void)state;
    static const int band[3][2] = {{610, 680}, {530, 570}, {430, 490}};
    double worst = 0;
    for (int i = 0; i < TSU_I_LEAF_PRESETS; i++) {
        const struct tsu_i_leaf_preset *leaf = tsu_i_leaf_presets + i;
        for (int k = 0; k < 3; k++) {
            double R = 0, T = 0;
            int count = 0;
            for (int nm = band[k][0]; nm <= band[k][1]; nm++, count++) {
                double one_R, one_T;
                tsu_i_prospect_leaf(&leaf->contents, nm, &one_R, &one_T);
                R += one_R;
                T += one_T;
            }
            worst = fmax(worst, fmax(fabs(R / count - leaf->R[k]), fabs(T / count - leaf->T[k])));
            const struct tsu_i_leaf_question question = {
                tsu_i_leaf_preset_n[k],
                0.5,
                {leaf->R[k], TSU_I_LEAF_PRESET_RATIO * leaf->R[k], leaf->T[k]}};
            struct tsu_i_leaf_inverse found;
            tsu_i_leaf_invert(&question, &found, memory);
            assert_true(found.residual <= 1e-7);
        }
    }
    print_message("presets: figures within %.1e of their contents\n", worst);
    assert_true(worst <= 3e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(presets_are_what_they_are_made_of),
        cmocka_unit_test(leaves_of_prospect),
        cmocka_unit_test(faces_are_the_solver_s),
        cmocka_unit_test(any_layers_come_back),
        cmocka_unit_test(leaves_keep_a_clear_layer),
        cmocka_unit_test(impossible_faces_are_refused),
        cmocka_unit_test(nearest_is_nearest),
        cmocka_unit_test(a_wish_for_the_lower_face_gives_way),
        cmocka_unit_test(ends_are_finite),
    };
    return cmocka_run_group_tests_name("leaf_inverse", tests, setup, teardown);
}

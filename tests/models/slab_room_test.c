// Functions of slabs stay within the room that they ask for, and answer at the ends of every range.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "models/leaf_body/functions_slab.h"
#include "optics/slab.h"

#include <math.h>
#include <stdlib.h>

static size_t bytes(uint32_t layer_count, uint32_t nodes, uint32_t modes, uint32_t directions,
                    int inside)
{
    struct tsu_i_slab_layer layers[SLAB_LAYERS];
    struct tsu_i_slab_direction both[2] = {{0.5, 1.0}, {0.5, 1.0}};
    for (uint32_t k = 0; k < layer_count; k++)
        layers[k] = (struct tsu_i_slab_layer){.n = 1.1 + 0.1 * k, .albedo = 0.5, .depth = 1.0};
    const struct tsu_i_slab_desc desc = {.layers = layers,
                                         .layer_count = layer_count,
                                         .slide_top = 1.0,
                                         .slide_bottom = 1.0,
                                         .nodes = nodes,
                                         .modes = modes,
                                         .directions = both,
                                         .direction_count = directions,
                                         .inside_wanted = (uint32_t)inside};
    assert_null(tsu_i_slab_check(&desc));
    return tsu_i_slab_doubles(&desc) * sizeof(double);
}

static void rooms_are_large_enough(void **state)
{
    (void)state;
    for (double g = -0.999; g <= 0.999; g += 0.001) {
        assert_true(bytes(1, tsu_i_slab_power_nodes(g), 1, 1, 0) <= SLAB_BYTES);
        const uint32_t nodes = tsu_i_slab_bsdf_nodes(g, g < 0.0 ? 1.0 : 1.5);
        assert_true(bytes(1, nodes, TSU_I_SLAB_MOMENTS * nodes, 2, 0) <= SLAB_BSDF_BYTES);
        const uint32_t of_layers = tsu_i_slab_layers_nodes(g);
        assert_true(bytes(SLAB_LAYERS, of_layers, TSU_I_SLAB_MOMENTS * of_layers, 2, 1) <=
                    SLAB_LAYERS_BYTES);
    }
}

struct function {
    const tsu_value_info *inputs;
    size_t columns, outputs;
    tsu_status (*ask)(const double *in, void *room, double *out);
};

static tsu_status ask_slab(const double *in, void *room, double *out)
{
    tsu_i_slab_answer(in, room, out);
    for (int k = 0; k < SLAB_OUTPUTS; k += 2)
        assert_true(out[k] + out[k + 1] <= 1.0 + 1e-12);
    return TSU_OK;
}

static tsu_status ask_bsdf(const double *in, void *room, double *out)
{
    tsu_i_slab_bsdf_answer(in, room, out);
    return TSU_OK;
}

static tsu_status ask_layers(const double *in, void *room, double *out)
{
    return tsu_i_slab_layers_answer(NULL, in, room, out);
}

// Every input at both ends of its range, the others at rest. Radiances of the sharpest phase
// functions take minutes: g of those stays.
static void ends_of_ranges_are_answered(void **state)
{
    (void)state;
    static const struct function functions[] = {
        {tsu_i_slab_inputs, SLAB_COLUMNS, SLAB_OUTPUTS, ask_slab},
        {tsu_i_slab_bsdf_inputs, SLAB_BSDF_COLUMNS, 1, ask_bsdf},
        {tsu_i_slab_layers_inputs, SLAB_LAYERS_COLUMNS, SLAB_LAYERS_OUTPUTS, ask_layers}};
    void *room = malloc(SLAB_LAYERS_BYTES);
    assert_non_null(room);
    for (size_t f = 0; f < sizeof functions / sizeof *functions; f++)
        for (size_t i = 0; i < functions[f].columns; i++) {
            const tsu_value_info *inputs = functions[f].inputs;
            double in[SLAB_LAYERS_COLUMNS], out[SLAB_LAYERS_OUTPUTS];
            if (f > 0 && inputs[i].name[0] == 'g')
                continue;
            for (int end = 0; end < 2; end++) {
                for (size_t k = 0; k < functions[f].columns; k++)
                    in[k] = inputs[k].default_value;
                in[i] = end ? inputs[i].maximum : inputs[i].minimum;
                const tsu_status status = functions[f].ask(in, room, out);
                for (size_t k = 0; status == TSU_OK && k < functions[f].outputs; k++)
                    if (!isfinite(out[k]) || out[k] < 0.0)
                        fail_msg("%s at %g: output %d is %g", inputs[i].name, in[i], (int)k,
                                 out[k]);
            }
        }
    free(room);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(rooms_are_large_enough),
                                       cmocka_unit_test(ends_of_ranges_are_answered)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

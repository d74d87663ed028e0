// The table "body". A unit solves one pigment at all thicknesses and leaves its numbers in its
// rows; the last touch puts them where the shader looks.
#include "models/leaf_body/state.h"

#include <math.h>
#include <string.h>

_Static_assert(LEAF_HEIGHT / LEAF_PIGMENTS * LEAF_WIDTH * 4 >=
                       LEAF_SETS * 3 * LEAF_THICKNESSES * LEAF_NUMBERS &&
                   LEAF_WIDTH * 4 % LEAF_NUMBERS == 0,
               "a unit's numbers fit its rows, and none is broken");

double tsu_i_leaf_pigment(int i)
{
    const double x = (double)i / (LEAF_PIGMENTS - 1);
    return 2.0 * x * x;
}

// Three steps from 1/2 to 1 and three from 1 to 2, so that doubling a layer makes another one.
double tsu_i_leaf_thickness(int i)
{
    return i < 4 ? (3.0 + i) / 6.0 : i / 3.0;
}

static void layers_of(const struct leaf_state *state, int channel, double pigment, double thickness,
                      struct leaf_layer layers[2])
{
    for (int k = 0; k < 2; k++) {
        layers[k].scatter = thickness * state->scatter[k][channel];
        layers[k].absorption = thickness * pigment * state->absorption[k][channel];
    }
}

static void operators(const struct leaf_frame *frame, const struct leaf_state *state, int channel,
                      double pigment, struct leaf_operator out[][LEAF_MODES][2])
{
    for (int t = 0; t < LEAF_THICKNESSES; t++) {
        struct leaf_layer layers[2];
        layers_of(state, channel, pigment, tsu_i_leaf_thickness(t), layers);
        for (int m = 0; m < LEAF_MODES; m++)
            for (int k = 0; k < 2; k++)
                if (t < 3) {
                    tsu_i_leaf_layer(frame, layers + k, m, &out[t][m][k]);
                } else {
                    out[t][m][k] = out[t - 3][m][k];
                    tsu_i_leaf_double(&out[t][m][k]);
                }
    }
}

// Float `number` of a unit in the table while it is baked.
static size_t kept(uint32_t unit, size_t number)
{
    const size_t row = 4 * LEAF_WIDTH;
    return (unit + number / row * LEAF_PIGMENTS) * row + number % row;
}

static size_t number_of(int set, int channel, int thickness)
{
    return (size_t)((set * 3 + channel) * LEAF_THICKNESSES + thickness) * LEAF_NUMBERS;
}

void tsu_i_leaf_bake(const void *opaque, uint32_t unit, void *scratch, float *texels)
{
    const struct leaf_state *state = opaque;
    struct leaf_room *room = scratch;
    const double pigment = tsu_i_leaf_pigment((int)unit);
    memset(texels, 0, (size_t)LEAF_HEIGHT / LEAF_PIGMENTS * LEAF_WIDTH * 4 * sizeof *texels);
    tsu_i_leaf_frame(state->n, &room->frame);
    tsu_i_leaf_fitter(&room->frame, state->coarse, &room->fitter);
    for (int c = 0; c < 3; c++) {
        operators(&room->frame, state, c, pigment, room->operators);
        for (int t = 0; t < LEAF_THICKNESSES; t++) {
            struct leaf_layer layers[2];
            struct leaf_modes modes;
            layers_of(state, c, pigment, tsu_i_leaf_thickness(t), layers);
            for (int m = 0; m < LEAF_MODES; m++)
                tsu_i_leaf_walls(&room->frame, layers, room->operators[t][m], m, &modes);
            for (int set = 0; set < LEAF_SETS; set++)
                tsu_i_leaf_fit(&room->frame, &room->fitter, layers, &modes, set,
                               texels + number_of(set, c, t));
        }
    }
}

// Knots of straight lines that err as much in the middle as at the knots, in place of samples: a
// twelfth of the second difference is taken off. Values lie `step` floats apart at places x.
static void knots(float *values, int step, int count, const double *x)
{
    double kept[LEAF_PIGMENTS], bent[LEAF_PIGMENTS] = {0.0};
    for (int i = 0; i < count; i++)
        kept[i] = values[i * step];
    for (int i = 1; i + 1 < count; i++) {
        const double below = x[i] - x[i - 1], above = x[i + 1] - x[i];
        const double curve = 2.0 *
                             ((kept[i + 1] - kept[i]) / above - (kept[i] - kept[i - 1]) / below) /
                             (below + above);
        bent[i] = curve * below * above / 13.0;
    }
    for (int i = 1; i + 1 < count; i++)
        values[i * step] = (float)(kept[i] - bent[i]);
}

void tsu_i_leaf_finish(const void *opaque, float *texels)
{
    enum { ROW = 4 * LEAF_WIDTH };
    float solved[LEAF_HEIGHT * ROW];
    double pigment[LEAF_PIGMENTS], thickness[LEAF_THICKNESSES];
    (void)opaque;
    memcpy(solved, texels, sizeof solved);
    memset(texels, 0, sizeof solved);
    for (int i = 0; i < LEAF_PIGMENTS; i++)
        pigment[i] = sqrt(tsu_i_leaf_pigment(i));
    for (int i = 0; i < LEAF_THICKNESSES; i++)
        thickness[i] = tsu_i_leaf_thickness(i);
    for (int set = 0; set < LEAF_SETS * 3; set++) {
        float *band = texels + (size_t)set * LEAF_THICKNESSES * ROW;
        for (int t = 0; t < LEAF_THICKNESSES; t++)
            for (uint32_t p = 0; p < LEAF_PIGMENTS; p++) {
                const float *numbers = solved + kept(p, number_of(set / 3, set % 3, t));
                for (int half = 0; half < LEAF_TEXELS; half++)
                    memcpy(band + t * ROW + 4 * ((uint32_t)half * LEAF_PIGMENTS + p),
                           numbers + 4 * half, 4 * sizeof *band);
            }
        for (int k = 0; k < ROW; k++)
            knots(band + k, ROW, LEAF_THICKNESSES, thickness);
        for (int t = 0; t < LEAF_THICKNESSES; t++)
            for (int k = 0; k < LEAF_NUMBERS; k++)
                knots(band + t * ROW + k / 4 * 4 * LEAF_PIGMENTS + k % 4, 4, LEAF_PIGMENTS,
                      pigment);
    }
}

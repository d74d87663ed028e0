// "leaf" and "leaf-body": the leaf of a preset, or of reflectances and a transmittance, in one pair
// of directions.
#include "models/leaf_body/functions.h"

#include "base/host.h"
#include "models/leaf_body/functions_prospect.h"
#include "models/leaf_body/functions_slab.h"
#include "models/leaf_body/state.h"
#include "models/values.h"
#include "optics/angle.h"
#include "optics/leaf_inverse.h"
#include "optics/leaf_presets.h"
#include "optics/slab.h"

#include <math.h>
#include <string.h>

enum { // columns, functions.h
    PRESET,
    CHANNEL,
    R_TOP,
    R_BOTTOM,
    TRANSMITTANCE,
    INDEX, // the material
    MU0,
    MU,
    PHI,
    KIND,
    SIDE,
    ABSORPTION,
    THICKNESS,
    COLUMNS
};
enum { NODES = 10, GAUSS = 8, DIRECTIONS = 2 + GAUSS };

struct question {
    double n;
    struct tsu_i_leaf_layers layers;
};

tsu_status tsu_i_leaf_find(const tsu_context *context, const struct tsu_i_leaf_question *question,
                           void *scratch, struct tsu_i_leaf_inverse *out)
{
    static const char *const why[] = {"", "more than all light comes back",
                                      "the surface alone reflects more, or T is negative",
                                      "no two layers do that"};
    tsu_i_leaf_invert(question, out, scratch);
    if (out->answer == TSU_I_LEAF_REACHED)
        return TSU_OK;
    tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_INPUT,
              "R_top = %g, R_bottom = %g, T = %g: %s; the nearest possible are %g, %g, %g",
              question->faces.R_top, question->faces.R_bottom, question->faces.T, why[out->answer],
              out->faces.R_top, out->faces.R_bottom, out->faces.T);
    return TSU_E_PARAMETER;
}

static tsu_status ask(const tsu_context *context, const double *in, void *scratch,
                      struct question *out)
{
    struct tsu_i_leaf_question question = {
        .n = in[INDEX], .g = LEAF_G, .faces = {in[R_TOP], in[R_BOTTOM], in[TRANSMITTANCE]}};
    if (in[PRESET] > 0.0) {
        const struct tsu_i_leaf_preset *preset = tsu_i_leaf_presets + (int)in[PRESET] - 1;
        const int channel = (int)in[CHANNEL];
        question.n = tsu_i_leaf_preset_n[channel];
        question.faces.R_top = preset->R[channel];
        question.faces.R_bottom = TSU_I_LEAF_PRESET_RATIO * preset->R[channel];
        question.faces.T = preset->T[channel];
    }
    struct tsu_i_leaf_inverse answer;
    const tsu_status status = tsu_i_leaf_find(context, &question, scratch, &answer);
    if (status != TSU_OK)
        return status;
    *out = (struct question){question.n, answer.layers};
    return TSU_OK;
}

tsu_status tsu_i_leaf_material(const tsu_context *context, const double *in, void *scratch,
                               void *to)
{
    tsu_leaf_body_params *p = to; // those of models that extend this one begin alike
    struct question question;
    const tsu_status status = ask(context, in, scratch, &question);
    if (status != TSU_OK)
        return status;
    p->n = (float)question.n;
    for (int c = 0; c < 3; c++) {
        p->scatter_top[c] = (float)question.layers.scatter_top;
        p->absorption_top[c] = (float)question.layers.absorption_top;
        p->scatter_bottom[c] = (float)question.layers.scatter_bottom;
        p->absorption_bottom[c] = (float)question.layers.absorption_bottom;
    }
    return TSU_OK;
}

// Gauss-Legendre on [0, 1], 8 nodes.
static double gauss(int i, double *weight)
{
    static const double x[4] = {0.183434642495649805, 0.525532409916328986, 0.796666477413626740,
                                0.960289856497536232};
    static const double w[4] = {0.362683783378361983, 0.313706645877887287, 0.222381034453374471,
                                0.101228536290376259};
    *weight = 0.5 * w[i / 2];
    return 0.5 + (i % 2 ? 0.5 : -0.5) * x[i / 2];
}

static void describe(const double *in, const struct question *question,
                     struct tsu_i_slab_layer layers[2], struct tsu_i_slab_direction *directions,
                     struct tsu_i_slab_desc *desc)
{
    const double thickness = in[THICKNESS], pigment = in[ABSORPTION];
    const struct tsu_i_leaf_layers *l = &question->layers;
    const double scatter[2] = {l->scatter_top, l->scatter_bottom};
    const double absorption[2] = {l->absorption_top, l->absorption_bottom};
    for (int k = 0; k < 2; k++) {
        const double s = thickness * scatter[k] / (1.0 - LEAF_G);
        const double depth = s + thickness * pigment * absorption[k];
        layers[k] = (struct tsu_i_slab_layer){
            .n = question->n, .albedo = depth > 0.0 ? s / depth : 0.0, .depth = depth, .g = LEAF_G};
    }
    directions[0] = (struct tsu_i_slab_direction){in[MU0], 1.0};
    directions[1] = (struct tsu_i_slab_direction){in[MU], 1.0};
    for (int i = 0; i < GAUSS; i++) {
        double weight;
        directions[2 + i] = (struct tsu_i_slab_direction){gauss(i, &weight), 1.0};
    }
    *desc = (struct tsu_i_slab_desc){.layers = layers,
                                     .layer_count = 2,
                                     .slide_top = 1.0,
                                     .slide_bottom = 1.0,
                                     .nodes = NODES,
                                     .modes = 2 * NODES,
                                     .directions = directions,
                                     .direction_count = DIRECTIONS};
}

size_t tsu_i_leaf_answer_bytes(void)
{
    struct tsu_i_slab_layer layers[2];
    struct tsu_i_slab_direction directions[DIRECTIONS];
    struct tsu_i_slab_desc desc;
    static const double in[COLUMNS] = {[MU0] = 1.0, [MU] = 0.5, [THICKNESS] = 1.0};
    static const struct question question = {1.45, {0.1, 0.1, 2.0, 0.1}};
    describe(in, &question, layers, directions, &desc);
    const size_t slab = tsu_i_slab_doubles(&desc), inverse = tsu_i_leaf_inverse_doubles();
    return (slab > inverse ? slab : inverse) * sizeof(double);
}

// What the model adds for light that goes straight on, or comes back so from the far wall:
// Lambert's value of the same power, over the walls' factors.
static double straight(const struct tsu_i_slab *slab, double n, int side, int through)
{
    double power = 0.0;
    for (int i = 0; i < GAUSS; i++) {
        double weight;
        const double mu = gauss(i, &weight);
        power += 2.0 * mu * weight *
                 (through ? slab->direct[side][2 + i]
                          : slab->specular[side][2 + i] - tsu_i_leaf_wall_reflectance(n, mu));
    }
    const double passed = 1.0 - tsu_i_leaf_wall_mean(n);
    return power / (TSU_I_PI * passed * passed);
}

tsu_status tsu_i_leaf_answer(const tsu_context *context, const double *in, double alpha,
                             void *scratch, double *out)
{
    struct question question;
    const tsu_status status = ask(context, in, scratch, &question);
    if (status != TSU_OK)
        return status;
    struct tsu_i_slab_layer layers[2];
    struct tsu_i_slab_direction directions[DIRECTIONS];
    struct tsu_i_slab_desc desc;
    struct tsu_i_slab slab;
    describe(in, &question, layers, directions, &desc);
    tsu_i_slab_solve(&slab, &desc, scratch);
    const double n = question.n, mu0 = in[MU0], mu = in[MU];
    const int side = in[SIDE] > 0.5, through = in[KIND] > 0.5;
    double f = through ? tsu_i_slab_btdf(&slab, side, 0, 1, in[PHI])
                       : tsu_i_slab_brdf(&slab, side, 0, 1, in[PHI]);
    f += straight(&slab, n, side, through) * (1.0 - tsu_i_leaf_wall_reflectance(n, mu0)) *
         (1.0 - tsu_i_leaf_wall_reflectance(n, mu));
    out[0] = out[1] = out[2] = 0.0;
    if (alpha > 0.0) {
        f *= tsu_i_leaf_coat_factor(n, alpha, mu0) * tsu_i_leaf_coat_factor(n, alpha, mu);
        const double l_v = mu0 * mu - sqrt((1.0 - mu0 * mu0) * (1.0 - mu * mu)) * cos(in[PHI]);
        const double h = sqrt(2.0 + 2.0 * l_v);
        if (!through && h > 0.0)
            out[0] = tsu_i_leaf_coat(n, alpha, mu0, mu, (mu0 + mu) / h, (1.0 + l_v) / h);
    }
    out[1 + through] = f;
    return TSU_OK;
}

void tsu_i_leaf_sampled(const struct leaf_state *state, const float *r,
                        const struct tsu_i_texels *tables, const double *in, double *out)
{
    const float c_l = (float)in[MU0], c_v = (float)in[MU];
    const int through = in[KIND] > 0.5, below = in[SIDE] > 0.5, viewer_above = through == below;
    const double sines = sqrt((1.0 - in[MU0] * in[MU0]) * (1.0 - in[MU] * in[MU]));
    const float z = (float)(sines * cos(in[PHI])) * r[6];
    const float t_l = sqrtf(c_l * c_l * r[6] + r[7]);
    const float t_v = sqrtf(c_v * c_v * r[6] + r[7]);
    const float walls =
        (r[15] + c_l * (r[8] + r[9] * c_l)) * (r[15] + c_v * (r[8] + r[9] * c_v)) /
        ((1.0f + c_l * (r[10] + r[11] * c_l)) * (1.0f + c_v * (r[10] + r[11] * c_v)));
    const float root = 1.0f / sqrtf(1.25f - ((through ? t_l * t_v : -t_l * t_v) + z));
    const float p = root * root * root;
    const float u_l = 1.0f - t_l, u_v = 1.0f - t_v;
    const float s = u_l + u_v, d = viewer_above ? u_l - u_v : u_v - u_l;
    const float grazing = c_l + c_v - 2.0f;
    const float third = state->coarse ? p - 1.0f : through ? p * d : grazing;
    const float first[3] = {s, through ? d : u_l * u_v, third};
    const float second[4] = {u_l * u_l + u_v * u_v, z, p - 1.0f, p * s};

    float a[4], b[4], f = 1.0f;
    tsu_i_leaf_read(r, tables, (float)in[ABSORPTION], (float)in[THICKNESS],
                    through ? LEAF_THROUGH
                    : below ? LEAF_BELOW
                            : LEAF_TOP,
                    0, a, b);
    for (int k = 0; k < 3; k++)
        f += a[1 + k] * first[k];
    for (int k = 0; k < 4; k++)
        f += b[k] * second[k];
    f = fminf(fmaxf(exp2f(a[0]) * f, 0.0f), 1.0f) * walls;
    out[0] = 0.0;
    out[1] = through ? 0.0 : (double)f;
    out[2] = through ? (double)f : 0.0;
    if (r[12] > 0.0f && !through) {
        const double l_v = in[MU0] * in[MU] - sines * cos(in[PHI]);
        const double h = sqrt(fmax(2.0 + 2.0 * l_v, 1e-12));
        out[0] = tsu_i_leaf_coat(sqrt(1.0 + (double)r[14]), sqrt((double)r[12]), in[MU0], in[MU],
                                 (in[MU0] + in[MU]) / h, (1.0 + l_v) / h);
    }
}

// "leaf-ambient": columns after the material.
enum { AMBIENT_MU = MU0, AMBIENT_SIDE, AMBIENT_ABSORPTION, AMBIENT_THICKNESS, AMBIENT_COLUMNS };

// What goes towards the viewer of uniform light is, by reciprocity, what goes everywhere of light
// from there.
static tsu_status ambient_answer(const tsu_context *context, const double *in, void *scratch,
                                 double *out)
{
    struct question question;
    const tsu_status status = ask(context, in, scratch, &question);
    if (status != TSU_OK)
        return status;
    struct tsu_i_slab_layer layers[2];
    struct tsu_i_slab_direction directions[DIRECTIONS];
    struct tsu_i_slab_desc desc;
    struct tsu_i_slab slab;
    double full[COLUMNS];
    memcpy(full, in, MU0 * sizeof *in);
    full[MU0] = full[MU] = in[AMBIENT_MU];
    full[ABSORPTION] = in[AMBIENT_ABSORPTION];
    full[THICKNESS] = in[AMBIENT_THICKNESS];
    describe(full, &question, layers, directions, &desc);
    desc.modes = 1;
    tsu_i_slab_solve(&slab, &desc, scratch);
    const int side = in[AMBIENT_SIDE] > 0.5;
    const double n = question.n;
    const double passed = TSU_I_PI * (1.0 - tsu_i_leaf_wall_mean(n)) *
                          (1.0 - tsu_i_leaf_wall_reflectance(n, full[MU]));
    out[0] =
        slab.reflectance[side][0] - slab.specular[side][0] + straight(&slab, n, side, 0) * passed;
    out[1] =
        slab.transmittance[side][0] - slab.direct[side][0] + straight(&slab, n, side, 1) * passed;
    return TSU_OK;
}

static void ambient_sampled(const void *opaque, const float *r, const struct tsu_i_texels *tables,
                            const double *in, double *out)
{
    const struct leaf_moments *h = &((const struct leaf_state *)opaque)->moments;
    const float c = (float)in[AMBIENT_MU], x = 1.0f - sqrtf(c * c * r[6] + r[7]);
    const float walls = (r[15] + c * (r[8] + r[9] * c)) / (1.0f + c * (r[10] + r[11] * c));
    const int below = in[AMBIENT_SIDE] > 0.5;
    for (int through = 0; through < 2; through++) {
        const float p = h->p[through][0] + x * (h->p[through][1] + x * h->p[through][2]);
        const float pu = h->pu[through][0] + x * (h->pu[through][1] + x * h->pu[through][2]);
        const float sign = below ? -1.0f : 1.0f;
        const float first[3] = {h->u[1] + x * h->u[0],
                                through ? sign * (h->u[1] - x * h->u[0]) : x * h->u[1],
                                through ? sign * (pu - x * p) : h->grazing + (c - 1.0f) * h->u[0]};
        const float second[4] = {h->u[2] + x * x * h->u[0], 0.0f, p - h->u[0], pu + x * p};
        float a[4], b[4], f = h->u[0];
        tsu_i_leaf_read(r, tables, (float)in[AMBIENT_ABSORPTION], (float)in[AMBIENT_THICKNESS],
                        through ? LEAF_THROUGH
                        : below ? LEAF_BELOW
                                : LEAF_TOP,
                        0, a, b);
        for (int k = 0; k < 3; k++)
            f += a[1 + k] * first[k];
        for (int k = 0; k < 4; k++)
            f += b[k] * second[k];
        out[through] = (double)fmaxf(walls * exp2f(a[0]) * f, 0.0f);
    }
}

static tsu_status body_answer(const tsu_context *context, const double *in, void *scratch,
                              double *out)
{
    double all[3];
    const tsu_status status = tsu_i_leaf_answer(context, in, 0.0, scratch, all);
    memcpy(out, all + 1, 2 * sizeof *out);
    return status;
}

static void body_sampled(const void *state, const float *record, const struct tsu_i_texels *tables,
                         const double *in, double *out)
{
    double all[3];
    tsu_i_leaf_sampled(state, record, tables, in, all);
    memcpy(out, all + 1, 2 * sizeof *out);
}

static const tsu_value_info body_inputs[] = {LEAF_COLUMNS};
static const tsu_value_info ambient_inputs[] = {
    LEAF_MATERIAL_COLUMNS, TSU_I_FRAGMENT("mu", "1", "cosine of the view, outside", 1e-3, 1, 1),
    TSU_I_FRAGMENT("side", "top|bottom", "the side that is seen", 0, 1, 0), LEAF_FACTOR_COLUMNS};
static const tsu_value_info ambient_outputs[] = {
    TSU_I_OUTPUT("reflected", "1", "radiance in uniform light of radiance 1 on the seen side"),
    TSU_I_OUTPUT("transmitted", "1", "the same of light on the other side")};
static const tsu_value_info outputs[] = {LEAF_OUTPUTS};

const struct tsu_i_function tsu_i_leaf_functions[LEAF_FUNCTIONS] = {
    {.info = {.struct_size = sizeof(tsu_function_info),
              .name = "leaf-body",
              .help = "BRDF and BTDF of a leaf without its coat",
              .input_count = COLUMNS,
              .output_count = 2},
     .inputs = body_inputs,
     .outputs = outputs + 1,
     .probe = "leaf_body/probe_leaf.glsl",
     .scratch_bytes = LEAF_ANSWER_BYTES,
     .material = tsu_i_leaf_material,
     .answer = body_answer,
     .sampled = body_sampled},
    {.info = {.struct_size = sizeof(tsu_function_info),
              .name = "leaf-ambient",
              .help = "a leaf without its coat in light that is uniform on each side",
              .input_count = AMBIENT_COLUMNS,
              .output_count = 2},
     .inputs = ambient_inputs,
     .outputs = ambient_outputs,
     .probe = "leaf_body/probe_ambient.glsl",
     .scratch_bytes = LEAF_ANSWER_BYTES,
     .material = tsu_i_leaf_material,
     .answer = ambient_answer,
     .sampled = ambient_sampled},
    LEAF_PROSPECT,
    LEAF_LAYERS,
    SLAB_FUNCTIONS};

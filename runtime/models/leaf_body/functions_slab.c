// "slab", "slab-bsdf" and "slab-layers": questions to the solver, for reference alone.
#include "models/leaf_body/functions_slab.h"

#include "base/host.h"
#include "models/values.h"
#include "optics/slab.h"

#include <math.h>
#include <string.h>

// Cosine 0 is the limit; what follows from a cosine this small differs from it by less than 1e-7.
static const double least_mu = 1e-8;

static struct tsu_i_slab_direction outside(double mu)
{
    return (struct tsu_i_slab_direction){fmax(mu, least_mu), 1.0};
}

static double thickness(double b)
{
    return b >= TSU_VALUE_INFINITE ? INFINITY : b;
}

uint32_t tsu_i_slab_power_nodes(double g)
{
    g = fabs(g);
    return g <= 0.8 ? 24 : g <= 0.95 ? 32 : g <= 0.97 ? 64 : 96;
}

uint32_t tsu_i_slab_bsdf_nodes(double g, double n)
{
    g = fabs(g);
    if (n >= 1.2)
        return g <= 0.85 ? 24 : g <= 0.9 ? 32 : 64;
    return g <= 0.85 ? 32 : g <= 0.9 ? 48 : 64;
}

uint32_t tsu_i_slab_layers_nodes(double g)
{
    g = fabs(g);
    return g <= 0.8 ? 24 : g <= 0.85 ? 32 : 48;
}

void tsu_i_slab_params(const double *in, void *params)
{
    (void)in;
    (void)params;
}

#define INDEX(n, h) TSU_I_FRAGMENT(n, "1", h, 1, 4, 1)
#define DEPTH(n, start)                                                                            \
    TSU_I_FRAGMENT(n, "1", "optical thickness; inf allowed", 0, TSU_VALUE_INFINITE, start)
#define ALBEDO(n) TSU_I_FRAGMENT(n, "1", "albedo of single scattering", 0, 1, 1)
#define ASYMMETRY(n) TSU_I_FRAGMENT(n, "1", "mean cosine, Henyey-Greenstein", -0.99, 0.999, 0)
#define LIGHT TSU_I_FRAGMENT("mu0", "1", "cosine of the light, in air; 0: the limit", 0, 1, 1)
#define VIEW(h) TSU_I_FRAGMENT("mu", "1", h, 0, 1, 1)
#define AZIMUTH                                                                                    \
    TSU_I_FRAGMENT("phi", "rad",                                                                   \
                   "azimuth between both directions of travel; 0 is straight on and the mirror's", \
                   -1e6, 1e6, 0)

const tsu_value_info tsu_i_slab_inputs[SLAB_COLUMNS] = {
    INDEX("n", "refractive index of the slab"),
    ALBEDO("a"),
    DEPTH("b", 1),
    ASYMMETRY("g"),
    LIGHT,
    INDEX("n_top", "index of a thin clear slide on the lit face, 1: none"),
    INDEX("n_bot", "index of a thin clear slide on the other face, 1: none"),
};
const tsu_value_info tsu_i_slab_outputs[SLAB_OUTPUTS] = {
    TSU_I_OUTPUT("UR1", "1", "light along mu0: all that comes back, the mirror's included"),
    TSU_I_OUTPUT("UT1", "1", "all that goes through, unscattered light included"),
    TSU_I_OUTPUT("URU", "1", "the same for Lambertian light from air: comes back"),
    TSU_I_OUTPUT("UTU", "1", "goes through"),
};

void tsu_i_slab_answer(const double *in, void *scratch, double *out)
{
    const struct tsu_i_slab_layer layer = {
        .n = in[0], .albedo = in[1], .depth = thickness(in[2]), .g = in[3]};
    const struct tsu_i_slab_direction direction = outside(in[4]);
    const struct tsu_i_slab_desc desc = {.layers = &layer,
                                         .layer_count = 1,
                                         .slide_top = in[5],
                                         .slide_bottom = in[6],
                                         .nodes = tsu_i_slab_power_nodes(in[3]),
                                         .modes = 1,
                                         .directions = &direction,
                                         .direction_count = 1};
    struct tsu_i_slab slab;
    tsu_i_slab_solve(&slab, &desc, scratch);
    out[0] = slab.reflectance[TSU_I_SLAB_TOP][0];
    out[1] = slab.transmittance[TSU_I_SLAB_TOP][0];
    out[2] = slab.diffuse_reflectance[TSU_I_SLAB_TOP];
    out[3] = slab.diffuse_transmittance[TSU_I_SLAB_TOP];
}

const tsu_value_info tsu_i_slab_bsdf_inputs[SLAB_BSDF_COLUMNS] = {
    ALBEDO("a"),
    DEPTH("b", 1),
    ASYMMETRY("g"),
    INDEX("n", "refractive index of the slab"),
    LIGHT,
    TSU_I_FRAGMENT("kind", "R|T", "the lit side, or the other", 0, 1, 0),
    VIEW("cosine of the light that leaves, in air; 0: the limit"),
    AZIMUTH,
};
const tsu_value_info tsu_i_slab_bsdf_outputs[1] = {
    TSU_I_OUTPUT("f", "1/sr", "BRDF or BTDF, mirrored and unscattered light excluded"),
};

void tsu_i_slab_bsdf_answer(const double *in, void *scratch, double *out)
{
    const struct tsu_i_slab_layer layer = {
        .n = in[3], .albedo = in[0], .depth = thickness(in[1]), .g = in[2]};
    const struct tsu_i_slab_direction directions[2] = {outside(in[4]), outside(in[6])};
    const uint32_t nodes = tsu_i_slab_bsdf_nodes(in[2], in[3]);
    const struct tsu_i_slab_desc desc = {.layers = &layer,
                                         .layer_count = 1,
                                         .slide_top = 1.0,
                                         .slide_bottom = 1.0,
                                         .nodes = nodes,
                                         .modes = TSU_I_SLAB_MOMENTS * nodes,
                                         .directions = directions,
                                         .direction_count = 2};
    struct tsu_i_slab slab;
    tsu_i_slab_solve(&slab, &desc, scratch);
    *out = in[5] > 0.5 ? tsu_i_slab_btdf(&slab, TSU_I_SLAB_TOP, 0, 1, in[7])
                       : tsu_i_slab_brdf(&slab, TSU_I_SLAB_TOP, 0, 1, in[7]);
}

enum {
    NONE,
    BACK,
    THROUGH,
    UP,
    DOWN,
    SKY_UP,
    SKY_DOWN,
    // Powers: no azimuth.
    FLUX_UP,
    FLUX_DOWN,
    SKY_FLUX_UP,
    SKY_FLUX_DOWN,
    KINDS
};
enum { COUNT, MU0, SIDE, KIND, MU, PHI, LEVEL, N_TOP, N_BOT, MOMENT };

enum { OF_HG, OF_RAYLEIGH, OF_MOMENTS };
#define MOMENT_COLUMN(i)                                                                           \
    TSU_I_FRAGMENT("chi" #i, "1", "Legendre moment " #i " of layers of phase moments", -1, 1, 0)
#define LAYER_COLUMNS(k)                                                                           \
    INDEX("n" #k, "refractive index of layer " #k ", 1 on top"), ALBEDO("a" #k), DEPTH("b" #k, 0), \
        ASYMMETRY("g" #k),                                                                         \
        TSU_I_FRAGMENT("phase" #k, "hg|rayleigh|moments",                                          \
                       "phase function: of g, 3/4 (1 + cos^2),"                                    \
                       " of chi1 to chi8",                                                         \
                       0, 2, 0)

const tsu_value_info tsu_i_slab_layers_inputs[SLAB_LAYERS_COLUMNS] = {
    TSU_I_FRAGMENT("layers", "1", "how many layers there are, whole; from the top", 1, SLAB_LAYERS,
                   1),
    LIGHT,
    TSU_I_FRAGMENT("side", "top|bottom", "lit side, of f", 0, 1, 0),
    TSU_I_FRAGMENT(
        "kind", "none|R|T|up|down|sky_up|sky_down|flux_up|flux_down|sky_flux_up|sky_flux_down",
        "what f is: BRDF, BTDF; or at the level, radiance along mu over the irradiance "
        "from outside, the same under a sky of radiance 1; power that crosses it of light "
        "along mu0, or Lambertian",
        0, KINDS - 1, 0),
    VIEW("cosine of the light that f is about: outside, or in the layer at the level"),
    AZIMUTH,
    TSU_I_FRAGMENT("level", "1", "optical thickness above the place inside", 0, TSU_VALUE_INFINITE,
                   0),
    INDEX("n_top", "index of a thin clear slide on the top face, 1: none"),
    INDEX("n_bot", "index of a thin clear slide on the bottom face, 1: none"),
    MOMENT_COLUMN(1),
    MOMENT_COLUMN(2),
    MOMENT_COLUMN(3),
    MOMENT_COLUMN(4),
    MOMENT_COLUMN(5),
    MOMENT_COLUMN(6),
    MOMENT_COLUMN(7),
    MOMENT_COLUMN(8),
    LAYER_COLUMNS(1),
    LAYER_COLUMNS(2),
    LAYER_COLUMNS(3),
    LAYER_COLUMNS(4),
    LAYER_COLUMNS(5),
    LAYER_COLUMNS(6),
};
const tsu_value_info tsu_i_slab_layers_outputs[SLAB_LAYERS_OUTPUTS] = {
    TSU_I_OUTPUT("UR1", "1", "lit from the top along mu0: all that comes back"),
    TSU_I_OUTPUT("UT1", "1", "goes through"),
    TSU_I_OUTPUT("UR1_bottom", "1", "lit from below: comes back"),
    TSU_I_OUTPUT("UT1_bottom", "1", "goes through"),
    TSU_I_OUTPUT("URU", "1", "Lambertian light from the top: comes back"),
    TSU_I_OUTPUT("UTU", "1", "goes through, the same from either side"),
    TSU_I_OUTPUT("URU_bottom", "1", "Lambertian light from below: comes back"),
    TSU_I_OUTPUT("f", "1/sr or 1", "what kind says; unscattered light is in powers and skies only"),
};

// The layers of a row and its largest |g|.
static double read_layers(const double *in, double *chi, struct tsu_i_slab_layer *layers,
                          uint32_t count)
{
    static const double rayleigh[3] = {1.0, 0.0, 0.1};
    double most = 0.0;
    chi[0] = 1.0;
    memcpy(chi + 1, in + MOMENT, SLAB_MOMENTS * sizeof *chi);
    for (uint32_t k = 0; k < count; k++) {
        const double *of = in + MOMENT + SLAB_MOMENTS + k * SLAB_LAYER_COLUMNS;
        const int phase = (int)of[4];
        layers[k] = (struct tsu_i_slab_layer){
            .n = of[0], .albedo = of[1], .depth = thickness(of[2]), .g = of[3]};
        layers[k].chi = phase == OF_RAYLEIGH ? rayleigh : phase == OF_MOMENTS ? chi : NULL;
        layers[k].chi_count = phase == OF_RAYLEIGH ? 3 : SLAB_MOMENTS + 1;
        most = phase == OF_HG ? fmax(most, fabs(of[3])) : most;
    }
    return most;
}

static double asked(const struct tsu_i_slab *slab, const double *in)
{
    const int side = in[SIDE] > 0.5 ? TSU_I_SLAB_BOTTOM : TSU_I_SLAB_TOP;
    switch ((int)in[KIND]) {
    case BACK:
        return tsu_i_slab_brdf(slab, side, 0, 1, in[PHI]);
    case THROUGH:
        return tsu_i_slab_btdf(slab, side, 0, 1, in[PHI]);
    case UP:
    case DOWN:
        return tsu_i_slab_inside(slab, side, (int)in[KIND] == UP, 0, 1, in[PHI]);
    case SKY_UP:
        return slab->sky_up[side][1];
    case SKY_DOWN:
        return slab->sky_down[side][1];
    case FLUX_UP:
        return slab->inside_up[side][0];
    case FLUX_DOWN:
        return slab->inside_down[side][0];
    case SKY_FLUX_UP:
        return slab->diffuse_inside_up[side];
    case SKY_FLUX_DOWN:
        return slab->diffuse_inside_down[side];
    default:
        return 0.0;
    }
}

tsu_status tsu_i_slab_layers_answer(const tsu_context *context, const double *in, void *scratch,
                                    double *out)
{
    struct tsu_i_slab_layer layers[SLAB_LAYERS];
    double chi[SLAB_MOMENTS + 1], level = in[LEVEL];
    const uint32_t count = (uint32_t)in[COUNT];
    const int kind = (int)in[KIND], inside = kind >= UP;
    const int azimuth = kind >= BACK && kind <= DOWN;
    if (in[COUNT] != (double)count) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_INPUT, "layers = %g is no whole number",
                  in[COUNT]);
        return TSU_E_PARAMETER;
    }
    const double g = read_layers(in, chi, layers, count);
    uint32_t at = 0;
    while (inside && at + 1 < count && level > layers[at].depth)
        level -= layers[at++].depth;
    // Sums of thicknesses are not exact.
    if (inside && level > layers[at].depth && level < layers[at].depth + 1e-9 * in[LEVEL])
        level = layers[at].depth;
    if (inside && !(level <= layers[at].depth && level < TSU_VALUE_INFINITE)) {
        tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_INPUT, "level = %g is below the layers",
                  in[LEVEL]);
        return TSU_E_PARAMETER;
    }
    struct tsu_i_slab_direction directions[2] = {outside(in[MU0]), outside(in[MU])};
    if (inside)
        directions[1].n = layers[at].n;
    const uint32_t nodes = tsu_i_slab_layers_nodes(g);
    const struct tsu_i_slab_desc desc = {.layers = layers,
                                         .layer_count = count,
                                         .slide_top = in[N_TOP],
                                         .slide_bottom = in[N_BOT],
                                         .nodes = nodes,
                                         .modes = azimuth ? TSU_I_SLAB_MOMENTS * nodes : 1,
                                         .directions = directions,
                                         .direction_count = 2,
                                         .inside_wanted = (uint32_t)inside,
                                         .level_layer = at,
                                         .level_depth = level};
    struct tsu_i_slab slab;
    tsu_i_slab_solve(&slab, &desc, scratch);
    for (int side = 0; side < 2; side++) {
        out[2 * side] = slab.reflectance[side][0];
        out[2 * side + 1] = slab.transmittance[side][0];
        out[4 + 2 * side] = slab.diffuse_reflectance[side];
    }
    out[5] = slab.diffuse_transmittance[TSU_I_SLAB_TOP];
    out[7] = asked(&slab, in);
    return TSU_OK;
}

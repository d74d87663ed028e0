// What the model can be asked: "hair", "hair-azimuthal", "longitudinal", with their references.
#include "models/marschner/state.h"

#include "models/values.h"
#include "optics/fiber.h"
#include "optics/lobe.h"

#include <tsuya/models/marschner.h>

static void hair_params(const double *in, void *params)
{
    tsu_marschner_params *p = params;
    p->eta = (float)in[3];
    p->alpha_R = (float)in[5];
    p->beta_R = (float)in[6];
    p->beta_az = (float)in[7];
    p->scale_shifts = (float)in[8];
}

static void azimuthal_params(const double *in, void *params)
{
    tsu_marschner_params *p = params;
    p->eta = (float)in[0];
    p->beta_az = (float)in[3];
}

static void longitudinal_params(const double *in, void *params)
{
    tsu_marschner_params *p = params;
    p->alpha_R = 0.0f;
    p->beta_R = (float)in[2];
}

static void hair_with(double (*lobe)(double, double, double), const double *in, double *out)
{
    double alpha[4], beta[4], n[4];
    tsu_i_marschner_lobes(in[5], in[6], in[8], alpha, beta);
    tsu_i_fiber_azimuthal(in[3], in[1], in[4], in[7], in[2], n);
    out[4] = 0.0;
    for (int p = 0; p < 4; p++) {
        out[p] = n[p] * lobe(in[0], in[1] - alpha[p], beta[p]);
        out[4] += out[p];
    }
}

static void hair_reference(const double *in, double *out)
{
    hair_with(tsu_i_lobe_deon, in, out);
}

static void hair_gaussian(const double *in, double *out)
{
    hair_with(tsu_i_lobe_gaussian, in, out);
}

static void azimuthal_reference(const double *in, double *out)
{
    tsu_i_fiber_azimuthal(in[0], in[1], in[2], in[3], in[4], out);
}

static void longitudinal_reference(const double *in, double *out)
{
    out[0] = tsu_i_lobe_deon(in[0], in[1], in[2]);
}

static void longitudinal_gaussian(const double *in, double *out)
{
    out[0] = tsu_i_lobe_gaussian(in[0], in[1], in[2]);
}

#define THETA_I                                                                                    \
    TSU_I_FRAGMENT("theta_i", "rad", "inclination of the light", TSU_I_DEGREES(-90),               \
                   TSU_I_DEGREES(90), 0)
#define THETA_R                                                                                    \
    TSU_I_FRAGMENT("theta_r", "rad", "inclination of the view", TSU_I_DEGREES(-90),                \
                   TSU_I_DEGREES(90), 0)
#define PHI TSU_I_FRAGMENT("phi", "rad", "azimuth of the view from the light's", -1e6, 1e6, 0)
#define ETA TSU_I_MATERIAL("eta", "1", "refractive index", 1.2, 2, 1.55)
#define BETA_AZ                                                                                    \
    TSU_I_MATERIAL("beta_az", "rad", "azimuthal deviation", TSU_I_DEGREES(5), TSU_I_DEGREES(30),   \
                   TSU_I_DEGREES(10))
#define SIGMA_A TSU_I_FRAGMENT("sigma_a", "1/radius", "absorption of one channel", 0, 1e6, 0.9061)

static const tsu_value_info hair_inputs[] = {
    THETA_I,
    THETA_R,
    PHI,
    ETA,
    SIGMA_A,
    TSU_I_MATERIAL("alpha_R", "rad", "shift of R", TSU_I_DEGREES(-20), TSU_I_DEGREES(20),
                   TSU_I_DEGREES(-7.5)),
    TSU_I_MATERIAL("beta_R", "rad", "deviation of R", TSU_I_DEGREES(2), TSU_I_DEGREES(30),
                   TSU_I_DEGREES(7.5)),
    BETA_AZ,
    TSU_I_MATERIAL("scale_shifts", "1", "shifts of real tilted scales", 0, 1, 0)};
static const tsu_value_info hair_outputs[] = {
    TSU_I_OUTPUT("R", "1/sr", "surface reflection"), TSU_I_OUTPUT("TT", "1/sr", "straight through"),
    TSU_I_OUTPUT("TRT", "1/sr", "one internal reflection"),
    TSU_I_OUTPUT("RES", "1/sr", "two and more internal reflections"),
    TSU_I_OUTPUT("total", "1/sr", "the sum")};
static const tsu_value_info azimuthal_inputs[] = {
    ETA, TSU_I_FRAGMENT("theta_d", "rad", "inclination", TSU_I_DEGREES(-90), TSU_I_DEGREES(90), 0),
    SIGMA_A, BETA_AZ, PHI};
static const tsu_value_info azimuthal_outputs[] = {
    TSU_I_OUTPUT("R", "1/rad", "surface reflection"),
    TSU_I_OUTPUT("TT", "1/rad", "straight through"),
    TSU_I_OUTPUT("TRT", "1/rad", "one internal reflection"),
    TSU_I_OUTPUT("RES", "1/rad", "N_3 + Abar_>=4 / (2 pi)")};
static const tsu_value_info longitudinal_inputs[] = {
    THETA_I, THETA_R,
    TSU_I_MATERIAL("beta", "rad", "deviation", TSU_I_DEGREES(2), TSU_I_DEGREES(30),
                   TSU_I_DEGREES(7.5))};
static const tsu_value_info longitudinal_outputs[] = {TSU_I_OUTPUT("M", "1/rad", "d'Eon's lobe")};

#define COUNT(array) (uint32_t)(sizeof(array) / sizeof *(array))
#define INFO(n, h, in, out, f)                                                                     \
    {                                                                                              \
        .struct_size = sizeof(tsu_function_info), .flags = f, .name = n, .help = h,                \
        .input_count = COUNT(in), .output_count = COUNT(out)                                       \
    }

const struct tsu_i_function tsu_i_marschner_functions[MARSCHNER_FUNCTIONS] = {
    {.info = INFO("hair", "S cos(theta_i) of a fibre, lobe by lobe", hair_inputs, hair_outputs, 0),
     .inputs = hair_inputs,
     .outputs = hair_outputs,
     .params = hair_params,
     .reference = hair_reference,
     .probe = "marschner/probe_hair.glsl",
     .sampled = tsu_i_marschner_hair},
    {.info =
         INFO("hair-azimuthal", "N(phi) of the four lobes", azimuthal_inputs, azimuthal_outputs, 0),
     .inputs = azimuthal_inputs,
     .outputs = azimuthal_outputs,
     .params = azimuthal_params,
     .reference = azimuthal_reference,
     .probe = "marschner/probe_hair_azimuthal.glsl",
     .sampled = tsu_i_marschner_azimuthal},
    {.info = INFO("longitudinal", "M of one unshifted lobe", longitudinal_inputs,
                  longitudinal_outputs, 0),
     .inputs = longitudinal_inputs,
     .outputs = longitudinal_outputs,
     .params = longitudinal_params,
     .reference = longitudinal_reference,
     .probe = "marschner/probe_longitudinal.glsl",
     .sampled = tsu_i_marschner_longitudinal},
    {.info = INFO("hair-fine", "hair as the fine variant shades it", hair_inputs, hair_outputs,
                  TSU_FUNCTION_FINE),
     .inputs = hair_inputs,
     .outputs = hair_outputs,
     .params = hair_params,
     .reference = hair_reference,
     .probe = "marschner/probe_hair.glsl",
     .sampled = tsu_i_marschner_hair_fine},
    {.info = INFO("hair-gaussian", "hair with Marschner's own Gaussian lobe; reference only",
                  hair_inputs, hair_outputs, TSU_FUNCTION_REFERENCE_ONLY),
     .inputs = hair_inputs,
     .outputs = hair_outputs,
     .params = hair_params,
     .reference = hair_gaussian},
    {.info = INFO("longitudinal-gaussian",
                  "Marschner's Gaussian divided by its normaliser; "
                  "reference only",
                  longitudinal_inputs, longitudinal_outputs, TSU_FUNCTION_REFERENCE_ONLY),
     .inputs = longitudinal_inputs,
     .outputs = longitudinal_outputs,
     .params = longitudinal_params,
     .reference = longitudinal_gaussian}};

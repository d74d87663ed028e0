#include "models/model.h"
#include "models/values.h"
#include "optics/angle.h"
#include "optics/fiber.h"
#include "optics/quadrature.h"

#include <tsuya/models/kajiya_kay.h>
#include <tsuya/set.h>

#include <math.h>
#include <string.h>

typedef tsu_kajiya_kay_params params;

// Record, laid out as in glsl/kajiya_kay/eval.glsl.
struct state {
    float record[16];
};

// Same hair as Marschner's default.
static const params defaults = {
    .struct_size = sizeof(params),
    .eta = 1.55f,
    .alpha_R = (float)TSU_I_DEGREES(-7.5),
    .beta_R = (float)TSU_I_DEGREES(7.5),
    .sigma_a = {0.5447f, 0.9061f, 1.781f},
};

static const tsu_parameter_info parameters[] = {
    TSU_I_PARAMETER(params, eta, 1, "1", 0, 1.2, 2.0, 1.55, "refractive index of the fibre"),
    TSU_I_PARAMETER(params, alpha_R, 1, "rad", 0, TSU_I_DEGREES(-20), TSU_I_DEGREES(20),
                    TSU_I_DEGREES(-7.5),
                    "shift of the highlight in theta_i + theta_r; negative is towards the root"),
    TSU_I_PARAMETER(params, beta_R, 1, "rad", 0, TSU_I_DEGREES(2), TSU_I_DEGREES(30),
                    TSU_I_DEGREES(7.5), "deviation of the highlight in theta_i + theta_r"),
    TSU_I_PARAMETER(params, sigma_a, 3, "1/radius", 0, 0, 1e6, 0.9061,
                    "absorption per fibre radius, linear RGB"),
};

static const tsu_input_info inputs[] = {
    TSU_I_INPUT("material", "int", 0, "index of the material in the bound page"),
    TSU_I_INPUT("t", "vec3", 0, "unit tangent, root to tip"),
    TSU_I_INPUT("l", "vec3", 0, "unit vector to the light"),
    TSU_I_INPUT("v", "vec3", 0, "unit vector to the viewer"),
    TSU_I_INPUT("sigma_a", "vec3", 0, "absorption per fibre radius, linear RGB"),
};

static const tsu_error_info errors[] = {
#include "models/kajiya_kay/errors.inc"
};

// Surface reflection and what the rest keeps after absorption, at one inclination.
static void marschner_energy(double eta, double cos_theta, double sigma_a, double *surface,
                             double *kept)
{
    double white[TSU_I_LOBES], absorbed[TSU_I_LOBES];
    const double theta = acos(cos_theta);
    tsu_i_fiber_attenuation(eta, theta, 0.0, white);
    tsu_i_fiber_attenuation(eta, theta, sigma_a, absorbed);
    *surface = white[TSU_I_R];
    *kept = (absorbed[TSU_I_TT] + absorbed[TSU_I_TRT] + absorbed[TSU_I_RES]) / (1.0 - *surface);
}

// 2 pi Int cos^n(theta_i + theta) cos(theta_i) dtheta_i over the lobe's half circle.
static double highlight_integral(double exponent, double cos_theta)
{
    const int panels = 16;
    const double theta = acos(cos_theta);
    double sum = 0.0;
    for (int i = 0; i < panels * TSU_I_QUADRATURE_PANEL; i++) {
        double weight;
        const double at =
            tsu_i_quadrature_node(-0.5 * TSU_I_PI, 0.5 * TSU_I_PI, panels, i, &weight);
        sum += weight * pow(fmax(cos(at + theta), 0.0), exponent) * cos(at);
    }
    return 2.0 * TSU_I_PI * sum;
}

static double surface_at(double eta, double cos_theta)
{
    double surface, kept;
    marschner_energy(eta, cos_theta, 0.0, &surface, &kept);
    return surface;
}

static double path_at(double eta, double cos_theta)
{
    const double sigma_a = 0.7;
    double surface, kept;
    marschner_energy(eta, cos_theta, sigma_a, &surface, &kept);
    return -log(kept) / sigma_a;
}

static void prepare(const void *from, void *to)
{
    const params *p = from;
    float *record = ((struct state *)to)->record;
    const double exponent = 1.0 / ((double)p->beta_R * p->beta_R);

    record[0] = cosf(p->alpha_R);
    record[1] = sinf(p->alpha_R);
    record[2] = (float)exponent;
    record[3] = (float)log2(1.0 / (TSU_I_PI * TSU_I_PI));

    // x + y 2^(z c) through the exact reflection at three cosines 0.4 apart.
    const double high = surface_at(p->eta, 1.0), middle = surface_at(p->eta, 0.6);
    const double low = surface_at(p->eta, 0.2);
    const double z = log2((middle - high) / (low - middle)) / 0.4;
    const double y = (low - middle) / (exp2(0.2 * z) - exp2(0.6 * z));
    record[4] = (float)(low - y * exp2(0.2 * z));
    record[5] = (float)y;
    record[6] = (float)z;

    // The body's path and the highlight's integral as lines in the cosine. The latter is exact at
    // 0, where a smaller value would make energy, and errs three times as much at 1 as, the other
    // way, at 1/2.
    const double near_path = path_at(p->eta, 0.87), far_path = path_at(p->eta, 0.4);
    const double path_slope = (near_path - far_path) / 0.47;
    record[8] = (float)(TSU_I_LOG2E * path_slope);
    record[9] = (float)(TSU_I_LOG2E * (near_path - 0.87 * path_slope));
    const double least = highlight_integral(exponent, 0.0);
    const double half = highlight_integral(exponent, 0.5);
    const double full = highlight_integral(exponent, 1.0);
    record[10] = (float)((4.0 - 3.0 * least / half - least / full) / (1.5 / half + 1.0 / full));
    record[11] = (float)least;
    memcpy(record + 12, p->sigma_a, sizeof p->sigma_a);
    record[15] = p->eta;
}

static void write_record(const void *state, const struct tsu_i_place *places, float *record)
{
    (void)places;
    memcpy(record, ((const struct state *)state)->record, sizeof((const struct state *)0)->record);
}

static float clamp01(float x)
{
    return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
}

// The shader in C, in float.
static void hair(const void *state, const float *r, const struct tsu_i_texels *tables,
                 const double *in, double *out)
{
    (void)state;
    (void)tables;
    const float sin_i = (float)sin(in[0]), sin_r = (float)sin(in[1]), sigma_a = (float)in[4];
    const float cos_i = sqrtf(clamp01(1.0f - sin_i * sin_i));
    const float cos_r = sqrtf(clamp01(1.0f - sin_r * sin_r));
    const float sin_s = r[0] * sin_r - r[1] * cos_r, cos_s = r[0] * cos_r + r[1] * sin_r;
    const float cone = clamp01(cos_i * fabsf(cos_s) - sin_i * sin_s);
    const float reflected = r[5] * exp2f(r[6] * cos_r) + r[4];
    out[1] = exp2f(r[2] * log2f(cone)) * (reflected / (r[10] * fabsf(cos_s) + r[11]));
    out[0] = (cos_i - cos_i * reflected) * exp2f(r[3] - sigma_a * (r[8] * cos_r + r[9]));
    out[2] = out[0] + out[1];
}

static void hair_params(const double *in, void *to)
{
    params *p = to;
    p->eta = (float)in[3];
    p->alpha_R = (float)in[5];
    p->beta_R = (float)in[6];
}

// The model's definition with exact energies: surface reflection, highlight integral and absorption
// by quadrature instead of the record's fits.
static void hair_reference(const double *in, double *out)
{
    const double cos_i = fabs(cos(in[0])), cos_r = fabs(cos(in[1])),
                 exponent = 1.0 / (in[6] * in[6]);
    const double shifted = in[1] - in[5];
    const double cone = cos(in[0]) * fabs(cos(shifted)) - sin(in[0]) * sin(shifted);
    double surface, kept;
    marschner_energy(in[3], fmax(cos_r, 1e-9), in[4], &surface, &kept);
    out[0] = (1.0 - surface) * kept * cos_i / (TSU_I_PI * TSU_I_PI);
    out[1] =
        surface * pow(fmax(cone, 0.0), exponent) / highlight_integral(exponent, fabs(cos(shifted)));
    out[2] = out[0] + out[1];
}

static const tsu_value_info hair_inputs[] = {
    TSU_I_FRAGMENT("theta_i", "rad", "inclination of the light", TSU_I_DEGREES(-90),
                   TSU_I_DEGREES(90), 0),
    TSU_I_FRAGMENT("theta_r", "rad", "inclination of the view", TSU_I_DEGREES(-90),
                   TSU_I_DEGREES(90), 0),
    TSU_I_FRAGMENT("phi", "rad", "azimuth of the view from the light's; no part in this model",
                   -1e6, 1e6, 0),
    TSU_I_MATERIAL("eta", "1", "refractive index", 1.2, 2, 1.55),
    TSU_I_FRAGMENT("sigma_a", "1/radius", "absorption of one channel", 0, 1e6, 0.9061),
    TSU_I_MATERIAL("alpha_R", "rad", "shift of the highlight", TSU_I_DEGREES(-20),
                   TSU_I_DEGREES(20), TSU_I_DEGREES(-7.5)),
    TSU_I_MATERIAL("beta_R", "rad", "deviation of the highlight", TSU_I_DEGREES(2),
                   TSU_I_DEGREES(30), TSU_I_DEGREES(7.5))};
static const tsu_value_info hair_outputs[] = {TSU_I_OUTPUT("diffuse", "1/sr", "body"),
                                              TSU_I_OUTPUT("specular", "1/sr", "highlight"),
                                              TSU_I_OUTPUT("total", "1/sr", "the sum")};

static const struct tsu_i_function functions[] = {
    {.info = {.struct_size = sizeof(tsu_function_info),
              .name = "hair",
              .help = "S cos(theta_i) of a fibre, lobe by lobe",
              .input_count = sizeof hair_inputs / sizeof *hair_inputs,
              .output_count = sizeof hair_outputs / sizeof *hair_outputs},
     .inputs = hair_inputs,
     .outputs = hair_outputs,
     .params = hair_params,
     .reference = hair_reference,
     .probe = "kajiya_kay/probe_hair.glsl",
     .sampled = hair}};

static const char *const snippets[] = {"kajiya_kay/eval.glsl", NULL};

const struct tsu_model tsu_i_model_kajiya_kay = {
    .info = {.struct_size = sizeof(tsu_model_info),
             .name = "kajiya_kay",
             .title = "Kajiya-Kay fibre with Marschner's energy",
             .source = "Kajiya and Kay 1989, Rendering Fur with Three Dimensional Textures",
             .params_size = sizeof(params),
             .parameter_count = sizeof parameters / sizeof *parameters,
             .error_count = sizeof errors / sizeof *errors,
             .input_count = sizeof inputs / sizeof *inputs,
             .function_count = sizeof functions / sizeof *functions},
    .defaults = &defaults,
    .params_least = sizeof(params),
    .parameters = parameters,
    .errors = errors,
    .inputs = inputs,
    .functions = functions,
    .snippets = snippets,
    .prepare = prepare,
    .record = write_record,
};

const tsu_model *tsu_kajiya_kay(void)
{
    return &tsu_i_model_kajiya_kay;
}

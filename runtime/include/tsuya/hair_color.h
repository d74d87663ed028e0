// Colours of hair: pigment, presets, albedo of a fibre and of a head, each to absorption sigma_a.
#ifndef TSUYA_HAIR_COLOR_H
#define TSUYA_HAIR_COLOR_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

// Absorption of the two hair pigments: sigma_a = eumelanin (0.419, 0.697, 1.37) + pheomelanin
// (0.187, 0.4, 1.05), per fibre radius, linear Rec. 709.
// Source: d'Eon et al. 2011, "An Energy-Conserving Hair Reflectance Model", section 6.1 (the set
// that pbrt and MaterialX use too; some renderers use another one, and differ in colour).
//   eumelanin, pheomelanin   concentrations, [0, 100]; dark blond 0.3, brown 1.3, black 8
// Errors: TSU_E_PARAMETER (not finite, out of range, NULL). Threads: any.
TSU_API tsu_status tsu_hair_melanin(tsu_context *context, double eumelanin, double pheomelanin,
                                    double sigma_a[3]);

// Albedo of one fibre lit from everywhere alike: the share of the light that it scatters, lobes of
// all orders, per channel. 1 at sigma_a = 0; falls to the surface reflection.
//   eta       refractive index, [1.2, 2]
//   sigma_a   per fibre radius, [0, 1e6]
// Errors: TSU_E_PARAMETER. Threads: any.
TSU_API tsu_status tsu_hair_albedo(tsu_context *context, double eta, const double sigma_a[3],
                                   double albedo[3]);

// The inverse of tsu_hair_albedo(), solved on that very function: round trip within 1e-12.
//   albedo    (least, 1]; the least is the surface reflection, which no pigment takes away: 0.099
//             at eta 1.55. The log line of an error gives it
// This is the colour of a single fibre, not of a head of such fibres: tsu_hair_head_sigma_a().
// Errors: TSU_E_PARAMETER. Threads: any.
TSU_API tsu_status tsu_hair_sigma_a(tsu_context *context, double eta, const double albedo[3],
                                    double sigma_a[3]);

// Colour of a head: albedo of hair so thick that nothing shows through it, a half space of parallel
// fibres at random, seen across the fibres and along the normal under light from everywhere alike.
// It is what a painter or a photograph means by the colour of hair. Light meets many fibres, so a
// head is far darker and more saturated than its fibres. The default fibre:
//   sigma_a   0   0.0025   0.01   0.05   0.1    0.2    0.5    1      2      5
//   a fibre   1   0.995    0.980  0.906  0.823  0.684  0.413  0.214  0.115  0.099
//   a head    1   0.687    0.500  0.249  0.153  0.080  0.030  0.017  0.014  0.013
// The fibre is tsuya's own (models/marschner.h): d'Eon's longitudinal lobes, all orders; all orders
// of scattering between fibres, by adding-doubling.
// Source of the idea: Chiang et al. 2016, "A Practical and Controllable Hair and Fur Model for
// Production Path Tracing", which fits such an inverse to renderings; here a solution
// is inverted, so it follows every parameter of the fibre.

// Fibre of a head; fields, ranges and defaults of tsu_marschner_params. Angles in radians.
typedef struct tsu_hair_head_desc {
    uint32_t struct_size; // set by tsu_hair_head_desc_init()
    uint32_t flags;       // 0
    float eta;            // refractive index, [1.2, 2], default 1.55
    float alpha_R;        // shift of R, [-20, 20] degrees, default -7.5
    float beta_R;         // deviation of R, [2, 30] degrees, default 7.5
    float beta_az;        // azimuthal deviation, [5, 30] degrees, default 10
    float scale_shifts;   // shifts of the later lobes, [0, 1], default 0
    uint32_t reserved;    // 0
} tsu_hair_head_desc;
// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_hair_head_desc_init_sized(tsu_hair_head_desc *desc, size_t size);
#define tsu_hair_head_desc_init(desc) tsu_hair_head_desc_init_sized((desc), sizeof *(desc))

enum { TSU_HAIR_HEAD_NODES = 17 };

// Albedo of a head over sigma_a, for one fibre: plain data that may be copied, kept and compared.
typedef struct tsu_hair_head_curve {
    uint32_t struct_size; // set by tsu_hair_head_curve_init()
    uint32_t flags;       // 0
    float eta, alpha_R, beta_R, beta_az, scale_shifts; // the fibre's
    uint32_t reserved;                                 // 0
    // At sqrt(sigma_a) = 0.15 i / (16 - i): from 1 without pigment to the least that can be, light
    // that only surfaces reflect. Does not rise.
    double albedo[TSU_HAIR_HEAD_NODES];
} tsu_hair_head_curve;
#define tsu_hair_head_curve_init(curve) tsu_info_init_sized((curve), sizeof *(curve))

// Fill a curve. The default fibre's is compiled in; any other takes 16 solutions, as two batches of
// 8 jobs: 2.5 s in one thread from beta_az 10 degrees on, 18 s at 5 degrees; 2.5 to 8 MB for each
// solution under way, freed before it returns.
// Error, of albedo: between nodes 3e-4 (5e-5 at the default fibre). At nodes the solution errs by
// 3e-4, by 1e-3 for beta_az below 10 degrees and by 4e-3 for beta_R of 2 degrees, whose lobes are
// narrower than its directions lie apart.
// Errors: TSU_E_PARAMETER (logged with field and range), TSU_E_STRUCT, TSU_E_MEMORY; *curve is zero
// then. Threads: object.
TSU_API tsu_status tsu_hair_head_curve_solve(tsu_context *context, const tsu_hair_head_desc *desc,
                                             tsu_hair_head_curve *curve);

// Albedo of a head, per channel: a few cubics of the curve.
//   sigma_a   per fibre radius, [0, 1e6]
// Errors: TSU_E_PARAMETER (a value; a curve that tsu_hair_head_curve_solve() did not fill),
// TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_hair_head_albedo(tsu_context *context, const tsu_hair_head_curve *curve,
                                        const double sigma_a[3], double albedo[3]);

// The inverse of tsu_hair_head_albedo(): round trip within 1e-12, within 1e-8 nearer than 1e-3 to
// the least; through the solution itself within 3e-4.
//   albedo    (least, 1], channels alone; the least is the curve's last node, 0.013 at the default
//             fibre. The log line of an error gives it
// Errors: as tsu_hair_head_albedo(). Threads: any.
TSU_API tsu_status tsu_hair_head_sigma_a(tsu_context *context, const tsu_hair_head_curve *curve,
                                         const double albedo[3], double sigma_a[3]);

typedef struct tsu_hair_preset_info {
    uint32_t struct_size; // set by tsu_hair_preset_info_init()
    uint32_t flags;       // 0
    const char *name;     // "black", "brown", ...
    double eumelanin, pheomelanin;
    double sigma_a[3]; // per fibre radius, linear Rec. 709
} tsu_hair_preset_info;
#define tsu_hair_preset_info_init(info) tsu_info_init_sized((info), sizeof *(info))

// Number of natural hair colours. Threads: any.
TSU_API uint32_t tsu_hair_preset_count(void);
// Colour by position. Errors: TSU_E_PARAMETER, TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_hair_preset(uint32_t index, tsu_hair_preset_info *out);

#ifdef __cplusplus
}
#endif
#endif

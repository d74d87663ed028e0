// Colours of hair: pigment, presets and single-fibre albedo, each to absorption sigma_a.
#ifndef TSUYA_HAIR_COLOR_H
#define TSUYA_HAIR_COLOR_H

#include <tsuya/context.h>

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

// The inverse of tsu_hair_albedo(), solved on that very function: round trip within 1e-9.
//   albedo    (least, 1]; the least is the surface reflection, which no pigment takes away: 0.099
//             at eta 1.55. The log line of an error gives it
// This is the colour of a single fibre: a thick head of hair looks much lighter and more saturated.
// Errors: TSU_E_PARAMETER. Threads: any.
TSU_API tsu_status tsu_hair_sigma_a(tsu_context *context, double eta, const double albedo[3],
                                    double sigma_a[3]);

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

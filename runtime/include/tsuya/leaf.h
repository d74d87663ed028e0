// Leaves: the layers of the models `leaf` and `leaf_body` from what a leaf is made of, from what it
// reflects and lets through, or by name.
//
// Three doors lead to the same parameters, the fields n, scatter_top, absorption_top,
// scatter_bottom and absorption_bottom of the model's typed parameters (models/leaf_body.h):
//   pigments     tsu_leaf_from_pigments(): chlorophyll and the like, or a preset
//   reflectance  tsu_leaf_from_reflectance(): measured or painted R_top, R_bottom, T
//   layers       the fields themselves; tsu_leaf_measure() tells what they do
//
//   tsu_leaf_params leaf;                      // models/leaf.h
//   tsu_leaf_pigments pigments;
//   tsu_leaf_params_init(&leaf);
//   tsu_leaf_pigments_init(&pigments);
//   pigments.chlorophyll = 60;
//   tsu_leaf_from_pigments(context, tsu_leaf(), &pigments, &leaf, NULL);
//
// Reflectance and transmittance are shares of light that comes along the normal
// (normal-hemispherical), linear Rec. 709, the mirror reflection of the surface and light that was
// never scattered included. R_top and T are of light from above, R_bottom of light from below.
//
// Layers are found by the reference solver, channel by channel: 10 ms for a leaf's channel, up to
// 0.3 s for odd ones and for refusals; three jobs where the host has jobs.
#ifndef TSUYA_LEAF_H
#define TSUYA_LEAF_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

// What a leaf is made of. Contents are per area of leaf; those of live leaves are in brackets.
typedef struct tsu_leaf_pigments {
    uint32_t struct_size; // set by tsu_leaf_pigments_init()
    uint32_t flags;       // 0
    double N;             // plates with air between them, [1, 10], (1 .. 3.5), default 1.5
    double chlorophyll;   // ug/cm2, [0, 1e6], (0 .. 100), default 40
    double carotenoids;   // ug/cm2, [0, 1e6], (0 .. 25), default 8
    double anthocyanins;  // ug/cm2, [0, 1e6], (0 .. 40), default 1
    double brown;         // brown pigments, 1, [0, 1e6], (0 .. 1.5), default 0
    double water;         // cm, [0, 1e6], (0.001 .. 0.05), default 0.01
    double dry_matter;    // g/cm2, [0, 1e6], (0.001 .. 0.03), default 0.008
    double n;             // index of the layers to find, [1.2, 1.8], default 1.45
    double bottom;        // R_bottom over R_top that is wished, [0.25, 4], default 1.4: contents do
                          // not tell the faces apart
} tsu_leaf_pigments;
// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_leaf_pigments_init_sized(tsu_leaf_pigments *pigments, size_t size);
#define tsu_leaf_pigments_init(pigments)                                                           \
    tsu_leaf_pigments_init_sized((pigments), sizeof *(pigments))

// Leaves with a name ("mature_broadleaf", ...). Threads: any.
TSU_API uint32_t tsu_leaf_preset_count(void);
// Name by position, NULL past the end. Threads: any.
TSU_API const char *tsu_leaf_preset_name(uint32_t index);
// Contents by position. Errors: TSU_E_PARAMETER, TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_leaf_preset(uint32_t index, tsu_leaf_pigments *out);

// Reflectance and transmittance at one wavelength by PROSPECT-D.
//   lambda   nm, [400, 780]
// Sources: Jacquemoud and Baret 1990, "PROSPECT: A Model of Leaf Optical Properties Spectra"; Feret
// et al. 2017, "PROSPECT-D", coefficients every 10 nm, lines between them.
// Error: 1e-6 against the authors' output at 400, 410, .. 780 nm; between them 0.008, on the red
// edge (690 to 720 nm) 0.02.
// Errors: TSU_E_PARAMETER (logged with field and range), TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_leaf_spectrum(tsu_context *context, const tsu_leaf_pigments *pigments,
                                     double lambda, double *R, double *T);

// The spectrum's colour under daylight (D65, CIE 1931 observer), linear Rec. 709, white 1. A
// channel of T may be negative, and one of R below what surfaces reflect: light through a leaf is
// greener than the green primary. Error: 5e-5.
// Errors, threads: as tsu_leaf_spectrum().
TSU_API tsu_status tsu_leaf_color(tsu_context *context, const tsu_leaf_pigments *pigments,
                                  double R[3], double T[3]);

// What the faces of a leaf do, measured or painted.
typedef struct tsu_leaf_reflectance {
    uint32_t struct_size;               // set by tsu_leaf_reflectance_init()
    uint32_t flags;                     // 0
    double n;                           // index of the layers to find, [1.2, 1.8], default 1.45
    double R_top[3], R_bottom[3], T[3]; // default 0, which no leaf has
} tsu_leaf_reflectance;
// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_leaf_reflectance_init_sized(tsu_leaf_reflectance *reflectance, size_t size);
#define tsu_leaf_reflectance_init(reflectance)                                                     \
    tsu_leaf_reflectance_init_sized((reflectance), sizeof *(reflectance))

// What layers do.
typedef struct tsu_leaf_report {
    uint32_t struct_size; // set by tsu_leaf_report_init()
    uint32_t flags;       // 0
    double R_top[3], R_bottom[3], T[3];
    double residual[3]; // the largest difference to what was asked, channel by channel
    uint32_t limited;   // bit k: in channel k R_bottom is not the wished one
    uint32_t raised;    // bit k: channel k was outside what leaves can show in Rec. 709
} tsu_leaf_report;
#define tsu_leaf_report_init(report) tsu_info_init_sized((report), sizeof *(report))

// Layers that reflect and transmit what is asked, within 1e-4 (leaves: 1e-7). Sets n and the four
// depths of `params`, typed parameters of `model` that must be initialised, and leaves the rest.
//   report   may be NULL; what the layers do. Where nothing does what is asked it holds, against
//            the rule, the nearest possible, each channel alone, in the sense of least squares
// Three numbers do not tell four depths apart: the clear layer's scattering is 0.1 wherever that
// does it, the top layer's where R_bottom >= R_top.
// Errors: TSU_E_PARAMETER, `params` unchanged: the model has no such layers; a value is not finite;
// R + T above 1; R below ((n-1)/(n+1))^2, the surface's share; faces more unlike, or a leaf
// clearer, than two layers can be. The log line names field and channel and the nearest possible.
// TSU_E_STRUCT, TSU_E_MEMORY. Threads: object.
TSU_API tsu_status tsu_leaf_from_reflectance(tsu_context *context, const tsu_model *model,
                                             const tsu_leaf_reflectance *reflectance, void *params,
                                             tsu_leaf_report *report);

// Layers of a leaf of these contents: its colours, then tsu_leaf_from_reflectance() with two
// exceptions, both told in *report.
//   limited  where `bottom` asks for more than two layers can do beside R_top and T, R_bottom is as
//            near to it as they allow: 1.2 R_top in the red of a yellow leaf
//   raised   a channel darker than leaves can be, R_top below the surface's share and 0.002 or T
//            below 0.0005, is raised to that; one of more than all light goes to the nearest
//            possible
// Errors, threads: as tsu_leaf_spectrum(), and TSU_E_MEMORY; *report is zero then.
TSU_API tsu_status tsu_leaf_from_pigments(tsu_context *context, const tsu_model *model,
                                          const tsu_leaf_pigments *pigments, void *params,
                                          tsu_leaf_report *report);

// What given layers do, pigment and thickness of `params` included; residual, limited and raised
// are 0. Error: 1.5e-6.
// Errors: TSU_E_PARAMETER (a field out of range, a model without layers; logged), TSU_E_STRUCT,
// TSU_E_MEMORY. Threads: object.
TSU_API tsu_status tsu_leaf_measure(tsu_context *context, const tsu_model *model,
                                    const void *params, tsu_leaf_report *report);

#ifdef __cplusplus
}
#endif
#endif

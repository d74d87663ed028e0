// Thickness and scale of leaves: how far light spreads sideways inside, whether BRDF and BTDF are
// enough for a pixel and a curvature, and the blur that close-ups need when they are not.
//
// A BRDF and a BTDF give light back where it came in. Inside a leaf it spreads first: 90 % of what
// a green leaf of 0.2 mm reflects leaves within 0.26 mm of where it came, 90 % of what it transmits
// within 0.33 mm. Seen from where a pixel covers a millimetre that does not matter; in a close-up
// the shadow of a vein is softer on the far side.
//
//   tsu_leaf_scale_solve()    once for a material: radii, totals, Gaussians. 40 to 800 ms in one
//                             thread, three jobs; 130 for the default leaf, most for thick white
//                             ones of g 0.8
//   tsu_leaf_scale_judge()    for a pixel and a curvature: is a BRDF and a BTDF enough, and why
//   tsu_blur()                GLSL, asked for with TSU_SHADER_BLUR
//
// The leaf is a slab of two layers between smooth walls, as model leaf_body: per channel reduced
// scattering depths sigma_s (1 - g) d and absorption depths sigma_a d of both layers. Light comes
// along the normal. At 40 degrees it spreads as wide (deviation of R within 2 %, of T 5 %, of
// random walks; at 80 degrees T up to 25 % wider) about a place .08 to .28 d further along its way,
// which the blur leaves out.
//
// Error of the radii (TSU_LEAF_TRANSPORT): the transport equation is solved for 20 spatial
// frequencies (optics/slab_spread.h) and six Gaussians are fitted. Against random walks over n 1.35
// to 1.55, g 0 to 0.8, reduced scattering depth 0.5 to 9, absorption depth 0 to 6, for 90 %: 0.7 %
// in the mean, 2.3 % at the worst. Against MCML's leaf, 90 %: R .253 mm (.255), T .322 mm (.325),
// its bins .01 mm wide; 99 %: R .450 mm (.475), T .547 mm (.545).
//
// Blur. The host keeps a map of the irradiance that falls on each side, in the leaf's own texture
// space, with mip maps, and puts
//
//   vec3 tsu_blur(sampler2D map, vec2 uv, vec2 texels_per_mm, vec4 gaussians[6])
//
// in the place of the irradiance at the point: of the far side with `transmitted`, of the seen side
// with `reflected`. 16 trilinear fetches for four Gaussians; tsu_blur_coarse(), the same
// arguments, 4. Error against the exact convolution, of the contrast: 0.05 at the worst, 0.006 root
// mean square; coarse 0.15 and 0.014. To these adds fit_error. A separable blur of the host's own
// takes the same numbers: the answer is sum_j weight_j * (map blurred by a Gaussian of deviation
// sigma_j).
#ifndef TSUYA_LEAF_SCALE_H
#define TSUYA_LEAF_SCALE_H

#include <tsuya/model.h>

#ifdef __cplusplus
extern "C" {
#endif

// How the profiles are found. All but the first are diffusion: there for comparison and for thick,
// pale matter, they take both layers as one, and are refused where R or T in total is off by more
// than 15 %, which is everywhere in red and blue of green leaves (multipole, a' .23: R +53 %,
// T -92 %). Error: light that six Gaussians put into the wrong ring around a pencil beam, of all
// light, against MCML (half space, a' .95 and .99; leaf, a' .95, reflected and transmitted). Half
// spaces lose most in the first tenth of a mean free path, which no six Gaussians follow.
typedef int32_t tsu_leaf_method;
enum {
    TSU_LEAF_TRANSPORT = 1,     // 12, 4; 3, 2 %
    TSU_LEAF_MULTIPOLE = 2,     // Donner and Jensen 2005; 14, 7 % of the leaf
    TSU_LEAF_DIPOLE = 3,        // Jensen et al. 2001: half space, reflection only; 51, 17 %
    TSU_LEAF_BETTER_DIPOLE = 4, // d'Eon 2012: half space, reflection only; 23, 13 %
    TSU_LEAF_PHOTON_BEAM = 5    // Habel et al. 2013: half space, reflection only; 14, 7 %
};

enum { TSU_LEAF_LIT_BELOW = 1 }; // the bottom layer is the lit side
enum { TSU_LEAF_GAUSSIANS = 6 };

typedef struct tsu_leaf_scale_desc {
    uint32_t struct_size;   // set by tsu_leaf_scale_desc_init()
    uint32_t flags;         // TSU_LEAF_LIT_BELOW; default 0
    tsu_leaf_method method; // default TSU_LEAF_TRANSPORT
    uint32_t gaussians;     // of the blur, [2, 6], default 4; the fit_error of leaves is .17, .05,
                            // .03, .02, .01
    float n;                // refractive index, [1, 2], default 1.45
    float g;                // mean cosine of Henyey and Greenstein, [0, 0.8], default 0.5
    float thickness;        // of both layers, mm, [1e-3, 1e3], default 0.2
    float share_top;        // of the thickness that is the top layer's, [0.05, 0.95], default 0.5
    // Depths of the layers along the normal, scattering [0, 5], absorption [0, 10]; default a green
    // leaf: 1 and 1 of scattering, 1.2, 0.3, 2.4 and as much of absorption.
    float scatter_top[3], absorption_top[3];
    float scatter_bottom[3], absorption_bottom[3];
    float fraction; // of the light that a radius is to hold, [0.05, 0.99], default 0.9
    float reserved; // 0
} tsu_leaf_scale_desc;

// Errors: TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_leaf_scale_desc_init_sized(tsu_leaf_scale_desc *desc, size_t size);
#define tsu_leaf_scale_desc_init(desc) tsu_leaf_scale_desc_init_sized((desc), sizeof *(desc))

typedef int32_t tsu_leaf_refusal;
enum {
    TSU_LEAF_ABSORBS = 1, // reduced albedo below what the method needs; value: the albedo
    TSU_LEAF_THIN = 2,    // value: reduced optical depth, or sigma_tr d of a half space
    TSU_LEAF_THICK = 3,   // value: sigma_tr d
    TSU_LEAF_TOTAL = 4    // value: total_error
};

// Plain data that may be copied, kept and compared. Per channel; lengths in mm.
typedef struct tsu_leaf_scale {
    uint32_t struct_size;      // set by tsu_leaf_scale_init()
    uint32_t flags;            // 0
    uint32_t gaussians;        // used of the six
    float thickness, fraction; // the description's
    float fit_error;           // largest |error| of a blur's answer to a pattern of stripes of any
                               // width, of the total
    float reflectance[3];      // scattered light that leaves on the lit side, of all that comes
    float transmittance[3];    // and on the far side, without `straight`
    float straight[3];         // passes without meeting anything: blurs nothing
    float reflected_radius[3]; // that holds `fraction` of the reflectance
    float transmitted_radius[3]; // and of the transmittance
    // What tsu_blur() takes as vec4[6]: weights of the channels, which sum to 1 (0 where there
    // is no light), and standard deviation in mm, which rises.
    float reflected[24], transmitted[24];
    tsu_leaf_refusal refusal[3]; // 0: none
    float refusal_value[3];
    float total_error[3]; // of diffusion methods: R and T over the solution's, less 1; the
                          // larger
} tsu_leaf_scale;
#define tsu_leaf_scale_init(scale) tsu_info_init_sized((scale), sizeof *(scale))

// Solve. A channel that the method is refused for makes the call fail with TSU_E_LIMIT, names
// reason and number in the log and leaves refusal, refusal_value and total_error in *scale.
// Errors: TSU_E_PARAMETER (logged with field and range), TSU_E_STRUCT, TSU_E_LIMIT, TSU_E_MEMORY;
// *scale is zero then but for the refusal. Threads: object.
TSU_API tsu_status tsu_leaf_scale_solve(tsu_context *context, const tsu_leaf_scale_desc *desc,
                                        tsu_leaf_scale *scale);

enum {
    TSU_LEAF_PIXEL_REFLECTED = 1, // pixels are too fine for a BRDF, for a BTDF
    TSU_LEAF_PIXEL_TRANSMITTED = 2,
    TSU_LEAF_CURVED_REFLECTED = 4, // the surface is too curved
    TSU_LEAF_CURVED_TRANSMITTED = 8
};

// Errors of BRDF and BTDF without blur, in shares of the brightest channel's light; [0] reflected,
// [1] transmitted.
typedef struct tsu_leaf_verdict {
    uint32_t struct_size; // set by tsu_leaf_verdict_init()
    uint32_t flags;       // 0: BRDF and BTDF are enough; else TSU_LEAF_* bits that say what is not
    // A border between light and shadow that falls on a border between pixels: what the first pixel
    // beyond gets in truth, and nothing without blur. At most 0.5. Exact for the Gaussians.
    float pixel_error[2];
    // A sphere of this radius: the larger of what the light's terminator is off by, and of a bound
    // for the power that a bent slab gives back, d / radius times: reflected min(1.5 + 0.8 r / d,
    // 3.2), r the radius that holds 90 %; transmitted 0.5. Bounds of random walks in shells for
    // radii from 10 d on. The sign is not said: reflection grows where the lit side is convex.
    float curvature_error[2];
    // From which pixel, from which radius of curvature on (mm) the error is within the tolerance.
    float pixel[2], curvature[2];
} tsu_leaf_verdict;
#define tsu_leaf_verdict_init(verdict) tsu_info_init_sized((verdict), sizeof *(verdict))

// Judge. tsu_leaf_scale_solve() with four Gaussians is enough.
//   pixel_mm       side of what a pixel covers on the leaf, [1e-6, 1e6] mm
//   curvature_mm   smaller radius of curvature, [1e-3, 1e9] mm; 1e9: flat
//   tolerance      error that is let pass, [1e-3, 0.5]; 0.1 is a soft border nobody misses
// Errors: TSU_E_PARAMETER (logged; also a scale that was not solved), TSU_E_STRUCT. Threads: any.
TSU_API tsu_status tsu_leaf_scale_judge(tsu_context *context, const tsu_leaf_scale *scale,
                                        double pixel_mm, double curvature_mm, double tolerance,
                                        tsu_leaf_verdict *verdict);

#ifdef __cplusplus
}
#endif
#endif

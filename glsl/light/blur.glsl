// SPDX-License-Identifier: MIT
// Light that spreads inside a leaf before it leaves it: the irradiance of a map, blurred by the
// Gaussians of tsu_leaf_scale_solve() (tsuya/leaf_scale.h).
//
// The map holds irradiance in the leaf's texture space, linear, any unit: of the far side for
// transmitted, of the seen side for reflected light; 0 outside of the leaf's outline. Mip maps are
// made of it by averaging four texels into one (glGenerateMipmap); filters are
// GL_LINEAR_MIPMAP_LINEAR and GL_LINEAR. What comes out stands in the place of the irradiance at
// the point: what leaves is the BRDF's or BTDF's value times it.
//
// Each Gaussian is four taps in a mip level whose texels, as wide as 1.4 deviations, do the rest of
// the blur: 16 trilinear fetches for four Gaussians; the coarse form is one tap a Gaussian. Error
// against the exact convolution, in shares of the contrast, for borders, shadows of veins and spots
// at 20 and 60 texels a millimetre (tests/gl): 0.05 at the worst, 0.006 root mean square; coarse
// 0.15 and 0.014.

// Deviations along u and v in texels; the mean variance of a mip-mapped, linear tap of level lod.
float tsu_blur_own(float lod)
{
    float texel2 = exp2(2.0 * floor(lod)) * (1.0 + 3.0 * fract(lod));
    // A box as wide as the texel, and the tent of the filter; the first level's box is the map's.
    return 0.25 * texel2 - 1.0 / 12.0;
}

// Level whose texels are `wide` texels wide.
float tsu_blur_level(sampler2D map, float wide)
{
    ivec2 size = textureSize(map, 0);
    return clamp(log2(max(wide, 1.0)), 0.0, floor(log2(float(max(size.x, size.y)))));
}

vec3 tsu_blur_one(sampler2D map, vec2 uv, vec2 sigma)
{
    float lod = tsu_blur_level(map, 1.4 * sqrt(sigma.x * sigma.y));
    vec2 a = sqrt(max(sigma * sigma - tsu_blur_own(lod), 0.0)) / vec2(textureSize(map, 0));
    vec2 b = vec2(a.x, -a.y);
    return 0.25 * (textureLod(map, uv + a, lod).rgb + textureLod(map, uv - a, lod).rgb +
                   textureLod(map, uv + b, lod).rgb + textureLod(map, uv - b, lod).rgb);
}

// The blurred irradiance.
//   map            irradiance, see above
//   uv             the point's place in it
//   texels_per_mm  texels of its first level a millimetre on the leaf, along u and v; within 1 : 2
//                  of each other, or the blur is too narrow along the coarser axis
//   gaussians      tsu_leaf_scale.reflected or .transmitted
vec3 tsu_blur(sampler2D map, vec2 uv, vec2 texels_per_mm, vec4 gaussians[6])
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 6; i++) {
        if (gaussians[i].w > 0.0) {
            sum += gaussians[i].rgb * tsu_blur_one(map, uv, gaussians[i].w * texels_per_mm);
        }
    }
    return sum;
}

// The same with one tap a Gaussian.
vec3 tsu_blur_coarse(sampler2D map, vec2 uv, vec2 texels_per_mm, vec4 gaussians[6])
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 6; i++) {
        vec2 sigma = gaussians[i].w * texels_per_mm;
        float lod = tsu_blur_level(map, sqrt(4.0 * sigma.x * sigma.y + 0.3333333));
        sum += gaussians[i].rgb * textureLod(map, uv, lod).rgb;
    }
    return sum;
}

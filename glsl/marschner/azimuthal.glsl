// SPDX-License-Identifier: MIT
// Azimuthal scattering of the four lobes from the baked table: two fetches, any absorption.
//
// The table of a material is one cell of 128 x 128 texels in two bands:
//   lower, 80 rows  N of R, TT, TRT and the residual at sigma_a = 0, 1/rad
//   upper, 48 rows  absorption of TT, TRT, residual as exponents of 2 (below), which is smoother
// over  x = sin(phi/2) - cos(phi/2) in [-1, 1] (nearly linear in phi, and no acos)
//       y = cos(theta_r) in [0, 1].

//   origin    texture coordinates of the cell's centre column and of the bands' first rows
//   size      half width of the cell and heights of the bands, from texel centre to texel centre
//   cos_r     cosine of the view's inclination
//   cos2_half cos^2(phi/2), in [0, 1]
void tsu_marschner_azimuthal(vec3 origin, vec3 size, float cos_r, float cos2_half, out vec4 n,
                             out vec4 path)
{
    float x = (sqrt(1.0 - cos2_half) - sqrt(cos2_half)) * size.x + origin.x;
    n = textureLod(tsu_tables, vec2(x, cos_r * size.y + origin.y), 0.0);
    path = textureLod(tsu_tables, vec2(x, cos_r * size.z + origin.z), 0.0);
}

// Exponents of 2 after absorption. path = (L, V, L_TRT, L_RES) in units of log2(e) fibre radii:
//   TT        exp(-sigma_a (L - min(V sigma_a, 1))): the spread of path lengths that blurring mixes
//   TRT, RES  exp(-sigma_a L)
vec3 tsu_marschner_absorb_tt(vec4 path, vec3 sigma_a, float exponent)
{
    return (clamp(path.y * sigma_a, 0.0, 1.0) - path.x) * sigma_a + exponent;
}

#if !defined(TSU_DROP_TRT) || !defined(TSU_DROP_RESIDUAL)
vec3 tsu_marschner_absorb(float path, vec3 sigma_a, float exponent)
{
    return exponent - path * sigma_a;
}
#endif

// SPDX-License-Identifier: MIT
// Marschner's fibre in a head of hair: its own scattering and what the other fibres add to it.
//
// Record: 0 to 5 as in marschner/eval.glsl, then
//   6  place of the table "fields": x of the strongest absorption, origin y, x of an octave of
//      absorption, extent y of a band of 32 rows
//   7  place of "spread": origin x, y; extent x of the front axis; w first row and column of "zinke",
//      row + column / 65536, or -1
// and, in place of eta and where marschner leaves room:
//   3.w  gamma, see fields.glsl
//   4.w  d_b / (3 pi/4), factor on the light that comes back;  5.z  d_f / (3 pi/4), that goes on
//   5.w  offset in y from the lobe of light that comes back to that of light that goes on

struct tsu_dual_scattering_lobes {
    vec3 single;   // direct light, scattered by this fibre alone
    vec3 multiple; // light that has met other fibres; without what comes back where that is dropped
};

// One longitudinal lobe of the table "spread": tsu_marschner_longitudinal with a plainer I0e, two
// straight lines under the root; within 1 % but for x from 0.5 to 1, where it is up to 8 % too high.
float tsu_dual_scattering_lobe(vec4 products, vec2 place)
{
    vec4 lobe = textureLod(tsu_tables, place, 0.0);
    float x = abs(lobe.x * products.x + lobe.y * products.y);
    float exponent = (lobe.z - lobe.x * products.z + lobe.y * products.w) + x;
    return exp2(exponent) * inversesqrt(max(1.4022 * x - 0.5655, 0.5824 * x + 0.3167));
}

// The two lobes of multiply scattered light: in the light's own half circle and beyond, 1/sr.
vec2 tsu_dual_scattering_near_far(int material, vec3 t, vec3 l, vec3 v, float front)
{
    vec4 place = TSU_RECORD(material, 7);
    vec4 more = TSU_RECORD(material, 5);
    // As in tsu_marschner_eval, which a compiler shares.
    float sin_i = dot(t, l);
    float sin_r = dot(t, v);
    float cos_i = sqrt(abs(1.0000005 - sin_i * sin_i));
    float cos_r = sqrt(abs(1.0000005 - sin_r * sin_r));
    vec4 products =
        vec4(cos_i * cos_r + 1e-12, cos_i * sin_r, sin_i * sin_r, sin_i * cos_r);
    float cos2_half = clamp((dot(l, v) - products.z) * (0.5 / products.x) + 0.5, 0.0, 1.0);
    float sin2_half = 1.0 - cos2_half;

    float x = exp2(-0.25 * front) * place.z + place.x;
    float near = 0.0;
#ifndef TSU_DROP_BACK
    near = (cos2_half * cos2_half) *
           (tsu_dual_scattering_lobe(products, vec2(x, place.y)) * TSU_RECORD(material, 4).w);
#endif
    float far = (sin2_half * sin2_half) *
                (tsu_dual_scattering_lobe(products, vec2(x, place.y + more.w)) * more.z);
    return vec2(near, far);
}

tsu_dual_scattering_stream tsu_dual_scattering_at(int material, vec3 t, vec3 v, vec3 sigma_a)
{
    vec4 place = TSU_RECORD(material, 6);
    float sin_r = dot(t, v);
    float cos_r = sqrt(abs(1.0000005 - sin_r * sin_r));
    return tsu_dual_scattering_read(place, tsu_dual_scattering_columns(place, sigma_a), cos_r);
}

// L_r = Int L_i value dω_i: times radiance and solid angle of the light, no further cosine and no
// transmittance.
//   material, t, l, v, sigma_a  as tsu_marschner_eval
//   front   mean number of fibres between this one and the light, >= 0
//   direct  share of the direct light that arrives, [0, 1]; fibres at random give exp(-front)
// Hair is taken as thick behind the fibre. Error: see tsuya/models/dual_scattering.h.
tsu_dual_scattering_lobes tsu_dual_scattering_eval(int material, vec3 t, vec3 l, vec3 v,
                                                   vec3 sigma_a, float front, float direct)
{
    vec2 lobes = tsu_dual_scattering_near_far(material, t, l, v, front);
    return tsu_dual_scattering_lobes(
        direct * tsu_marschner_sum(tsu_marschner_eval(material, t, l, v, sigma_a)),
        tsu_dual_scattering_thick(tsu_dual_scattering_at(material, t, v, sigma_a), front,
                                  pow(direct, TSU_RECORD(material, 3).w), lobes.x, lobes.y));
}

// The same with `behind`, the mean number of fibres on the far side of this one, away from the light:
// thin hair and tips, where light is lost to the other side.
tsu_dual_scattering_lobes tsu_dual_scattering_finite_eval(int material, vec3 t, vec3 l, vec3 v,
                                                          vec3 sigma_a, float front, float behind,
                                                          float direct)
{
    vec2 lobes = tsu_dual_scattering_near_far(material, t, l, v, front);
    return tsu_dual_scattering_lobes(
        direct * tsu_marschner_sum(tsu_marschner_eval(material, t, l, v, sigma_a)),
        tsu_dual_scattering_finite(tsu_dual_scattering_at(material, t, v, sigma_a), front, behind,
                                   pow(direct, TSU_RECORD(material, 3).w), lobes.x, lobes.y));
}

vec3 tsu_dual_scattering_sum(tsu_dual_scattering_lobes lobes)
{
    return lobes.single + lobes.multiple;
}

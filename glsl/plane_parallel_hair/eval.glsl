// SPDX-License-Identifier: MIT
// Hair lit through solved layers of hair: dual_scattering's shader over another table.
//
// Record: as in dual_scattering/eval.glsl, with the places of the table "layer":
//   6  the same over its fields, 48 rows over sin(theta_r) (0.5 - 0.2 cos(theta_r)) + 0.5: nearly
//      even in theta_r
//   7  origin x, y of the lobe of light that comes back; extent x of the front axis

struct tsu_plane_parallel_hair_lobes {
    vec3 single;   // direct light, scattered by this fibre alone
    vec3 multiple; // light that has met other fibres; without what comes back where that is dropped
};

// Fibres that diffuse light meets on its way to a surface `fibres` away: light that was sent on
// keeps its way for a while.
float tsu_plane_parallel_hair_delayed(float fibres)
{
    return (fibres - 1.8) + 1.8 * exp2(-0.25 * fibres);
}

// Texture coordinates of the absorptions of three channels in the table "layer": 16 octaves of
// sigma_a + 0.0005 up to 32.768, finer than dual_scattering's where next to nothing absorbs.
vec3 tsu_plane_parallel_hair_columns(vec4 place, vec3 sigma_a)
{
    return log2(clamp(sigma_a * (2000.0 / 65536.0) + 1.0 / 65536.0, 0.0, 1.0)) * place.z + place.x;
}

tsu_dual_scattering_stream tsu_plane_parallel_hair_at(int material, vec3 t, vec3 v, vec3 sigma_a)
{
    vec4 place = TSU_RECORD(material, 6);
    float sin_r = dot(t, v);
    float cos_r = sqrt(abs(1.0000005 - sin_r * sin_r));
    return tsu_dual_scattering_read(place, tsu_plane_parallel_hair_columns(place, sigma_a),
                                    sin_r * (0.5 - 0.2 * cos_r) + 0.5);
}

// L_r = Int L_i value dω_i: times radiance and solid angle of the light, no further cosine and no
// transmittance. Inputs as tsu_dual_scattering_eval; error: see tsuya/models/plane_parallel_hair.h.
tsu_plane_parallel_hair_lobes tsu_plane_parallel_hair_eval(int material, vec3 t, vec3 l, vec3 v,
                                                       vec3 sigma_a, float front, float direct)
{
    vec2 lobes = tsu_dual_scattering_near_far(material, t, l, v, front);
    return tsu_plane_parallel_hair_lobes(
        direct * tsu_marschner_sum(tsu_marschner_eval(material, t, l, v, sigma_a)),
        tsu_dual_scattering_thick(tsu_plane_parallel_hair_at(material, t, v, sigma_a),
                                  tsu_plane_parallel_hair_delayed(front),
                                  pow(direct, TSU_RECORD(material, 3).w), lobes.x, lobes.y));
}

// The same with `behind`, the mean number of fibres on the far side of this one, away from the light.
tsu_plane_parallel_hair_lobes tsu_plane_parallel_hair_finite_eval(int material, vec3 t, vec3 l, vec3 v,
                                                              vec3 sigma_a, float front,
                                                              float behind, float direct)
{
    vec2 lobes = tsu_dual_scattering_near_far(material, t, l, v, front);
    return tsu_plane_parallel_hair_lobes(
        direct * tsu_marschner_sum(tsu_marschner_eval(material, t, l, v, sigma_a)),
        tsu_dual_scattering_finite(tsu_plane_parallel_hair_at(material, t, v, sigma_a),
                                   tsu_plane_parallel_hair_delayed(front),
                                   tsu_plane_parallel_hair_delayed(behind),
                                   pow(direct, TSU_RECORD(material, 3).w), lobes.x, lobes.y));
}

vec3 tsu_plane_parallel_hair_sum(tsu_plane_parallel_hair_lobes lobes)
{
    return lobes.single + lobes.multiple;
}

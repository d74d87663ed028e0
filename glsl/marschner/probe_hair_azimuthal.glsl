// SPDX-License-Identifier: MIT
// Function "hair-azimuthal": eta, theta_d, sigma_a, beta_az, phi -> R, TT, TRT, RES.

void tsu_probe(int material, float x[16], out float y[8])
{
    vec3 origin = vec3(TSU_RECORD(material, 0).w, TSU_RECORD(material, 1).w,
                       TSU_RECORD(material, 2).w);
    float half_cos = cos(0.5 * x[4]);
    vec4 n, path;
    tsu_marschner_azimuthal(origin, TSU_RECORD(material, 3).xyz, cos(x[1]),
                            clamp(half_cos * half_cos, 0.0, 1.0), n, path);
    y[0] = n.x;
    y[1] = n.y * exp2(tsu_marschner_absorb_tt(path, vec3(x[2]), 0.0).x);
    y[2] = n.z * exp2(tsu_marschner_absorb(path.z, vec3(x[2]), 0.0).x);
    y[3] = n.w * exp2(tsu_marschner_absorb(path.w, vec3(x[2]), 0.0).x);
}

// SPDX-License-Identifier: MIT
// Function "leaf-coarse": preset, channel, R_top, R_bottom, T, n, mu0, mu, phi, kind, side,
// absorption, thickness -> reflected, transmitted.

void tsu_probe(int material, float x[16], out float y[8])
{
    float light = x[10] > 0.5 ? -1.0 : 1.0;
    float viewer = x[9] > 0.5 ? -light : light;
    float s_l = sqrt(1.0 - x[6] * x[6]);
    float s_v = sqrt(1.0 - x[7] * x[7]);
    vec3 l = vec3(-s_l, 0.0, light * x[6]);
    vec3 v = vec3(s_v * cos(x[8]), s_v * sin(x[8]), viewer * x[7]);
    tsu_leaf_coarse_lobes lobes =
        tsu_leaf_coarse_eval(material, vec3(0.0, 0.0, 1.0), l, v, x[11], x[12]);
    y[0] = tsu_leaf_coarse_reflected(lobes).x / x[6];
    y[1] = tsu_leaf_coarse_transmitted(lobes).x / x[6];
}

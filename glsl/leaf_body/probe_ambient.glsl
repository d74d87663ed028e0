// SPDX-License-Identifier: MIT
// Function "leaf-ambient": preset, channel, R_top, R_bottom, T, n, mu, side, absorption, thickness ->
// reflected, transmitted.

void tsu_probe(int material, float x[16], out float y[8])
{
    float viewer = x[7] > 0.5 ? -1.0 : 1.0;
    vec3 v = vec3(sqrt(1.0 - x[6] * x[6]), 0.0, viewer * x[6]);
    tsu_leaf_body_ambience light = tsu_leaf_body_ambient(material, vec3(0.0, 0.0, 1.0), v, x[8],
                                                         x[9], vec3(1.0), vec3(1.0));
    y[0] = light.reflected.x;
    y[1] = light.transmitted.x;
}

// SPDX-License-Identifier: MIT
// Function "hair": theta_i, theta_r, phi, eta, sigma_a, alpha_R, beta_R -> diffuse, specular,
// total.

void tsu_probe(int material, float x[16], out float y[8])
{
    vec3 l = vec3(cos(x[0]), 0.0, sin(x[0]));
    vec3 v = vec3(cos(x[1]) * cos(x[2]), cos(x[1]) * sin(x[2]), sin(x[1]));
    tsu_kajiya_kay_lobes lobes =
        tsu_kajiya_kay_eval(material, vec3(0.0, 0.0, 1.0), l, v, vec3(x[4]));
    y[0] = lobes.diffuse.x;
    y[1] = lobes.specular;
    y[2] = tsu_kajiya_kay_sum(lobes).x;
}

// SPDX-License-Identifier: MIT
// Functions "hair" and, with TSU_SHADER_FINE, "hair-fine": theta_i, theta_r, phi, eta, sigma_a, alpha_R,
// beta_R, beta_az, scale_shifts -> R, TT, TRT, RES, total.

void tsu_probe(int material, float x[16], out float y[8])
{
    vec3 l = vec3(cos(x[0]), 0.0, sin(x[0]));
    vec3 v = vec3(cos(x[1]) * cos(x[2]), cos(x[1]) * sin(x[2]), sin(x[1]));
    tsu_marschner_lobes lobes =
        tsu_marschner_eval(material, vec3(0.0, 0.0, 1.0), l, v, vec3(x[4]));
    y[0] = lobes.r;
    y[1] = lobes.tt.x;
    y[2] = lobes.trt.x;
    y[3] = lobes.res.x;
    y[4] = tsu_marschner_sum(lobes).x;
}

// SPDX-License-Identifier: MIT
// Function "hair-multiple-zinke": theta_i, sigma_a, tau and the fibre -> a_f, a_b averaged, R, T. R is
// what comes back of the light that reaches a fibre, T the share of light that `tau` fibres in front
// leave of it: both sums over all directions of what the snippet returns.

void tsu_probe(int material, float x[16], out float y[8])
{
    const int AZIMUTHS = 96, INCLINATIONS = 96;
    vec3 v = vec3(cos(x[0]), 0.0, sin(x[0]));
    vec3 t = vec3(0.0, 0.0, 1.0);
    vec3 sigma_a = vec3(x[1]);
    float tau = min(x[2], 1e4);
    float back = 0.0, all = 0.0, behind = 0.0;
    for (int a = 0; a < AZIMUTHS; a++) {
        float phi = 6.28318531 * (float(a) + 0.5) / float(AZIMUTHS);
        for (int i = 0; i < INCLINATIONS; i++) {
            float theta = 3.14159265 * ((float(i) + 0.5) / float(INCLINATIONS) - 0.5);
            vec3 l = vec3(cos(theta) * cos(phi), cos(theta) * sin(phi), sin(theta));
            float near = cos(theta) * tsu_dual_scattering_sum(tsu_dual_scattering_zinke_eval(
                                          material, t, l, v, sigma_a, 0.0, 0.0)).x;
            all += near;
            back += cos(phi) > 0.0 ? near : 0.0;
            behind += cos(theta) * tsu_dual_scattering_sum(tsu_dual_scattering_zinke_eval(
                                       material, t, l, v, sigma_a, tau, 0.0)).x;
        }
    }
    vec4 place =
        tsu_dual_scattering_zinke_place(TSU_RECORD(material, 6), TSU_RECORD(material, 7).w);
    vec2 at = vec2(tsu_dual_scattering_columns(place, sigma_a).x, cos(x[0]) * place.w + place.y);
    y[0] = exp2(textureLod(tsu_tables, at, 0.0).x);
    at.y += 3.0 * place.w * 1.03226139;
    y[1] = textureLod(tsu_tables, at, 0.0).w;
    y[2] = back * (6.28318531 / float(AZIMUTHS)) * (3.14159265 / float(INCLINATIONS));
    y[3] = behind / all;
}

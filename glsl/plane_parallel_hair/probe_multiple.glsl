// SPDX-License-Identifier: MIT
// Function "hair-multiple-plane_parallel": theta_i, sigma_a, tau and the fibre -> a_f,
// a_b, R, T. A slab is drawn fibre by fibre: its depth and all light directions are summed over what
// the snippet returns.

void tsu_probe(int material, float x[16], out float y[8])
{
    const int AZIMUTHS = 12, DEPTHS = 24, INCLINATIONS = 80;
    vec3 v = vec3(cos(x[0]), 0.0, sin(x[0]));
    vec3 t = vec3(0.0, 0.0, 1.0);
    vec3 sigma_a = vec3(x[1]);
    float tau = min(x[2], 1e4);
    float seen = 1.0 - exp(-tau), deepest = min(tau, 20.0);
    // The fibre's own shares: 32 rows after 48, 46.9999 of which are the extent of the fields.
    vec4 place = TSU_RECORD(material, 6);
    vec4 shares =
        textureLod(tsu_tables, vec2(tsu_plane_parallel_hair_columns(place, sigma_a).x,
                                    (cos(x[0]) * 30.9999 + 48.0) / 46.9999 * place.w + place.y),
                   0.0);
    y[0] = shares.x;
    y[1] = shares.y;

    float r = 0.0, through = 0.0;
    for (int a = 0; a < AZIMUTHS; a++) {
        float phi = 1.57079633 * (float(a) + 0.5) / float(AZIMUTHS);
        for (int d = 0; d < DEPTHS; d++) {
            // Depths that are seen alike for light from above; alike spaced for light from below,
            // whose share is much the same at any depth.
            float u = (float(d) + 0.5) / float(DEPTHS);
            float depth = -log(1.0 - seen * u), level = u * deepest;
            float above = depth / cos(phi), below = max(tau - depth, 0.0) / cos(phi);
            float over = level / cos(phi), under = max(tau - level, 0.0) / cos(phi);
            for (int i = 0; i < INCLINATIONS; i++) {
                float theta = 3.14159265 * ((float(i) + 0.5) / float(INCLINATIONS) - 0.5);
                vec3 l = vec3(cos(theta) * cos(phi), cos(theta) * sin(phi), sin(theta));
                vec3 m = vec3(-l.x, l.yz);
                r += cos(theta) * tsu_plane_parallel_hair_sum(tsu_plane_parallel_hair_finite_eval(
                                      material, t, l, v, sigma_a, above, below, exp(-above))).x;
                through += exp(-level) * cos(theta) *
                           tsu_plane_parallel_hair_sum(tsu_plane_parallel_hair_finite_eval(
                               material, t, m, v, sigma_a, under, over, exp(-under))).x;
            }
        }
    }
    float weight = 2.0 * (1.57079633 / float(AZIMUTHS)) * (3.14159265 / float(INCLINATIONS)) /
                   float(DEPTHS);
    y[2] = r * weight * seen;
    y[3] = through * weight * deepest + exp(-tau);
}

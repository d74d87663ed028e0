// SPDX-License-Identifier: MIT
// Functions "hair-multiple" and "hair-multiple-exact": theta_i, sigma_a, tau and the fibre -> a_f,
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
    vec4 place = TSU_RECORD(material, 6);
    tsu_dual_scattering_stream s =
        tsu_dual_scattering_read(place, tsu_dual_scattering_columns(place, sigma_a), cos(x[0]));
    // Less what near-white shares lose, see runtime/optics/two_stream.h.
    float kept = s.on.x + s.back.x;
    float restore =
        kept <= 0.95 ? 1.0 : (1.285 - sqrt(max(1.651225 - 1.2 * kept, 0.0))) / (0.6 * kept);
    y[0] = (0.92441318 * s.on.x + 0.07558682 * s.back.x) * restore;
    y[1] = (0.92441318 * s.back.x + 0.07558682 * s.on.x) * restore;

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
                r += cos(theta) * tsu_dual_scattering_sum(tsu_dual_scattering_finite_eval(
                                      material, t, l, v, sigma_a, above, below, exp(-above))).x;
                through += exp(-level) * cos(theta) *
                           tsu_dual_scattering_sum(tsu_dual_scattering_finite_eval(
                               material, t, m, v, sigma_a, under, over, exp(-under))).x;
            }
        }
    }
    float weight = 2.0 * (1.57079633 / float(AZIMUTHS)) * (3.14159265 / float(INCLINATIONS)) /
                   float(DEPTHS);
    y[2] = r * weight * seen;
    y[3] = through * weight * deepest + exp(-tau);
}

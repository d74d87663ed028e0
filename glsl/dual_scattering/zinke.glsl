// SPDX-License-Identifier: MIT
// Dual scattering as published, with the choices that tsuya/models/dual_scattering.h lists.
//
// Source: Zinke et al. 2008, "Dual Scattering Approximation for Fast Multiple Scattering in Hair",
// eq. 5 to 17 and figure 5. Forward scattering behind `front` fibres of one inclination; the averages
// over the incident half circle turn N into N^G, whose even orders vanish.

// d'Eon's lobe of variance v with its shift, as exponent and factor.
float tsu_dual_scattering_widened(vec4 products, float cos_shift, float sin_shift, float variance)
{
    float scale = 1.44269504 / variance;
    float c = -log2(variance * (1.0 - exp2(-2.0 * scale))) - scale - 0.81484518;
    float exponent, factor;
    tsu_marschner_longitudinal(products, cos_shift * scale, sin_shift * scale, c, exponent, factor);
    return factor * exp2(exponent);
}

// The same for a lobe of marschner's record (a, b) and an added variance.
float tsu_dual_scattering_more(vec4 products, vec4 lobe, float added)
{
    float inverse = length(lobe.xy); // log2(e) / v
    vec2 shift = lobe.xy / inverse;
    return tsu_dual_scattering_widened(products, shift.x, shift.y, 1.44269504 / inverse + added);
}

//   c  cosine coefficients 0, 1 and 3 of N
float tsu_dual_scattering_azimuth(vec3 c, float cos_phi)
{
    float cos_3phi = (4.0 * cos_phi * cos_phi - 3.0) * cos_phi;
    return max(0.15915494 * c.x + 0.20264237 * c.y * cos_phi - 0.06754746 * c.z * cos_3phi, 0.0);
}

// Place of the first band of the table "zinke", as record 6 has that of "fields": both have the same
// axes.
//   origin  record 7.w
vec4 tsu_dual_scattering_zinke_place(vec4 place, float origin)
{
    float column = place.z * (13.0 / 63.0), row = place.w / 30.9999;
    return vec4((fract(origin) * 65536.0 + 63.5) * column, (floor(origin) + 0.5) * row, place.zw);
}

// Inputs as tsu_dual_scattering_eval.
tsu_dual_scattering_lobes tsu_dual_scattering_zinke_eval(int material, vec3 t, vec3 l, vec3 v,
                                                         vec3 sigma_a, float front, float direct)
{
    float origin = TSU_RECORD(material, 7).w;
    vec4 place = tsu_dual_scattering_zinke_place(TSU_RECORD(material, 6), origin);
    float d_f = TSU_RECORD(material, 5).z * 2.35619449; // 3 pi/4, see eval.glsl
#ifndef TSU_DROP_BACK
    float d_b = TSU_RECORD(material, 4).w; // 0.75 of it is d_b / pi
#endif
    float sin_i = dot(t, l);
    float sin_r = dot(t, v);
    float cos_i = sqrt(abs(1.0000005 - sin_i * sin_i));
    float cos_r = sqrt(abs(1.0000005 - sin_r * sin_r));
    vec4 products =
        vec4(cos_i * cos_r + 1e-12, cos_i * sin_r, sin_i * sin_r, sin_i * cos_r);
    float cos_phi = clamp((dot(l, v) - products.z) / products.x, -1.0, 1.0);

    vec3 columns = tsu_dual_scattering_columns(place, sigma_a);
    float y = cos_r * place.w + place.y;
    float band = place.w * 1.03226139; // 32 rows of a band over the 30.9999 of its extent
    tsu_dual_scattering_lobes lobes;
    lobes.single = direct * tsu_marschner_sum(tsu_marschner_eval(material, t, l, v, sigma_a));
    for (int k = 0; k < 3; k++) {
        vec4 whole = textureLod(tsu_tables, vec2(columns[k], y), 0.0);
        vec4 tt = textureLod(tsu_tables, vec2(columns[k], y + band), 0.0);
        vec4 trt = textureLod(tsu_tables, vec2(columns[k], y + 2.0 * band), 0.0);
        vec4 m = textureLod(tsu_tables, vec2(columns[k], y + 3.0 * band), 0.0);
        float through = (1.0 - direct) * d_f * exp2(min(front * whole.x, 0.0));
        float added = front * m.z;
        lobes.multiple[k] =
            through *
            (tsu_dual_scattering_azimuth(vec3(whole.zw, tt.w), cos_phi) *
                 tsu_dual_scattering_more(products, TSU_RECORD(material, 0), added) +
             tsu_dual_scattering_azimuth(tt.xyz, cos_phi) *
                 tsu_dual_scattering_more(products, TSU_RECORD(material, 1), added) +
             tsu_dual_scattering_azimuth(trt.xyz, cos_phi) *
                 tsu_dual_scattering_more(products, TSU_RECORD(material, 2), added));
#ifndef TSU_DROP_BACK
        float cos_shift = cos(m.x), sin_shift = sin(m.x);
        float near = tsu_dual_scattering_widened(products, cos_shift, sin_shift, m.y);
        float far = tsu_dual_scattering_widened(products, cos_shift, sin_shift, m.y + added);
        lobes.multiple[k] +=
            cos_phi > 0.0 ? 0.75 * d_b * whole.y * (direct * near + through * far) : 0.0;
#endif
    }
    // Without the table all that was read belongs to another.
    lobes.multiple = origin >= 0.0 ? lobes.multiple : vec3(0.0);
    return lobes;
}

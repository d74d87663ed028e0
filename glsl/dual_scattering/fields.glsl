// SPDX-License-Identifier: MIT
// Multiply scattered light in closed form: how much comes back, how much goes on.
//
// Source and meaning of k, r and the shares: runtime/optics/two_stream.h.

// Texture coordinates of the absorptions of three channels in the table "fields": 13 octaves of
// sigma_a + 0.004 up to 32.768.
//   place  record 6
vec3 tsu_dual_scattering_columns(vec4 place, vec3 sigma_a)
{
    return log2(clamp(sigma_a * (250.0 / 8192.0) + 1.0 / 8192.0, 0.0, 1.0)) * place.z + place.x;
}

// k, r, and the shares that the first event sends back and on; one channel each in x, y, z.
struct tsu_dual_scattering_stream {
    vec3 k, r, back, on;
};

tsu_dual_scattering_stream tsu_dual_scattering_read(vec4 place, vec3 columns, float cos_r)
{
    float y = cos_r * place.w + place.y;
    vec4 a = textureLod(tsu_tables, vec2(columns.x, y), 0.0);
    vec4 b = textureLod(tsu_tables, vec2(columns.y, y), 0.0);
    vec4 c = textureLod(tsu_tables, vec2(columns.z, y), 0.0);
    return tsu_dual_scattering_stream(vec3(a.x, b.x, c.x), vec3(a.y, b.y, c.y),
                                      vec3(a.z, b.z, c.z), vec3(a.w, b.w, c.w));
}

// Light that leaves after more than one event towards a lobe `near` (the light's own side) and a
// lobe `far` (beyond): the sum of both, per channel; `near` is nothing where it is dropped. Hair is
// thick behind the fibre.
//   single  direct^gamma: the first event's light that leaves at once, counted elsewhere
vec3 tsu_dual_scattering_thick(tsu_dual_scattering_stream s, float front, float single, float near,
                               float far)
{
    vec3 x = exp2(-front * s.k);
#ifdef TSU_DROP_BACK
    vec3 first = s.on * far;    // as the first event sends it
    vec3 turned = s.back * far; // after a half space has reflected it once more
#else
    vec3 first = s.back * near + s.on * far;  // as the first event sends it
    vec3 turned = s.on * near + s.back * far; // after a half space has reflected it once more
#endif
    return max(x * (s.r * turned + first) - single * first, 0.0);
}

// The same with `behind` fibres on the far side of the fibre.
vec3 tsu_dual_scattering_finite(tsu_dual_scattering_stream s, float front, float behind,
                                float single, float near, float far)
{
    vec3 x = exp2(-front * s.k);
    vec3 zr = exp2(-2.0 * behind * s.k) * s.r;
    vec3 scale = x / (1.0 - (x * s.r) * (x * zr));
#ifdef TSU_DROP_BACK
    vec3 p = s.on * s.r + s.back;
    vec3 q = s.back * s.r + s.on;
    return max(((q - p * zr) * scale - single * s.on) * far, 0.0);
#else
    vec3 first = s.back * near + s.on * far;
    vec3 turned = s.on * near + s.back * far;
    return max((s.r * turned + first - zr * (s.r * first + turned)) * scale - single * first, 0.0);
#endif
}

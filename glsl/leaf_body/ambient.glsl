// SPDX-License-Identifier: MIT
// A leaf in light that is uniform on each side: the form's integral over all directions of light.
//
// Record: 4 to 7 integrals over a side: H1, HU, HUU, H(c - 1), then in powers of the view's U of P
// (same side, other side) and P U (same side, other side), three each.

struct tsu_leaf_body_ambience {
    vec3 reflected, transmitted; // radiance
};

// One channel: integrals of the form's terms, in the order of the texels.
float tsu_leaf_body_integral(vec4 a, vec4 b, vec3 first, vec4 second, float one)
{
    return exp2(a.x) * (one + dot(a.yzw, first) + dot(b, second));
}

float tsu_leaf_body_walls(int material, float c, float a)
{
    vec4 fit = TSU_RECORD(material, 2);
    return (a + c * (fit.x + fit.y * c)) / (1.0 + c * (fit.z + fit.w * c));
}

tsu_leaf_body_ambience tsu_leaf_body_integrals(int material, vec3 n, vec3 v, float pigment,
                                               float thickness, float walls, vec3 same, vec3 other)
{
    vec4 table = TSU_RECORD(material, 0);
    vec4 leaf = TSU_RECORD(material, 1);
    vec4 h0 = TSU_RECORD(material, 4);
    vec4 h1 = TSU_RECORD(material, 5);
    vec4 h2 = TSU_RECORD(material, 6);
    vec4 h3 = TSU_RECORD(material, 7);
    float n_v = dot(n, v);
    bool above = n_v > 0.0;
    float c = abs(n_v);
    float x = 1.0 - sqrt(c * c * leaf.z + leaf.w);

    // Same side, other side.
    vec2 p = vec2(h1.x, h1.w) + x * (vec2(h1.y, h2.x) + x * vec2(h1.z, h2.y));
    vec2 pu = vec2(h2.z, h3.y) + x * (vec2(h2.w, h3.z) + x * vec2(h3.x, h3.w));
    float s = h0.y + x * h0.x;
    float uu = h0.z + x * x * h0.x;
    vec3 first_same = vec3(s, x * h0.y, h0.w + (c - 1.0) * h0.x);
    vec4 second_same = vec4(uu, 0.0, p.x - h0.x, pu.x + x * p.x);
#ifndef TSU_DROP_TRANSMITTED
    float d = above ? h0.y - x * h0.x : x * h0.x - h0.y;
    float pd = above ? pu.y - x * p.y : x * p.y - pu.y;
    vec3 first_other = vec3(s, d, pd);
    vec4 second_other = vec4(uu, 0.0, p.y - h0.x, pu.y + x * p.y);
#endif

    vec2 place = tsu_leaf_body_place(material, pigment, thickness);
    float y_same = place.y + (above ? 7.0 : 0.0) * table.w;
    float second = place.x + table.y * (16.0 / 15.0);
    tsu_leaf_body_ambience result;
    result.transmitted = vec3(0.0);
#ifndef TSU_DROP_TRANSMITTED
    float y_other = place.y + 3.5 * table.w;
#endif
    for (int i = 0; i < 3; i++) {
        result.reflected[i] = tsu_leaf_body_integral(
            textureLod(tsu_tables, vec2(place.x, y_same), 0.0),
            textureLod(tsu_tables, vec2(second, y_same), 0.0), first_same, second_same, h0.x);
        y_same += table.w * (7.0 / 6.0);
#ifndef TSU_DROP_TRANSMITTED
        result.transmitted[i] = tsu_leaf_body_integral(
            textureLod(tsu_tables, vec2(place.x, y_other), 0.0),
            textureLod(tsu_tables, vec2(second, y_other), 0.0), first_other, second_other, h0.x);
        y_other += table.w * (7.0 / 6.0);
#endif
    }
    result.reflected = max(walls * result.reflected, 0.0) * same;
    result.transmitted = max(walls * result.transmitted, 0.0) * other;
    return result;
}

// Radiance towards the viewer.
//   same, other  radiance on the viewer's side and on the other one, linear RGB; for light that is
//                not uniform, irradiance / pi
tsu_leaf_body_ambience tsu_leaf_body_ambient(int material, vec3 n, vec3 v, float pigment,
                                             float thickness, vec3 same, vec3 other)
{
    float walls = tsu_leaf_body_walls(material, abs(dot(n, v)), 0.0);
    return tsu_leaf_body_integrals(material, n, v, pigment, thickness, walls, same, other);
}

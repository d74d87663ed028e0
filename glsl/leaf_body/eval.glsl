// SPDX-License-Identifier: MIT
// A leaf's body: light that scattered inside. The form and its terms are in the header
// tsuya/models/leaf_body.h, with the errors.
//
// Record of a material:
//   0  table: x of the first pigment, extent of all, y of the first thickness, extent of all
//   1  pigment/2, thickness/2, 1/n^2, 1 - 1/n^2
//   2  1 - r = (a + c (x + y c))/(1 + c (z + w c)), c the cosine outside; a is 0 without a coat
//   3  of the coat, see glsl/leaf/eval.glsl
//   4 to 7  integrals over uniform light, see ambient.glsl
// Table: texels A = (log2 F0, a, b, c), 16 columns further B = (d, e, h, j); rows are sets (both
// below, one above one below, both above), channels, thicknesses.

struct tsu_leaf_body_lobes {
    vec3 body;    // what is sent towards the viewer
    bool through; // it came through the leaf: light and viewer are on two sides
};

// Two directions of a leaf: what the form and the table need of them.
struct tsu_leaf_body_frame {
    vec3 first;  // S, Q, X
    vec4 second; // U^2 + V^2, Z, P - 1, P S
    float walls; // (1 - r_l)(1 - r_v), times cosine of the light
    bool through;
    float set; // row of the table, in extents of all thicknesses
};

// `above`: light, viewer on the top's side. a: of the walls.
tsu_leaf_body_frame tsu_leaf_body_directions(int material, float n_l, float n_v, float l_v,
                                             bool light_above, bool viewer_above, float a)
{
    vec4 leaf = TSU_RECORD(material, 1);
    vec4 fit = TSU_RECORD(material, 2);
    float c_l = abs(n_l);
    float c_v = abs(n_v);
    bool same = light_above == viewer_above;

    tsu_leaf_body_frame frame;
    frame.through = !same;
#ifdef TSU_DROP_TRANSMITTED
    frame.set = light_above ? 7.0 : 0.0;
    float cosine = same ? c_l : 0.0;
#else
    frame.set = same ? (light_above ? 7.0 : 0.0) : 3.5;
    float cosine = c_l;
#endif
    frame.walls = cosine *
                  ((a + c_l * (fit.x + fit.y * c_l)) * (a + c_v * (fit.x + fit.y * c_v))) /
                  ((1.0 + c_l * (fit.z + fit.w * c_l)) * (1.0 + c_v * (fit.z + fit.w * c_v)));

    float t_l = sqrt(c_l * c_l * leaf.z + leaf.w);
    float t_v = sqrt(c_v * c_v * leaf.z + leaf.w);
    float z = (n_l * n_v - l_v) * leaf.z;
    float t_lv = t_l * t_v;
#ifdef TSU_DROP_TRANSMITTED
    float root = inversesqrt(1.25 + t_lv - z);
#else
    float root = inversesqrt(1.25 - ((same ? -t_lv : t_lv) + z));
#endif
    float p = root * root * root - 1.0;
    float u_l = 1.0 - t_l;
    float u_v = 1.0 - t_v;
    float s = u_l + u_v;
#ifdef TSU_DROP_TRANSMITTED
    frame.first = vec3(s, u_l * u_v, c_l + c_v - 2.0);
#else
    float d = viewer_above ? t_v - t_l : t_l - t_v;
    frame.first = vec3(s, same ? u_l * u_v : d, same ? c_l + c_v - 2.0 : p * d + d);
#endif
    frame.second = vec4(u_l * u_l + u_v * u_v, z, p, p * s + s);
    return frame;
}

// Where pigment and thickness lie in the table; the row of the first set.
vec2 tsu_leaf_body_place(int material, float pigment, float thickness)
{
    vec4 place = TSU_RECORD(material, 0);
    vec4 leaf = TSU_RECORD(material, 1);
    float t = thickness * leaf.y;
    vec2 where = vec2(sqrt(pigment * leaf.x), min(2.0 * t - 0.5, t));
    return clamp(where, 0.0, 1.0) * place.yw + place.xz;
}

// Three channels of the form.
vec3 tsu_leaf_body_form(int material, tsu_leaf_body_frame frame, vec2 place)
{
    vec4 table = TSU_RECORD(material, 0);
    float second = place.x + table.y * (16.0 / 15.0);
    float y = place.y + frame.set * table.w;
    vec3 f;
    for (int i = 0; i < 3; i++) {
        vec4 a = textureLod(tsu_tables, vec2(place.x, y), 0.0);
        vec4 b = textureLod(tsu_tables, vec2(second, y), 0.0);
        // At most 1: nothing a leaf does comes near, and a compiler clamps for nothing.
        f[i] = clamp(exp2(a.x) * (1.0 + dot(a.yzw, frame.first) + dot(b, frame.second)), 0.0, 1.0);
        y += table.w * (7.0 / 6.0);
    }
    return f * frame.walls;
}

// BRDF or BTDF times the cosine of the light, 1/sr. Multiply by radiance and solid angle.
//   material   index in the bound page
//   n          unit normal of the leaf's top, whichever side is seen
//   l, v       unit, towards light and viewer, same space as n
//   pigment    factor on absorption, [0, 2] with the material's own
//   thickness  factor on all depths, [0.5, 2] with the material's own
tsu_leaf_body_lobes tsu_leaf_body_eval(int material, vec3 n, vec3 l, vec3 v, float pigment,
                                       float thickness)
{
    float n_l = dot(n, l);
    float n_v = dot(n, v);
    tsu_leaf_body_frame frame =
        tsu_leaf_body_directions(material, n_l, n_v, dot(l, v), n_l > 0.0, n_v > 0.0, 0.0);
    return tsu_leaf_body_lobes(
        tsu_leaf_body_form(material, frame, tsu_leaf_body_place(material, pigment, thickness)),
        frame.through);
}

// The same with a normal that is bent away from the surface's: by a normal map, or towards that of
// a crown. `face` is the geometric normal of the leaf's top, which tells on what side light and
// viewer are; light that n has on the other side than face gives none.
tsu_leaf_body_lobes tsu_leaf_body_bent_eval(int material, vec3 n, vec3 l, vec3 v, float pigment,
                                            float thickness, vec3 face)
{
    bool light_above = dot(face, l) > 0.0;
    bool viewer_above = dot(face, v) > 0.0;
    float n_l = light_above ? max(dot(n, l), 0.0) : min(dot(n, l), 0.0);
    float n_v = viewer_above ? max(dot(n, v), 0.01) : min(dot(n, v), -0.01);
    tsu_leaf_body_frame frame =
        tsu_leaf_body_directions(material, n_l, n_v, dot(l, v), light_above, viewer_above, 0.0);
    return tsu_leaf_body_lobes(
        tsu_leaf_body_form(material, frame, tsu_leaf_body_place(material, pigment, thickness)),
        frame.through);
}

vec3 tsu_leaf_body_sum(tsu_leaf_body_lobes lobes)
{
    return lobes.body;
}

vec3 tsu_leaf_body_reflected(tsu_leaf_body_lobes lobes)
{
    return lobes.through ? vec3(0.0) : lobes.body;
}

vec3 tsu_leaf_body_transmitted(tsu_leaf_body_lobes lobes)
{
    return lobes.through ? lobes.body : vec3(0.0);
}

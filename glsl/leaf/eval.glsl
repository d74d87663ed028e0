// SPDX-License-Identifier: MIT
// A leaf: the body of glsl/leaf_body/eval.glsl under a rough cuticle.
//
// Record: as of leaf_body, its factor 1 - r being what the coat leaves, and
//   3  alpha^2, root of the share that the coat lets in over a smooth wall's, n^2 - 1, a of the
//      walls

struct tsu_leaf_lobes {
    vec3 body;      // scattered inside
    float specular; // from the surface, no colour
    bool through;   // light and viewer are on two sides
};

// GGX facets under Fresnel's reflectance, times the cosine of the light; for one side.
// Source: Walter et al. 2007, eqs. 20 and 33; Heitz 2014, eq. 99.
float tsu_leaf_coat(int material, float n_l, float n_v, float l_v)
{
    vec4 coat = TSU_RECORD(material, 3);
    float a = abs(n_l);
    float b = abs(n_v);
    float over_h = inversesqrt(max(2.0 + 2.0 * l_v, 1e-6));
    float n_h = (a + b) * over_h;
    float c = (1.0 + l_v) * over_h;
    // Fresnel over (A/B)^2/2.
    float g = sqrt(c * c + coat.z);
    float A = g - c;
    float B = g + c;
    float p = c * B - 1.0;
    float q = c * A + 1.0;
    float root = n_h * n_h * (coat.x - 1.0) + 1.0;
    float masking = a * sqrt(b * b - b * b * coat.x + coat.x) +
                    b * sqrt(a * a - a * a * coat.x + coat.x);
    float below = root * B * q;
    return 0.0795774715 * coat.x * a * (A * A) * (p * p + q * q) /
           (max(masking, 1e-6) * below * below);
}

// BRDF or BTDF times the cosine of the light, 1/sr: arguments as of tsu_leaf_body_eval.
tsu_leaf_lobes tsu_leaf_eval(int material, vec3 n, vec3 l, vec3 v, float pigment, float thickness)
{
    float n_l = dot(n, l);
    float n_v = dot(n, v);
    float l_v = dot(l, v);
    tsu_leaf_body_frame frame =
        tsu_leaf_body_directions(material, n_l, n_v, l_v, n_l > 0.0, n_v > 0.0,
                                 TSU_RECORD(material, 3).w);
    return tsu_leaf_lobes(
        tsu_leaf_body_form(material, frame, tsu_leaf_body_place(material, pigment, thickness)),
        frame.through ? 0.0 : tsu_leaf_coat(material, n_l, n_v, l_v), frame.through);
}

// The same with a bent normal, see tsu_leaf_body_bent_eval.
tsu_leaf_lobes tsu_leaf_bent_eval(int material, vec3 n, vec3 l, vec3 v, float pigment,
                                  float thickness, vec3 face)
{
    bool light_above = dot(face, l) > 0.0;
    bool viewer_above = dot(face, v) > 0.0;
    float n_l = light_above ? max(dot(n, l), 0.0) : min(dot(n, l), 0.0);
    float n_v = viewer_above ? max(dot(n, v), 0.01) : min(dot(n, v), -0.01);
    float l_v = dot(l, v);
    tsu_leaf_body_frame frame =
        tsu_leaf_body_directions(material, n_l, n_v, l_v, light_above, viewer_above,
                                 TSU_RECORD(material, 3).w);
    return tsu_leaf_lobes(
        tsu_leaf_body_form(material, frame, tsu_leaf_body_place(material, pigment, thickness)),
        frame.through ? 0.0 : tsu_leaf_coat(material, n_l, n_v, l_v), frame.through);
}

// A leaf of one pigment and one thickness, see glsl/leaf_body/uniform.glsl.
tsu_leaf_lobes tsu_leaf_uniform(int material, vec3 n, vec3 l, vec3 v, mat3x4 a, mat3x4 b)
{
    float n_l = dot(n, l);
    float n_v = dot(n, v);
    float l_v = dot(l, v);
    tsu_leaf_body_frame frame =
        tsu_leaf_body_directions(material, n_l, n_v, l_v, n_l > 0.0, n_v > 0.0,
                                 TSU_RECORD(material, 3).w);
    return tsu_leaf_lobes(tsu_leaf_body_numbers(frame, a, b),
                          frame.through ? 0.0 : tsu_leaf_coat(material, n_l, n_v, l_v),
                          frame.through);
}

vec3 tsu_leaf_sum(tsu_leaf_lobes lobes)
{
    return lobes.body + lobes.specular;
}

vec3 tsu_leaf_reflected(tsu_leaf_lobes lobes)
{
    return lobes.through ? vec3(0.0) : lobes.body;
}

vec3 tsu_leaf_transmitted(tsu_leaf_lobes lobes)
{
    return lobes.through ? lobes.body : vec3(0.0);
}

struct tsu_leaf_ambience {
    vec3 specular, reflected, transmitted; // radiance
};

// In light that is uniform on each side, see tsu_leaf_body_ambient.
tsu_leaf_ambience tsu_leaf_ambient(int material, vec3 n, vec3 v, float pigment, float thickness,
                                   vec3 same, vec3 other)
{
    vec4 coat = TSU_RECORD(material, 3);
    float walls = tsu_leaf_body_walls(material, abs(dot(n, v)), coat.w);
    tsu_leaf_body_ambience body =
        tsu_leaf_body_integrals(material, n, v, pigment, thickness, walls, same, other);
    float albedo = clamp(1.0 - walls * coat.y, 0.0, 1.0);
    return tsu_leaf_ambience(albedo * same, body.reflected, body.transmitted);
}

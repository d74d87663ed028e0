// A leaf's radiance: the one place where a model of the library is called for surfaces.
//
// LEAF_EVAL and LEAF_SUM are the model's entry and its sum of lobes. BENT: the entry takes the
// geometric normal as well; without it the shading normal tells the sides. EVEN: LEAF_AMBIENT is the
// model's own answer to light that is even on each side, an LEAF_AMBIENCE, with a gloss of its own
// when GLOSS is defined; without it the model is summed over twelve directions. The material is the
// only one of its page.

// Light from l: BRDF or BTDF times the cosine.
//   n, face  shading normal and geometric normal of the leaf's upper side, whichever is seen
vec3 leaf_light(vec3 n, vec3 face, vec3 l, vec3 v, float pigment, float thickness)
{
#ifdef BENT
    return LEAF_SUM(LEAF_EVAL(0, n, l, v, pigment, thickness, face));
#else
    return LEAF_SUM(LEAF_EVAL(0, n, l, v, pigment, thickness));
#endif
}

#ifndef EVEN
// Light of radiance 1 from all over one side: two rings of three directions of equal weight.
vec3 leaf_side(vec3 n, vec3 side, vec3 v, float pigment, float thickness)
{
    vec3 x = normalize(cross(side, abs(side.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 y = cross(side, x);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 6; i++) {
        float c = i < 3 ? 0.8660254 : 0.5;
        float angle = 1.0471976 * float(i < 3 ? 2 * i : 2 * i + 1);
        vec3 l = side * c + sqrt(1.0 - c * c) * (x * cos(angle) + y * sin(angle));
        sum += leaf_light(n, n, l, v, pigment, thickness) * (3.14159265 / 6.0 / c);
    }
    return sum;
}
#endif

// The sky: mean radiance on the viewer's side and on the other. n is on the viewer's side.
//   above  the viewer sees the upper side
vec3 leaf_sky_light(vec3 n, bool above, vec3 v, float pigment, float thickness, vec3 same,
                    vec3 other)
{
    vec3 top = above ? n : -n;
#ifdef EVEN
    LEAF_AMBIENCE ambience = LEAF_AMBIENT(0, top, v, pigment, thickness, same, other);
    vec3 sum = ambience.reflected + ambience.transmitted;
#ifdef GLOSS
    sum += ambience.specular;
#endif
    return sum;
#else
    return same * leaf_side(top, n, v, pigment, thickness) +
           other * leaf_side(top, -n, v, pigment, thickness);
#endif
}

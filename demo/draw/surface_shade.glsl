// A leaf's radiance: the one place where a model of the library is called for surfaces.
//
// LEAF_EVAL, LEAF_SUM, LEAF_AMBIENCE, LEAF_AMBIENT are the model's entry, its sum of lobes and its
// answer to light that is even on each side; GLOSS is defined when that has a gloss of its own. The
// material is the only one of its page.

// Light from l: BRDF or BTDF times the cosine.
//   n, face  shading normal and geometric normal of the leaf's upper side, whichever is seen
vec3 leaf_light(vec3 n, vec3 face, vec3 l, vec3 v, float pigment, float thickness)
{
    return LEAF_SUM(LEAF_EVAL(0, n, l, v, pigment, thickness, face));
}

// Light that passes, of light that is even on the other side.
vec3 leaf_passes(vec3 n, vec3 v, float pigment, float thickness)
{
    LEAF_AMBIENCE ambience = LEAF_AMBIENT(0, n, v, pigment, thickness, vec3(0.0), vec3(1.0));
    return ambience.transmitted;
}

// The sky: mean radiance on the viewer's side and on the other.
vec3 leaf_sky_light(vec3 n, vec3 v, float pigment, float thickness, vec3 same, vec3 other)
{
    LEAF_AMBIENCE ambience = LEAF_AMBIENT(0, n, v, pigment, thickness, same, other);
    vec3 sum = ambience.reflected + ambience.transmitted;
#ifdef GLOSS
    sum += ambience.specular;
#endif
    return sum;
}

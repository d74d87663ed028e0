// SPDX-License-Identifier: MIT
// A leaf of one pigment and one thickness: no fetch. Its numbers come from tsu_leaf_body_uniform()
// in two matrices for each of three sets, six `mat3x4` in an array of the host's own:
//
//   int set = tsu_leaf_body_set(n, l, v);
//   tsu_leaf_body_uniform(material, n, l, v, numbers[2 * set], numbers[2 * set + 1]);

// 0: light and viewer below, 1: on two sides, 2: above.
int tsu_leaf_body_set(vec3 n, vec3 l, vec3 v)
{
    bool above = dot(n, l) > 0.0;
    return above == (dot(n, v) > 0.0) ? (above ? 2 : 0) : 1;
}

vec3 tsu_leaf_body_numbers(tsu_leaf_body_frame frame, mat3x4 a, mat3x4 b)
{
    vec3 f;
    for (int i = 0; i < 3; i++)
        f[i] = clamp(a[i].x + dot(a[i].yzw, frame.first) + dot(b[i], frame.second), 0.0, 1.0);
    return f * frame.walls;
}

// As tsu_leaf_body_eval, with columns of a and b for red, green and blue.
tsu_leaf_body_lobes tsu_leaf_body_uniform(int material, vec3 n, vec3 l, vec3 v, mat3x4 a, mat3x4 b)
{
    float n_l = dot(n, l);
    float n_v = dot(n, v);
    tsu_leaf_body_frame frame =
        tsu_leaf_body_directions(material, n_l, n_v, dot(l, v), n_l > 0.0, n_v > 0.0, 0.0);
    return tsu_leaf_body_lobes(tsu_leaf_body_numbers(frame, a, b), frame.through);
}

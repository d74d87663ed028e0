// SPDX-License-Identifier: MIT
// A leaf's body by four numbers of eight: three fetches. Record and arguments as of leaf_body.
//
// Table: texel A = (log2 F0, a, b, h) of F0 (1 + a S + b Q + h (P - 1)).

struct tsu_leaf_coarse_lobes {
    vec3 body;    // what is sent towards the viewer
    bool through; // it came through the leaf
};

tsu_leaf_coarse_lobes tsu_leaf_coarse_eval(int material, vec3 n, vec3 l, vec3 v, float pigment,
                                           float thickness)
{
    vec4 table = TSU_RECORD(material, 0);
    float n_l = dot(n, l);
    float n_v = dot(n, v);
    tsu_leaf_body_frame frame =
        tsu_leaf_body_directions(material, n_l, n_v, dot(l, v), n_l > 0.0, n_v > 0.0, 0.0);
    vec2 place = tsu_leaf_body_place(material, pigment, thickness);
    place.y += frame.set * table.w;
    vec3 terms = vec3(frame.first.xy, frame.second.z);
    vec3 f;
    for (int i = 0; i < 3; i++) {
        vec4 a = textureLod(tsu_tables, place, 0.0);
        f[i] = clamp(exp2(a.x) * (1.0 + dot(a.yzw, terms)), 0.0, 1.0);
        place.y += table.w * (7.0 / 6.0);
    }
    return tsu_leaf_coarse_lobes(f * frame.walls, frame.through);
}

vec3 tsu_leaf_coarse_sum(tsu_leaf_coarse_lobes lobes)
{
    return lobes.body;
}

vec3 tsu_leaf_coarse_reflected(tsu_leaf_coarse_lobes lobes)
{
    return lobes.through ? vec3(0.0) : lobes.body;
}

vec3 tsu_leaf_coarse_transmitted(tsu_leaf_coarse_lobes lobes)
{
    return lobes.through ? lobes.body : vec3(0.0);
}

// SPDX-License-Identifier: MIT
// Light from all around: spherical harmonics of order 2, as a few directions of each fibre's own.
//
// Record of an environment, made by tsu_environment_make() (tsuya/light.h), linear RGB each, with
// the direction d = (x, y, z) of the record's space:
//   radiance(d) = r0 + r1 x + r2 y + r3 z + r4 xy + r5 yz + r6 zx + r7 (x^2 - y^2) + r8 (3 z^2 - 1)
//   r0.w  evaluations
//
//     int count = tsu_environment_count(environment);
//     for (int i = 0; i < count; i++) {
//         vec3 l;
//         vec3 weight = tsu_environment_sample(environment, fiber, t, v, i, l);
//         color += weight * tsu_M_sum(tsu_M_eval(material, t, l, v, sigma_a, ...));
//     }
// A fibre looks the same from both sides of the plane through its axis and the viewer: each
// evaluation takes the light of a direction and of its mirror image. The dominant light that
// tsu_environment_make() takes out of the surroundings is one more light of light.glsl.

// Radiance from direction d, unit; never negative.
vec3 tsu_environment_radiance(vec4 record[9], vec3 d)
{
    vec3 sum = record[0].rgb + record[1].rgb * d.x + record[2].rgb * d.y + record[3].rgb * d.z +
               record[4].rgb * (d.x * d.y) + record[5].rgb * (d.y * d.z) +
               record[6].rgb * (d.z * d.x) + record[7].rgb * (d.x * d.x - d.y * d.y) +
               record[8].rgb * (3.0 * d.z * d.z - 1.0);
    return max(sum, vec3(0.0));
}

int tsu_environment_count(vec4 record[9])
{
    return int(record[0].w + 0.5);
}

// Direction i, unit, and the radiance times solid angle that one evaluation of the model there
// stands for.
//   fiber   tsu_light_lobes() or tsu_light_cone() of the material
//   t, v    unit: tangent from root to tip, towards the viewer
// Even directions lie on one side of the fibre, odd ones on the other: so that shadow looked up in
// them is of both.
vec3 tsu_environment_sample(vec4 record[9], tsu_light_fiber fiber, vec3 t, vec3 v, int i,
                            out vec3 l)
{
    int count = tsu_environment_count(record);
    vec3 u = tsu_light_across(t, v);
    vec3 w = cross(t, u) * ((i & 1) == 0 ? 1.0 : -1.0);
    // From straight behind the fibre to the viewer's side.
    float azimuth = 3.14159265 * (float(i) + 0.5) / float(count);
    vec2 lobe = tsu_light_lobe(fiber, tsu_light_mirror(t, v), azimuth);
    vec2 ends = atan((vec2(-1.57079633, 1.57079633) - lobe.x) / lobe.y);
    // A lattice again, turned the other way: measured better on the whole sphere.
    float x = tan(mix(ends.x, ends.y, fract(0.5 + float(i) * 0.38196601)));
    float theta = lobe.x + lobe.y * x;
    float angle = 3.14159265 / float(count) * (ends.y - ends.x) * lobe.y * (1.0 + x * x) *
                  max(cos(theta), 0.0);
    vec3 level = t * sin(theta) - u * (cos(azimuth) * cos(theta));
    vec3 side = w * (sin(azimuth) * cos(theta));
    l = level + side;
    vec3 sum = tsu_environment_radiance(record, l) + tsu_environment_radiance(record, level - side);
    return angle < 12.6 ? sum * angle : vec3(0.0);
}

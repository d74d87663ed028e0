// SPDX-License-Identifier: MIT
// Lights as a few directions with radiance and solid angle: directional, point, rectangle, disk.
//
// Record of a light, made by tsu_light_pack() (tsuya/light.h):
//   0  place (directional: unit vector towards the light); kind: 0 directional, 1 point,
//      2 rectangle, 3 disk, 4 directional with a disk
//   1  half axis x; evaluations
//   2  half axis y; 1: shines to both sides
//   3  irradiance, intensity or radiance (linear RGB); least distance of a point light
//
// For each light:
//     tsu_light light = tsu_light_begin(record, fiber, position, t, v);
//     for (int i = 0; i < light.count; i++) {
//         vec3 l;
//         vec3 weight = tsu_light_sample(light, i, l);
//         if (dot(weight, vec3(1.0)) > 0.0)
//             color += weight * tsu_M_sum(tsu_M_eval(material, t, l, v, sigma_a, ...));
//     }
// Directions lie on meridians of the fibre: half circles from tip to root. A meridian cuts a
// rectangle or a disk in one arc, found in closed form; eight of them tell how the light's share of
// the density in fiber.glsl is spread over the azimuth. Each direction stands for an equal share.
// Errors and what shadow to use: tsuya/light.h.

struct tsu_light {
    int count;   // directions, 0: no light arrives
    vec3 middle; // unit, towards the centre: where one look at the shadow serves all directions
    vec3 color;  // count 1: radiance times solid angle, else radiance

    // What tsu_light_sample() needs. Lengths are relative to the distance.
    bool disk;
    vec3 centre, x, y;      // from the point
    vec3 t, u, w;           // frame of the fibre, u towards the light's centre
    float mirror, back;     // inclination of the mirror cone, azimuth straight behind the fibre
    vec2 range;             // stretched azimuths from `back`
    tsu_light_fiber fiber;
    float share[9];         // of the density up to each eighth of the range
};

// Ends of a meridian's arc inside the light, as inclinations; x >= y: none. m is its unit vector at
// inclination 0.
vec2 tsu_light_arc(tsu_light light, vec3 m)
{
    vec3 n = cross(light.x, light.y);
    float height = dot(light.centre, n);
    float along = dot(light.t, n), level = dot(m, n);
    float low = -1e5, high = 1e5; // tangents of the inclination
    if (light.disk) {
        // |direction height - centre (direction . n)| <= radius |direction . n|, quadratic in tan
        float size = dot(light.x, light.x);
        vec3 p = light.t * height - light.centre * along;
        vec3 q = m * height - light.centre * level;
        float a = dot(p, p) - size * along * along;
        float b = dot(p, q) - size * along * level;
        float root = b * b - a * (dot(q, q) - size * level * level);
        if (!(root > 0.0)) {
            return vec2(0.0);
        }
        root = sqrt(root);
        if (a > 0.0) {
            low = (-b - root) / a;
            high = (root - b) / a;
            // The cone's other half lies on the far side of the point.
            if ((level * a - along * b) * height < 0.0) {
                return vec2(0.0);
            }
        } else {
            // A pole is inside: from the arc's end to it.
            a = min(a, -1e-12);
            float one = (-b - root) / a, two = (root - b) / a;
            low = along * height > 0.0 ? max(one, two) : low;
            high = along * height > 0.0 ? high : min(one, two);
        }
    } else {
        float side = height < 0.0 ? -1.0 : 1.0;
        for (int k = 0; k < 4; k++) {
            vec3 axis = (k < 2 ? light.x : light.y) * ((k & 1) == 0 ? side : -side);
            float size = dot(axis, axis);
            float reach = side * size + dot(light.centre, axis);
            float slope = reach * along - dot(light.t, axis) * height;
            float start = reach * level - dot(m, axis) * height;
            // start + slope tan >= 0
            if (abs(slope) < 1e-12) {
                high = start < 0.0 ? low : high;
            } else if (slope > 0.0) {
                low = max(low, -start / slope);
            } else {
                high = min(high, -start / slope);
            }
        }
    }
    return atan(vec2(low, high));
}

// Azimuths of the light from u's: its outermost, or all when a pole of the fibre is inside.
vec2 tsu_light_azimuths(tsu_light light)
{
    vec2 c = vec2(dot(light.centre, light.u), dot(light.centre, light.w));
    vec2 x = vec2(dot(light.x, light.u), dot(light.x, light.w));
    vec2 y = vec2(dot(light.y, light.u), dot(light.y, light.w));
    const vec2 all = vec2(-3.14159265, 3.14159265);
    if (light.disk) {
        // Planes through the fibre that touch the disk.
        vec3 q = vec3(c.x * c.x - x.x * x.x - y.x * y.x, c.x * c.y - x.x * x.y - y.x * y.y,
                      c.y * c.y - x.y * x.y - y.y * y.y);
        float root = sqrt(max(q.y * q.y - q.x * q.z, 0.0));
        return q.x > 1e-9 ? atan(vec2(q.y - root, q.y + root) / q.x) : all;
    }
    vec3 n = cross(light.x, light.y);
    float along = dot(light.t, n);
    float height = dot(light.centre, n);
    vec3 pole = light.t * (height / (abs(along) < 1e-9 ? 1e-9 : along)) - light.centre;
    if (abs(dot(pole, light.x)) <= dot(light.x, light.x) &&
        abs(dot(pole, light.y)) <= dot(light.y, light.y)) {
        return all;
    }
    vec4 a = vec4(c + x + y, c + x - y), b = vec4(c - x + y, c - x - y);
    vec4 angles = vec4(atan(a.y, a.x), atan(a.w, a.z), atan(b.y, b.x), atan(b.w, b.z));
    return vec2(min(min(angles.x, angles.y), min(angles.z, angles.w)),
                max(max(angles.x, angles.y), max(angles.z, angles.w)));
}

// The azimuth and its stretched twin; both grow by 2 pi together.
float tsu_light_stretch(float x, float k)
{
    float turns = floor(x / 6.28318531 + 0.5);
    float half_x = 0.5 * (x - 6.28318531 * turns);
    return 6.28318531 * turns + 2.0 * atan(sin(half_x), k * cos(half_x));
}

// Arc and lobe at a stretched azimuth: centre, width of the lobe, ends of the arc as angles of the
// Cauchy density; equal ends: outside.
vec4 tsu_light_slice(tsu_light light, float stretched, out vec3 m, out float azimuth)
{
    azimuth = tsu_light_stretch(stretched, 2.0);
    float angle = light.back + azimuth;
    m = light.u * cos(angle) + light.w * sin(angle);
    vec2 arc = tsu_light_arc(light, m);
    vec2 lobe = tsu_light_lobe(light.fiber, light.mirror, azimuth);
    return arc.y > arc.x ? vec4(lobe, atan((arc - lobe.x) / lobe.y)) : vec4(lobe, 0.0, 0.0);
}

// One direction: of a small or far light.
tsu_light tsu_light_single(tsu_light light, vec3 color)
{
    light.count = dot(color, vec3(1.0)) > 0.0 ? 1 : 0;
    light.color = light.count > 0 ? min(color, vec3(1e30)) : vec3(0.0);
    return light;
}

// Look at a light from a fibre.
//   record         of the light
//   fiber          tsu_light_lobes() or tsu_light_cone() of the material
//   position       of the fibre, in the record's space
//   t, v           unit: tangent from root to tip, towards the viewer
tsu_light tsu_light_begin(vec4 record[4], tsu_light_fiber fiber, vec3 position, vec3 t, vec3 v)
{
    tsu_light light;
    int kind = int(record[0].w + 0.5);
    vec3 way = kind == 0 || kind == 4 ? record[0].xyz : record[0].xyz - position;
    float far = length(way);
    // A light in the point itself shines from the side.
    light.middle = far > 1e-18 && far < 1e18 ? way / far : tsu_light_across(t, v);
    light.color = record[3].rgb;
    light.count = 0;
    light.fiber = fiber;
    light.t = t;
    light.disk = kind > 2;
    // Lengths relative to the largest one.
    float scale = 1.0 / max(max(far, 1e-18), max(length(record[1].xyz), length(record[2].xyz)));
    light.centre = way * scale;
    light.x = record[1].xyz * scale;
    light.y = record[2].xyz * scale;
    light.u = tsu_light_across(t, light.middle);
    light.w = cross(t, light.u);
    light.mirror = tsu_light_mirror(t, v);
    vec3 behind = tsu_light_across(t, -v);
    light.back = atan(dot(behind, light.w), dot(behind, light.u));
    light.range = vec2(0.0);
    for (int k = 0; k < 9; k++) {
        light.share[k] = 0.0;
    }
    if (!(far < 1e18)) {
        return light;
    }
    if (kind == 0) {
        return tsu_light_single(light, record[3].rgb);
    }
    if (kind == 1) {
        float least = max(far, record[3].w);
        return tsu_light_single(light, record[3].rgb / (least * least));
    }
    vec3 n = cross(light.x, light.y);
    if (kind != 4 && record[2].w < 0.5 && !(dot(n, light.centre) < 0.0)) {
        return light; // from behind
    }
    // Seen from 50 times its half axes away an area is a direction.
    float size = max(dot(light.x, light.x), dot(light.y, light.y));
    if (size < 4e-4 * dot(light.centre, light.centre)) {
        float area = (light.disk ? 3.14159265 : 4.0) * abs(dot(n, light.middle));
        return tsu_light_single(light, record[3].rgb * area);
    }
    vec2 azimuths = tsu_light_azimuths(light) - light.back;
    // All around, the range begins in front: the density has no step there.
    if (azimuths.y - azimuths.x > 6.28) {
        azimuths = vec2(-3.14159265, 3.14159265);
    }
    light.range = vec2(tsu_light_stretch(azimuths.x, 0.5), tsu_light_stretch(azimuths.y, 0.5));
    // Eight heights of a half circle overstate its area by 1.354 %.
    float cell = (light.range.y - light.range.x) / 8.0 *
                 (light.disk && azimuths.y - azimuths.x < 6.28 ? 0.98664 : 1.0);
    for (int k = 0; k < 8; k++) {
        vec3 m;
        float azimuth;
        vec4 slice = tsu_light_slice(
            light, mix(light.range.x, light.range.y, (float(k) + 0.5) / 8.0), m, azimuth);
        light.share[k + 1] = light.share[k] + (slice.w - slice.z) * cell;
    }
    light.count = light.share[8] > 0.0 ? int(record[1].w + 0.5) : 0;
    return light;
}

// Direction i of light.count, unit, and its radiance times solid angle. Finite; 0 when there is
// nothing to add, and l a unit vector all the same.
vec3 tsu_light_sample(tsu_light light, int i, out vec3 l)
{
    l = light.middle;
    if (light.range.y <= light.range.x) {
        return i == 0 ? light.color : vec3(0.0);
    }
    float all = light.share[8];
    float at = all * (float(i) + 0.5) / float(light.count);
    int cell = 0;
    for (int k = 1; k < 8; k++) {
        cell = light.share[k] <= at ? k : cell;
    }
    float inside = (at - light.share[cell]) /
                   max(light.share[cell + 1] - light.share[cell], 1e-12 * all);
    vec3 m;
    float azimuth;
    vec4 slice = tsu_light_slice(
        light, mix(light.range.x, light.range.y, (float(cell) + clamp(inside, 0.0, 1.0)) / 8.0), m,
        azimuth);
    if (!(slice.w > slice.z)) {
        return vec3(0.0);
    }
    float x = tan(mix(slice.z, slice.w, tsu_light_level(i)));
    float theta = slice.x + slice.y * x;
    // Solid angle: cos(theta) and both densities, each direction an equal share.
    float c = cos(0.5 * azimuth), s = 2.0 * sin(0.5 * azimuth);
    float stretch = 0.5 * (c * c + s * s);
    float angle =
        slice.y * (1.0 + x * x) * stretch * max(cos(theta), 0.0) * all / float(light.count);
    l = light.t * sin(theta) + m * cos(theta);
    return angle < 12.6 ? light.color * angle : vec3(0.0);
}

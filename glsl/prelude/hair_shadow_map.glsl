// SPDX-License-Identifier: MIT
// What deep opacity maps and opacity shadow maps share: places, layers, one tap.
//
// `record` is the plan's (tsuya/hair_shadow.h). Textures are read by texelFetch alone.

// Place of a point in the map, in texels from the centre of the first one, and distance behind the
// near plane. A point that is not finite, or behind a point light, comes out before all hair.
vec3 tsu_hair_shadow_place(vec4 record[12], vec3 position)
{
    vec4 p = vec4(position, 1.0);
    float w = dot(record[2], p);
    vec2 at = vec2(dot(record[0], p), dot(record[1], p)) / w - 0.5;
    float ahead = dot(record[3], p);
    // Every comparison with what is no number is false.
    bool good = w > 0.0 && abs(at.x) < 16384.0 && abs(at.y) < 16384.0 && abs(ahead) < 1e30;
    return good ? vec3(at, ahead) : vec3(0.0, 0.0, -1e30);
}

// Distance behind the near plane of a depth in [0, 1] as a depth buffer stores it.
float tsu_hair_shadow_stored(vec4 record[12], float depth)
{
    return record[4].x * depth / (record[4].z * depth + record[4].w);
}

// What a fragment adds to its layer: `amount` fibres at `depth` behind the layers' beginning.
//   amount    share of the texel that the fibre covers: tsu_hair_shadow_ribbon() or _line()
//   position  the fragment's, world; what rounds the sums of an RGBA8 target at random
void tsu_hair_shadow_add(vec4 record[12], vec3 position, float depth, float amount,
                         out vec4 layers, out vec4 deeper)
{
    // 1 from each layer's beginning on; the first begins in front of everything.
    vec4 a = step(vec4(0.0), depth * record[5] + record[7]);
    vec4 b = step(vec4(0.0), depth * record[6] + record[8]);
    a.x = 1.0;
    float value = amount > 0.0 ? amount / record[10].y : 0.0;
    if (record[10].z > 0.0) {
        float chance = fract(sin(dot(position / record[10].w, vec3(1269.5, 2691.9, 3537.7))) *
                             43758.5453);
        value = min(floor(value * 255.0 + chance), 255.0) / 255.0;
    }
    layers = value * (a - vec4(a.yzw, b.x));
    deeper = value * (b - vec4(b.yzw, 0.0));
}

// The four texels around a place: columns and rows of the first and the last, in the tile. Places
// outside get the outermost texels, in which a plan leaves no hair.
ivec4 tsu_hair_shadow_texels(vec4 record[12], vec2 at)
{
    vec4 corners = floor(vec4(at, at + 1.0));
    return ivec4(clamp(corners, 0.0, record[9].z - 1.0) + record[9].xyxy);
}

// Their weights: (first, first), (last, first), (first, last), (last, last).
vec4 tsu_hair_shadow_weights(vec2 at)
{
    vec2 f = at - floor(at);
    vec2 x = vec2(1.0 - f.x, f.x);
    return vec4(x * (1.0 - f.y), x * f.y);
}

// One texel's answer, added with its weight: `behind` still holds all fibres.
//   depth  of the point behind the layers' beginning
void tsu_hair_shadow_tap(vec4 record[12], float depth, vec4 layers, vec4 deeper, float weight,
                         inout tsu_hair_shadow sum)
{
    // Hair is even within a layer.
    float front = record[10].y * (dot(clamp(depth * record[5] + record[7], 0.0, 1.0), layers) +
                                  dot(clamp(depth * record[6] + record[8], 0.0, 1.0), deeper));
    sum.front += weight * front;
    sum.behind += weight * dot(layers + deeper, vec4(1.0));
    sum.direct += weight * exp(-front);
    sum.transmittance += weight * exp(-record[10].x * front);
}

// All fibres less those in front are those behind.
tsu_hair_shadow tsu_hair_shadow_sum(vec4 record[12], tsu_hair_shadow sum)
{
    sum.behind = max(record[10].y * sum.behind - sum.front, 0.0);
    return sum;
}

// Share of a unit square on one side of a line at distance x from its centre.
//   sides  absolute components of the line's direction, the greater first
float tsu_hair_shadow_side(float x, vec2 sides)
{
    float outer = 0.5 * (sides.x + sides.y);
    float inner = 0.5 * (sides.x - sides.y);
    float y = min(abs(x), outer);
    float rest = outer - y;
    float h = y < inner ? y / sides.x : 0.5 - rest * rest / (2.0 * sides.x * max(sides.y, 1e-5));
    return 0.5 + sign(x) * h;
}

// Share of a texel that a straight ribbon covers, for hosts that draw quads wide enough to reach
// every texel that the fibre touches: half the width and 0.71 texels to all sides.
//   across        distance of the texel's centre from the axis, texels
//   half_width    of the fibre, texels
//   begin, end    distances of the centre from both ends along the axis, positive inside, texels
//   direction     of the axis on the map, any length
// Sums over all texels are width times length: no fibre is lost or counted twice.
float tsu_hair_shadow_ribbon(float across, float half_width, float begin, float end,
                             vec2 direction)
{
    vec2 d = abs(direction) / max(length(direction), 1e-20);
    vec2 sides = vec2(max(d.x, d.y), min(d.x, d.y));
    float covered = tsu_hair_shadow_side(across + half_width, sides) -
                    tsu_hair_shadow_side(across - half_width, sides);
    float ends = tsu_hair_shadow_side(begin, sides) + tsu_hair_shadow_side(end, sides) - 1.0;
    return max(covered, 0.0) * max(ends, 0.0);
}

// The same for hosts that draw lines of one texel, which have max(|dx|, |dy|) fragments.
//   width      of the fibre, texels
//   direction  of the line on the map, any length
float tsu_hair_shadow_line(float width, vec2 direction)
{
    vec2 d = abs(direction);
    return width * length(d) / max(max(d.x, d.y), 1e-20);
}

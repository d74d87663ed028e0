// Ribbons that face the camera, one quad a segment, expanded in pixels.
//
// Vertex 4 k + 2 end + side of the segment from point k to k + 1. A vertex is moved sideways by the
// fibre's true half width plus the reach of a pixel's square, so that the fragment shader meets
// every pixel that the fibre touches. Everything is given in pixels with w = 1, so that varyings
// are linear on the screen; segments nearer than the near plane never come here, those behind a
// light are left out.
//
// Thin segments end each by itself, moved outwards as well: the shares of a pixel that neighbours
// cover add up to the whole, so a strand keeps its energy around every bend, however small on the
// screen. Covering twice at an opaque joint would leave a notch, so wide segments share mitred
// edges.

uniform highp sampler2D u_points;  // xyz and radius, world units before u_model
uniform highp sampler2D u_strands; // length from the root, length to the tip, seed, strand
uniform highp sampler2D u_sky;     // radiance from the sky at each point
uniform mat4 u_model;
uniform mat4 u_view_projection;
uniform vec2 u_half_size;    // of the picture, pixels
uniform float u_pixel_scale; // pixels of one world unit at clip w = 1
uniform float u_width_scale; // of every fibre
uniform float u_taper;       // share of the length over which the tip narrows to a point
uniform float u_thin;        // full width in pixels up to which a segment counts as thin

out vec3 v_position;
out vec3 v_tangent;
out vec4 v_ribbon; // across, half width, length from the root, length to the tip: pixels
out vec2 v_screen; // direction on the screen
out vec2 v_strand; // seed, strand
out vec3 v_sky;

ivec2 texel(int index)
{
    int width = textureSize(u_points, 0).x;
    return ivec2(index % width, index / width);
}

vec3 world(int index)
{
    return (u_model * vec4(texelFetch(u_points, texel(index), 0).xyz, 1.0)).xyz;
}

vec2 pixel(vec3 position)
{
    vec4 clip = u_view_projection * vec4(position, 1.0);
    return clip.xy / max(clip.w, 1e-6) * u_half_size;
}

// Unit vector along d, or `other` for a vector too short to have a direction.
vec2 direction(vec2 d, vec2 other)
{
    float size = length(d);
    return size > 1e-5 ? d / size : other;
}

float half_width(vec4 strand, int index, float w)
{
    float share = strand.y / max(strand.x + strand.y, 1e-30);
    float taper = u_taper > 0.0 ? min(share / u_taper, 1.0) : 1.0;
    float radius = texelFetch(u_points, texel(index), 0).w * u_width_scale * taper;
    return radius * u_pixel_scale / max(w, 1e-6);
}

void main()
{
    int first = gl_VertexID / 4;
    bool end = gl_VertexID % 4 > 1;
    float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
    int point = end ? first + 1 : first;
    int other = end ? first : first + 1;
    vec4 strand = texelFetch(u_strands, texel(point), 0);
    bool root = strand.x <= 0.0;
    bool tip = strand.y <= 0.0;

    vec3 here = world(point);
    vec3 before = root ? here : world(point - 1);
    vec3 after = tip ? here : world(point + 1);
    vec4 clip = u_view_projection * vec4(here, 1.0);
    vec2 here_px = pixel(here);
    vec2 in_px = here_px - pixel(before);
    vec2 out_px = pixel(after) - here_px;
    float half_here = half_width(strand, point, clip.w);
    vec4 far_clip = u_view_projection * vec4(end ? before : after, 1.0);
    float half_other = half_width(texelFetch(u_strands, texel(other), 0), other, far_clip.w);

    vec2 dir;
    vec2 ends;          // length from the start and to the end, pixels
    float mitre = 1.0;
    float move = 0.0;   // of the vertex along dir, in reaches
    if (max(half_here, half_other) < 0.5 * u_thin) {
        vec2 along = end ? in_px : out_px;
        dir = direction(along, vec2(1.0, 0.0));
        ends = end ? vec2(length(along), 0.0) : vec2(0.0, length(along));
        move = end ? 1.0 : -1.0;
    } else {
        vec2 in_dir = direction(in_px, direction(out_px, vec2(1.0, 0.0)));
        vec2 out_dir = direction(out_px, in_dir);
        dir = dot(in_dir, out_dir) > -0.9 ? normalize(in_dir + out_dir) : out_dir;
        // A mitre keeps the width on both sides of a bend; past 60 degrees it would stick out.
        mitre = 1.0 / max(dot(dir, out_dir), 0.5);
        float pixels = (length(in_px) + length(out_px)) /
                       max(length(here - before) + length(after - here), 1e-30);
        ends = strand.xy * pixels;
        move = (tip ? 1.0 : 0.0) - (root ? 1.0 : 0.0);
    }
    // The farthest that a pixel's square reaches along any direction, to both sides of its centre.
    float reach = 0.5 * (abs(dir.x) + abs(dir.y)) + 0.01;
    float across = side * (half_here + reach);
    vec2 at = here_px + vec2(-dir.y, dir.x) * (across * mitre) + dir * (move * reach);

    v_position = here;
    v_tangent = after - before;
    v_ribbon = vec4(across, half_here, ends.x + move * reach, ends.y - move * reach);
    v_screen = dir;
    v_strand = strand.zw;
    v_sky = texelFetch(u_sky, texel(point), 0).rgb;
    gl_Position = min(clip.w, far_clip.w) > 1e-6 ? vec4(at / u_half_size, clip.z / clip.w, 1.0)
                                                 : vec4(2.0, 2.0, 2.0, 1.0);
}

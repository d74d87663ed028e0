// Ribbons that face the camera, one quad a segment, expanded in pixels.
//
// Vertex 2 k + side of point k. A vertex is moved sideways by the fibre's true half width plus the
// reach of a pixel's square, so that the fragment shader meets every pixel that the fibre touches;
// ends are moved outwards likewise. Everything is given in pixels with w = 1, so that varyings are
// linear on the screen; segments nearer than the near plane never come here.

uniform highp sampler2D u_points;  // xyz and radius, world units before u_model
uniform highp sampler2D u_strands; // length from the root, length to the tip, seed, strand
uniform highp sampler2D u_sky;     // radiance from the sky at each point
uniform mat4 u_model;
uniform mat4 u_view_projection;
uniform vec2 u_half_size;    // of the picture, pixels
uniform float u_pixel_scale; // pixels of one world unit at clip w = 1
uniform float u_width_scale; // of every fibre
uniform float u_taper;       // share of the length over which the tip narrows to a point

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

void main()
{
    int point = gl_VertexID / 2;
    float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
    vec4 strand = texelFetch(u_strands, texel(point), 0);
    bool root = strand.x <= 0.0;
    bool tip = strand.y <= 0.0;

    vec3 here = world(point);
    vec3 before = root ? here : world(point - 1);
    vec3 after = tip ? here : world(point + 1);
    vec3 along = after - before;

    vec2 here_px = pixel(here);
    vec2 in_px = here_px - pixel(before);
    vec2 out_px = pixel(after) - here_px;
    vec2 in_dir = direction(in_px, direction(out_px, vec2(1.0, 0.0)));
    vec2 out_dir = direction(out_px, in_dir);
    vec2 dir = dot(in_dir, out_dir) > -0.9 ? normalize(in_dir + out_dir) : out_dir;
    // A mitre keeps the width on both sides of a bend; past 60 degrees it would stick out.
    float mitre = 1.0 / max(dot(dir, out_dir), 0.5);

    vec4 clip = u_view_projection * vec4(here, 1.0);
    float share = strand.y / max(strand.x + strand.y, 1e-30);
    float taper = u_taper > 0.0 ? min(share / u_taper, 1.0) : 1.0;
    float radius = texelFetch(u_points, texel(point), 0).w * u_width_scale * taper;
    float half_width = radius * u_pixel_scale / max(clip.w, 1e-6);
    // Half the side of a pixel's square along any direction is at most this.
    float reach = 0.5 * (abs(dir.x) + abs(dir.y)) + 0.01;
    float across = side * (half_width + reach);

    float end = (tip ? reach : 0.0) - (root ? reach : 0.0);
    vec2 at = here_px + vec2(-dir.y, dir.x) * (across * mitre) + dir * end;
    float pixels = (length(in_px) + length(out_px)) /
                   max(length(here - before) + length(after - here), 1e-30);

    v_position = here;
    v_tangent = along;
    v_ribbon = vec4(across, half_width, strand.x * pixels + end, strand.y * pixels - end);
    v_screen = dir;
    v_strand = strand.zw;
    v_sky = texelFetch(u_sky, texel(point), 0).rgb;
    gl_Position = vec4(at / u_half_size, clip.z / clip.w, 1.0);
}

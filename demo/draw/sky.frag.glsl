// The sky's radiance off every point of every strand, one pixel a point. A sky is smooth, so that
// a ribbon may take it between its points, at a fraction of the cost for each pixel.

uniform highp sampler2D u_points;
uniform highp sampler2D u_strands;
uniform mat4 u_model;
uniform vec3 u_eye;
out vec4 o_color;

vec3 world(ivec2 size, int index)
{
    vec4 point = texelFetch(u_points, ivec2(index % size.x, index / size.x), 0);
    return (u_model * vec4(point.xyz, 1.0)).xyz;
}

void main()
{
    ivec2 size = textureSize(u_points, 0);
    ivec2 place = ivec2(gl_FragCoord.xy);
    int index = place.y * size.x + place.x;
    vec4 strand = texelFetch(u_strands, place, 0);
    if (strand.x + strand.y <= 0.0) {
        discard; // past the last point
    }
    vec3 here = world(size, index);
    vec3 before = strand.x <= 0.0 ? here : world(size, index - 1);
    vec3 after = strand.y <= 0.0 ? here : world(size, index + 1);
    vec3 t = normalize(after - before);
    o_color = vec4(lit(t, normalize(u_eye - here), here, strand.z), 1.0);
}

// Depth of what a light meets second; wood that it meets first counts again.

uniform highp sampler2D u_first; // depths met first
uniform float u_same;            // difference of depth up to which it is the same surface
uniform int u_opaque;

void main()
{
    float first = texelFetch(u_first, ivec2(gl_FragCoord.xy), 0).r;
    if (u_opaque == 0 && gl_FragCoord.z <= first + u_same) {
        discard;
    }
}

// Mean of the u_samples x u_samples texels that lie in this pixel.

uniform highp sampler2D u_picture;
uniform int u_samples;
out vec4 o_color;

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * u_samples;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < u_samples; y++) {
        for (int x = 0; x < u_samples; x++) {
            sum += texelFetch(u_picture, corner + ivec2(x, y), 0);
        }
    }
    o_color = sum / float(u_samples * u_samples);
}

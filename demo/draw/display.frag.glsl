// Linear light to what a screen can show: exposure, a film curve, and the sRGB curve if asked for.

uniform highp sampler2D u_picture;
uniform float u_exposure; // factor
uniform int u_filmic;     // 1: roll off highlights; 0: cut at 1
uniform int u_encode;     // 1: sRGB curve
out vec4 o_color;

// Source: Narkowicz 2016, "ACES Filmic Tone Mapping Curve", a fit of the ACES reference curve.
vec3 film(vec3 x)
{
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

vec3 srgb(vec3 x)
{
    return mix(1.055 * pow(max(x, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055, 12.92 * x,
               vec3(lessThanEqual(x, vec3(0.0031308))));
}

void main()
{
    vec3 c = max(texelFetch(u_picture, ivec2(gl_FragCoord.xy), 0).rgb * u_exposure, vec3(0.0));
    // The fit maps 0.8 to what the curve it was made for maps 1 to.
    c = u_filmic == 1 ? film(0.8 * c) : min(c, vec3(1.0));
    o_color = vec4(u_encode == 1 ? srgb(c) : c, 1.0);
}

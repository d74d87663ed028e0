// Share of light that passes a leaf which it meets at 45 degrees from above: one pixel.

out vec4 o_color;

void main()
{
    // Reciprocal: what comes through towards 45 degrees of even light is what light from there
    // sends to all sides.
    vec3 v = vec3(0.0, 0.70710678, -0.70710678);
    o_color = vec4(leaf_sky_light(vec3(0.0, 0.0, -1.0), false, v, 1.0, 1.0, vec3(0.0), vec3(1.0)),
                   1.0);
}

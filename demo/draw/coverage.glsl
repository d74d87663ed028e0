// Share of a pixel's square that a fibre covers.

in vec4 v_ribbon; // across, half width, length from the root, length to the tip: pixels
in vec2 v_screen; // direction on the screen

// Share of a unit square on one side of a line at distance x from its centre. The square's shadow
// on the line's normal is a trapezoid, the sum of two boxes as wide as the normal's components.
//   sides  absolute components of the normal, the greater first
float side_of(float x, vec2 sides)
{
    float outer = 0.5 * (sides.x + sides.y);
    float inner = 0.5 * (sides.x - sides.y);
    float y = min(abs(x), outer);
    float rest = outer - y;
    float h = y < inner ? y / sides.x : 0.5 - rest * rest / (2.0 * sides.x * max(sides.y, 1e-5));
    return 0.5 + sign(x) * h;
}

// Exact area of a straight ribbon in this pixel, so that the sum over all pixels is width times
// length at every width, angle and position. A fibre thinner than a pixel comes out one pixel wide
// with the opacity true width / drawn width. Ends are cut by the same rule, as if the square were
// the product of its shadows.
float coverage()
{
    vec2 a = abs(normalize(v_screen));
    vec2 sides = vec2(max(a.x, a.y), min(a.x, a.y));
    float across = side_of(v_ribbon.x + v_ribbon.y, sides) -
                   side_of(v_ribbon.x - v_ribbon.y, sides);
    float ends = side_of(v_ribbon.z, sides) + side_of(v_ribbon.w, sides) - 1.0;
    return max(across, 0.0) * max(ends, 0.0);
}

// Which strand touches the pixel: its number plus one in four bytes, the lowest in red.

in vec2 v_strand;
out vec4 o_color;

void main()
{
    if (coverage() <= 0.0) {
        discard;
    }
    float number = floor(v_strand.y + 0.5) + 1.0;
    vec4 digits = floor(number / vec4(1.0, 256.0, 65536.0, 16777216.0));
    o_color = (digits - 256.0 * floor(digits / 256.0)) / 255.0;
}

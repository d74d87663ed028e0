// A fibre's radiance towards the camera from the lights; the sky's share comes from its points.

in vec3 v_position;
in vec3 v_tangent;
in vec2 v_strand; // seed, strand
in vec3 v_sky;
uniform vec3 u_eye;
uniform float u_gain; // on all of it
out vec4 o_color;          // multiplied by coverage

void main()
{
    float cover = coverage();
    if (cover <= 0.0) {
        discard;
    }
    vec3 sum = v_sky + lit(normalize(v_tangent), normalize(u_eye - v_position), v_position,
                           v_strand.x);
    o_color = vec4(u_gain * sum, 1.0) * cover;
}

// A fibre's radiance towards the camera: one call of the model for each light.
//
// HAIR(t, l, v, sigma_a) is the model's entry and its sum of lobes.

in vec3 v_position;
in vec3 v_tangent;
in vec2 v_strand; // seed, strand
uniform vec3 u_eye;
uniform vec3 u_sigma_a;
uniform float u_variation; // deviation of ln(sigma_a) from strand to strand
out vec4 o_color;          // multiplied by coverage

void main()
{
    float cover = coverage();
    if (cover <= 0.0) {
        discard;
    }
    vec3 t = normalize(v_tangent);
    vec3 v = normalize(u_eye - v_position);
    // Uniform with deviation 1.
    float chance = 1.7320508 * (2.0 * v_strand.x - 1.0);
    vec3 sigma_a = u_sigma_a * exp(u_variation * chance);
    vec3 place = grid_place(v_position);

    vec3 sum = vec3(0.0);
    for (int k = 0; 4 * k < u_lights; k++) {
        vec4 count = fibres(place, k);
        int last = min(u_lights - 4 * k, 4);
        for (int i = 0; i < last; i++) {
            vec3 light = u_light_color[4 * k + i] * exp(-u_loss * count[i]);
            sum += light * HAIR(t, u_light_direction[4 * k + i], v, sigma_a);
        }
    }
    o_color = vec4(sum, 1.0) * cover;
}

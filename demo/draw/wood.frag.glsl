// Diffuse wood and stalks.

in vec3 v_position;
in vec3 v_normal;
in vec3 v_albedo;
out vec4 o_color; // alpha is the share of leaves: none

void main()
{
    vec3 n = normalize(v_normal);
    vec3 sum = 3.14159265 * sky_mean(v_position, n);
    for (int i = 0; i < u_lights; i++) {
        vec3 share = light_share(i, v_position, n, u_light_direction[i]);
        for (int k = 0; k < light_samples(i); k++) {
            vec3 l;
            vec3 color = light_sample(i, k, v_position, l);
            sum += share * color * max(dot(n, l), 0.0);
        }
    }
    o_color = vec4(sum * v_albedo / 3.14159265, 0.0);
}

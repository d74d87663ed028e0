// A diffuse ground that goes over into the background.

in vec3 v_position;
uniform vec4 u_ground;
uniform vec3 u_background;
out vec4 o_color; // alpha is the share of leaves: none

void main()
{
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 sum = 3.14159265 * sky_mean(v_position, up);
    for (int i = 0; i < u_lights; i++) {
        vec3 share = light_share(i, v_position, up, u_light_direction[i]);
        for (int k = 0; k < light_samples(i); k++) {
            vec3 l;
            vec3 color = light_sample(i, k, v_position, l);
            sum += share * color * max(l.y, 0.0);
        }
    }
    vec3 soil = vec3(0.17, 0.15, 0.115) * sum / 3.14159265;
    float far = length(v_position.xz - u_ground.xz) / u_ground.w;
    o_color = vec4(mix(soil, u_background, smoothstep(0.25, 0.98, far)), 0.0);
}

// A diffuse head in the hair's shadow.

in vec3 v_position;
in vec3 v_normal;
uniform vec3 u_albedo;
uniform float u_lift; // metres off the surface, out of the head's own cells
out vec4 o_color;     // alpha is the share of hair: none

void main()
{
    vec3 n = normalize(v_normal);
    vec3 place = grid_place(v_position + u_lift * n);
    vec3 sum = vec3(0.0);
    for (int k = u_groups_begin; k < u_groups_end; k++) {
        vec4 count = fibres(place, k);
        for (int i = 0; i < 4; i++) {
            vec3 irradiance = vec3(0.0);
            for (int j = 0; j < light_samples(4 * k + i); j++) {
                vec3 l;
                vec3 color = light_sample(4 * k + i, j, v_position, l);
                irradiance += color * max(dot(n, l), 0.0);
            }
            sum += exp(-u_loss * count[i]) * irradiance;
        }
    }
    o_color = vec4(sum * u_albedo / 3.14159265, 0.0);
}

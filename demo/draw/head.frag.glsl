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
    for (int k = 0; 4 * k < u_lights; k++) {
        vec4 count = fibres(place, k);
        int last = min(u_lights - 4 * k, 4);
        for (int i = 0; i < last; i++) {
            float facing = max(dot(n, u_light_direction[4 * k + i]), 0.0);
            sum += u_light_color[4 * k + i] * exp(-u_loss * count[i]) * facing;
        }
    }
    o_color = vec4(sum * u_albedo / 3.14159265, 0.0);
}

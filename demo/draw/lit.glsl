// Radiance of a fibre towards the viewer from a range of lights: one call of the model for each.
//
// HAIR(t, l, v, sigma_a, shadow) is the model's entry and its sum of lobes, with the shadow as its
// extra inputs; SCATTERS is defined when it takes some: it is then multiplied by no transmittance.

uniform vec3 u_sigma_a;
uniform float u_variation; // deviation of ln(sigma_a) from strand to strand

// Light that hair has dimmed to less than this share is left out.
const float FAINT = 1e-3;

vec3 strand_sigma_a(float seed)
{
    // Uniform with deviation 1.
    float chance = 1.7320508 * (2.0 * seed - 1.0);
    return u_sigma_a * exp(u_variation * chance);
}

//   t, v      unit: tangent from root to tip, towards the viewer
//   position  world
//   seed      of the strand, [0, 1)
vec3 lit(vec3 t, vec3 v, vec3 position, float seed)
{
    vec3 sigma_a = strand_sigma_a(seed);
    vec3 place = grid_place(position);
    vec3 sum = vec3(0.0);
    for (int k = u_groups_begin; k < u_groups_end; k++) {
        vec4 front = fibres(place, k);
        vec4 behind = beyond(place, k);
        for (int i = 0; i < 4; i++) {
            vec3 color = u_light_color[4 * k + i];
            if (max(color.r, max(color.g, color.b)) <= 0.0) {
                continue;
            }
            vec3 l = u_light_direction[4 * k + i];
            tsu_hair_shadow shadow = shadow_of(4 * k + i, position, l, front[i], behind[i]);
#ifdef SCATTERS
            sum += color * HAIR(t, l, v, sigma_a, shadow);
#else
            vec3 share = passed(shadow);
            if (max(share.r, max(share.g, share.b)) > FAINT) {
                sum += share * color * HAIR(t, l, v, sigma_a, shadow);
            }
#endif
        }
    }
    return sum;
}

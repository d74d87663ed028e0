// Radiance of a fibre towards the viewer from a range of lights: one call of the model for each.
//
// HAIR(t, l, v, sigma_a, shadow) is the model's entry and its sum of lobes, with the shadow as its
// extra inputs; SCATTERS is defined when it takes some: it is then multiplied by no transmittance.

uniform vec3 u_sigma_a;
uniform float u_variation; // deviation of ln(sigma_a) from strand to strand

#ifdef AREAS
uniform int u_areas;                          // the first lights may be more than a direction
uniform vec4 u_area[4 * 8];                   // records; kind 0: a direction after all
#endif

// Light that hair has dimmed to less than this share is left out.
const float FAINT = 1e-3;

vec3 strand_sigma_a(float seed)
{
    // Uniform with deviation 1.
    float chance = 1.7320508 * (2.0 * seed - 1.0);
    return u_sigma_a * exp(u_variation * chance);
}

#ifdef AREAS
// Does light `index` have a place or a size?
bool has_area(int index)
{
    return index < u_areas && u_area[4 * index].w > 0.5;
}

// The same for such a light, with one look at the shadow, towards its centre.
vec3 lit_area(int index, vec3 t, vec3 v, vec3 position, vec3 sigma_a, float front, float behind)
{
    vec4 record[4];
    for (int k = 0; k < 4; k++) {
        record[k] = u_area[4 * index + k];
    }
    tsu_light light = tsu_light_begin(record, FIBER, position, t, v);
    vec3 sum = vec3(0.0);
    if (light.count > 0) {
        tsu_hair_shadow shadow = shadow_of(index, position, light.middle, front, behind);
        for (int i = 0; i < light.count; i++) {
            vec3 l;
            vec3 weight = tsu_light_sample(light, i, l);
#ifndef SCATTERS
            weight *= passed(shadow);
#endif
            if (max(weight.r, max(weight.g, weight.b)) > 0.0) {
                sum += weight * HAIR(t, l, v, sigma_a, shadow);
            }
        }
    }
    return sum;
}
#endif

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
#ifdef AREAS
            if (has_area(4 * k + i)) {
                sum += lit_area(4 * k + i, t, v, position, sigma_a, front[i], behind[i]);
                continue;
            }
#endif
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

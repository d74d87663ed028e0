// The sky's radiance off every point of every strand, one pixel a point. A sky is smooth, so that
// a ribbon may take it between its points, at a fraction of the cost for each pixel.
//
// Deep in hair the sky's light has been scattered often and comes from all sides alike: the
// radiance around a point is the mean over directions of what the hair lets through, and the model
// is integrated over the whole sphere. Models of equal albedo are therefore equally bright in it.

uniform highp sampler2D u_points;
uniform highp sampler2D u_strands;
uniform mat4 u_model;
uniform vec3 u_eye;
uniform int u_samples;
#ifdef SURROUNDED
uniform vec4 u_surroundings[9];
#endif
uniform float u_sky_lights; // lights that the sky is made of
out vec4 o_color;

// Spread of the samples around the mirror cone, radians: between the widths of narrow and wide
// lobes.
const float SPREAD = 0.2;

vec3 world(ivec2 size, int index)
{
    vec4 point = texelFetch(u_points, ivec2(index % size.x, index / size.x), 0);
    return (u_model * vec4(point.xyz, 1.0)).xyz;
}

// Light from direction l: irradiance of the sky's light nearest to it, and the hair on its way.
vec3 sky_light(vec3 place, vec3 position, vec3 l, out tsu_hair_shadow shadow)
{
    int nearest = 4 * u_groups_begin;
    float best = -2.0;
    for (int i = 4 * u_groups_begin; i < 4 * u_groups_end; i++) {
        float angle = dot(l, u_light_direction[i]);
        if (angle > best && dot(u_light_color[i], vec3(1.0)) > 0.0) {
            best = angle;
            nearest = i;
        }
    }
    vec4 front = fibres(place, nearest / 4);
    vec4 behind = beyond(place, nearest / 4);
    shadow = past_head(tsu_hair_shadow_count(front[nearest % 4], behind[nearest % 4]),
                       blocked(position, u_light_direction[nearest]));
    return u_light_color[nearest];
}

#ifndef SCATTERS
// The sky's irradiances, as the hair and the head let them through.
vec3 let_through(vec3 place, vec3 position)
{
    vec3 sum = vec3(0.0);
    for (int k = u_groups_begin; k < u_groups_end; k++) {
        vec4 count = fibres(place, k);
        for (int i = 0; i < 4; i++) {
            sum += exp(-u_loss * count[i]) * u_light_color[4 * k + i] *
                   (1.0 - blocked(position, u_light_direction[4 * k + i]));
        }
    }
    return sum;
}
#endif

// Integral of the model over all light directions; of its product with the sky's irradiances when
// it takes the shadow itself. Inclinations follow a Cauchy density around the
// mirror cone, azimuths are uniform, both by a low-discrepancy sequence (Roberts 2018, "The
// Unreasonable Effectiveness of Quasirandom Sequences") that starts elsewhere in each point.
vec3 albedo(vec3 t, vec3 v, vec3 sigma_a, vec3 place, vec3 position, vec2 start)
{
    float sin_r = clamp(dot(t, v), -1.0, 1.0);
    vec3 u = v - t * sin_r;
    u = dot(u, u) > 1e-8 ? normalize(u) : normalize(cross(t, vec3(0.31, 0.87, 0.38)));
    vec3 w = cross(t, u);
    float centre = -asin(sin_r);
    float low = atan((-1.57079633 - centre) / SPREAD);
    float high = atan((1.57079633 - centre) / SPREAD);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < u_samples; i++) {
        vec2 at = fract(start + float(i) * vec2(0.7548776662, 0.5698402910));
        float x = tan(mix(low, high, at.x));
        float theta = centre + SPREAD * x;
        float phi = 6.28318531 * at.y;
        vec3 l = t * sin(theta) + cos(theta) * (u * cos(phi) + w * sin(phi));
        float density = 1.0 / ((high - low) * SPREAD * (1.0 + x * x) * 6.28318531);
        float weight = max(cos(theta), 0.0) / density;
        tsu_hair_shadow shadow = tsu_hair_shadow_none();
#ifdef SCATTERS
        vec3 irradiance = sky_light(place, position, l, shadow);
        sum += irradiance * HAIR(t, l, v, sigma_a, shadow) * weight;
#else
        sum += HAIR(t, l, v, sigma_a, shadow) * weight;
#endif
    }
    return sum / float(u_samples);
}

#ifdef SURROUNDED
// The same from surroundings that are not uniform: radiance comes from where it is, and a model
// that knows no shadow is dimmed by what the hair lets through in the mean, as under the dome.
vec3 surrounded(vec3 t, vec3 v, vec3 sigma_a, vec3 place, vec3 position)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < tsu_environment_count(u_surroundings); i++) {
        vec3 l;
        vec3 weight = tsu_environment_sample(u_surroundings, FIBER, t, v, i, l);
        tsu_hair_shadow shadow = tsu_hair_shadow_none();
#ifdef SCATTERS
        sky_light(place, position, l, shadow);
#endif
        sum += weight * HAIR(t, l, v, sigma_a, shadow);
    }
#ifndef SCATTERS
    vec3 all = vec3(1e-20);
    for (int i = 4 * u_groups_begin; i < 4 * u_groups_end; i++) {
        all += u_light_color[i];
    }
    sum *= let_through(place, position) / all;
#endif
    return sum;
}
#endif

void main()
{
    ivec2 size = textureSize(u_points, 0);
    ivec2 place = ivec2(gl_FragCoord.xy);
    int index = place.y * size.x + place.x;
    vec4 strand = texelFetch(u_strands, place, 0);
    if (strand.x + strand.y <= 0.0) {
        discard; // past the last point
    }
    vec3 here = world(size, index);
    vec3 before = strand.x <= 0.0 ? here : world(size, index - 1);
    vec3 after = strand.y <= 0.0 ? here : world(size, index + 1);
    vec3 t = normalize(after - before);

    vec3 place_in_grid = grid_place(here);
#ifdef SURROUNDED
    o_color = vec4(surrounded(t, normalize(u_eye - here), strand_sigma_a(strand.z), place_in_grid,
                              here),
                   1.0);
#else
    vec2 start = fract(vec2(float(index % 8191) * 0.61803399, float(index % 8179) * 0.41421356) +
                       strand.z);
    vec3 scattered = albedo(t, normalize(u_eye - here), strand_sigma_a(strand.z), place_in_grid,
                            here, start);
#ifdef SCATTERS
    // Each light stands for 4 pi / u_sky_lights of the sphere.
    o_color = vec4(scattered * u_sky_lights / 12.5663706, 1.0);
#else
    o_color = vec4(let_through(place_in_grid, here) / 12.5663706 * scattered, 1.0);
#endif
#endif
}

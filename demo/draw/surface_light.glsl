// Lights on a surface, what stands in their way, and the sky.

const int LIGHTS = 32;
const int MAPS = 4;

uniform int u_lights;
uniform vec3 u_light_direction[LIGHTS]; // towards the light, unit, world
uniform vec3 u_light_color[LIGHTS];     // irradiance facing the light, linear

uniform int u_depth_maps;               // the first lights have shadow maps
uniform mat4 u_to_depth[MAPS];          // world to a map's [0, 1] cube
uniform float u_depth_texel;            // world size of a map's texel
uniform highp sampler2D u_depths;       // two maps a side: what a light meets first
uniform highp sampler2D u_depths_second;
uniform vec3 u_leaf_passes;             // share of light that passes a leaf

uniform vec4 u_sky[9];                  // record of an environment (tsuya/light.h)
uniform highp sampler3D u_leaf_sky;     // a and b of a + b . d, one slab a colour
uniform mat4 u_to_leaf_sky;             // world to its unit cube
uniform float u_leaf_sky_slab;          // cells of one slab along z; 0: the open sky

// Share of light i that arrives: depths compared over three texels a side, softly. One leaf in the
// way lets a share pass, as if it went straight on; more leaves, and wood, let nothing pass.
//   ng  geometric normal, of either side
vec3 light_share(int i, vec3 position, vec3 ng, vec3 l)
{
    if (i >= u_depth_maps) {
        return vec3(1.0);
    }
    // Off the surface towards the light, further at grazing light, or it would shade itself.
    float c = dot(ng, l);
    vec3 side = c < 0.0 ? -ng : ng;
    vec3 from = position + u_depth_texel * (side * (0.6 + 2.2 * sqrt(max(1.0 - c * c, 0.0))) + l);
    vec3 place = (u_to_depth[i] * vec4(from, 1.0)).xyz;
    place.z = min(place.z, 1.0); // the ground goes on behind the map
    int size = textureSize(u_depths, 0).x / 2;
    if (any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0)))) {
        return vec3(1.0);
    }
    vec2 at = place.xy * float(size) - 0.5;
    ivec2 low = ivec2(floor(at)) - 1;
    vec2 f = at - floor(at);
    vec4 wx = vec4(1.0 - f.x, 1.0, 1.0, f.x), wy = vec4(1.0 - f.y, 1.0, 1.0, f.y);
    ivec2 tile = ivec2(i % 2, i / 2) * size;
    vec2 sum = vec2(0.0); // without anything in the way, with one leaf
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 4; x++) {
            ivec2 texel = clamp(low + ivec2(x, y), ivec2(0), ivec2(size - 1)) + tile;
            vec2 open = vec2(texelFetch(u_depths, texel, 0).r < place.z ? 0.0 : 1.0,
                             texelFetch(u_depths_second, texel, 0).r < place.z ? 0.0 : 1.0);
            sum += wx[x] * wy[y] * open;
        }
    }
    return (sum.x + (sum.y - sum.x) * u_leaf_passes) / 9.0;
}

// Mean radiance over the hemisphere around d, weighed by the cosine.
vec3 sky_mean(vec3 position, vec3 d)
{
    // Cosine lobe in harmonics: 1, 2/3, 1/4 (Ramamoorthi and Hanrahan 2001).
    vec3 open = u_sky[0].rgb +
                    2.0 / 3.0 * (u_sky[1].rgb * d.x + u_sky[2].rgb * d.y + u_sky[3].rgb * d.z) +
                    0.25 * (u_sky[4].rgb * (d.x * d.y) + u_sky[5].rgb * (d.y * d.z) +
                            u_sky[6].rgb * (d.z * d.x) + u_sky[7].rgb * (d.x * d.x - d.y * d.y) +
                            u_sky[8].rgb * (3.0 * d.z * d.z - 1.0));
    if (u_leaf_sky_slab <= 0.0) {
        return max(open, vec3(0.0));
    }
    vec3 place = (u_to_leaf_sky * vec4(position, 1.0)).xyz;
    float z = clamp(place.z * u_leaf_sky_slab, 0.5, u_leaf_sky_slab - 0.5);
    vec3 mean;
    for (int c = 0; c < 3; c++) {
        float slab = (z + float(c) * u_leaf_sky_slab) / (3.0 * u_leaf_sky_slab);
        vec4 t = texture(u_leaf_sky, vec3(place.xy, slab));
        mean[c] = t.x + 2.0 / 3.0 * dot(t.yzw, d);
    }
    // Beside the crown the open sky comes back.
    vec3 outside = max(abs(place - 0.5) - 0.5, vec3(0.0));
    return max(mix(mean, open, smoothstep(0.0, 0.6, length(outside))), vec3(0.0));
}

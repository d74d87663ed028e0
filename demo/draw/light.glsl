// Directional lights and the hair between a point and each of them.

const int LIGHTS = 64;

uniform int u_groups_begin; // lights are used in groups of four
uniform int u_groups_end;
uniform vec3 u_light_direction[LIGHTS]; // towards the light, unit, world
uniform vec3 u_light_color[LIGHTS];     // irradiance facing the light, linear; 0: no light
uniform highp sampler3D u_fibres;       // fibres on the way to four lights, slabs of four along z
uniform mat4 u_to_grid;                 // world to the grid's unit cube
uniform float u_slab;                   // cells of one slab along z; 0: no shadow
uniform vec3 u_loss;                    // share of the light that a fibre takes out of the way

// Fibres between `place` (in the grid's cube) and lights 4 k .. 4 k + 3.
vec4 fibres(vec3 place, int k)
{
    if (u_slab <= 0.0) {
        return vec4(0.0);
    }
    float depth = float(textureSize(u_fibres, 0).z);
    float z = clamp(place.z * u_slab, 0.5, u_slab - 0.5) + float(k) * u_slab;
    return texture(u_fibres, vec3(place.xy, z / depth));
}

vec3 grid_place(vec3 position)
{
    return (u_to_grid * vec4(position, 1.0)).xyz;
}

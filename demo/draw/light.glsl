// Directional lights and the hair between a point and each of them.

const int LIGHTS = 64;

uniform int u_groups_begin; // lights are used in groups of four
uniform int u_groups_end;
uniform vec3 u_light_direction[LIGHTS]; // towards the light, unit, world
uniform vec3 u_light_color[LIGHTS];     // irradiance facing the light, linear; 0: no light
uniform highp sampler3D u_fibres;       // fibres on the way to four lights, slabs of four along z
#ifdef BEYOND
uniform highp sampler3D u_beyond;       // the same on the way on, away from the lights
#endif
uniform mat4 u_to_grid;                 // world to the grid's unit cube
uniform float u_slab;                   // cells of one slab along z; 0: no shadow
uniform vec3 u_loss;                    // share of the light that a fibre takes out of the way

// Fibres of lights 4 k .. 4 k + 3 at `place` (in the grid's cube).
vec4 slab(highp sampler3D counts, vec3 place, int k)
{
    float depth = float(textureSize(counts, 0).z);
    float z = clamp(place.z * u_slab, 0.5, u_slab - 0.5) + float(k) * u_slab;
    return texture(counts, vec3(place.xy, z / depth));
}

// Fibres between `place` and the lights.
vec4 fibres(vec3 place, int k)
{
    return u_slab > 0.0 ? slab(u_fibres, place, k) : vec4(0.0);
}

// Fibres further along the same lines. A thousand, thick hair, where nothing is known.
vec4 beyond(vec3 place, int k)
{
#ifdef BEYOND
    if (u_slab > 0.0) {
        return slab(u_beyond, place, k);
    }
#endif
    return vec4(1000.0);
}

vec3 grid_place(vec3 position)
{
    return (u_to_grid * vec4(position, 1.0)).xyz;
}
